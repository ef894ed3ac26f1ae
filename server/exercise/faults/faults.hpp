#pragma once
// The instructor's faults: armed, active, cleared; each active one is a cause in the model.

#include "server/exercise/picture/event_log.hpp"
#include "server/exercise/picture/snapshot.hpp"
#include "server/physics/windlass/windlass.hpp"

#include <span>
#include <vector>

namespace windlass::exercise {

/// What a trigger looks at, of one side.
struct TriggerInputs {
    double time = 0;       ///< s
    double cable_out = 0;  ///< m
    double gypsy_load = 0; ///< N
};

/// All faults of an exercise; one for each code and side.
class FaultBook {
public:
    /// Arms, raises or clears at a time (s). Every change is told to log.
    void order(const FaultOrder& order, double time, const EventLog& log);
    /// What a draw means: the moment of the fault with a window that was armed last and has none yet.
    void draw(const ChanceDrawn& drawn);
    /// An order of the bridge was heard: faults that wait for it come with the next step.
    void hear(const BridgeOrderGiven& given);

    /// Severities on their way, and the end of those that last for a while, at a time (s).
    void advance(double time, const EventLog& log);

    /// Raises the armed faults of a side whose trigger has come. events: of this tick; more may be logged
    /// into the same list while it is gone through.
    void watch(Side side, const TriggerInputs& inputs, const std::vector<ExerciseEvent>& events,
               const EventLog& log);

    /// What is wrong with a side's windlass and with the ship now; a blackout is on both.
    physics::EquipmentFaults causes(Side side) const;

    /// s that a fault has been active at a time (s), of either side; below 0: it is not.
    double seconds_of(FaultCode code, double time) const;

    const std::vector<FaultView>& list() const { return faults_; }

    template <class Visitor, physics::StateOf<FaultBook> Self>
    friend void visit_state(Visitor& v, Self& self);

private:
    /// What is remembered of a fault beside what is shown of it.
    struct Progress {
        double armed_at = 0;      ///< s
        double active_since = 0;  ///< s
        double from = 0;          ///< severity that it begins at: of a fault that was there already
        bool above = false;       ///< the value has been above the trigger's since it was armed
        bool heard = false;       ///< the order that it waits for was given
        bool drawn = false;       ///< its moment is known
        double moment = 0;        ///< s, drawn from its window
        std::uint64_t arming = 0; ///< which arming of all it was
    };

    bool due(std::size_t place, const TriggerInputs& inputs, const std::vector<ExerciseEvent>& events);
    void raise(std::size_t place, double time, const EventLog& log);
    void clear(std::size_t place, const EventLog& log);
    double severity_at(std::size_t place, double time) const;

    std::vector<FaultView> faults_;
    std::vector<Progress> progress_; ///< of each of them
    std::uint64_t armings_ = 0;
};

} // namespace windlass::exercise
