#include "door/class_runs.hpp"

#include "door/marks_so_far.hpp"
#include "idl/payload.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace windlass::door {

using namespace std::chrono_literals;

namespace {

constexpr auto kAgain = 30s;      // one that begins at anchor is played there first
constexpr auto kTakesUp = 10s;    // for which a server that is started again may be at what it has kept
constexpr auto kEnds = 10s;       // for which a class that is over waits for an exercise to end
constexpr std::size_t kAsked = 8; // at a time: a server lets 16 wait

constexpr std::size_t kWaiting = 16; // orders, for an exercise that is not there yet

/// It has not begun: nobody has started it, and it goes on from nowhere.
bool is_ready(const ClassroomExercise& exercise) {
    return exercise.state() == RUN_READY;
}

} // namespace

void ClassRuns::give(const std::vector<std::string>& exercises, const wire::TopicInfo& topic,
                     const nlohmann::json& sample, const std::string& by) {
    try {
        gateway::encode_order(topic, sample, {.source = by});
    } catch (const gateway::Refused& refusal) {
        throw Denied(400, refusal.what());
    }
    for (const std::string& exercise : exercises)
        if (const auto waiting = given_.find(exercise);
            waiting != given_.end() && waiting->second.size() >= kWaiting)
            throw Denied(409, "exercise " + exercise + " is not there yet, and enough waits for it");
    for (const std::string& exercise : exercises)
        given_[exercise].push_back({&topic, sample, by});
}

void ClassRuns::remove(const std::vector<std::string>& exercises, const std::string& by) {
    for (const std::string& exercise : exercises) {
        to_be_removed_[exercise] = {};
        given_[exercise] = {{&wire::topics::exercise_command, {{"action", "EXERCISE_STOP"}}, by}};
    }
}

std::optional<ClassroomExercise> ClassRuns::told(const std::string& exercise) const {
    const auto found = found_.find(exercise);
    return found == found_.end() ? std::nullopt : std::optional(found->second.exercise);
}

std::optional<ClassroomExercise> ClassRuns::lost(const std::string& exercise) const {
    const auto awaited = awaited_.find(exercise);
    const bool was_there = awaited != awaited_.end() && awaited->second.there != gateway::Clock::time_point{};
    if (!was_there || found_.contains(exercise) || asked_.contains(exercise)) return std::nullopt;
    return awaited->second.last;
}

ClassRuns::Desk::Desk(const gateway::SharedReaders& readers, const std::string& exercise)
    : feed{readers,
           wire::exercise_partition(exercise),
           gateway::Feed::Kind::exercise,
           {&wire::topics::exercise_status, &wire::topics::assessment, &wire::topics::event}},
      orders{feed.participant(),
             {&wire::topics::exercise_command, &wire::topics::fault_command,
              &wire::topics::bridge_order_command},
             "door"} {}

void ClassRuns::listen(gateway::Clock::time_point now) {
    servers_ = instructor_.servers();
    std::set<std::string> heard;
    for (const ClassroomStatus& server : servers_)
        heard.insert(server.server().to_string());
    if (!std::ranges::includes(heard_servers_, heard)) newest_server_ = now;
    heard_servers_ = std::move(heard);
    found_.clear();
    for (const ClassroomStatus& server : servers_)
        for (const ClassroomExercise& each : server.exercises())
            found_[each.id().to_string()] = {server.server().to_string(), each};
    std::erase_if(stood_, [&](const auto& each) { return !found_.contains(each.first); });
    for (const auto& [id, found] : found_)
        if (found.exercise.state() != RUN_RUNNING || !stood_.contains(id)) stood_[id] = now;
}

double ClassRuns::ran_for(const std::string& exercise, gateway::Clock::time_point now) const {
    const auto found = stood_.find(exercise);
    return found == stood_.end() ? 0 : std::chrono::duration<double>(now - found->second).count();
}

Result ClassRuns::result(const std::string& exercise) const {
    const auto found = recordings_.find(exercise);
    Result result{.recording = found == recordings_.end() ? std::string() : found->second};
    const auto desk = desks_.find(exercise);
    if (desk == desks_.end()) return result;
    for (const gateway::FramePtr& frame : desk->second->feed.kept(wire::topics::assessment)) {
        try {
            const auto heard = wire::decode<Assessment>(frame->payload);
            if (heard.finished())
                result.points = heard.score();
            else if (const auto marks = marks_so_far(heard))
                result.points = marks->points, result.lost = marks->lost;
            result.pass = heard.pass();
            result.outcome = heard.finished() && heard.practice() ? "practice" : heard.outcome().to_string();
            // That somebody ended it, or its class, who looks at the class has seen or done.
            result.abort = heard.ending() == LESSON_ENDED_EARLY ? std::string() : heard.abort().to_string();
        } catch (const std::exception&) {
            continue; // of a writer that is no server of ours
        }
    }
    return result;
}

void ClassRuns::look_back(const std::string& exercise, const std::function<bool(const Event&)>& look) const {
    static const std::set<std::string> kBegins{"exercise.loaded", "exercise.reset", "exercise.restored"};
    const auto desk = desks_.find(exercise);
    if (desk == desks_.end()) return;
    const auto events = desk->second->feed.kept(wire::topics::event);
    for (auto frame = events.rbegin(); frame != events.rend(); ++frame) {
        try {
            const auto heard = wire::decode<Event>((*frame)->payload);
            if (kBegins.contains(heard.code().to_string()) || !look(heard)) return;
        } catch (const std::exception&) {
            continue; // of a writer that is no server of ours
        }
    }
}

std::optional<Asking> ClassRuns::asking(const std::string& exercise) const {
    std::optional<Asking> asks;
    look_back(exercise, [&](const Event& event) {
        const bool misled = event.code() == "assessment.misled";
        if (misled || event.code() == "assessment.unanswered") {
            if (!asks) asks = Asking{.since = 0, .gives_up = event.value()};
            asks->since = event.time();
            asks->misled = asks->misled || misled;
        }
        return event.code() != "assessment.answered" && event.code() != "lesson.over";
    });
    return asks;
}

bool ClassRuns::holds_for_a_question(const std::string& exercise) const {
    static const std::set<std::string> kElse{"exercise.paused", "exercise.resumed", "exercise.started",
                                             "exercise.taken_up", "lesson.over"};
    bool holds = false;
    look_back(exercise, [&](const Event& event) {
        holds = event.code() == "exercise.held";
        return !holds && !kElse.contains(event.code().to_string());
    });
    return holds;
}

/// From when somebody sits there: so the recorder hears before it is started.
void ClassRuns::record(const TrainingClass& of, const std::string& exercise) {
    const auto sits = [&](const Trainee& each) { return each.exercise == exercise; };
    if (const auto made = recordings_.find(exercise); made != recordings_.end()) {
        // Another one than was begun, where its recorder was lost.
        if (const auto now = instructor_.recording_of(exercise)) made->second = *now;
        return;
    }
    if (std::ranges::none_of(of.trainees, sits)) return;
    if (!instructor_.recording_of(exercise)) { // else somebody at its desk was faster
        try {
            instructor_.record(exercise, true);
        } catch (const gateway::Refused& refusal) {
            unrecorded_[exercise] = std::string("it is not recorded: ") + refusal.what();
            instructor_.log("exercise " + exercise + ": " + unrecorded_[exercise]);
        }
    }
    recordings_[exercise] =
        instructor_.recording_of(exercise).value_or(""); // asked once, whatever came of it
}

void ClassRuns::tick(const std::vector<TrainingClass>& classes, gateway::Clock::time_point now) {
    listen(now);
    std::set<std::string> wanted;
    for (const auto& [exercise, leaving] : to_be_removed_)
        wanted.insert(exercise);
    for (const TrainingClass& each : classes) {
        if (each.over) continue;
        for (const std::string& exercise : each.exercises) {
            wanted.insert(exercise);
            if (!found_.contains(exercise)) {
                if (!may_be_kept(exercise, now)) create(exercise, each, now);
                continue;
            }
            Awaited& awaited = awaited_[exercise];
            awaited.there = now;
            awaited.last = found_.at(exercise).exercise;
            if (asked_.erase(exercise) > 0) hindered_.erase(exercise); // it is made
            if (!desks_.contains(exercise)) desks_[exercise] = std::make_unique<Desk>(readers_, exercise);
            if (each.from && is_ready(found_.at(exercise).exercise))
                go_on(*each.from, exercise, now);
            else
                hindered_.erase(exercise);
            record(each, exercise);
        }
    }
    const auto unwanted = [&](const auto& each) { return !wanted.contains(each.first); };
    std::erase_if(desks_, unwanted);
    std::erase_if(asked_, unwanted);
    std::erase_if(awaited_, unwanted);
    std::erase_if(going_on_, unwanted);
    std::erase_if(given_, unwanted);
    std::erase_if(recordings_, unwanted);
    std::erase_if(hindered_, unwanted);
    std::erase_if(unrecorded_, unwanted);
    carry_out();
    remove_asked(now);
}

void ClassRuns::go_on(const Moment& from, const std::string& exercise, gateway::Clock::time_point now) {
    if (const auto asked = going_on_.find(exercise); asked != going_on_.end() && now - asked->second < kAgain)
        return;
    if (!instructor_.can_continue()) return;
    try {
        instructor_.continue_in(
            exercise, from.recording, from.position,
            [this, exercise](const gateway::Refused& why) { hinder(exercise, why.what()); });
        going_on_[exercise] = now;
    } catch (const gateway::Refused& refusal) {
        hinder(exercise, refusal.what());
    }
}

/// Told in the class, and in the log where it is another reason than before: what is asked is asked again.
void ClassRuns::hinder(const std::string& exercise, const std::string& why) {
    if (std::exchange(hindered_[exercise], why) != why) instructor_.log("exercise " + exercise + ": " + why);
}

std::string ClassRuns::trouble(const std::string& exercise) const {
    for (const auto* each : {&hindered_, &unrecorded_})
        if (const auto found = each->find(exercise); found != each->end()) return found->second;
    return "";
}

bool ClassRuns::at_their_moment(const TrainingClass& of) const {
    return !of.from || std::ranges::all_of(of.manned(), [&](const std::string& exercise) {
        const auto found = found_.find(exercise);
        return found != found_.end() && !is_ready(found->second.exercise);
    });
}

bool ClassRuns::has_ended(const std::string& exercise) const {
    const auto found = found_.find(exercise);
    if (found == found_.end()) return true;
    const RunState state = found->second.exercise.state();
    return state == RUN_FINISHED || state == RUN_STOPPED_BY_FAULT;
}

/// A server that was lost takes up what it has kept when it is started again, and tells of it then. One of
/// that name that another server made meanwhile would give way to it, and end in the trainee's eyes.
bool ClassRuns::may_be_kept(const std::string& exercise, gateway::Clock::time_point now) {
    const Awaited& awaited = awaited_.try_emplace(exercise, Awaited{.since = now}).first->second;
    const bool server_came = newest_server_ >= awaited.since && now - newest_server_ < kTakesUp;
    const bool was_there = awaited.there != gateway::Clock::time_point{} && now - awaited.there < kTakesUp;
    return server_came || was_there;
}

/// On the server that has the fewest, with those that it was asked for.
void ClassRuns::create(const std::string& exercise, const TrainingClass& of, gateway::Clock::time_point now) {
    const auto asked = asked_.find(exercise);
    if (servers_.empty() ||
        (asked == asked_.end() ? asked_.size() >= kAsked : now - asked->second.at < kAgain))
        return;
    if (asked != asked_.end())
        hinder(exercise, fmt::format("server {} was asked for it and has not made it: its log says why",
                                     asked->second.server));
    const auto server = std::ranges::min_element(servers_, {}, [&](const ClassroomStatus& each) {
        return each.exercises().size() +
               static_cast<std::size_t>(std::ranges::count_if(
                   asked_, [&](const auto& one) { return one.second.server == each.server().c_str(); }));
    });
    try {
        instructor_.order_classroom(wire::topics::classroom_command,
                                    {{"action", "CLASSROOM_CREATE"},
                                     {"server", server->server().to_string()},
                                     {"id", exercise},
                                     {"exercise", of.lesson},
                                     {"practice", of.practice},
                                     {"wait", true}},
                                    "door");
        asked_[exercise] = {server->server().to_string(), now};
    } catch (const gateway::Refused& refusal) {
        hinder(exercise, refusal.what());
    }
}

void ClassRuns::carry_out() {
    for (auto& [exercise, waiting] : given_) {
        const auto desk = desks_.find(exercise);
        if (desk == desks_.end()) continue;
        const auto server = desk->second->feed.writer(wire::topics::exercise_status);
        for (; !waiting.empty(); waiting.pop_front()) {
            const auto& [topic, sample, by] = waiting.front();
            if (!server || !desk->second->orders.heard_by(*topic, *server)) break;
            try {
                desk->second->orders.write(*topic, sample, by);
            } catch (const gateway::Refused& refusal) {
                instructor_.log(refusal.what());
            }
        }
    }
    std::erase_if(given_, [](const auto& each) { return each.second.empty(); });
}

/// First it is ended, for which it is marked; then its recording is whole; then it goes.
void ClassRuns::remove_asked(gateway::Clock::time_point now) {
    std::erase_if(to_be_removed_, [&](const auto& each) { return !found_.contains(each.first); });
    for (auto& [exercise, leaving] : to_be_removed_) {
        if (leaving.since == gateway::Clock::time_point{}) leaving.since = now;
        if (!has_ended(exercise) && now - leaving.since < kEnds) continue;
        if (instructor_.recording_of(exercise)) {
            if (!std::exchange(leaving.recorded, true)) instructor_.record(exercise, false);
            continue;
        }
        if (leaving.asked && now - *leaving.asked < kAgain) continue;
        leaving.asked = now;
        try {
            instructor_.order_classroom(
                wire::topics::classroom_command,
                {{"action", "CLASSROOM_REMOVE"}, {"server", found_.at(exercise).server}, {"id", exercise}},
                "door");
        } catch (const gateway::Refused& refusal) {
            instructor_.log(refusal.what());
        }
    }
}

} // namespace windlass::door
