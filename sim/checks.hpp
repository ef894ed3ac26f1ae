#pragma once
// What must hold of a centre, whatever happens to it. Looks on as a recorder does, by what is told of each
// tick, and goes through it again undisturbed. What does not hold is thrown as a Failure.

#include "server/run/course.hpp"
#include "server/run/session.hpp"
#include "sim/network.hpp"

#include <list>
#include <map>
#include <memory>
#include <optional>
#include <set>

namespace windlass::sim {

/// How a server begins.
struct Beginning {
    Loss lost_by = Loss::killed;       ///< what the server before it was lost by
    bool first = false;                ///< there was none
    bool taken_up = false;             ///< the exercise stands where it stood, as it says
    bool running = false;              ///< one that ran is to run on
    std::string refused{}, set_back{}; ///< as in run::Resumption
    std::size_t attempts = 0;          ///< that the disk has counted before
    bool set_back_before = false;      ///< by one that was lost at it, or before it had a file of its own
    bool rotten = false;               ///< the disk is broken, or a byte was changed that it had
};

class Checks {
public:
    explicit Checks(const World& world) : world_(world) {}

    /// A server is about to begin; it may be lost before it has. how: what was there before it.
    void starts(const Beginning& how);
    /// A server has begun, and has not ticked yet.
    void begins(const run::Session& session, const Beginning& how);
    /// A sample is in the mailbox.
    void hears(const Sent& sent);
    void leaves(const wire::WriterId& writer);
    void comes(const wire::WriterId& writer);
    /// The orders of a tick have been taken and it was run, or the exercise stands still; before the news are
    /// cleared. now: s, as the session was told.
    void look(const run::Session& session, const run::Inbox& inbox, double now, const std::string& trouble);

    /// What was looked at last is with the system, or with the disk.
    struct Place {
        std::uint64_t line = 0, tick = 0;
        std::size_t orders = 0;
        std::uint64_t turns = 0; ///< of `goes_on_` up to there
    };
    Place place() const;
    void handed_over(const Place& place);
    void on_disk(const Place& place);

    /// The server has ended by itself, with all that was looked at handed over: it is no loss.
    void left_whole();

    /// All that was not gone through undisturbed yet.
    void end();

    std::uint64_t tick() const { return tick_; } ///< looked at last
    std::uint64_t seen() const { return seen_; } ///< ticks, of all servers
    std::uint64_t digest() const { return digest_; }
    std::optional<Place> promised(Loss how) const;
    std::vector<run::AlertView> open_alerts() const;

    /// What of it was drawn.
    struct Counts {
        std::uint64_t takings = 0;     ///< of levers, from another hand
        std::uint64_t questions = 0;   ///< that were told
        std::uint64_t answered = 0;    ///< of them
        std::uint64_t passed_over = 0; ///< by an instructor
        std::uint64_t stood_again = 0; ///< behind the loss of a server
    };
    const Counts& counts() const { return counts_; }

    bool sabotage_order = false;    ///< the next order is not the one that was taken
    bool sabotage_marks = false;    ///< the next marks are not those that were given
    bool sabotage_taking = false;   ///< the next to take levers is not the one that is told
    bool sabotage_question = false; ///< the next question is not told

private:
    /// A course from its beginning, or from where another one was left.
    struct Line {
        std::uint64_t number = 0;
        std::shared_ptr<const exercise::ExerciseDef> def;
        std::optional<assess::Assessor> assessor; // at its beginning
        std::vector<run::OrderView> orders;
        struct Mark {
            std::uint64_t tick = 0;
            std::size_t orders = 0;
            std::uint64_t hash = 0, assessment = 0;
        };
        std::vector<Mark> marks;
        std::map<std::uint64_t, std::size_t>
            checkpoints; // that were told: how many orders are in it, by tick
        std::optional<Place> handed_over, on_disk;
        bool ended = false;     // nothing of it need be kept
        std::size_t starts = 0; // of servers, since it began
        std::size_t left = 0;   // of them, up to one that ended by itself: they are counted no more
        std::size_t losses() const { return starts - left; }
    };
    /// Gone through undisturbed, some way along a line.
    struct Undisturbed {
        std::uint64_t line = 0;
        run::Course course;
        std::size_t orders = 0, marks = 0;
    };

    Line& line() { return lines_.back(); }
    void begin_line(const run::Session& session);
    /// A state that was told, and the orders that were told with it and are in it.
    struct State {
        std::uint64_t tick = 0, hash = 0;
        std::vector<run::OrderView> behind{};
        std::optional<std::uint64_t> assessment{}; // where it is told: words may change it and nothing else
    };
    static bool is(const run::Course& course, const Line& line, const State& state);
    static run::Course copy_of(const run::Course& course, const Line& line);
    static bool comes_to(const run::Course& course, const Line& line, const State& state);
    std::optional<std::size_t> orders_of(Line& line, std::uint64_t tick, const State& state);
    bool go_on_from(Line& line, std::uint64_t tick, const State& state);
    void leave_line();
    void branch(const run::Session& session, std::uint64_t tick);
    void hold_set_back(const Place& promise, const Beginning& how) const;
    void hold_what_ran(const run::Session& session) const;
    void note_whether_it_goes_on(const run::Session& session);
    void go_through(Line& line, std::uint64_t tick, std::size_t orders);
    void hold_against(Line& line);
    void leave_out_what_was_not_taken(const run::Inbox& inbox);
    void look_at_orders(const run::Session& session);
    void look_at_levers(const run::OrderView& order, double now);
    void look_for_silence(const run::Session& session);
    void look_at_takings(const run::Session& session);
    void look_at_answers(const run::Session& session, const run::Inbox& inbox);
    void look_at_questions(const run::Session& session, const run::Inbox& inbox);
    void hold_questions_again(const run::Session& session);
    void look_at_events(const run::Session& session);
    void look_at_alerts(const run::Session& session, const std::string& trouble);
    void forget_hands();
    void add(std::uint64_t number);
    void add(const std::string& text);
    [[noreturn]] void fail(std::string check, std::string expected, std::string found) const;

    const World& world_;
    std::list<Line> lines_; // of which a server that is lost may come back to; the newest is the present one
    std::uint64_t line_number_ = 0;
    std::optional<Undisturbed> undisturbed_;

    bool left_whole_ = false; // the last server
    std::uint64_t tick_ = 0, seen_ = 0, digest_ = 14695981039346656037ULL;
    std::uint64_t run_ = 0, run_base_ = 0; // orders of the line before the run's first
    std::uint64_t event_ = 0;

    /// Of the levers of a group.
    struct Levers {
        std::array<double, 5> at{}; // as ordered last
        std::string source;         // who was heard last in this run; empty: nobody
        std::string hand;           // whose words these were last, in whatever run of this server
        bool lay_there = false;     // its levers lay there as the run began
        std::array<double, 5> moved{}, lay_since{}; // s, by its last word; by its last before the run began
        bool instructor = false;
        /// Whose these words were: one, but where words of two programs of a hand came together.
        std::set<wire::WriterId> writers{};
        double heard = 0; // s of listening
    };
    bool has_left(const Levers& levers) const;
    void find_levers(const exercise::ExerciseDef& def, const exercise::Exercise& in); // as they stand in it
    std::array<Levers, 3> levers_;
    std::vector<Sent> heard_;                         // levers, since the last look
    std::ptrdiff_t taken_ = 0;                        // of them, up to here
    std::map<wire::WriterId, std::uint64_t> serials_; // of levers, taken last by this server
    std::set<wire::WriterId> left_;                   // writers that are there no more
    double listened_ = 0, listened_at_ = 0, ran_since_ = 0;
    bool ran_ = false;
    /// A hand that has levers from another one.
    struct Taking {
        std::string source, before;
    };
    std::array<std::string, 3> holders_;         // of levers; empty: nobody
    std::array<std::vector<Taking>, 3> takings_; // since the last look, of the present run
    bool run_began_ = false;                     // since the last look
    /// What a seat was told last that it is asked.
    struct Asked {
        std::string id;
        std::uint64_t run = 0, tick = 0;
    };
    bool goes_on_ = false;                        // it runs, or will by itself once a question is answered
    std::uint64_t turns_ = 0;                     // how often that has changed, of all servers
    std::array<Asked, 2> asked_;                  // forecastle, bridge
    bool was_running_ = false, was_held_ = false; // at the last look
    Counts counts_;
    std::map<std::pair<std::string, int>, run::AlertCondition> alerts_;
    std::map<std::pair<std::string, int>, double> raised_; // s of exercise
};

} // namespace windlass::sim
