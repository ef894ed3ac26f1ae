#include "station/gateway/recorders.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace windlass::gateway {

using nlohmann::json;

Recorders::Recorders(std::filesystem::path program, std::vector<std::string> arguments)
    : program_(std::move(program)), arguments_(std::move(arguments)) {
    arguments_.insert(arguments_.begin(), "record-many");
}

void Recorders::begin(const std::string& exercise, const std::filesystem::path& folder) {
    const auto has_room = std::ranges::find_if(all_, [](const Recorder& each) {
        return !each.leaving && !each.process->ended() && each.exercises.size() < kExercisesEach;
    });
    Recorder& recorder = has_room != all_.end() ? *has_room
                                                : all_.emplace_back(std::make_unique<RecorderProcess>(
                                                      program_, arguments_, RecorderProcess::Stdio::ours));
    recorder.process->tell(json{{"record", exercise}, {"output", folder.string()}}.dump());
    recorder.exercises.insert(exercise);
}

void Recorders::end(const std::string& exercise) {
    for (const Recorder& each : all_)
        if (each.exercises.contains(exercise)) each.process->tell(json{{"end", exercise}}.dump());
}

std::vector<Recorders::Ended> Recorders::ended() {
    std::vector<Ended> ended;
    for (Recorder& each : all_) {
        const bool lost = each.process->ended(); // before what it has told is read: nothing comes behind it
        for (const std::string& line : each.process->told()) {
            const json word = json::parse(line, nullptr, false);
            if (!word.is_object() || !word.contains("ended") || !word["ended"].is_string()) continue;
            const auto exercise = word["ended"].get<std::string>();
            if (each.exercises.erase(exercise) > 0) ended.push_back({exercise});
        }
        if (lost)
            for (const std::string& exercise : std::exchange(each.exercises, {}))
                ended.push_back({exercise, true});
        if (each.exercises.empty() && !std::exchange(each.leaving, true)) each.process->stop();
    }
    std::erase_if(all_, [](const Recorder& each) { return each.leaving && each.process->ended(); });
    return ended;
}

} // namespace windlass::gateway
