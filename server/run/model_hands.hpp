#pragma once
// The lesson's model hands at an exercise of their own beside the trainee's: what a session and its host know
// of them. Scripts stand above a server's rooms; whoever starts it brings the hands (lesson/beside.hpp).

#include "server/assess/state.hpp"
#include "server/exercise/definition/exercise_def.hpp"
#include "server/exercise/picture/snapshot.hpp"
#include "server/run/status.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace windlass::run {

class ModelHands {
public:
    virtual ~ModelHands() = default;

    /// The last tick that they have gone through.
    virtual std::uint64_t tick() const = 0;
    /// What goes into the exercise besides: an instructor's faults and weather, a draw.
    virtual void take(const exercise::Order& order) = 0;
    /// One tick. False: their lesson is over, or their exercise cannot go on.
    virtual bool step() = 0;
    /// The picture of that tick; and how far their lesson has come.
    virtual const exercise::Snapshot& seen() = 0;
    virtual const assess::State& state() const = 0;
    virtual const exercise::ExerciseDef& def() const = 0;
};

/// How an attempt began.
struct Beginning {
    exercise::ExerciseDef def;
    std::int64_t seed = 0; ///< of its lesson's chances (assess::State)
};

/// From the beginning of an attempt. Throws std::exception when the exercise cannot be set up, or the
/// lesson's scripts are not to be had.
using ModelHandsFrom = std::function<std::unique_ptr<ModelHands>(const Beginning& beginning)>;

/// Whether the lesson of those hands has come to something to which the trainee's has not: an order, a fault,
/// a change of the weather. What they do then would tell it before its time.
bool is_ahead(const assess::State& hands, const assess::State& trainee);

} // namespace windlass::run
