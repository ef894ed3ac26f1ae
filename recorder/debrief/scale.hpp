#pragma once
// Axes: round steps, and lines without the points that a pixel does not show.

#include <string>
#include <vector>

namespace windlass::debrief {

/// A place in a drawing, px, y downwards.
struct Spot {
    double x = 0, y = 0;
};

/// A round step (1, 2 or 5 times a power of ten) that divides the length into at most so many parts.
double round_step(double length, int parts);
/// The same of times, s: 1, 2, 5, 10, 15, 30 s, 1, 2, 5, 10, 15, 30 min, and hours.
double round_time_step(double seconds, int parts);
/// A figure with as many decimals as a step of that size needs.
std::string figure(double value, double step);
/// m:ss, and tenths where the step is below a second; with a minus below 0.
std::string time_figure(double seconds, double step);

/// The line without points that lie within `off` px of what is left (Douglas and Peucker 1973).
std::vector<Spot> simplified(const std::vector<Spot>& line, double off);
/// An SVG path of the line to a tenth of a px; empty for less than two places.
std::string path_of(const std::vector<Spot>& line);

} // namespace windlass::debrief
