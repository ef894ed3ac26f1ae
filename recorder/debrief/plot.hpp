#pragma once
// A plot over the time of exercise as inline SVG: lines told apart by dashes as well as by colour, numbered
// flags for the key moments, a title and a sentence for those who do not see it.

#include "recorder/debrief/series.hpp"

#include <string>
#include <vector>

namespace windlass::debrief {

struct PlotLine {
    std::string name;
    std::vector<Sample> samples;
    bool sets_axis = true; ///< false: cut off where it leaves the others' range
    int other = 0;         ///< 0: of this attempt; n: of the n-th that is laid over it
};

/// A strip that is filled while its value is above one half: a clutch that is in.
struct PlotStrip {
    std::string name;
    std::vector<Sample> samples;
};

struct PlotFlag {
    double time = 0;
    int number = 0; ///< of the key moment
};

struct Plot {
    std::string id; ///< of the element, unique in the page
    std::string title, unit, sentence;
    double from = 0, to = 0; ///< s of exercise
    std::vector<PlotLine> lines;
    std::vector<PlotStrip> strips;
    std::vector<PlotFlag> flags;
};

/// The <svg> element.
std::string svg_of(const Plot& plot);

/// Stroke, dashes and width of the line with that place in its plot's key, as attributes; other as in
/// PlotLine.
std::string stroke_of(std::size_t place, int other);

} // namespace windlass::debrief
