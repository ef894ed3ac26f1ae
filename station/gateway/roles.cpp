#include "station/gateway/roles.hpp"

#include <algorithm>

namespace windlass::gateway {

namespace {

namespace topics = wire::topics;
using station::Seat;

Topics seat_hears(Seat seat) {
    Topics list{&topics::exercise_status,
                &topics::bridge_order,
                &topics::seat_assessment,
                &topics::scene_description,
                &topics::landmarks,
                &topics::daylight,
                &topics::lights_and_shapes,
                &topics::sea_state,
                &topics::replay_status,
                &topics::windlass_command,
                &topics::instructor_windlass_command,
                &topics::helm_command,
                &topics::instructor_helm_command};
    if (on_forecastle(seat))
        list.insert(list.end(), {&topics::forecastle_view, &topics::forecastle_event,
                                 &topics::forecastle_alert, &topics::forecastle_instruction,
                                 &topics::forecastle_question, &topics::forecastle_ghost});
    if (on_bridge(seat))
        list.insert(list.end(), {&topics::bridge_view, &topics::bridge_event, &topics::alert,
                                 &topics::bridge_instruction, &topics::bridge_question, &topics::bridge_ghost,
                                 &topics::forecastle_camera, &topics::chart, &topics::report});
    return list;
}

bool among(const Topics& list, const wire::TopicInfo& topic) {
    return std::ranges::any_of(list,
                               [&](const auto* each) { return std::string_view(each->name) == topic.name; });
}

/// What those who have the truth hear, and the seats in a replay.
Topics everything() {
    Topics list;
    for (const wire::TopicInfo& topic : topics::all)
        if (topic.name != std::string_view(topics::checkpoint.name)) list.push_back(&topic);
    return list;
}

/// The same without the commands, but levers and reports.
Topics what_is_seen() {
    static const Topics kCommands{&topics::own_ship_input,      &topics::exercise_command,
                                  &topics::environment_command, &topics::restore_command,
                                  &topics::fault_command,       &topics::bridge_order_command,
                                  &topics::watch_circle,        &topics::lights_and_shapes_command,
                                  &topics::deck_work_command,   &topics::forecastle_answer,
                                  &topics::bridge_answer,       &topics::alert_command,
                                  &topics::assessment_command,  &topics::replay_command};
    Topics list = everything();
    std::erase_if(list, [](const auto* topic) { return among(kCommands, *topic); });
    return list;
}

Topics seat_writes(Seat seat, bool in_replay) {
    switch (seat) {
    case Seat::forecastle:
        return {&topics::windlass_command, &topics::report, &topics::deck_work_command,
                &topics::forecastle_answer, &topics::alert_command};
    case Seat::conning:
        return {&topics::helm_command,  &topics::bridge_order_command,
                &topics::watch_circle,  &topics::lights_and_shapes_command,
                &topics::bridge_answer, &topics::alert_command};
    case Seat::trainee:
    case Seat::coach:
        return {&topics::windlass_command,  &topics::helm_command,  &topics::report,
                &topics::deck_work_command, &topics::watch_circle,  &topics::lights_and_shapes_command,
                &topics::forecastle_answer, &topics::bridge_answer, &topics::alert_command};
    case Seat::watcher:
    case Seat::observer:
        return {};
    case Seat::assessor:
        if (in_replay) return {&topics::assessment_command, &topics::replay_command};
        return {&topics::assessment_command};
    case Seat::instructor:
        break;
    }
    return {&topics::instructor_windlass_command,
            &topics::instructor_helm_command,
            &topics::exercise_command,
            &topics::environment_command,
            &topics::restore_command,
            &topics::fault_command,
            &topics::report,
            &topics::bridge_order_command,
            &topics::watch_circle,
            &topics::lights_and_shapes_command,
            &topics::deck_work_command,
            &topics::alert_command,
            &topics::assessment_command,
            &topics::replay_command};
}

const char* name_of(Seat seat) {
    switch (seat) {
    case Seat::forecastle:
        return "forecastle";
    case Seat::conning:
        return "conning";
    case Seat::trainee:
        return "trainee";
    case Seat::watcher:
        return "watcher";
    case Seat::coach:
        return "coach";
    case Seat::observer:
        return "observer";
    case Seat::assessor:
        return "assessor";
    case Seat::instructor:
        return "instructor";
    }
    return "";
}

std::vector<std::string> pages_of(Seat seat) {
    if (seat == Seat::instructor) return {"instructor", "classroom", "lessons"};
    if (seat == Seat::observer || seat == Seat::assessor) return {"instructor", "classroom"};
    std::vector<std::string> pages;
    if (on_forecastle(seat)) pages.emplace_back("forecastle");
    if (on_bridge(seat)) pages.insert(pages.end(), {"bridge", "watch"});
    return pages;
}

Topics hears(Seat seat, bool in_replay) {
    if (seat == Seat::instructor) return everything();
    if (seat == Seat::observer || seat == Seat::assessor) return what_is_seen();
    return in_replay ? everything() : seat_hears(seat);
}

} // namespace

Role role_of(Seat seat, const std::string& exercise) {
    const bool instructor = seat == Seat::instructor, in_replay = exercise.starts_with("replay");
    Role role{.name = name_of(seat),
              .hears = hears(seat, in_replay),
              .writes = seat_writes(seat, in_replay),
              .classroom_hears = {&topics::classroom_status},
              .classroom_writes = {},
              .pages = pages_of(seat)};
    if (instructor || seat == Seat::observer || seat == Seat::assessor)
        role.classroom_hears.push_back(&topics::event);
    if (instructor) role.classroom_writes.push_back(&topics::classroom_command);
    return role;
}

bool may_replay(Seat seat) {
    return among(seat_writes(seat, true), topics::replay_command);
}

const wire::TopicInfo* find_topic(const std::string& name) {
    const auto named = [&name](const wire::TopicInfo& topic) { return name == topic.name; };
    if (const auto found = std::ranges::find_if(topics::all, named); found != topics::all.end())
        return &*found;
    const auto found = std::ranges::find_if(topics::classroom, named);
    return found != topics::classroom.end() ? &*found : nullptr;
}

bool is_lever_topic(const wire::TopicInfo& topic) {
    return topic.exclusive;
}

} // namespace windlass::gateway
