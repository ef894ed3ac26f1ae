#pragma once
// The event detector: says what the anchor is doing and calls out what happens.

#include "server/exercise/faults/faults.hpp"
#include "server/exercise/watch/riding.hpp"
#include "server/physics/tackle/ground_tackle.hpp"

namespace windlass::exercise {

/// Of the hand-wheel: from here on a brake is hard on, which is within a quarter of a turn.
inline constexpr double kHardOn = 0.95;

/// What the rest of the world has to do with one cable.
struct CableStrain {
    double pull = 0;        ///< N, level part of its pull on the ship
    double asked = 0;       ///< N, of it, when she lies at rest; as Riding
    double wave_period = 0; ///< s; 0: no waves to speak of
};

/// How a cable runs: let go and the anchor not yet on the bottom, running away, or both.
/// One number, as the flag for let go alone was: what no cable ran away in keeps its hash, and its
/// checkpoints are read.
enum class Run { none, let_go, away, let_go_and_away };
constexpr Run last_of(Run) {
    return Run::let_go_and_away;
}

/// Watches one side. What it remembers is part of the exercise's state.
class EventDetector {
public:
    EventDetector(Side side, const physics::GroundTackle& tackle);

    /// One step of dt (s). Events go to log.
    void watch(double dt, const physics::GroundTackle& tackle, const physics::EnvironmentDef& environment,
               const CableStrain& strain, const EventLog& log);

    AnchorPhase phase() const { return phase_; }
    bool brought_up() const { return brought_up_.is(); }
    /// Its cable runs away, and is still faster than practice lets it run.
    bool runs_away() const;

    /// All that it remembers.
    template <class Visitor, physics::StateOf<EventDetector> Self>
    friend void visit_state(Visitor& v, Self& self);

private:
    AnchorPhase look(const physics::GroundTackle& tackle) const;
    void call_phase(AnchorPhase now, const physics::GroundTackle& tackle, const EventLog& log);
    void call_cable(const physics::GroundTackle& tackle, const EventLog& log);
    void call_machine(const physics::GroundTackle& tackle, const EventLog& log);
    void call_fast(double dt, const physics::Windlass& windlass, const EventLog& log);

    int side_;
    AnchorPhase phase_, candidate_;
    double candidate_time_ = 0; ///< s that the candidate has lasted
    bool was_on_bottom_ = false;
    Run run_ = Run::none;
    int shackles_ = 0; ///< whole shackles out
    AnchorWay way_;
    BroughtUp brought_up_;
    bool hot_ = false, slipping_ = false, tripped_ = false, overspeed_ = false, overload_ = false;
    bool overspeed_trip_ = false, burst_ = false, sheared_ = false, jumping_ = false, sprung_ = false;
    bool glazed_ = false, end_parted_ = false, lost_ = false, overstrained_ = false;
    bool clutch_refused_ = false, stopper_refused_ = false, brake_waits_ = false, end_ = false;
    /// s for which cable that is to run out has stood on a jam in the spurling pipe; kCalled: it has been
    /// called in this try.
    double stood_ = 0;
    bool heaping_ = false, turned_ = false, wedged_ = false, flukes_inboard_ = false;
};

} // namespace windlass::exercise
