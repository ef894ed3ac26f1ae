// recorder info: what is in a recording, and whether all of it is.

#include "recorder/command.hpp"
#include "recorder/info/figures.hpp"
#include "station/format.hpp"
#include "station/line_view.hpp"
#include "station/names.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <iostream>

namespace windlass::recorder {

namespace {

using nlohmann::ordered_json;
using recording::Recording;

struct InfoOptions {
    std::vector<std::filesystem::path> paths;
    bool as_json = false;
};

std::uint64_t bytes_of(const Recording& recording) {
    std::uint64_t bytes = 0;
    for (const auto& file : recording.files())
        bytes += file->size();
    return bytes;
}

/// Entries of the metadata of that name, later files over earlier ones.
mcap::Strings metadata_of(const Recording& recording, const std::string& name) {
    mcap::Strings all;
    for (const auto& file : recording.files())
        for (const auto& metadata : file->metadata())
            if (metadata.name == name)
                for (const auto& [key, value] : metadata.entries)
                    all[key] = value;
    return all;
}

std::set<std::string> attachments_of(const Recording& recording) {
    std::set<std::string> names;
    for (const auto& file : recording.files())
        for (const auto& attachment : file->attachments())
            names.insert(attachment.name);
    return names;
}

void print_text(const Recording& recording, const Figures& figures) {
    fmt::print("{}: {:.1f} s, {} messages in {} file{}, {} chunks, {:.1f} MB\n", recording.name(),
               recording.seconds(), figures.messages, recording.files().size(),
               recording.files().size() == 1 ? "" : "s", recording.chunks(),
               static_cast<double>(bytes_of(recording)) * 1e-6);
    for (const char* name : {"windlass.recording", "windlass.closing"})
        for (const auto& [key, value] : metadata_of(recording, name))
            fmt::print("  {:12} {}\n", key, value);
    for (const auto& name : attachments_of(recording))
        fmt::print("  {:12} {}\n", "attached", name);

    fmt::print("\n{:25} {:>9} {:>8} {:>9} {:>7} {:>8} {:>9} {:>6}   {}\n", "topic", "messages", "rate Hz",
               "mean byte", "writers", "gap s", "gap at s", "lost", "latency ms p50 / p99 / max");
    for (const auto& topic : figures.topics) {
        fmt::print("{:25} {:>9} {:>8.1f} {:>9} {:>7} {:>8.3f} {:>9.1f} {:>6}   {:.3f} / {:.3f} / {:.3f}\n",
                   topic.topic, topic.messages, topic.rate(), topic.bytes / topic.messages,
                   topic.writers.size(), topic.largest_gap, topic.largest_gap_at, topic.lost,
                   topic.latency_at(0.5) * 1e3, topic.latency_at(0.99) * 1e3, topic.latency_at(1) * 1e3);
    }
    if (!figures.events.empty()) fmt::print("\nevents, by exercise time\n");
    for (const auto& event : figures.events)
        fmt::print("  {:>7}  {:24} {}\n", station::clock(event.time()), event.code().c_str(),
                   station::told(event));
}

void print_json(const Recording& recording, const Figures& figures) {
    ordered_json topics = ordered_json::array();
    for (const auto& topic : figures.topics) {
        topics.push_back({{"topic", topic.topic},
                          {"type", topic.type},
                          {"messages", topic.messages},
                          {"rate_hz", topic.rate()},
                          {"bytes", topic.bytes},
                          {"writers", topic.writers},
                          {"first_s", topic.first},
                          {"last_s", topic.last},
                          {"largest_gap_s", topic.largest_gap},
                          {"largest_gap_at_s", topic.largest_gap_at},
                          {"lost", topic.lost},
                          {"latency_s",
                           {{"p50", topic.latency_at(0.5)},
                            {"p99", topic.latency_at(0.99)},
                            {"max", topic.latency_at(1)}}}});
    }
    ordered_json events = ordered_json::array();
    for (const auto& event : figures.events)
        events.push_back({{"time", event.time()},
                          {"code", event.code().to_string()},
                          {"severity", station::name(event.severity())},
                          {"side", station::side_name(event.side())},
                          {"value", event.value()},
                          {"text", event.text().to_string()}});
    const ordered_json all{{"name", recording.name()},
                           {"duration_s", recording.seconds()},
                           {"messages", figures.messages},
                           {"files", recording.files().size()},
                           {"chunks", recording.chunks()},
                           {"bytes", bytes_of(recording)},
                           {"damage", recording.damage()},
                           {"recording", metadata_of(recording, "windlass.recording")},
                           {"closing", metadata_of(recording, "windlass.closing")},
                           {"attachments", attachments_of(recording)},
                           {"topics", topics},
                           {"events", events}};
    std::cout << all.dump(2, ' ', false, ordered_json::error_handler_t::replace) << std::endl;
}

int info(const InfoOptions& options) {
    Recording recording(options.paths);
    const Figures figures = figures_of(recording);
    if (options.as_json)
        print_json(recording, figures);
    else
        print_text(recording, figures);
    std::fflush(stdout);
    for (const auto& damage : recording.damage())
        tell(damage);
    return recording.damage().empty() ? kOk : kDamaged;
}

} // namespace

void add_info(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<InfoOptions>();
    CLI::App& sub = *app.add_subcommand("info", "topics, counts, rates, gaps, latencies and events");
    sub.add_option("recording", options->paths, "folder of a recording, or its MCAP files")->required();
    sub.add_flag("--json", options->as_json, "as one JSON object");
    sub.footer(
        "gap: longest time without a message of the topic, and where it begins. lost: samples whose\n"
        "numbers are missing. latency: from the writer's write() to the recorder.\n"
        "Exit codes: 0 all could be read, 1 failed, 2 bad option, 3 damaged: what could be read is told.");
    sub.callback([&chosen, options] { chosen = [options] { return info(*options); }; });
}

} // namespace windlass::recorder
