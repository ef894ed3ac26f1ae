#pragma once
// A stockless anchor as data.

namespace windlass::physics {

/// One anchor. Defaults: 9 900 kg stockless (UR A1 row EN 3210-3400). Plain values.
struct AnchorDef {
    double mass = 9900;        ///< kg
    double shank_length = 2.9; ///< m, crown pin to anchor shackle; tuned to the mass: common Hall drawings
    double fluke_length = 1.9; ///< m
    double crown_width = 2.1;  ///< m, across the flukes
    double drag_area = 6.0;    ///< m2, drag coefficient times area: falls at about 5 m/s alone
    double added_mass = 1.0;   ///< -, of the displaced mass; tuned
    double bed_friction = 0.3; ///< -, steel sliding on the bed without digging in; tuned
    double setting_drag = 8.0; ///< fluke lengths dragged until dug in: 5-10 in sand
    double holding_mud = 3.0;  ///< holding power / weight in air by soil: Hall or Spek (realtrawlers)
    double holding_sand =
        3.5; ///< stockless JIS, Japan P&I Bulletin 25; sources spread by 2: instructor's choice
    double holding_clay = 3.5;     ///< as above, 3-5
    double holding_gravel = 2.5;   ///< 2-3
    double holding_rock = 1.0;     ///< 0-2, unreliable
    double holding_dragging = 1.5; ///< residual while it drags (Japan P&I Bulletin 25, sand)
};

} // namespace windlass::physics
