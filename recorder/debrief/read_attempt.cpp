#include "recorder/debrief/read_attempt.hpp"

#include "recorder/debrief/attempt_reader.hpp"
#include "recorder/debrief/lesson_text.hpp"
#include "recorder/recording/sha256.hpp"
#include "recorder/recording/typed.hpp"

#include "idl/topics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace windlass::debrief {

namespace topics = wire::topics;
using recording::Nanoseconds;
using recording::Recording;

namespace {

/// One course of the exercise, by its ExerciseStatus.
struct Course {
    std::vector<std::uint64_t> runs; ///< several, where its server was lost on the way
    Nanoseconds first = 0;           ///< log_time of its first status
    std::vector<std::pair<Nanoseconds, ExerciseStatus>> statuses;
};

std::vector<Course> courses_of(Recording& recording) {
    std::vector<Course> courses;
    auto cursor = recording.messages({.topics = {topics::exercise_status.name}});
    while (const auto message = cursor.next()) {
        try {
            auto status = recording::decode<ExerciseStatus>(message->payload);
            if (courses.empty() || courses.back().runs.back() != status.run())
                courses.push_back({{status.run()}, message->log_time, {}});
            courses.back().statuses.emplace_back(message->log_time, std::move(status));
        } catch (const mcap::Damage&) {
            continue; // told by the second reading
        }
    }
    return courses;
}

/// When an exercise was taken up again after its server was lost.
std::vector<Nanoseconds> taken_up_at(Recording& recording) {
    std::vector<Nanoseconds> times;
    auto cursor = recording.messages({.topics = {topics::event.name}});
    while (const auto message = cursor.next()) {
        try {
            if (recording::decode<Event>(message->payload).code() == "exercise.taken_up")
                times.push_back(message->log_time);
        } catch (const mcap::Damage&) {
            continue;
        }
    }
    return times;
}

/// A run that was taken up goes on with the one before it: told between the last status of the one and the
/// second of the other.
std::vector<Course> joined(std::vector<Course> courses, const std::vector<Nanoseconds>& taken_up) {
    std::vector<Course> all;
    for (Course& course : courses) {
        const Nanoseconds second = course.statuses.at(course.statuses.size() > 1 ? 1 : 0).first;
        const bool goes_on = !all.empty() && std::ranges::any_of(taken_up, [&](Nanoseconds time) {
            return time >= all.back().statuses.back().first && time <= second;
        });
        if (!goes_on) {
            all.push_back(std::move(course));
            continue;
        }
        std::ranges::copy(course.runs, std::back_inserter(all.back().runs));
        std::ranges::move(course.statuses, std::back_inserter(all.back().statuses));
    }
    return all;
}

std::string said_by_recorder(const Recording& recording, const std::string& key) {
    for (const auto& file : recording.files())
        for (const auto& metadata : file->metadata())
            if (metadata.name == "windlass.recording" && metadata.entries.contains(key))
                return metadata.entries.at(key);
    return {};
}

Origin origin_of(const Recording& recording, const Course& course, std::size_t runs) {
    std::vector<std::filesystem::path> files;
    for (const auto& file : recording.files())
        files.push_back(file->path());
    return {.recording = recording.name(),
            .sha256 = recording::sha256(files),
            .run = course.runs.back(),
            .taken_up_from = {course.runs.begin(), course.runs.end() - 1},
            .runs = runs,
            .began_unix_ns = course.first,
            .recording_began_unix_ns = recording.start(),
            .recorder_version = said_by_recorder(recording, "recorder"),
            .complete = true};
}

void take_statuses(const Course& course, Nanoseconds start, Attempt& attempt) {
    const auto& last = course.statuses.back().second;
    attempt.exercise = last.exercise().to_string();
    attempt.title = last.title().to_string();
    attempt.began = course.statuses.front().second.time();
    for (const auto& [log_time, status] : course.statuses) {
        if (!attempt.positions.empty() && status.time() < attempt.positions.back().first) continue;
        attempt.positions.emplace_back(status.time(), static_cast<double>(log_time - start) * 1e-9);
        attempt.ended = status.time();
        if (status.state() != RUN_REPLAY) attempt.state = status.state();
        if (status.tick() > 0) attempt.dt = status.time() / static_cast<double>(status.tick());
    }
}

} // namespace

Attempt read_attempt(Recording& recording, std::size_t run) {
    const auto courses = joined(courses_of(recording), taken_up_at(recording));
    if (courses.empty())
        throw std::runtime_error(recording.name() + " has no state of an exercise (topic ExerciseStatus)");
    if (run > courses.size())
        throw std::runtime_error(fmt::format("{} has {} run{}: there is no run {}", recording.name(),
                                             courses.size(), courses.size() == 1 ? "" : "s", run));
    const std::size_t chosen = run == 0 ? courses.size() - 1 : run - 1;
    const Course& course = courses[chosen];
    Attempt attempt;
    attempt.origin = origin_of(recording, course, courses.size());
    take_statuses(course, recording.start(), attempt);
    attempt.lesson = lesson_text(recording);

    const Nanoseconds from = chosen == 0 ? recording.start() : course.first;
    recording::Query query;
    query.topics = AttemptReader::topics();
    if (chosen + 1 < courses.size()) query.until = courses[chosen + 1].first;
    AttemptReader reader(attempt, AttemptReader::interval_of(attempt));
    auto cursor = recording.messages(query);
    while (const auto message = cursor.next())
        if (!reader.read(*message, message->log_time >= from)) attempt.origin.complete = false;
    reader.finish();
    if (!recording.damage().empty()) attempt.origin.complete = false;
    return attempt;
}

} // namespace windlass::debrief
