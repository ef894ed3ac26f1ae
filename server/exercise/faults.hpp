#pragma once
// The instructor's faults: armed, active, cleared; each active one is a cause in the model.

#include "server/exercise/snapshot.hpp"
#include "server/physics/windlass/windlass.hpp"

#include <functional>
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
    using Log =
        std::function<void(Severity, const char* code, int side, double value, const std::string& text)>;

    /// Arms, raises or clears. Every change is told to log.
    void order(const FaultOrder& order, const Log& log);

    /// Raises the armed faults of a side whose trigger has come.
    void watch(Side side, const TriggerInputs& sight, const Log& log);

    /// What is wrong with a side's windlass now; a blackout is on both.
    physics::EquipmentFaults causes(Side side) const;

    const std::vector<FaultView>& list() const { return faults_; }

    void visit_state(physics::StateVisitor& v);

private:
    std::vector<FaultView> faults_;
};

} // namespace windlass::exercise
