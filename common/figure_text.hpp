#pragma once
// Figures for people.

#include <string>

namespace windlass {

/// "383 kN", "5.8 m/s", "35 degC": of a value in an SI unit. unit: "N", "K" (above absolute zero), "yes" (1
/// or 0), or any other as it is to be read; empty: a bare number.
std::string figure_text(double value, const std::string& unit);

} // namespace windlass
