#pragma once
// What use has left of a cable's links.

namespace windlass::physics {

/// The state in which a surveyor finds a piece of cable. Wear and corrosion take section, and with it proof
/// and breaking load by the square of the diameter that is left. A defect (crack, lost stud, joining shackle
/// whose pin works out) breaks early without stretching first.
/// A length is renewed at a mean diameter 12 % below the nominal one (IACS; LR Naval Survey Guidance 7.12).
struct LinkCondition {
    double begins = 0; ///< m of cable from the anchor shackle
    double ends = 0;   ///< m; where it begins: one link
    double wear = 0;   ///< share of the diameter worn and rusted off, mean of two measurements at the crown
    double defect = 0; ///< share of the breaking load lost
};

} // namespace windlass::physics
