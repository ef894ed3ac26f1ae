// What an instructor's station does with files: recordings are made, shown, talked over, gone on from;
// exercises are read and saved.

#include "station/gateway/admission.hpp"
#include "station/gateway/gateway.hpp"
#include "station/gateway/page_session.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace windlass::gateway {

using nlohmann::json;
using namespace std::chrono_literals;

namespace {

constexpr auto kDiscovery = 5s; // until an exercise that has just been joined is heard
constexpr std::size_t kReadings = 4;
constexpr int kRecorders = 4; // that one recording may lose, less one

Refused no_instructor(const char* what) {
    return {"", "", what, "for an instructor"};
}

} // namespace

void Gateway::record(const std::string& exercise, bool on, const std::string& wanted) {
    if (options_.seat != station::Seat::instructor || !recorders_) throw no_instructor("a recorder");
    const auto running = recordings_.find(exercise);
    if (!on) {
        if (running == recordings_.end()) throw Refused("", "on", "false", "nothing is recorded here");
        recorders_->end(exercise);
        running->second.stopping = true;
        return;
    }
    if (running != recordings_.end()) throw Refused("", "on", "true", "it is recorded already");
    const std::string name = wanted.empty()
                                 ? fmt::format("{}-{}", exercise,
                                               std::chrono::duration_cast<std::chrono::seconds>(
                                                   std::chrono::system_clock::now().time_since_epoch())
                                                   .count())
                                 : wanted;
    begin_recording(exercise, {.asked_as = name, .name = name});
    tell_news();
}

void Gateway::begin_recording(const std::string& exercise, const Recording& recording) {
    if (!wire::is_exercise_name(recording.name) || recording.name.starts_with('.'))
        throw Refused("", "name", "this name", "1 to 64 letters, digits, dashes, underscores and dots");
    const auto folder = options_.recordings / recording.name;
    if (std::filesystem::exists(folder))
        throw Refused("", "name", recording.name, "a name that no recording has yet");
    try {
        std::filesystem::create_directories(options_.recordings);
        recorders_->begin(exercise, folder);
    } catch (const std::exception& error) {
        throw Refused("", "name", recording.name, error.what());
    }
    recordings_[exercise] = recording;
    log("recording exercise " + exercise + " into " + folder.string());
}

std::optional<std::string> Gateway::recording_of(const std::string& exercise) const {
    const auto running = recordings_.find(exercise);
    return running == recordings_.end() ? std::nullopt : std::optional(running->second.name);
}

void Gateway::tend_recorders() {
    if (!recorders_) return;
    for (const Recorders::Ended& each : recorders_->ended()) {
        const auto at = recordings_.find(each.exercise);
        if (at == recordings_.end()) continue;
        Recording was = at->second;
        recordings_.erase(at);
        log((was.stopping ? "recorded " : "the recorder ended by itself: ") + was.name);
        if (std::filesystem::exists(options_.recordings / was.name)) // something was heard
            recorded_[each.exercise] = was.name;
        if (each.with_its_process && !was.stopping && was.recorders < kRecorders)
            record_on(each.exercise, was);
    }
}

/// What came to an end with its recorder goes on as another recording: what was between is in neither.
void Gateway::record_on(const std::string& exercise, const Recording& was) {
    const int recorders = was.recorders + 1;
    try {
        begin_recording(exercise, {.asked_as = was.asked_as,
                                   .name = fmt::format("{}-{}", was.asked_as, recorders),
                                   .recorders = recorders});
    } catch (const Refused& refusal) {
        log("exercise " + exercise + " is recorded no more: " + refusal.what());
    }
}

void Gateway::continue_live(PageSession& page, const json& id, const std::string& recording, double position,
                            const std::string& exercise) {
    if (options_.seat != station::Seat::instructor) throw no_instructor("continuing a recording");
    continue_in(exercise, recording, position);
    continuations_.back().page = &page;
    continuations_.back().id = id;
}

void Gateway::continue_in(const std::string& exercise, const std::string& recording, double position,
                          std::function<void(const Refused&)> refused) {
    if (!options_.state_at) throw no_instructor("continuing a recording");
    if (!wire::is_exercise_name(exercise)) throw Refused("", "exercise", "this name", "an exercise's name");
    const auto folder = folder_of(recording);
    if (!can_continue()) throw Refused("", "recording", recording, "one after the other");
    continuations_.push_back({.state = std::async(std::launch::async, options_.state_at, folder, position),
                              .sample = {},
                              .desk = desk(exercise),
                              .page = nullptr,
                              .id = {},
                              .refused = std::move(refused),
                              .until = {}});
}

std::filesystem::path Gateway::folder_of(const std::string& recording) const {
    if (!wire::is_exercise_name(recording) || recording.starts_with('.') ||
        !std::filesystem::exists(options_.recordings / recording))
        throw Refused("", "recording", "this name", "a recording in " + options_.recordings.string());
    return options_.recordings / recording;
}

void Gateway::read_events(PageSession& page, const json& id, const std::string& recording) {
    if (!may_replay(options_.seat) || !options_.events_of || !options_.past_of)
        throw no_instructor("a recording's events");
    const auto folder = folder_of(recording);
    read({.made = std::async(std::launch::async,
                             [events_of = options_.events_of, past_of = options_.past_of, folder] {
                                 return json{{"events", events_of(folder)}, {"past", past_of(folder)}};
                             }),
          .message =
              [recording](json found) {
                  found["op"] = "recording_events";
                  found["recording"] = recording;
                  return found;
              },
          .field = "recording",
          .value = recording,
          .page = &page,
          .id = id});
}

void Gateway::debrief(PageSession& page, const json& id, const std::string& recording) {
    if (options_.seat != station::Seat::instructor || !options_.debrief_of || !options_.what_if_of ||
        !options_.publish)
        throw no_instructor("a debriefing");
    const auto folder = folder_of(recording);
    // Nobody finds the page but who asked for it: it is served by a name that cannot be guessed.
    auto& path = debriefs_[recording];
    if (path.empty()) path = "/debrief-" + make_token();
    const std::string what_if = path + "-what-if";
    options_.publish(what_if, [make = options_.what_if_of, folder] { return make(folder); });
    read({.made = std::async(std::launch::async, [make = options_.debrief_of, folder,
                                                  what_if] { return json(make(folder, what_if)); }),
          .message =
              [this, recording, path](json html) {
                  options_.publish(path, [page = html.get<std::string>()] { return page; });
                  return json{{"op", "debrief"}, {"recording", recording}, {"address", path}};
              },
          .field = "recording",
          .value = recording,
          .page = &page,
          .id = id});
}

void Gateway::ask_exercise_files(PageSession& page, const json& id, const json& request) {
    if (options_.seat != station::Seat::instructor || !options_.exercise_files)
        throw no_instructor("the exercises' files");
    const auto name = request.at("name").get<std::string>();
    read({.made = std::async(std::launch::async, options_.exercise_files, request),
          .message =
              [](json answer) {
                  answer["op"] = "exercise_files";
                  return answer;
              },
          .field = "name",
          .value = wire::is_exercise_name(name) ? name : "this name",
          .page = &page,
          .id = id});
}

void Gateway::read(Reading reading) {
    if (readings_.size() >= kReadings) throw Refused("", reading.field, reading.value, "one after the other");
    readings_.push_back(std::move(reading));
}

bool Gateway::show(Reading& reading) {
    if (reading.made.wait_for(0s) != std::future_status::ready) return false;
    try {
        const json message = reading.message(reading.made.get());
        if (reading.page != nullptr) reading.page->tell(reading.id, message);
    } catch (const std::exception& error) {
        if (reading.page != nullptr)
            reading.page->tell_refused(reading.id, Refused("", reading.field, reading.value, error.what()));
    }
    return true;
}

std::string Gateway::replay(const std::string& recording) {
    if (!options_.replays || !may_replay(options_.seat))
        throw Refused("", "", "a replay", "for an instructor or an assessor");
    return options_.replays->show(folder_of(recording));
}

bool Gateway::go_on(Continuation& each, Clock::time_point now) {
    if (!each.sample && each.state.wait_for(0s) != std::future_status::ready) return false;
    const auto refuse = [&](const Refused& refusal) {
        if (each.page != nullptr)
            each.page->tell_refused(each.id, refusal);
        else if (each.refused)
            each.refused(refusal);
        else
            log(refusal.what());
        return true;
    };
    if (!each.sample) {
        try {
            each.sample = each.state.get();
        } catch (const std::exception& error) {
            return refuse(Refused("", "recording", "this moment of it", error.what()));
        }
        each.until = now + kDiscovery;
    }
    try {
        each.desk->give(wire::topics::restore_command, *each.sample);
    } catch (const Refused& refusal) {
        if (now < each.until) return false;
        return refuse(refusal);
    }
    if (each.page != nullptr) each.page->tell_sent(each.id);
    return true;
}

} // namespace windlass::gateway
