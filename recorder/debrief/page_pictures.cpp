// The scene at the key moments.

#include "recorder/debrief/elevation.hpp"
#include "recorder/debrief/html.hpp"
#include "recorder/debrief/page_parts.hpp"
#include "recorder/debrief/scenes.hpp"
#include "recorder/debrief/seat_units.hpp"
#include "station/format.hpp"
#include "station/names.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace windlass::debrief {

namespace {

constexpr std::size_t kNodeRows = 16;
constexpr double kAsPictured = 0.5; // s: a cable that runs is out a few metres more by then

/// Whose cable is looked at: the moment's, or the first that was worked.
int side_of(const Attempt& attempt, const PicturedMoments& moments) {
    if (moments.side >= 0) return moments.side;
    return attempt.sides[0].worked || !attempt.sides[1].worked ? SIDE_PORT : SIDE_STARBOARD;
}

std::string table_of(const SceneAt& scene, int side) {
    const ChainState& chain = *scene.chains[static_cast<std::size_t>(side)];
    std::vector<std::vector<Cell>> rows;
    const std::size_t nodes = chain.nodes().size();
    const std::size_t step = std::max<std::size_t>(1, (nodes - 1) / kNodeRows);
    for (std::size_t i = 0; i < nodes; i += step)
        rows.push_back({figure_cell(fmt::format("{}", i)),
                        figure_cell(station::number(chain.nodes()[i].x(), 1)),
                        figure_cell(station::number(chain.nodes()[i].y(), 1)),
                        figure_cell(station::number(chain.nodes()[i].z(), 1)),
                        figure_cell(i < chain.tension().size()
                                        ? station::number(chain.tension()[i] / words::units::tonne, 1)
                                        : std::string())});
    return table("Cable from the lip to the anchor",
                 {"node", "east, m", "north, m", "over the water, m", "t"}, rows);
}

/// "2 0:22 anchor let go; not pictured, soon after: 3 0:25 anchor on the bottom": it is drawn at the first.
std::string heading(const PageContext& page, const PicturedMoments& moments) {
    std::string text;
    bool later = false;
    for (const std::size_t place : moments.numbers) {
        const Moment& moment = page.moments[place];
        const bool pictured = moment.time <= moments.time + kAsPictured;
        const char* before = text.empty() ? "" : "; ";
        if (!pictured && !later) before = "; not pictured, soon after: ";
        later = !pictured;
        text += fmt::format("{}<b>{}</b> {} {}", before, place + 1, time_link(page, moment.time),
                            escaped(moment.what));
    }
    return text;
}

std::string picture(const PageContext& page, const PicturedMoments& moments, std::size_t number) {
    const auto scene = std::ranges::find(page.attempt.scenes, moments.time, &SceneAt::time);
    if (scene == page.attempt.scenes.end()) return {};
    return scene_figure(page, *scene, side_of(page.attempt, moments), number, heading(page, moments));
}

} // namespace

std::string scene_words(const SceneAt& scene, int side) {
    const ChainState& chain = *scene.chains[static_cast<std::size_t>(side)];
    const auto& anchor = scene.anchors[static_cast<std::size_t>(side)];
    std::string text = side == SIDE_PORT ? "Port: " : "Starboard: ";
    const bool home = anchor && anchor->phase() == ANCHOR_HOUSED;
    if (home || (anchor && anchor->phase() == ANCHOR_ACOCKBILL)) { // no cable is out that leads anywhere
        text += "anchor " + (home ? "home" : station::words(anchor->phase()));
    } else {
        text +=
            fmt::format("{} ({}) out", station::cable(chain.cable_out()), shackles_text(chain.cable_out()));
        if (!chain.tension().empty())
            text += fmt::format(", {} at the lip", station::tonnes(chain.tension().front()));
        text += chain.stay() == STAY_UP_AND_DOWN
                    ? ", up and down"
                    : fmt::format(", leads {}, {}", station::lead(chain.lead_clock()),
                                  station::words(chain.stay()));
        if (chain.on_bottom() > 0)
            text += fmt::format(", {} on the bottom", station::cable(chain.on_bottom()));
        if (anchor) text += fmt::format("; anchor {}", station::words(anchor->phase()));
    }
    return text + fmt::format(". Ship {}.", station::knots(scene.ship->speed_over_ground()));
}

std::string scene_figure(const PageContext& page, const SceneAt& scene, int side, std::size_t number,
                         const std::string& heading) {
    if (!elevation_of(scene, side)) return {};
    const std::string words = scene_words(scene, side);
    const std::string time = station::clock(scene.time);
    const std::string svg = elevation_svg(page.attempt, scene, side, page.limits, number,
                                          fmt::format("The scene at {}, from abeam", time), words);
    return fmt::format("<figure><p>{}</p><div class=\"wide\" role=\"group\" tabindex=\"0\" "
                       "aria-label=\"Scene at {}\">{}</div><figcaption>{}</figcaption><details>"
                       "<summary>Table: the cable at {}</summary>{}</details></figure>\n",
                       heading, time, svg, escaped(words), time, table_of(scene, side));
}

std::string pictures_part(const PageContext& page) {
    std::string figures;
    std::size_t number = 0;
    for (const PicturedMoments& each : pictured(page.moments))
        figures += picture(page, each, ++number);
    if (figures.empty()) return {};
    return "<section aria-labelledby=\"scenes\">\n<h2 id=\"scenes\">The scene at key moments</h2>\n<p>As "
           "recorded, in true shape, seen across the cable; the cable&#39;s line is wider and redder with "
           "its "
           "tension. The numbers are those of the moments; each picture is of the first beside it.</p>\n"
           "<div class=\"wide key\" role=\"group\" tabindex=\"0\" aria-label=\"Key of tensions\">" +
           tension_key(page.limits) + "</div>\n" + figures + "</section>\n";
}

} // namespace windlass::debrief
