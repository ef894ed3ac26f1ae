#pragma once
// The parts of the page, in the order in which they stand in it. Each is a section with its heading.

#include "recorder/debrief/elevation.hpp"
#include "recorder/debrief/html.hpp"
#include "recorder/debrief/moments.hpp"
#include "recorder/debrief/page.hpp"
#include "recorder/debrief/plot.hpp"

namespace windlass::debrief {

/// What the parts have in common.
struct PageContext {
    const Attempt& attempt;
    const PageOptions& options;
    std::vector<Moment> moments;
    TensionLimits limits; ///< of all scenes of the page, so that one line means one tension
};

std::string summary_part(const PageContext& page);
std::string result_part(const PageContext& page);
std::string moments_part(const PageContext& page);
std::string pictures_part(const PageContext& page); ///< of the moments; empty where no scene was read
std::string plots_part(const PageContext& page);
std::string comparison_part(const PageContext& page);
std::string talk_part(const PageContext& page);
std::string events_part(const PageContext& page);
std::string ahead_part(const PageContext& page); ///< empty where nobody asked for predictions
std::string origin_part(const PageContext& page);

/// A plot under its title as a heading of that level, with its sentence, and its table out of sight until it
/// is asked for.
std::string plot_figure(const Plot& plot, int level, const std::string& table);

/// "Port: 88 m (3.2 shackles) out, 3.5 t at the lip, leads 11 o'clock, long stay; anchor holding.
/// Ship 0.4 kn." Of a scene that has ship and that side's cable.
std::string scene_words(const SceneAt& scene, int side);

/// A scene from abeam under its heading (HTML), with what it shows in a sentence. number: of the picture in
/// the page, for its ids. Empty where nothing can be drawn.
std::string scene_figure(const PageContext& page, const SceneAt& scene, int side, std::size_t number,
                         const std::string& heading);

/// A row of a table with the time of exercise that it is of.
struct TimedRow {
    double time = 0; ///< s
    std::vector<Cell> cells;
};
/// The rows, by time, as a table; those of after the lesson's end as another one under a heading that says
/// so.
std::string timed_tables(const Attempt& attempt, std::string_view caption,
                         const std::vector<std::string>& columns, const std::vector<TimedRow>& rows);

/// "2:05", linked to the replay of it where there is one.
std::string time_link(const PageContext& page, double time);

} // namespace windlass::debrief
