#pragma once
// The exercises of classes: made on servers that have room, recorded, started and paused together, and
// removed.

#include "door/class_book.hpp"
#include "station/gateway/gateway.hpp"

#include <deque>
#include <functional>
#include <set>

namespace windlass::door {

/// A lesson's bridge that has asked in vain; s of exercise.
struct Asking {
    double since = 0;    ///< when it was told first that it has
    double gives_up = 0; ///< and ends the lesson, unless it hears something
    bool misled = false; ///< it was told what is not so since
};

/// What is asked is asked again until it shows: a server that was started late has a class all the same. One
/// thread.
class ClassRuns {
public:
    ClassRuns(gateway::Gateway& instructor, gateway::SharedReaders readers)
        : instructor_{instructor}, readers_{std::move(readers)} {}

    /// An instructor's order to exercises of a class, by somebody's name: a command of the exercise, a
    /// fault, words of the bridge; as encode_order() takes it. Throws Denied where it cannot be such a
    /// sample, and where too many wait for an exercise that no server has yet.
    void give(const std::vector<std::string>& exercises, const wire::TopicInfo& topic,
              const nlohmann::json& sample, const std::string& by);

    /// No class has these any more: they are ended, by somebody's name, and removed.
    void remove(const std::vector<std::string>& exercises, const std::string& by);

    /// Twice a second is enough.
    void tick(const std::vector<TrainingClass>& classes, gateway::Clock::time_point now);

    /// Whether each of a class's exercises in which somebody sits stands at the moment from which it is to go
    /// on; of a class that begins anew they do.
    bool at_their_moment(const TrainingClass& of) const;

    /// It has ended, and is marked; or no server has it.
    bool has_ended(const std::string& exercise) const;

    /// As servers tell it; nothing: there is none of that name yet.
    std::optional<ClassroomExercise> told(const std::string& exercise) const;
    /// As it was told last by a server that is not heard now: it is back with that server, where that one
    /// keeps its exercises. Nothing: it never was there, or is made anew.
    std::optional<ClassroomExercise> lost(const std::string& exercise) const;
    /// What came of an exercise so far, as it was heard last: recording and marks.
    Result result(const std::string& exercise) const;
    /// Why an exercise is not there yet, does not stand at its moment, or is not recorded; empty: nothing is
    /// wrong.
    std::string trouble(const std::string& exercise) const;
    /// What the lesson's bridge waits for in vain; nothing: it waits for no answer.
    std::optional<Asking> asking(const std::string& exercise) const;
    /// Whether an exercise holds for a question to one of its seats.
    bool holds_for_a_question(const std::string& exercise) const;
    /// s of wall time since an exercise was heard to run on from a start or a pause; 0: it does not.
    double ran_for(const std::string& exercise, gateway::Clock::time_point now) const;
    std::size_t servers() const { return servers_.size(); }

private:
    /// An exercise's events since its run began, the newest first, until one of them is enough (false).
    void look_back(const std::string& exercise, const std::function<bool(const Event&)>& look) const;
    /// The way to one exercise.
    struct Desk {
        Desk(const gateway::SharedReaders& readers, const std::string& exercise);
        gateway::Feed feed;
        gateway::OrderWriters orders;
    };
    struct Given {
        const wire::TopicInfo* topic;
        nlohmann::json sample;
        std::string by;
    };
    /// An exercise that no class has any more.
    struct Leaving {
        gateway::Clock::time_point since{};
        bool recorded = false; // its recording is asked to end
        std::optional<gateway::Clock::time_point> asked = {};
    };
    struct Asked {
        std::string server;
        gateway::Clock::time_point at;
    };
    struct Awaited {
        gateway::Clock::time_point since;      // it was first not there
        gateway::Clock::time_point there = {}; // when it was told of last
        ClassroomExercise last = {};           // as it was told then
    };
    struct Found {
        std::string server;
        ClassroomExercise exercise;
    };
    void listen(gateway::Clock::time_point now);
    bool may_be_kept(const std::string& exercise, gateway::Clock::time_point now);
    void record(const TrainingClass& of, const std::string& exercise);
    void go_on(const Moment& from, const std::string& exercise, gateway::Clock::time_point now);
    void create(const std::string& exercise, const TrainingClass& of, gateway::Clock::time_point now);
    void carry_out();
    void remove_asked(gateway::Clock::time_point now);
    void hinder(const std::string& exercise, const std::string& why);

    gateway::Gateway& instructor_;
    const gateway::SharedReaders readers_;
    std::vector<ClassroomStatus> servers_;
    std::set<std::string> heard_servers_;
    gateway::Clock::time_point newest_server_{};                 // when the last of them was heard first
    std::map<std::string, Found> found_;                         // by exercise
    std::map<std::string, gateway::Clock::time_point> stood_;    // by exercise: when it did last
    std::map<std::string, Awaited> awaited_;                     // by exercise, of classes
    std::map<std::string, std::unique_ptr<Desk>> desks_;         // by exercise, of classes
    std::map<std::string, Asked> asked_;                         // to be created, by exercise
    std::map<std::string, gateway::Clock::time_point> going_on_; // by exercise: when it was asked to
    std::map<std::string, std::string> recordings_;              // by exercise; empty: there is none
    std::map<std::string, std::string> hindered_, unrecorded_;   // by exercise: why
    std::map<std::string, std::deque<Given>> given_;             // by exercise: what has not gone out yet
    std::map<std::string, Leaving> to_be_removed_;               // by exercise
};

} // namespace windlass::door
