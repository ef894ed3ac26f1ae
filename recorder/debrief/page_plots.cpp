// The plots over time, the track, and the figures of attempts beside each other.

#include "common/figure_text.hpp"
#include "recorder/debrief/compare.hpp"
#include "recorder/debrief/curves.hpp"
#include "recorder/debrief/html.hpp"
#include "recorder/debrief/judgement.hpp"
#include "recorder/debrief/page_parts.hpp"
#include "recorder/debrief/plot.hpp"
#include "recorder/debrief/scale.hpp"
#include "recorder/debrief/track.hpp"
#include "station/format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace windlass::debrief {

namespace {

constexpr int kPlotRows = 24;
constexpr double kShown = 0.005; // of any unit; what never comes to more is nothing to look at
constexpr double kMinute = 60;   // s; plots of less are stretched to it

/// A curve with its samples, and the ghost's; nullptr: it has none.
struct Drawn {
    std::string_view name, unit;
    const Series* series;
    const Series* ghost;
};

constexpr double kAlike = 0.5; // s, by which a ghost need not be moved

/// s for which curves go on behind the lesson's end: how the last order was left is seen in what comes of it
/// (a brake that is put on, a cable that stops), and what comes later would only press together what counts.
constexpr double kAfterLesson = 30;

/// s of exercise at which the curves of an attempt end.
double curves_end(const Attempt& attempt) {
    return std::min(attempt.ended, attempt.counted_end() + kAfterLesson);
}

/// What is drawn of a curve of that attempt.
std::vector<Sample> drawn_of(const Series& series, const Attempt& attempt) {
    std::vector<Sample> samples = series.samples();
    std::erase_if(samples, [end = curves_end(attempt)](const Sample& each) { return each.time > end; });
    return samples;
}

/// s of exercise at which the plots end.
double end_of(const Attempt& attempt) {
    return std::max(curves_end(attempt), attempt.began + kMinute);
}

std::string attempt_name(const Attempt& attempt) {
    return attempt.origin.recording;
}

/// "NAME: largest 343 kN at 7:14, least 0 kN at 0:00." until: s of exercise
std::string extremes(const Drawn& drawn, double until) {
    const auto most = drawn.series->largest_until(until), least = drawn.series->least_until(until);
    if (!most) return {};
    const double step = std::abs(most->value) + std::abs(least->value) >= 20 ? 1 : 0.01;
    const std::string unit = drawn.unit.empty() ? "" : " " + std::string(drawn.unit);
    return fmt::format("{}: largest {}{} at {}, least {}{} at {}.", drawn.name, figure(most->value, step),
                       unit, station::clock(most->time), figure(least->value, step), unit,
                       station::clock(least->time));
}

std::string table_of(const std::string& title, const std::vector<Drawn>& curves, double from, double to) {
    std::vector<std::string> columns{"time"};
    for (const Drawn& each : curves)
        columns.push_back(fmt::format("{}{}{}", each.name, each.unit.empty() ? "" : ", ", each.unit));
    std::vector<std::vector<Cell>> rows;
    const double step = round_time_step(std::max(to - from, 1.0), kPlotRows);
    for (double time = std::ceil(from / step) * step; time <= to; time += step) {
        std::vector<Cell> row{figure_cell(time_figure(time, step))};
        for (const Drawn& each : curves) {
            const auto value = each.series->at(time);
            row.push_back(figure_cell(value ? figure(*value, std::abs(*value) >= 100 ? 1 : 0.01) : ""));
        }
        rows.push_back(std::move(row));
    }
    return table(title, columns, rows);
}

/// One plot of all its curves. others: the first curve of it of the attempts laid over, which may be empty.
std::string figure_of(const PageContext& page, const std::string& id, const std::string& title,
                      const std::vector<Drawn>& curves, const std::vector<const Series*>& others,
                      const std::vector<PlotStrip>& strips, int side) {
    const Attempt& attempt = page.attempt;
    Plot plot{.id = id,
              .title = title,
              .unit = std::string(curves.front().unit),
              .sentence = {},
              .from = attempt.began,
              .to = end_of(attempt),
              .lines = {},
              .strips = strips,
              .flags = {}};
    for (std::size_t style = 0; style < curves.size(); ++style) {
        const Drawn& each = curves[style];
        plot.sentence += (plot.sentence.empty() ? "" : " ") + extremes(each, attempt.counted_until());
        // What the brake could hold is a multiple of what it has to: the axis is the load's.
        const bool sets_axis = each.name != windlass_curves()[kBrakeCapacity].name;
        plot.lines.push_back(
            {std::string(each.name), drawn_of(*each.series, attempt), style, sets_axis, kOwn});
        if (each.ghost != nullptr)
            plot.lines.push_back({"the same, " + page.options.ghost->name,
                                  drawn_of(*each.ghost, *page.options.ghost->attempt), style, true, kGhost});
    }
    for (std::size_t i = 0; i < others.size(); ++i) {
        if (others[i] == nullptr || others[i]->empty()) continue;
        const Attempt& other = *page.options.over[i];
        const Alignment alignment = align(attempt, other);
        auto samples = drawn_of(*others[i], other);
        for (Sample& sample : samples)
            sample.time += alignment.shift;
        plot.lines.push_back({fmt::format("{} ({})", attempt_name(other), alignment.reason), samples, 0, true,
                              static_cast<int>(i) + 1});
    }
    for (std::size_t i = 0; i < page.moments.size(); ++i)
        if (side < 0 || page.moments[i].side < 0 || page.moments[i].side == side)
            plot.flags.push_back({page.moments[i].time, fmt::format("{}", i + 1)});
    return plot_figure(plot, 3, table_of(title, curves, attempt.began, curves_end(attempt)));
}

/// The plots of a table of curves. others: for each attempt laid over, its series in the order of the table;
/// ghost: the ghost's, or nullptr.
template <class From>
std::string plots_of(const PageContext& page, const std::string& id, const std::string& suffix,
                     std::span<const Curve<From>> curves, const std::vector<Series>& series,
                     const std::vector<const std::vector<Series>*>& others, const std::vector<Series>* ghost,
                     int side) {
    std::string html;
    for (std::size_t i = 0; i < curves.size();) {
        const std::string_view plot = curves[i].plot;
        const std::size_t first = i;
        std::vector<Drawn> drawn;
        std::vector<PlotStrip> strips;
        bool told = false;
        for (; i < curves.size() && curves[i].plot == plot; ++i) {
            const Series& each = series[i];
            if (each.empty()) continue;
            told = told || std::ranges::any_of(drawn_of(each, page.attempt), [](const Sample& sample) {
                       return std::abs(sample.value) >= kShown;
                   });
            const Series* theirs =
                ghost != nullptr && curves[i].ghost && !(*ghost)[i].empty() ? &(*ghost)[i] : nullptr;
            // A lever with two places is a strip.
            if (side >= 0 && (i == kClutch || i == kStopper))
                strips.push_back({i == kClutch ? "clutch in" : "stopper", drawn_of(each, page.attempt),
                                  theirs != nullptr ? drawn_of(*theirs, *page.options.ghost->attempt)
                                                    : std::vector<Sample>()});
            else
                drawn.push_back({curves[i].name, curves[i].unit, &each, theirs});
        }
        if (drawn.empty() || !told) continue; // no waves, say
        std::vector<const Series*> over;
        for (const auto* other : others)
            over.push_back(first < other->size() ? &(*other)[first] : nullptr);
        html += figure_of(page, fmt::format("{}{}", id, first), std::string(plot) + suffix, drawn, over,
                          strips, side);
    }
    return html;
}

/// What both did and when, of what a ghost can be lined up at.
std::string both_did(const Attempt& attempt, const Attempt& ghost) {
    std::string text;
    for (const auto& [code, what] :
         {std::pair{"anchor.let_go", "let go"}, {"anchor.on_bottom", "on the bottom"}}) {
        const Event *ours = attempt.event(code), *theirs = ghost.event(code);
        if (ours != nullptr && theirs != nullptr)
            text += fmt::format("{} {} at {}, theirs at {}", text.empty() ? "" : ";", what,
                                station::clock(ours->time()), station::clock(theirs->time()));
    }
    return text.empty() ? "" : fmt::format(" This attempt:{}.", text);
}

/// Why a model run came to less than it should: it is no example then.
std::string falls_short(const Ghost& ghost) {
    const auto& marks = ghost.attempt->assessment;
    if (ghost.name != kModelGhost || !marks || !marks->finished() || marks->outcome() == "achieved")
        return {};
    return fmt::format(
        " <strong>They came to {} of 100 points, {}</strong>: what an instructor broke, blew or "
        "said in this attempt came to them, too, and they expect none of it.",
        points_text(marks->score()), escaped(outcome_words(marks->outcome().to_string())));
}

/// Says what the paler lines are, and puts them where they are to be, or out of sight.
std::string ghost_choice(const PageContext& page) {
    const Ghost& ghost = *page.options.ghost;
    const Alignment alignment = align(page.attempt, *ghost.attempt);
    const std::string moved =
        fmt::format("{}, {:.1f} s {}", alignment.reason, std::abs(alignment.shift),
                    alignment.shift > 0 ? "later than they were" : "sooner than they were");
    const auto choice = [](const char* id, const char* checked, const std::string& words) {
        return fmt::format("<label><input type=\"radio\" name=\"ghost\" id=\"{}\" autocomplete=\"off\"{}/> "
                           "{}</label>\n",
                           id, checked, escaped(words));
    };
    std::string html = fmt::format(
        "<p class=\"ghost\">Paler, dashed and wider, behind this attempt&#39;s own lines: the "
        "lesson {}.{}{}{}</p>\n"
        "<fieldset><legend>The paler lines</legend>\n",
        escaped(ghost.name), escaped(both_did(page.attempt, *ghost.attempt)),
        fmt::format(" Theirs ends at {}.", station::clock(ghost.attempt->ended)), falls_short(ghost));
    html += choice("ghost-played", " checked=\"checked\"", "in their own time, from the same beginning");
    if (std::abs(alignment.shift) > kAlike) html += choice("ghost-aligned", "", moved);
    html += choice("ghost-off", "", "out of sight") + "</fieldset>\n";
    return html + fmt::format("<p class=\"moved\">The paler lines are {}.</p>\n", escaped(moved));
}

} // namespace

std::string plot_figure(const Plot& plot, int level, const std::string& table) {
    return fmt::format(
        "<h{0}>{1}</h{0}>\n<figure><div class=\"wide\" role=\"group\" tabindex=\"0\" aria-label=\"Plot: "
        "{1}\">{2}</div><figcaption>{3}</figcaption><details><summary>Table: {1}</summary>{4}</details>"
        "</figure>\n",
        level, escaped(plot.title), svg_of(plot), escaped(plot.sentence), table);
}

std::string plots_part(const PageContext& page) {
    const Attempt& attempt = page.attempt;
    const Attempt* ghost = page.options.ghost ? page.options.ghost->attempt : nullptr;
    std::string html = "<section aria-labelledby=\"plots\"";
    if (ghost != nullptr)
        html += fmt::format(" style=\"--ghost-moved: {:.1f}px\"",
                            width_of(align(attempt, *ghost).shift, attempt.began, end_of(attempt)));
    html += ">\n<h2 id=\"plots\">Over time</h2>\n";
    if (curves_end(attempt) < attempt.ended)
        html +=
            fmt::format("<p>The curves end at {}, {:.0f} s after the lesson; largest and least are those of "
                        "the lesson.</p>\n",
                        station::clock(curves_end(attempt)), kAfterLesson);
    if (ghost != nullptr)
        html += ghost_choice(page);
    else if (!page.options.no_ghost.empty())
        html += fmt::format("<p>The model run is not laid behind the curves: {}.</p>\n",
                            escaped(page.options.no_ghost));
    const auto others = [&](auto series_of) {
        std::vector<const std::vector<Series>*> all;
        for (const Attempt* other : page.options.over)
            all.push_back(&series_of(*other));
        return all;
    };
    for (const int side : {SIDE_PORT, SIDE_STARBOARD}) {
        const auto index = static_cast<std::size_t>(side);
        if (!attempt.sides[index].worked) continue;
        const bool both = attempt.sides[0].worked && attempt.sides[1].worked;
        html += plots_of(page, side == SIDE_PORT ? "port" : "starboard",
                         both ? (side == SIDE_PORT ? ", port" : ", starboard") : "", windlass_curves(),
                         attempt.sides[index].curves,
                         others([index](const Attempt& of) -> const auto& { return of.sides[index].curves; }),
                         ghost != nullptr ? &ghost->sides[index].curves : nullptr, side);
    }
    html += plots_of(page, "ship", "", ship_curves(), attempt.ship,
                     others([](const Attempt& of) -> const auto& { return of.ship; }),
                     ghost != nullptr ? &ghost->ship : nullptr, -1);
    html += plots_of(page, "weather", "", weather_curves(), attempt.weather,
                     others([](const Attempt& of) -> const auto& { return of.weather; }), nullptr, -1);
    std::vector<OtherTrack> tracks;
    if (ghost != nullptr) tracks.push_back({page.options.ghost->name, ghost, kGhost});
    for (std::size_t i = 0; i < page.options.over.size(); ++i)
        tracks.push_back(
            {attempt_name(*page.options.over[i]), page.options.over[i], static_cast<int>(i) + 1});
    if (const std::string track = track_figure(attempt, page.moments, tracks); !track.empty())
        html += "<h3>Track and swinging circle</h3>\n" + track;
    return html + "</section>\n";
}

std::string comparison_part(const PageContext& page) {
    if (page.options.over.empty() && !page.options.ghost) return {};
    std::vector<std::string> columns{"figure", "this attempt"};
    std::vector<std::vector<Figure>> others;
    if (page.options.ghost) {
        columns.push_back(page.options.ghost->name);
        others.push_back(figures_of(*page.options.ghost->attempt));
    }
    for (const Attempt* other : page.options.over) {
        columns.push_back(attempt_name(*other));
        others.push_back(figures_of(*other));
    }
    std::vector<std::vector<Cell>> rows;
    for (const Figure& each : figures_of(page.attempt)) {
        std::vector<Cell> row{text_cell(each.name), text_cell(each.words)};
        for (const auto& figures : others) {
            const auto found = std::ranges::find(figures, each.id, &Figure::id);
            row.push_back(text_cell(found == figures.end() ? "" : found->words));
        }
        rows.push_back(std::move(row));
    }
    return "<section aria-labelledby=\"beside\">\n<h2 id=\"beside\">Beside other attempts</h2>\n" +
           table("Figures of each", columns, rows) + "</section>\n";
}

} // namespace windlass::debrief
