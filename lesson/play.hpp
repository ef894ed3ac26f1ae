#pragma once
// An exercise played at once, without network or clock: the session that a server runs, and at its seats
// scripts that see what the seats are given. As fast as the machine goes, and the same on every machine.

#include "server/exercise/definition/exercise_def.hpp"
#include "server/run/session.hpp"
#include "trainee_client/script.hpp"

#include <functional>

namespace windlass::lesson {

/// What is told while it is played.
struct Told {
    double time = 0; ///< s of exercise
    std::string who; ///< "trainee", "bridge", "event", "report"
    std::string text;
};

inline constexpr double kLook = 0.1;     ///< s of exercise between two looks of a scripted trainee
inline constexpr double kLongest = 3600; ///< s, of what has no time limit

/// Share of the hand-wheel's way that one press of a key moves it, as on the forecastle's page.
inline constexpr double kKeyStep = 0.05;

/// One at a seat.
struct Part {
    trainee::Script script;
    bool voice_only = false; ///< makes reports, and has no hand on a lever
    bool keys = false;       ///< works the hand-wheel with keys
    bool coach = false;      ///< sees the truth beside what the seat is given
};

inline constexpr double kMillimetre = 0.001; ///< m of water, that nobody on board can tell

/// The sea of a picture as it comes to be, with a little more water (m) and another seed of gusts and waves:
/// as soon as it may be without a jump.
exercise::EnvironmentOrder another_sea(const exercise::Snapshot& seen, double more_water,
                                       unsigned other_waves);

/// What chance has made of an attempt.
struct Luck {
    std::uint64_t seed = 1;   ///< of what the attempt leaves to chance; the same draws the same
    double more_water = 0;    ///< m
    unsigned other_waves = 0; ///< by which the seed of gusts and waves is another
    double later = 0;         ///< s by which hands begin later with each order
};
/// The k-th of some that nobody on board could tell from the first: other draws, gusts and waves, k mm more
/// water, and hands that begin with each order up to a second and a half later.
Luck luck(unsigned k);

/// A hand that begins with each order some seconds later.
trainee::Script later(trainee::Script script, double seconds);

/// How it went.
struct Played {
    assess::Result result;
    double time = 0;   ///< s of exercise at the end
    std::string stuck; ///< the step that a script still waited for when it was over; empty: none
    std::vector<Told> told;
};

/// Plays an exercise until its lesson is over, or every script is done or has failed where it has none. Every
/// script has one windlass, its side's; who touches the helm has it, and beside him there may be a voice
/// without levers. tick: looked in after every tick. Throws std::runtime_error when its state ceases to be
/// finite; the time limit of the lesson ends it at the latest, or an hour.
Played play(const exercise::ExerciseDef& def, const std::vector<Part>& parts,
            const std::function<void(run::Session&)>& tick = {}, const Luck& luck = {});
Played play(const exercise::ExerciseDef& def, const std::vector<trainee::Script>& scripts,
            const std::function<void(run::Session&)>& tick = {}, const Luck& luck = {});

} // namespace windlass::lesson
