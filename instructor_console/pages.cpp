#include "instructor_console/pages.hpp"

#include "instructor_console/debrief_page.hpp"
#include "instructor_console/exercise_files.hpp"
#include "instructor_console/orders.hpp"
#include "instructor_console/recording_events.hpp"
#include "instructor_console/recording_position.hpp"

#include <nlohmann/json.hpp>

namespace windlass::console {

using nlohmann::json;

gateway::GatewayOptions instructor_pages(const station::SessionOptions& session,
                                         const std::filesystem::path& recordings,
                                         const std::filesystem::path& exercises) {
    gateway::GatewayOptions wanted;
    wanted.member = session.session();
    wanted.seat = station::Seat::instructor;
    wanted.exercise = session.partition;
    wanted.recorder = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "recorder";
    if (!std::filesystem::exists(wanted.recorder)) wanted.recorder.clear();
    wanted.recorder_arguments = session.arguments();
    wanted.recordings = recordings;
    wanted.config_root = (std::filesystem::absolute(exercises) / "..").lexically_normal();
    wanted.state_at = [](const std::filesystem::path& recording, double position) {
        const auto order = restore_order_at(recording, position);
        const auto& octets = order.sample.checkpoint();
        return json{{"from", order.sample.from().to_string()},
                    {"checkpoint", std::string(octets.begin(), octets.end())}};
    };
    wanted.events_of = events_of;
    wanted.past_of = past_of;
    wanted.debrief_of = [config = wanted.config_root](const std::filesystem::path& recording,
                                                      const std::string& what_if) {
        return debrief_page(recording, config, what_if);
    };
    wanted.what_if_of = [pages = std::make_shared<WhatIfPages>(wanted.config_root)](
                            const std::filesystem::path& recording) { return pages->page(recording); };
    wanted.exercise_files = [files = std::make_shared<ExerciseFiles>(exercises)](const json& request) {
        return files->answer(request);
    };
    return wanted;
}

} // namespace windlass::console
