#pragma once
// The figures of a tick that a lesson may look at.

#include "server/exercise/picture/snapshot.hpp"

#include <span>
#include <string>

namespace windlass::assess {

/// One figure, SI; what is yes or no is 1 or 0.
struct Quantity {
    const char* name;
    const char* unit;
    const char* text; ///< what it is, for people
    /// tackle: of the side that is looked at. Null: it is no figure of one tick (fold.hpp: figure()).
    double (*read)(const exercise::Snapshot& seen, const exercise::TackleView& tackle);
    double period = 0; ///< after which it comes round again: hours of the clock, degrees; 0: it does not
    const char* not_so = ""; ///< of what is yes or no: how people say that it is not
};

std::span<const Quantity> quantities();
/// The one at that place of the table.
inline const Quantity& quantity_at(int place) {
    return quantities()[static_cast<std::size_t>(place)];
}

/// How much of a quantity one of another unit is: 1000 of "kN" where it is in N, 1 of its own unit; 0: that
/// unit does not belong to it.
double one_of(const std::string& unit, const Quantity& quantity);

/// Place of a quantity in the table; -1: there is none of that name.
int quantity_of(const std::string& name);

/// The tackle of a side; null: the exercise has none.
const exercise::TackleView* tackle_of(const exercise::Snapshot& seen, int side);

} // namespace windlass::assess
