#pragma once
// The waves that are in the water, and how one sea gives way to another.
//
// A train whose height alone changes keeps its components. One of another period, direction or seed comes up
// while the old one goes down, both in straight lines of amplitude: half-way the two together are 0.7 of the
// height that each would be alone. Never faster than in kSeaFade, whatever is ordered: a sea that changed at
// once would throw the ship.

#include "server/physics/base/state_visitor.hpp"
#include "server/physics/sea/waves.hpp"

#include <array>

namespace windlass::physics {

inline constexpr int kMaxWaveComponents = 2 * (kSeaComponents + kSwellComponents);
inline constexpr double kSeaFade = 30; ///< s

/// A sea as it shall be: significant heights (m; 0: none), periods of the spectra's peaks (s), directions
/// where it comes from (rad clockwise from north).
struct SeaDef {
    double wave_height = 0, wave_period = 6, wave_from = 0;
    double swell_height = 0, swell_period = 12, swell_from = 0;
    std::uint32_t seed = 1;
    bool operator==(const SeaDef&) const = default;
};
template <class Visitor, StateOf<SeaDef> State>
void visit_state(Visitor& v, State& def);

/// The surface. Takes no memory; the state is what the trains are, from which the components follow.
class SeaSurface {
public:
    /// depth: m, of the water; the sea is there at once.
    SeaSurface(const SeaDef& def, double depth);

    /// From t (s) on the sea changes to another in so many seconds. While one sea gives way to another
    /// already and a third is ordered, the first is faded out in kSeaFade, and then the third comes up.
    void order(const SeaDef& def, double t, double ramp);

    /// To be called as time goes on. Whether components or ramp are others now.
    bool advance(double t);

    std::span<const WaveComponent> components() const { return {components_.data(), count_}; }
    double ramp_begin() const { return ramp_begin_; } ///< s
    double ramp_end() const { return ramp_end_; }     ///< s
    double share(double t) const;                     ///< 0..1, of the ramp that is over
    bool flat() const { return count_ == 0; }
    double height(double t) const; ///< m, significant, of all trains together
    /// Counts up whenever the components are made anew: for who keeps something of theirs.
    unsigned made() const { return made_; }

    double elevation(double x, double y, double t) const; ///< m above z = 0

    template <class Visitor, StateOf<SeaSurface> Self>
    friend void visit_state(Visitor& v, Self& self);

private:
    /// A train with its height; none where both heights are 0.
    struct Train {
        double height_before = 0, height_after = 0; ///< m
        double period = 0, from = 0;
        std::uint32_t seed = 0;
        bool gone() const { return height_before == 0 && height_after == 0; }
        bool same_as(const Train& o) const { return period == o.period && from == o.from && seed == o.seed; }
    };
    static constexpr std::size_t kTrains = 2; ///< of each kind: one that goes, one that comes
    using Trains = std::array<std::array<Train, kTrains>, 2>;

    void settle(double t);
    bool has_room(const SeaDef& def) const;
    void change(const SeaDef& def, double t, double ramp);
    void lay_out();

    Trains trains_{};
    double ramp_begin_ = 0, ramp_end_ = 0;
    bool waiting_ = false; ///< a sea, for the end of this ramp
    SeaDef next_;
    double next_end_ = 0; ///< s, when it shall be there

    double depth_;
    std::array<WaveComponent, kMaxWaveComponents> components_{};
    std::size_t count_ = 0;
    unsigned made_ = 0;
};

} // namespace windlass::physics
