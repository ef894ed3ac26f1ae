#pragma once
// What clients may ask of the server, once checked.

#include "server/exercise/definition/orders.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace windlass::run {

/// Orders about the run of the exercise, not about what happens in it.
enum class RunAction { load, start, pause, reset, time_scale, stop, snapshot, restore, bookmark, predict };

struct RunOrder {
    RunAction action = RunAction::start;
    std::string exercise;    ///< load: file name under the exercise folder
    bool practice = false;   ///< load: its lesson is played for practice
    double time_scale = 1;   ///< time_scale: exercise seconds per wall second, 0 = as fast as possible
    double restore_time = 0; ///< restore: s of exercise, of the last checkpoint up to then
    std::string text;        ///< bookmark: a word for it
    bool predict = false;    ///< predict: from now on; false: no more
};

/// A watchkeeper acknowledges or silences an alert.
struct AlertOrder {
    std::string code;
    int side = -1;           ///< 0 port, 1 starboard, -1 neither
    bool acknowledge = true; ///< false: silence
};

/// To go on from a state that is brought along.
struct StateOrder {
    std::string from; ///< for people
    std::vector<std::uint8_t> checkpoint;
};

/// An answer over the topic of a seat, which is that seat's: what it answers is looked at before it is an
/// order.
struct AnswerOrder {
    bool of_forecastle = true; ///< false: of the bridge
    exercise::AnswerGiven answer;
};

using OrderContent = std::variant<exercise::Order, RunOrder, AlertOrder, StateOrder, AnswerOrder>;

/// Tells the writer of an order from all others; of an order that came from none, all zero.
using WriterKey = std::array<std::uint8_t, 16>;

/// An order and who gave it.
struct ReceivedOrder {
    std::string source;
    OrderContent what;
    bool instructor = false; ///< over a topic that only instructors may write
    WriterKey writer{};
    std::uint64_t moved_in_run = 0; ///< of levers: RunStatus::run, as the hand that last moved one knew it;
                                    ///< 0: not said
};

} // namespace windlass::run
