#pragma once
// A plot over the time of exercise as inline SVG: lines told apart by dashes as well as by colour, numbered
// flags for the key moments, a title and a sentence for those who do not see it.

#include "recorder/debrief/series.hpp"

#include <string>
#include <vector>

namespace windlass::debrief {

/// Whose a line is: of this attempt; of a ghost, behind the line with its style; n: of the n-th attempt that
/// is laid over it.
inline constexpr int kOwn = 0, kGhost = -1;

struct PlotLine {
    std::string name;
    std::vector<Sample> samples;
    std::size_t style = 0; ///< by which the lines of one attempt are told apart
    bool sets_axis = true; ///< false: cut off where it leaves the others' range
    int whose = kOwn;
};

/// A strip that is filled while its value is above one half: a clutch that is in.
struct PlotStrip {
    std::string name;
    std::vector<Sample> samples, ghost; ///< ghost: below it; empty: there is none
};

struct PlotFlag {
    double time = 0;
    std::string label; ///< number of the key moment
};

struct Plot {
    std::string id; ///< of the element, unique in the page
    std::string title, unit, sentence;
    double from = 0, to = 0; ///< s of exercise, or from what the axis says
    std::string axis = "time of exercise, m:ss";
    double height = 170;   ///< px, between its axes
    bool from_zero = true; ///< its axis has 0 in it; false: no more than the lines need
    std::vector<PlotLine> lines;
    std::vector<PlotStrip> strips;
    std::vector<PlotFlag> flags;
};

/// The <svg> element.
std::string svg_of(const Plot& plot);

/// px by which a line is farther right in a plot from `from` to `to` that is `seconds` later.
double width_of(double seconds, double from, double to);

/// The line's part of a key: its stroke at x, y, and its name behind it.
std::string key_of(const std::string& name, std::size_t style, int whose, double x, double y);

/// Stroke, dashes and width as attributes; style and whose as in PlotLine. A ghost's has a class, by which it
/// can be put out of sight.
std::string stroke_of(std::size_t style, int whose);

} // namespace windlass::debrief
