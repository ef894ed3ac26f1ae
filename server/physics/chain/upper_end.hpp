#pragma once
// Where the chain's solve ends: the top link and what holds or moves it.

namespace windlass::physics {

/// The top link as the windlass meets it: its mean pull in the step is a straight line in the travel, as long
/// as it is not slack.
struct TopLink {
    double dt = 0;            ///< s
    double pull = 0;          ///< N, if nothing is paid out in this step
    double yielding = 0;      ///< N/m, pull lost for each metre paid out
    double outboard_mass = 0; ///< kg, half of the top link: it moves with the gypsy
    double outboard_pull = 0; ///< N, weight of that half along the chain

    /// Its mean pull (N) when chain is paid out at a speed (m/s).
    double pull_at(double speed) const {
        const double pulls = pull - yielding * speed * dt;
        return pulls > 0 ? pulls : 0;
    }
};

/// What holds or moves the chain at the top.
class UpperEnd {
public:
    virtual ~UpperEnd() = default;
    /// m/s at which chain is paid out in this step. Asked once for each Newton iteration; must not change
    /// anything.
    virtual double speed(const TopLink& link) const = 0;
    /// m/s at which chain was paid out before the step; for the energy balance.
    virtual double speed_before() const { return 0; }
    /// m of chain between hawse pipe lip and gypsy, whose stretch the top link takes over.
    virtual double deck_length() const { return 0; }
};

/// A top that holds: bitter end made fast at the hawse pipe.
class LockedEnd final : public UpperEnd {
public:
    double speed(const TopLink& /*link*/) const override { return 0; }
};

} // namespace windlass::physics
