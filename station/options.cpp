#include "station/options.hpp"

#include "idl/network_options.hpp"

#include <csignal>
#include <iostream>

namespace windlass::station {

namespace {
volatile std::sig_atomic_t stop_signal = 0;
}

void SessionOptions::add_to(CLI::App& app) {
    app.add_option("--domain", domain, "DDS domain of the server")
        ->check(CLI::Range(0, 232))
        ->capture_default_str();
    app.add_option("--partition", partition, "exercise to join on that domain")
        ->check([](const std::string& text) {
            return wire::is_exercise_name(text)
                       ? ""
                       : "1 to 64 letters, digits, dots, dashes and underscores are allowed, not " + text;
        })
        ->capture_default_str();
    app.add_option("--name", name, "name under which this station gives its orders")
        ->check([](const std::string& text) {
            return !text.empty() && text.size() <= 32 ? "" : std::string{"1 to 32 characters are allowed"};
        })
        ->capture_default_str();
    app.add_option("--security", security, "folder with this program's identity (docs/security.md)")
        ->type_name("DIR")
        ->check(CLI::ExistingDirectory);
    wire::add_network_options(app, network);
}

wire::JoinOptions SessionOptions::session() const {
    return {.domain = domain,
            .partition = wire::exercise_partition(partition),
            .name = name,
            .security = security,
            .network = network};
}

std::vector<std::string> SessionOptions::arguments() const {
    std::vector<std::string> list{"--domain", std::to_string(domain)};
    if (!security.empty()) list.insert(list.end(), {"--security", security.string()});
    if (network.lan) list.emplace_back("--lan");
    if (!network.discovery_server.empty())
        list.insert(list.end(), {"--discovery-server", network.discovery_server});
    return list;
}

std::optional<int> parse(CLI::App& app, int argc, char** argv) {
    std::signal(SIGPIPE, SIG_IGN);
    try {
        app.parse(argc, argv);
        return std::nullopt;
    } catch (const CLI::ParseError& error) {
        return leave(app.exit(error) == 0 ? kOk : kBadOption);
    }
}

void catch_stop_signals() {
    const auto stop = [](int signal) { stop_signal = signal; };
    std::signal(SIGINT, stop);
    std::signal(SIGTERM, stop);
}

bool stop_asked() {
    return stop_signal != 0 || !std::cout;
}

int leave(int code) {
    if (std::cout.flush() || code != kOk) return code;
    std::cerr << "nobody reads the output\n";
    return kFailed;
}

} // namespace windlass::station
