#pragma once
// How a ship rides to one of her anchors, as it truly is: whether the anchor holds, digs in or drags, and
// whether she is brought up. With hysteresis, so that an anchor that creeps as she yaws, or a cable that
// works in a sea, is called once.

#include "server/physics/base/state_visitor.hpp"

#include <array>

namespace windlass::exercise {

inline constexpr double kGrip = 0.2; ///< embedment above which an anchor has dug in and counts as holding

/// What the rules look at, of one step.
struct Riding {
    double dt = 0;    ///< s
    double pull = 0;  ///< N, level part of the cable's pull on the ship
    double asked = 0; ///< N, along it: what wind, stream, waves, engine and the other cable ask of this one,
                      ///< were she at rest on her present heading
    double wave_period = 0; ///< s, of the waves that she lies in; 0: none to speak of
    double dragged = 0;     ///< m, moved on the bottom since it landed
    double embedment = 0;   ///< 0..1
    double setting = 1;     ///< m that it moves until it has dug in
    bool landed = false;    ///< the anchor is on the bottom
    bool taut = false;      ///< the cable pulls at the anchor
    bool held = false;      ///< no cable runs
};

/// How far the cable has dragged an anchor lately, and what to call that.
class AnchorWay {
public:
    void observe(const Riding& now);

    /// m moved in the last 30 s and 60 s while the cable was taut; the edge of the window is 3 s wide.
    double moved_in_half_minute() const { return way_ - ways_[kMarks / 2 - 1]; }
    double moved_in_minute() const { return way_ - ways_[kMarks - 1]; }

    /// It is pulled through the ground: 2 m within 60 s, and not because it digs in, until no more than 0.5
    /// m.
    bool dragging() const { return dragging_; }
    /// It stays where it is: no more than 0.1 m within 30 s, until it moves 1 m within 30 s.
    bool still() const { return still_; }

    template <class Visitor, physics::StateOf<AnchorWay> Self>
    friend void visit_state(Visitor& v, Self& self);

private:
    void forget(const Riding& now);
    void mark(double embedment);

    static constexpr int kMarks = 20;                  ///< 3 s apart
    double way_ = 0;                                   ///< m moved while the cable was taut
    double dragged_ = 0;                               ///< m, of the last step
    double since_mark_ = 0;                            ///< s
    std::array<double, kMarks> ways_{}, embedments_{}; ///< newest first
    bool dragging_ = false, still_ = false;
};

/// Whether she is brought up: the brake has stopped the cable, its level pull has risen well above what wind,
/// stream, waves and engine ask, has come down to that again, and the anchor dug in and stays where it is. A
/// rule that was tried in seven anchorings; docs/physics.md.
class BroughtUp {
public:
    /// way: of the same anchor, of the same step. Returns whether she has been brought up in this step.
    bool observe(const Riding& now, const AnchorWay& way);

    bool is() const { return is_; }

    template <class Visitor, physics::StateOf<BroughtUp> Self>
    friend void visit_state(Visitor& v, Self& self);

private:
    /// The mean over some waves: two first-order lags of the waves' period, which leave 2.5 % of what goes at
    /// that period. In no waves the value itself.
    struct Mean {
        double first = 0, second = 0;
        void follow(double value, double lag, double dt);
    };
    bool waiting_ = false; ///< the cable is held; else nothing below counts
    Mean pull_, asked_;    ///< N
    double peak_ = 0;      ///< N, of the pull's mean, since the cable was held
    bool is_ = false;
};

} // namespace windlass::exercise
