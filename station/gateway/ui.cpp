#include "station/gateway/ui.hpp"

#include "station/gateway/server.hpp"

#include <fmt/format.h>

#include <iostream>
#include <thread>

namespace windlass::gateway {

namespace {

constexpr int kPortsTried = 20;

/// At the port asked for; otherwise at the first one that is free.
std::unique_ptr<Server> listen(const UiOptions& options, ServerOptions server, const Assets& assets,
                               Gateway& gateway) {
    server.port = static_cast<unsigned short>(options.port.value_or(UiOptions::kPort));
    for (int tried = 1;; ++tried, ++server.port) {
        try {
            return std::make_unique<Server>(server, assets, gateway);
        } catch (const std::runtime_error&) {
            if (options.port || tried == kPortsTried) throw;
        }
    }
}

} // namespace

void UiOptions::add_to(CLI::App& app) {
    app.add_option(
           "--ui-port", port,
           fmt::format("port of the pages on this computer, 0: any (default: {}, or the next free one)",
                       kPort))
        ->check(CLI::Range(0, 65535));
}

void UiOptions::add_foxglove_to(CLI::App& app) {
    app.add_flag("--foxglove", foxglove,
                 "let Foxglove and Lichtblick look on, with the same token (docs/gateway.md)");
    app.add_option("--foxglove-origin", foxglove_origins,
                   "a site whose pages may do so, e.g. https://app.foxglove.dev");
}

int serve_pages(const UiOptions& options, GatewayOptions wanted) {
    station::catch_stop_signals();
    const Role role = role_of(wanted.seat, wanted.exercise);
    Assets assets(folder_of_pages(), role.pages.front());
    wanted.publish = [&assets](const std::string& path, std::function<std::string()> page) {
        assets.add_page(path, std::move(page));
    };
    wanted.log = [](const std::string& line) { std::cerr << line + '\n' << std::flush; };
    const std::string exercise = wanted.exercise;
    const bool any_exercise = wanted.seat == station::Seat::instructor;
    const std::string token = make_token();
    Gateway gateway(std::move(wanted));
    const auto server = listen(options,
                               {.token = token,
                                .exercise = exercise,
                                .any_exercise = any_exercise,
                                .foxglove = options.foxglove,
                                .foxglove_origins = options.foxglove_origins},
                               assets, gateway);
    for (const std::string& page : role.pages)
        if (assets.find('/' + page) != nullptr)
            std::cout << fmt::format("http://127.0.0.1:{}/{}#token={}\n", server->port(), page, token);
    if (options.foxglove)
        std::cout << fmt::format("ws://127.0.0.1:{}/foxglove?token={}\n", server->port(), token);
    std::cout << std::flush;
    while (!station::stop_asked())
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    return station::kOk;
}

} // namespace windlass::gateway
