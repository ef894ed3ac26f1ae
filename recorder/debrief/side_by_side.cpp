#include "recorder/debrief/side_by_side.hpp"

#include "common/figure_text.hpp"
#include "recorder/debrief/compare.hpp"
#include "recorder/debrief/curves.hpp"
#include "recorder/debrief/html.hpp"
#include "recorder/debrief/judgement.hpp"
#include "recorder/debrief/page_parts.hpp"
#include "recorder/debrief/said.hpp"
#include "recorder/debrief/scale.hpp"
#include "recorder/debrief/seat_units.hpp"
#include "station/format.hpp"
#include "station/names.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace windlass::debrief {

namespace {

/// As wide as the window: a column an exercise.
constexpr std::string_view kWideStyle = R"(
@page { size: A4 landscape; }
main { max-width: 76rem; }
@media (min-width: 30.01rem) { td:has(.squares) { white-space: nowrap; } }
.squares { letter-spacing: .1em; }
)";

constexpr std::size_t kOwnLines = 4; // that a plot tells apart

/// Of an attempt the side whose cable moved most; nullptr: none was worked.
const Side* worked_side(const Attempt& attempt) {
    const Side* most = nullptr;
    double moved = -1;
    for (const Side& side : attempt.sides) {
        const Series& cable = side.curves[kCableOut];
        if (!side.worked || cable.empty()) continue;
        if (const double way = cable.largest()->value - cable.least()->value; way > moved)
            most = &side, moved = way;
    }
    return most;
}

/// The members of one lesson, with what is asked of each more than once.
struct Class {
    std::vector<Beside> all;
    std::vector<Judgement> judged;
    std::vector<const Side*> worked; // as worked_side() has it
    Zero zero;

    std::size_t size() const { return all.size(); }
    const Attempt& at(std::size_t i) const { return *all[i].attempt; }
    std::vector<std::string> columns(std::string first) const {
        std::vector<std::string> names{std::move(first)};
        for (std::size_t i = 1; i <= size(); ++i)
            names.push_back(fmt::format("{}", i));
        return names;
    }
};

std::string section(std::string_view id, std::string_view title, const std::string& body) {
    return fmt::format("<section aria-labelledby=\"{0}\">\n<h2 id=\"{0}\">{1}</h2>\n{2}</section>\n", id,
                       escaped(title), body);
}

/// In the unit in which it is told: "35" of t.
std::string told(const Figure& figure) {
    if (figure.unit == "s") return station::clock(figure.value);
    const SeatUnit unit = seat_unit(figure.unit, "cable_speed"); // no other speed is told
    if (unit.name != figure.unit) return limited_figure(figure.value, figure.unit, "cable_speed");
    return fmt::format("{:.{}f}", figure.value, figure.unit == "degC" ? 0 : 1);
}

std::string heading(const Figure& figure) {
    if (figure.unit == "s") return figure.name;
    return figure.name + ", " +
           (figure.unit == "degC" ? "\u00b0C" : seat_unit(figure.unit, "cable_speed").name);
}

/// Why an exercise has no figures of its tackle, and no curve; empty: it has.
std::string why_no_figures(const Class& of, std::size_t i) {
    if (of.worked[i] != nullptr) return "";
    return std::ranges::any_of(of.at(i).sides, &Side::worked) ? "nothing of its cable was recorded"
                                                              : "no lever was moved, and no cable";
}

/// That some exercises went on after their lessons; empty: none did.
std::string what_counts(const Class& of) {
    std::string ends;
    for (std::size_t i = 0; i < of.size(); ++i)
        if (const auto over = of.at(i).lesson_over())
            ends += fmt::format("{}no. {} at {}", ends.empty() ? "" : ", ", i + 1, station::clock(*over));
    if (ends.empty()) return "";
    return fmt::format("<p>All that is told here ends with the lesson: {}. What came after that counts for "
                       "nothing, and stands in the debriefing.</p>\n",
                       ends);
}

std::string results_part(const Class& of) {
    std::vector<std::string> columns{"no.", "who", "outcome"};
    std::vector<std::map<std::string, Figure>> figures(of.size());
    std::vector<std::string> order; // of what at least one has
    for (std::size_t i = 0; i < of.size(); ++i)
        for (Figure& figure : figures_of(of.at(i))) {
            if (std::ranges::find(order, figure.id) == order.end()) {
                order.push_back(figure.id);
                columns.push_back(heading(figure));
            }
            figures[i].insert_or_assign(figure.id, std::move(figure));
        }
    std::vector<std::vector<Cell>> rows;
    for (std::size_t i = 0; i < of.size(); ++i) {
        const Beside& one = of.all[i];
        const auto& marks = of.at(i).assessment;
        const std::string no_figures = why_no_figures(of, i);
        const std::string who = escaped(one.who),
                          since = one.word ? fmt::format("; set by {} since: {}: {}", one.word->by,
                                                         one.word->stands(), one.word->note)
                                           : "";
        std::vector<Cell> row{
            figure_cell(fmt::format("{}", i + 1)),
            {one.link.empty() ? who : fmt::format("<a href=\"{}\">{}</a>", escaped(one.link), who), false},
            text_cell((!marks              ? "not assessed"
                       : marks->practice() ? practice_words(of.at(i))
                                           : outcome_words(marks->outcome().to_string())) +
                      (no_figures.empty() ? "" : "; " + no_figures) + since)};
        for (const std::string& id : order) {
            const auto found = figures[i].find(id);
            row.push_back(figure_cell(found == figures[i].end() ? "" : told(found->second)));
        }
        rows.push_back(std::move(row));
    }
    return section("results", "Results",
                   table("Each exercise; its number stands for it below", columns, rows) + what_counts(of));
}

bool in_play(const Mark* mark) {
    return mark != nullptr && mark->points > 0;
}

/// What a criterion came to in each exercise; nullptr where it is not in the assessment.
struct Row {
    const Criterion* criterion = nullptr;
    std::vector<const Mark*> marks;

    double lost() const {
        double sum = 0;
        for (const Mark* mark : marks)
            if (mark != nullptr) sum += mark->lost;
        return sum;
    }
    auto playing() const { return std::ranges::count_if(marks, in_play); }
    /// In the mean of those in which it was in play; below 0: in none.
    double lost_in_the_mean() const { return playing() == 0 ? -1 : lost() / static_cast<double>(playing()); }
};

bool whole(const Mark& mark) {
    return mark.lost <= 0;
}
bool in_part(const Mark& mark) {
    constexpr double kNone = 1e-9; // of its points
    return mark.lost > 0 && mark.lost < (1 - kNone) * mark.points;
}

Cell mark_cell(const Mark* mark) {
    if (!in_play(mark)) return figure_cell("-");
    const std::string points = share_text(mark->points - mark->lost);
    return figure_cell(whole(*mark) ? points : fmt::format("{} at {}", points, station::clock(mark->time)));
}

/// "■■◧□ 2 whole, 1 in part, 1 none": a square to each exercise in which it was in play.
Cell spread_cell(const Row& row) {
    std::string squares;
    int wholes = 0, parts = 0, nones = 0;
    for (const Mark* mark : row.marks) {
        if (!in_play(mark)) continue;
        squares += whole(*mark) ? "\u25a0" : in_part(*mark) ? "\u25e7" : "\u25a1";
        ++(whole(*mark) ? wholes : in_part(*mark) ? parts : nones);
    }
    std::string words;
    const auto add = [&](int count, const char* what) {
        if (count > 0) words += fmt::format("{}{} {}", words.empty() ? "" : ", ", count, what);
    };
    add(wholes, "whole");
    add(parts, "in part");
    add(nones, "none");
    if (words.empty()) return text_cell("not in play");
    return {fmt::format("<span class=\"squares\" aria-hidden=\"true\">{}</span> {}", squares, words), false};
}

/// Whether it is worth other points in one exercise than in another, as they are told.
bool differs_in_worth(const Row& row) {
    std::set<std::string> worth;
    for (const Mark* mark : row.marks)
        if (in_play(mark)) worth.insert(share_text(mark->points));
    return worth.size() > 1;
}

std::string criteria_part(const Class& of) {
    std::vector<Row> all;
    for (std::size_t i = 0; i < of.size(); ++i)
        for (const Mark& mark : of.judged[i].marks) {
            auto row = std::ranges::find_if(
                all, [&](const Row& each) { return each.criterion->code() == mark.criterion->code(); });
            if (row == all.end())
                row = all.insert(all.end(), {mark.criterion, std::vector<const Mark*>(of.size())});
            row->marks[i] = &mark;
        }
    if (all.empty()) return section("criteria", "Criteria", "<p>Nothing was assessed.</p>\n");
    std::ranges::stable_sort(all, std::greater{}, [](const Row& row) { return row.lost_in_the_mean(); });
    auto columns = of.columns("criterion");
    columns.insert(columns.end(), {"lost in the mean", "how it is spread"});
    std::vector<std::vector<Cell>> rows;
    for (const Row& each : all) {
        std::vector<Cell> row{
            text_cell(title_of(*each.criterion) + (each.criterion->must() ? " (must)" : ""))};
        for (const Mark* mark : each.marks)
            row.push_back(mark_cell(mark));
        row.push_back(figure_cell(each.playing() == 0 ? "" : share_text(each.lost_in_the_mean())));
        row.push_back(spread_cell(each));
        rows.push_back(std::move(row));
    }
    return section(
        "criteria", "Criteria",
        table("Points of 100 that each has of it, and the time of exercise at which it went wrong; "
              "what lost most stands first; -: not in play",
              columns, rows) +
            (std::ranges::any_of(all, differs_in_worth)
                 ? "<p>What came into play makes up 100 points in each exercise: where something did not, "
                   "the "
                   "rest is worth more, and the same deed has other points.</p>\n"
                 : ""));
}

/// Something that was done in one or more of the exercises: when, in each.
struct Deed {
    std::string what;
    std::vector<std::optional<double>> times; ///< s of exercise

    double median(const Zero& zero) const {
        std::vector<double> all;
        for (std::size_t i = 0; i < times.size(); ++i)
            if (times[i]) all.push_back(*times[i] - zero.times[i]);
        std::ranges::sort(all);
        return all[all.size() / 2];
    }
};

/// When the wheel of a brake that stood open is hard on; nothing: never.
std::optional<double> checked(const Side& side) {
    constexpr double kOpen = 0.5, kHardOn = 0.9;
    if (!side.worked) return std::nullopt;
    bool open = false;
    for (const Sample& sample : side.curves[kBrake].samples()) {
        if (open && sample.value > kHardOn) return sample.time;
        open = open || sample.value < kOpen;
    }
    return std::nullopt;
}

/// "on the bottom", "anchor let go": of a name as the wire has it.
std::string in_words(std::string_view name) {
    std::string words(name);
    std::ranges::replace_if(
        words, [](char c) { return c == '_' || c == '.'; }, ' ');
    return words;
}

/// Without what the bridge added ("I say again"): it is the same order.
std::string order_words(BridgeOrder order) {
    if (order.code() != BRIDGE_ORDER_TEXT) order.text("");
    return station::words(order);
}

/// Orders, what came of them, reports, brakes, and what the anchor did, each the first time, as far as it
/// counts.
std::vector<Deed> deeds_of(const Class& of) {
    std::vector<Deed> all;
    for (std::size_t i = 0; i < of.size(); ++i) {
        const Attempt& attempt = of.at(i);
        const auto add = [&](const std::string& what, std::optional<double> time) {
            if (!time || !attempt.counts(*time)) return;
            auto deed = std::ranges::find(all, what, &Deed::what);
            if (deed == all.end())
                deed = all.insert(all.end(), {what, std::vector<std::optional<double>>(of.size())});
            if (!deed->times[i] || *time < *deed->times[i]) deed->times[i] = time;
        };
        for (const auto& [order, changed] : attempt.orders)
            add("the bridge orders: " + order_words(order), order.time());
        for (const OrderSaid& said : orders_said(attempt))
            for (const auto& [order, changed] : attempt.orders)
                if (order.number() == said.number) add("carried out: " + order_words(order), said.done);
        for (const ReportSaid& report : reports_said(attempt))
            add("reported: " + in_words(report.code), report.time);
        for (const Event& event : attempt.events) {
            const words::Event* row = words::find_event(event.code().c_str());
            if (row != nullptr && row->moment) add(in_words(row->name), event.time());
        }
        for (const int side : {SIDE_PORT, SIDE_STARBOARD})
            add(side == SIDE_PORT ? "port brake hard on that stood open"
                                  : "starboard brake hard on that stood open",
                checked(attempt.sides[static_cast<std::size_t>(side)]));
    }
    std::ranges::stable_sort(all, {}, [&](const Deed& deed) { return deed.median(of.zero); });
    return all;
}

/// "+0:12", "-1:05".
std::string from_zero(double seconds) {
    return (seconds < -0.5 ? '-' : '+') + station::clock(std::round(std::abs(seconds)));
}

std::string deeds_part(const Class& of) {
    std::vector<std::vector<Cell>> rows;
    for (const Deed& deed : deeds_of(of)) {
        std::vector<Cell> row{text_cell(deed.what)};
        for (std::size_t i = 0; i < of.size(); ++i)
            row.push_back(figure_cell(deed.times[i] ? from_zero(*deed.times[i] - of.zero.times[i]) : ""));
        rows.push_back(std::move(row));
    }
    return section("deeds", "Who did what when",
                   rows.empty() ? "<p>Nobody did anything.</p>\n"
                                : table(fmt::format("The first time of each, from {} on, m:ss; empty: never",
                                                    of.zero.words),
                                        of.columns("what"), rows));
}

/// Those of until then, moved in time.
std::vector<Sample> moved(std::vector<Sample> samples, double by, double until) {
    std::erase_if(samples, [until](const Sample& sample) { return sample.time > until; });
    for (Sample& sample : samples)
        sample.time += by;
    return samples;
}

/// Least, median and largest of the cables, s by s, while half of them at least go on: the last alone is no
/// spread.
std::vector<PlotLine> spread_of(const Class& of, double from, double to) {
    std::vector<PlotLine> lines;
    for (const char* name : {"least", "median", "most"})
        lines.push_back({.name = name, .samples = {}, .style = lines.size()});
    const auto worked = static_cast<std::size_t>(
        std::ranges::count_if(of.worked, [](const Side* side) { return side != nullptr; }));
    for (double time = from; time <= to; time += 1) {
        std::vector<double> values;
        for (std::size_t i = 0; i < of.size(); ++i) {
            const double at = time + of.zero.times[i];
            const Side* side = of.worked[i];
            if (side == nullptr || at > of.at(i).counted_end()) continue;
            if (const auto value = side->curves[kCableOut].at(at)) values.push_back(*value);
        }
        if (values.empty() || 2 * values.size() < worked) continue;
        std::ranges::sort(values);
        lines[0].samples.push_back({time, values.front()});
        lines[1].samples.push_back({time, values[values.size() / 2]});
        lines[2].samples.push_back({time, values.back()});
    }
    return lines;
}

std::string plot_part(const Class& of) {
    Plot plot{.id = "brakes",
              .title = "Cable out, and whose brake was more than half on",
              .unit = "m",
              .sentence = {},
              .from = 0,
              .to = 0,
              .axis = fmt::format("from {} on, m:ss", of.zero.words),
              .lines = {},
              .strips = {},
              .flags = {}};
    for (std::size_t i = 0; i < of.size(); ++i) {
        const double zero = of.zero.times[i];
        plot.from = std::min(plot.from, of.at(i).began - zero);
        const double until = of.at(i).counted_until();
        plot.to = std::max(plot.to, of.at(i).counted_end() - zero);
        const Side* side = of.worked[i];
        if (side == nullptr) continue;
        const std::string number = fmt::format("no. {}", i + 1);
        plot.strips.push_back({number, moved(side->curves[kBrake].samples(), -zero, until), {}});
        plot.lines.push_back({.name = number,
                              .samples = moved(side->curves[kCableOut].samples(), -zero, until),
                              .style = plot.lines.size()});
    }
    if (plot.strips.empty()) return {};
    if (plot.lines.size() > kOwnLines) plot.lines = spread_of(of, plot.from, plot.to);
    for (const PlotLine& line : plot.lines)
        if (!line.samples.empty())
            plot.sentence += fmt::format("{}{}: {:.1f} m at the end.", plot.sentence.empty() ? "" : " ",
                                         line.name, line.samples.back().value);
    for (std::size_t i = 0; i < of.size(); ++i)
        if (const std::string why = why_no_figures(of, i); !why.empty())
            plot.sentence += fmt::format(" no. {}: {}.", i + 1, why);
    return section(
        "over-time", "Over one time",
        fmt::format("<figure>\n<div class=\"wide\">{}</div>\n<figcaption>{} Below it a row to each "
                    "exercise, black where its brake is more than half on; of two windlasses the one whose "
                    "cable moved most.</figcaption>\n"
                    "</figure>\n",
                    svg_of(plot), escaped(plot.sentence)));
}

} // namespace

Zero zero_of(const std::vector<Beside>& all) {
    for (const auto& [event, words] :
         {std::pair{"anchor.let_go", "letting go"}, std::pair{"fault.active", "the first fault"}}) {
        std::vector<double> times;
        for (const Beside& each : all)
            if (const Event* found = each.attempt->event(event)) times.push_back(found->time());
        if (times.empty()) continue;
        std::ranges::sort(times);
        Zero zero{.times = std::vector<double>(all.size(), times[times.size() / 2]), .words = words};
        for (std::size_t i = 0; i < all.size(); ++i)
            if (const Event* found = all[i].attempt->event(event)) zero.times[i] = found->time();
        if (times.size() < all.size())
            zero.words += " (who never did: from when the middle one of the others did)";
        return zero;
    }
    return {.times = std::vector<double>(all.size(), 0.0), .words = "the exercise's beginning"};
}

std::string side_by_side_page(const std::string& title, const std::vector<Beside>& all) {
    std::string html = fmt::format("<h1>{}</h1>\n", escaped(title));
    Class of;
    for (const Beside& each : all) {
        std::string why = each.missing;
        if (each.attempt != nullptr) why = of.all.empty() ? "" : unlike(of.at(0), *each.attempt);
        if (each.attempt != nullptr && why.empty())
            of.all.push_back(each);
        else
            html += fmt::format("<p class=\"warning\">{} is left out: it {}.</p>\n", escaped(each.who),
                                escaped(why));
    }
    if (of.all.empty()) return document(title, html + "<p>There is no recording.</p>\n", kWideStyle);
    for (const Beside& each : of.all) {
        of.judged.push_back(judgement_of(*each.attempt));
        of.worked.push_back(worked_side(*each.attempt));
    }
    of.zero = zero_of(of.all);
    const Attempt& first = of.at(0);
    html += fmt::format("<p>{}</p>\n", escaped(first.title.empty() ? first.exercise : first.title));
    html += results_part(of) + criteria_part(of) + deeds_part(of) + plot_part(of);
    return document(title, html, kWideStyle);
}

} // namespace windlass::debrief
