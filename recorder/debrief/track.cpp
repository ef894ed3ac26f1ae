#include "recorder/debrief/track.hpp"

#include "recorder/debrief/html.hpp"
#include "recorder/debrief/plot.hpp"
#include "recorder/debrief/scale.hpp"
#include "station/format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace windlass::debrief {

namespace {

constexpr double kWidth = 720, kMargin = 30, kMost = 560; // px
constexpr double kKey = 20;                               // px a row
constexpr int kTrackRows = 24;

/// World to drawing: east to the right, north up.
struct Map {
    double west = 0, south = 0, east = 0, north = 0; // m
    double scale = 1, top = 0;                       // px per m, px

    void take(double x, double y, double around = 0) {
        west = std::min(west, x - around);
        east = std::max(east, x + around);
        south = std::min(south, y - around);
        north = std::max(north, y + around);
    }
    void fit(double from_top) {
        top = from_top;
        scale = std::min((kWidth - 2 * kMargin) / std::max(east - west, 1.0),
                         (kMost - 2 * kMargin) / std::max(north - south, 1.0));
    }
    Spot at(double x, double y) const {
        const double left = (kWidth - (east - west) * scale) / 2;
        return {left + (x - west) * scale, top + kMargin + (north - y) * scale};
    }
    double height() const { return top + 2 * kMargin + (north - south) * scale; }
};

const Place* place_at(const Attempt& attempt, double time) {
    const auto after = std::ranges::upper_bound(attempt.track, time, {}, &Place::time);
    return after == attempt.track.begin() ? nullptr : &*std::prev(after);
}

/// Her outline from above: a bow of a fifth of her length.
std::string outline(const Map& map, const Place& place, double length, double beam) {
    const double s = std::sin(place.heading), c = std::cos(place.heading);
    std::vector<Spot> corners;
    for (const auto& [forward, starboard] :
         {std::pair{0.5, 0.0}, {0.3, 0.5}, {-0.5, 0.5}, {-0.5, -0.5}, {0.3, -0.5}}) {
        const double ahead = forward * length, abeam = starboard * beam;
        corners.push_back(map.at(place.x + ahead * s + abeam * c, place.y + ahead * c - abeam * s));
    }
    return fmt::format("<path class=\"hull\" d=\"{}z\"/>", path_of(corners));
}

std::string circle(const Map& map, double x, double y, double radius, const char* kind) {
    const Spot at = map.at(x, y);
    return fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>", kind, at.x, at.y,
                       radius * map.scale);
}

std::string anchor(const Map& map, const Side& side, int index) {
    std::vector<Spot> way;
    for (const Vec3& each : side.anchor)
        way.push_back(map.at(each.x(), each.y()));
    const Spot at = way.back();
    return fmt::format("<path class=\"dragged\" d=\"{}\"/><path class=\"anchor\" d=\"M{:.1f} {:.1f}v10"
                       "m-4 -7h8m-9 5q5 6 10 0\"/><text x=\"{:.1f}\" y=\"{:.1f}\">{} anchor</text>",
                       path_of(simplified(way, 0.3)), at.x, at.y - 5, at.x + 8, at.y + 14,
                       index == SIDE_PORT ? "port" : "starboard");
}

std::string bar_and_north(const Map& map, double height) {
    const double metres = round_step((map.east - map.west) / 2, 2);
    return fmt::format("<path class=\"zero\" d=\"M{0} {1:.0f}v6h{2:.1f}v-6\"/><text x=\"{0}\" "
                       "y=\"{3:.0f}\">{4:.0f} m</text><path class=\"zero\" d=\"M700 {5:.0f}v-34l-5 10m5 "
                       "-10l5 10\"/><text x=\"690\" y=\"{6:.0f}\" text-anchor=\"end\">N</text>",
                       kMargin, height - 14, metres * map.scale, height - 18, metres, map.top + 44,
                       map.top + 22);
}

std::string numbers(const Map& map, const Attempt& attempt, const std::vector<Moment>& moments) {
    std::string svg;
    std::vector<Spot> taken;
    for (std::size_t i = 0; i < moments.size(); ++i) {
        const Place* place = place_at(attempt, moments[i].time);
        if (place == nullptr) continue;
        Spot at = map.at(place->x, place->y);
        svg += fmt::format("<circle class=\"dot\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2\"/>", at.x, at.y);
        // Beside the track, below each other where she lay still.
        at.x += 12;
        while (std::ranges::any_of(taken, [&](const Spot& other) {
            return std::abs(other.x - at.x) < 14 && std::abs(other.y - at.y) < 11;
        }))
            at.x += 14;
        taken.push_back(at);
        svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>", at.x, at.y + 4,
                           i + 1);
    }
    return "<g class=\"numbers\">" + svg + "</g>";
}

std::string sentence(const Attempt& attempt, const std::vector<SwingingCircle>& circles) {
    const Place &first = attempt.track.front(), &last = attempt.track.back();
    std::string text =
        fmt::format("The ship's way over the ground, {} to {}; she ends {:.0f} m from where "
                    "she began, heading {}.",
                    station::clock(first.time), station::clock(last.time),
                    std::hypot(last.x - first.x, last.y - first.y), station::bearing(last.heading));
    for (const SwingingCircle& each : circles)
        text +=
            fmt::format(" Swinging circle of the {} anchor: {:.0f} m from anchor to stern, were the cable "
                        "straight. The anchor moved {:.1f} m on the bottom.",
                        each.side == SIDE_PORT ? "port" : "starboard", each.radius,
                        attempt.sides[static_cast<std::size_t>(each.side)].dragged);
    return text;
}

std::string table_of(const Attempt& attempt) {
    std::vector<std::vector<Cell>> rows;
    const double step = round_time_step(attempt.duration(), kTrackRows);
    for (double time = std::ceil(attempt.began / step) * step; time <= attempt.ended; time += step)
        if (const Place* place = place_at(attempt, time))
            rows.push_back({figure_cell(time_figure(time, step)), figure_cell(station::number(place->x, 0)),
                            figure_cell(station::number(place->y, 0)),
                            figure_cell(station::bearing(place->heading))});
    return table("Ship's place, amidships", {"time", "east, m", "north, m", "heading, degrees"}, rows);
}

} // namespace

std::vector<SwingingCircle> swinging_circles(const Attempt& attempt) {
    std::vector<SwingingCircle> circles;
    for (int index = 0; index < 2; ++index) {
        const Side& side = attempt.sides[static_cast<std::size_t>(index)];
        if (!side.worked || side.anchor.empty() || !(side.cable_out > attempt.depth)) continue;
        const Event* last = nullptr;
        for (const Event& event : attempt.events)
            if (event.side() == index &&
                (event.code() == "anchor.on_bottom" || event.code() == "anchor.aweigh" ||
                 event.code() == "cable.lost" || event.code() == "cable.parted"))
                last = &event;
        if (last != nullptr && last->code() != "anchor.on_bottom") continue;
        const double straight = std::sqrt(side.cable_out * side.cable_out - attempt.depth * attempt.depth);
        circles.push_back({.side = index,
                           .x = side.anchor.back().x(),
                           .y = side.anchor.back().y(),
                           .radius = straight + attempt.length_overall});
    }
    return circles;
}

std::string track_figure(const Attempt& attempt, const std::vector<Moment>& moments,
                         const std::vector<OtherTrack>& others) {
    if (attempt.track.empty()) return {};
    const auto circles = swinging_circles(attempt);
    const Place& last = attempt.track.back();
    Map map{last.x, last.y, last.x, last.y};
    for (const Place& place : attempt.track)
        map.take(place.x, place.y, attempt.length_overall / 2);
    for (const OtherTrack& other : others)
        for (const Place& place : other.attempt->track)
            map.take(place.x, place.y);
    for (const SwingingCircle& each : circles)
        map.take(each.x, each.y, each.radius);
    if (attempt.watch) map.take(attempt.watch->x(), attempt.watch->y(), attempt.watch->radius());
    const auto way = [&](const Attempt& of, int whose) {
        std::vector<Spot> spots;
        for (const Place& each : of.track)
            spots.push_back(map.at(each.x, each.y));
        return fmt::format("<path {} d=\"{}\"/>", stroke_of(0, whose), path_of(simplified(spots, 0.3)));
    };
    map.fit(kKey * (1 + static_cast<double>(others.size())));
    double row = 16;
    std::string keys =
        key_of(fmt::format("this attempt, amidships; her outline at the end; circle: swinging circle{}",
                           attempt.watch ? "; dotted circle: anchor watch" : ""),
               0, kOwn, 30, row);
    std::string svg;
    for (const OtherTrack& other : others) {
        svg += way(*other.attempt, other.whose);
        keys += key_of(other.name, 0, other.whose, 30, row += kKey);
    }
    svg += way(attempt, kOwn);
    for (const SwingingCircle& each : circles)
        svg += circle(map, each.x, each.y, each.radius, "swing");
    if (attempt.watch)
        svg += circle(map, attempt.watch->x(), attempt.watch->y(), attempt.watch->radius(), "watch");
    if (attempt.length_overall > 0) svg += outline(map, last, attempt.length_overall, attempt.beam);
    for (int index = 0; index < 2; ++index)
        if (const Side& side = attempt.sides[static_cast<std::size_t>(index)];
            side.worked && !side.anchor.empty())
            svg += anchor(map, side, index);
    const double height = map.height();
    const std::string words = sentence(attempt, circles);
    return fmt::format(
        "<figure><div class=\"wide\" role=\"group\" tabindex=\"0\" aria-label=\"Track\"><svg role=\"img\" "
        "aria-labelledby=\"track-title track-words\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
        "height=\"{1:.0f}\"><title id=\"track-title\">Track and swinging circle</title><desc "
        "id=\"track-words\">{2}</desc>{3}{4}{5}{6}</svg></div><figcaption>{2}</figcaption><details>"
        "<summary>Table: the ship's place</summary>{7}</details></figure>\n",
        kWidth, height, escaped(words), keys, svg, numbers(map, attempt, moments), bar_and_north(map, height),
        table_of(attempt));
}

} // namespace windlass::debrief
