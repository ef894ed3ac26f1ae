#include "recorder/debrief/compare.hpp"

#include "common/figure_text.hpp"
#include "recorder/debrief/curves.hpp"
#include "recorder/debrief/seat_units.hpp"
#include "station/format.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace windlass::debrief {

Alignment align(const Attempt& attempt, const Attempt& other) {
    struct Way {
        const char *event, *reason;
    };
    for (const Way way :
         {Way{"anchor.let_go", "aligned at letting go"}, Way{"fault.active", "aligned at the first fault"}}) {
        const Event *ours = attempt.event(way.event), *theirs = other.event(way.event);
        if (ours != nullptr && theirs != nullptr) return {ours->time() - theirs->time(), way.reason};
    }
    return {attempt.began - other.began, "aligned at the beginning"};
}

std::string unlike(const Attempt& attempt, const Attempt& other) {
    const auto named = [](const Attempt& of) {
        return of.title.empty() ? of.exercise : fmt::format("{} ({})", of.exercise, of.title);
    };
    if (attempt.exercise != other.exercise)
        return fmt::format("is of {}, this attempt of {}: only the same lesson can be laid behind it",
                           named(other), named(attempt));
    const auto lesson = [](const Attempt& of) { return of.assessment ? of.assessment->lesson_hash() : 0; };
    // A lesson for practice has another definition, and is the same lesson.
    const auto practice = [](const Attempt& of) { return of.assessment && of.assessment->practice(); };
    const bool same = lesson(attempt) == lesson(other) && (practice(attempt) != practice(other) ||
                                                           attempt.definition_hash == other.definition_hash);
    return same
               ? ""
               : fmt::format("is of another version of {} (definition {:016x}, lesson {:016x}; this attempt: "
                             "{:016x}, {:016x})",
                             named(attempt), other.definition_hash, lesson(other), attempt.definition_hash,
                             lesson(attempt));
}

namespace {

/// m/s
double speed_of(const Sample& of) {
    return of.value * words::units::metre_a_minute;
}

void add_side(const Attempt& attempt, int index, std::vector<Figure>& figures) {
    const Side& side = attempt.sides[static_cast<std::size_t>(index)];
    if (!side.worked) return;
    const double until = attempt.counted_until();
    const Truth* last = attempt.lesson_over() ? side.truth_at(until) : nullptr;
    const double cable_out = last != nullptr ? last->cable_out : side.cable_out;
    const double dragged = last != nullptr ? last->dragged : side.dragged;
    const std::string of = index == SIDE_PORT ? "port" : "starboard";
    const auto add = [&](const char* id, const char* name, double value, const char* unit,
                         std::string words) {
        figures.push_back(
            {fmt::format("{}_{}", id, of), fmt::format("{}, {}", name, of), value, unit, std::move(words)});
    };
    if (const auto most = side.curves[kTension].largest_until(until)) {
        const double newton = most->value * words::units::tonne;
        add("largest_tension", "Largest tension at the lip", newton, "N",
            fmt::format("{} at {}{}", station::tonnes(newton), station::clock(most->time),
                        side.breaking_load > 0 ? fmt::format(", {} of the breaking load",
                                                             station::percent(newton / side.breaking_load))
                                               : ""));
    }
    if (const auto most = side.curves[kCableSpeed].largest_until(until))
        add("fastest_out", "Fastest cable, paying out", speed_of(*most), "m/s",
            fmt::format("{} at {}", cable_speed_text(speed_of(*most)), station::clock(most->time)));
    if (const auto least = side.curves[kCableSpeed].least_until(until); least && least->value < 0)
        add("fastest_in", "Fastest cable, heaving", -speed_of(*least), "m/s",
            fmt::format("{} at {}", cable_speed_text(-speed_of(*least)), station::clock(least->time)));
    add("cable_out", "Cable out at the end", cable_out, "m",
        fmt::format("{:.1f} m, {}", cable_out, shackles_text(cable_out)));
    if (const auto most = side.curves[kLining].largest_until(until))
        add("lining", "Hottest lining of the brake", most->value, "degC",
            fmt::format("{:.0f} \u00b0C at {}", most->value, station::clock(most->time)));
    add("dragged", "Anchor moved on the bottom", dragged, "m", fmt::format("{:.1f} m", dragged));
}

} // namespace

std::vector<Figure> figures_of(const Attempt& attempt) {
    std::vector<Figure> figures;
    const double duration = attempt.counted_end() - attempt.began;
    figures.push_back({"duration", "Duration", duration, "s", station::clock(duration)});
    if (attempt.assessment)
        figures.push_back({"score", "Score", attempt.assessment->score(), "points",
                           points_text(attempt.assessment->score()) + " of 100"});
    for (const int side : {SIDE_PORT, SIDE_STARBOARD})
        add_side(attempt, side, figures);
    return figures;
}

} // namespace windlass::debrief
