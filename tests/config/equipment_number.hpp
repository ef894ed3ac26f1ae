#pragma once
// The equipment table of IACS UR A1: stockless bower anchors, and stud-link chain of grade 3 for both of
// them.

#include <array>

namespace windlass::config {

/// Equipment numbers above the first and up to the second.
struct EquipmentRow {
    double above = 0, to = 0;
    double anchor = 0;         ///< kg, each
    double chain = 0;          ///< m, of both sides
    double diameter_k3_mm = 0; ///< mm
};

/// Rows to 3400 from a maker's table "IACS Req. 2014" (scribd 505125071), those above from memory, checked at
/// 4600 and 7400 against a table of three ships (cultofsea.com). Not compared with the requirement itself.
inline constexpr std::array kEquipment{
    EquipmentRow{205, 240, 660, 302.5, 20.5},    EquipmentRow{240, 280, 780, 330, 22},
    EquipmentRow{280, 320, 900, 357.5, 24},      EquipmentRow{320, 360, 1020, 357.5, 24},
    EquipmentRow{360, 400, 1140, 385, 26},       EquipmentRow{400, 450, 1290, 385, 28},
    EquipmentRow{450, 500, 1440, 412.5, 30},     EquipmentRow{500, 550, 1590, 412.5, 30},
    EquipmentRow{550, 600, 1740, 440, 32},       EquipmentRow{600, 660, 1920, 440, 34},
    EquipmentRow{660, 720, 2100, 440, 36},       EquipmentRow{720, 780, 2280, 467.5, 36},
    EquipmentRow{780, 840, 2460, 467.5, 38},     EquipmentRow{840, 910, 2640, 467.5, 40},
    EquipmentRow{910, 980, 2850, 495, 42},       EquipmentRow{980, 1060, 3060, 495, 44},
    EquipmentRow{1060, 1140, 3300, 495, 46},     EquipmentRow{1140, 1220, 3540, 522.5, 46},
    EquipmentRow{1220, 1300, 3780, 522.5, 48},   EquipmentRow{1300, 1390, 4050, 522.5, 50},
    EquipmentRow{1390, 1480, 4320, 550, 50},     EquipmentRow{1480, 1570, 4590, 550, 52},
    EquipmentRow{1570, 1670, 4890, 550, 54},     EquipmentRow{1670, 1790, 5250, 577.5, 56},
    EquipmentRow{1790, 1930, 5610, 577.5, 58},   EquipmentRow{1930, 2080, 6000, 577.5, 60},
    EquipmentRow{2080, 2230, 6450, 605, 62},     EquipmentRow{2230, 2380, 6900, 605, 64},
    EquipmentRow{2380, 2530, 7350, 605, 66},     EquipmentRow{2530, 2700, 7800, 632.5, 68},
    EquipmentRow{2700, 2870, 8300, 632.5, 70},   EquipmentRow{2870, 3040, 8700, 632.5, 73},
    EquipmentRow{3040, 3210, 9300, 660, 76},     EquipmentRow{3210, 3400, 9900, 660, 78},
    EquipmentRow{3400, 3600, 10500, 660, 78},    EquipmentRow{3600, 3800, 11100, 687.5, 81},
    EquipmentRow{3800, 4000, 11700, 687.5, 84},  EquipmentRow{4000, 4200, 12300, 687.5, 87},
    EquipmentRow{4200, 4400, 12900, 715, 87},    EquipmentRow{4400, 4600, 13500, 715, 90},
    EquipmentRow{4600, 4800, 14100, 715, 92},    EquipmentRow{4800, 5000, 14700, 742.5, 95},
    EquipmentRow{5000, 5200, 15400, 742.5, 97},  EquipmentRow{5200, 5500, 16100, 742.5, 97},
    EquipmentRow{5500, 5800, 16900, 742.5, 100}, EquipmentRow{5800, 6100, 17800, 742.5, 102},
    EquipmentRow{6100, 6500, 18800, 742.5, 107}, EquipmentRow{6500, 6900, 20000, 770, 111},
    EquipmentRow{6900, 7400, 21500, 770, 114},   EquipmentRow{7400, 7900, 23000, 770, 117},
    EquipmentRow{7900, 8400, 24500, 770, 122},   EquipmentRow{8400, 8900, 26000, 770, 127},
    EquipmentRow{8900, 9400, 27500, 770, 132},   EquipmentRow{9400, 10000, 29000, 770, 132},
};

} // namespace windlass::config
