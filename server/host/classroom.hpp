#pragma once
// A server's place in partition "classroom": tells which exercises it has, opens and removes some on order,
// and sees to it that no two servers of a domain have one name, or an exercise of one name.

#include "server/dds/flood_gate.hpp"
#include "server/dds/mailbox.hpp"
#include "server/host/host.hpp"
#include "server/host/neighbours.hpp"
#include "server/run/refusal_log.hpp"
#include "words/words.hpp"

#include <deque>

namespace windlass::host {

/// Where exercises come from that an instructor asks for.
struct ExerciseSource {
    /// By the name of a file, or from JSON text. Both return at once; what is wrong comes as a std::exception
    /// with a text for people.
    std::function<run::Reading(const std::string& name)> load;
    std::function<run::Reading(const std::string& text, const std::string& source)> parse;
    /// How a session begins.
    std::function<run::SessionOptions(bool wait)> options;
};

/// All methods are for the host's thread.
class Classroom {
public:
    /// Of the time of the threads that tick, more than which exercises in real time may not take when another
    /// is to be created: what is left is for cables that run, which cost ten times as much.
    static constexpr double kMaxLoad = 0.75;

    /// name: of the server, 1..64 characters. member: in partition "classroom". threads: that tick. load: of
    /// the exercises in real time that they tick, threads. Throws std::runtime_error.
    Classroom(wire::Participant& member, std::string name, Host& host, unsigned threads,
              ExerciseSource source, std::function<double()> load);

    /// Hears who else is there; to be called before anything is opened or served.
    void meet_others();
    /// Another server of our name was there already; or it came to be heard of later, and has had its
    /// exercises for longer. Two of one name would both carry out what is ordered of one.
    bool name_taken() const { return name_taken_; }
    /// The server that has an exercise of that name already, as far as is known; empty: none.
    std::string server_of(const std::string& id) const { return neighbours_.server_of(id); }

    /// Carries out what was ordered, gives way where another server was first, and tells how things stand
    /// when that has changed or a second has passed.
    void serve();

    /// An exercise was closed because another server had one of its name.
    bool gave_way() const { return gave_way_; }

private:
    struct Received {
        ClassroomCommand sample;
        wire::WriterId writer;
        bool told = false; ///< that it takes its time
    };

    void hear(const ClassroomCommand& sample, const wire::WriterId& writer);
    void carry_out(const Received& received);
    /// What is wrong with an order; of one that is in order the serial counts as accepted.
    std::optional<run::Refusal> refusal(const Received& received);
    std::optional<run::Refusal> begin_create(const Received& received);
    void create();
    void refuse_unseen(std::uint64_t samples, const char* field, const char* allowed);
    void tell_waiting();
    void give_way();
    void tell_status();
    void log(words::EventCode code, std::string text);
    void refuse(const run::Refusal& refusal);
    void log_refused(const run::RefusalLog::Told& refusal);

    const std::string name_;
    Host& host_;
    const ExerciseSource source_;
    const std::function<double()> load_;
    dds::Serials serials_;
    run::RefusalLog refusals_;
    ClassroomStatus status_;
    std::chrono::steady_clock::time_point told_{}, looked_{};
    std::uint64_t events_ = 0;
    /// An exercise that is to be opened when it has been read; orders behind it wait.
    struct Creating {
        Received received;
        run::Reading reading;
        std::chrono::steady_clock::time_point since; ///< when the reading began
    };
    std::optional<Creating> creating_;
    std::deque<Received> orders_;
    bool gave_way_ = false;
    bool name_taken_ = false;

    std::mutex mutex_;
    std::vector<Received> waiting_;              // guarded by mutex_
    std::uint64_t too_many_ = 0, malformed_ = 0; // guarded by mutex_; samples since the last serve()
    dds::FloodGate gate_;                        // guarded by mutex_

    wire::Writer<ClassroomStatus> status_writer_;
    wire::Writer<Event> event_writer_;
    Neighbours neighbours_;
    wire::Reader<ClassroomCommand> commands_; // last: its callback uses the above
};

} // namespace windlass::host
