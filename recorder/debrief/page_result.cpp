// Summary, result, key moments.

#include "common/figure_text.hpp"
#include "recorder/debrief/again.hpp"
#include "recorder/debrief/compare.hpp"
#include "recorder/debrief/html.hpp"
#include "recorder/debrief/judgement.hpp"
#include "recorder/debrief/lesson_text.hpp"
#include "recorder/debrief/page_parts.hpp"
#include "recorder/debrief/scale.hpp"
#include "recorder/debrief/seat_units.hpp"
#include "recorder/debrief/wall_time.hpp"
#include "station/format.hpp"
#include "station/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>

namespace windlass::debrief {

namespace {

std::string term(std::string_view name, std::string_view text) {
    return text.empty() ? "" : fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped(name), escaped(text));
}

std::string end_words(const Attempt& attempt) {
    if (attempt.assessment && attempt.assessment->abort().size() > 0) {
        const std::string why = attempt.assessment->abort().to_string();
        return attempt.assessment->ending() == LESSON_BROKEN_OFF ? "broken off: " + why : why;
    }
    switch (attempt.state) {
    case RUN_FINISHED:
        return "the exercise was finished";
    case RUN_STOPPED_BY_FAULT:
        return "stopped by a fault of the simulation";
    case RUN_READY:
        return "it never began";
    case RUN_RUNNING:
    case RUN_PAUSED:
    case RUN_REPLAY:
        break;
    }
    return attempt.assessment && attempt.assessment->finished() ? "the lesson was finished"
                                                                : "the recording ends while it runs";
}

/// Which stretch the marks and figures are of, where it is not all; empty: it is.
std::string counted_words(const Attempt& attempt) {
    const auto over = attempt.lesson_over();
    if (!over) return "";
    return fmt::format("{} to {}, when the lesson was over: marks, and the figures below, are of that alone",
                       station::clock(attempt.began), station::clock(*over));
}

std::string hands_words(const Attempt& attempt) {
    std::string text;
    for (const auto& [name, hand] : attempt.hands) {
        std::string did;
        const auto add = [&](int count, const char* one, const char* many) {
            if (count > 0)
                did += fmt::format("{}{} {}", did.empty() ? "" : ", ", count, count == 1 ? one : many);
        };
        add(hand.windlass, "move of the windlass", "moves of the windlass");
        add(hand.helm, "move of the helm", "moves of the helm");
        add(hand.orders, "order", "orders");
        add(hand.reports, "report", "reports");
        add(hand.others, "other order to the exercise", "other orders to the exercise");
        text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", name, did);
    }
    return text.empty() ? "nobody moved a lever, ordered or reported" : text;
}

Cell html_cell(std::string html) {
    return {std::move(html), false};
}

std::string objectives(const Attempt& attempt) {
    std::vector<std::vector<Cell>> rows;
    for (const Achievement& each : achievements_of(attempt))
        rows.push_back({text_cell(each.text.empty() ? each.id : each.text), text_cell(each.stcw),
                        figure_cell(points_text(each.score)), figure_cell(fmt::format("{:g}", each.pass)),
                        text_cell(outcome_words(each.outcome))});
    if (rows.empty()) return {};
    return "<h3>Objectives</h3>\n" +
           table("Competence by objective", {"objective", "STCW", "points of 100", "to pass", "outcome"},
                 rows) +
           "<p>An objective is achieved when its criteria marked (must) are met, each with half of its "
           "points at least, and it has the points to pass itself; only one with less than half of its "
           "points fails the lesson.</p>\n";
}

/// What would have kept it, and whence to do it again.
std::string remedy(const PageContext& page, const std::string& criterion) {
    for (const Remedy& each : *page.options.remedies) {
        if (each.criterion != criterion) continue;
        std::string html = escaped(in_seat_units(each.words));
        if (each.time)
            html += fmt::format(" Do it again from {}.",
                                time_link(page, std::max(page.attempt.began, *each.time - kAgainBefore)));
        return html;
    }
    return {};
}

/// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& all) {
    std::string text;
    for (std::size_t k = 0; k < all.size(); ++k)
        text += (k == 0 ? "" : k + 1 == all.size() ? " and " : ", ") + all[k];
    return text;
}

/// How the score comes of the deductions, where they are not all.
std::string reckoning(const PageContext& page, const Judgement& judgement) {
    constexpr double kSeen = 0.05; // points
    const auto found = reckoning_of(page.attempt, judgement);
    if (!found || (found->unearned < kSeen && !found->halved)) return {};
    const Reckoning& of = *found;
    std::string text = fmt::format("<p>100 less these {:.1f}", of.lost);
    if (of.unearned >= kSeen)
        text += fmt::format(
            ", and less {:.1f} since limits and prohibitions that were kept count in the measure in "
            "which the rest was done ({:.0f} %; so it is with each objective)",
            of.unearned, 100 * of.done);
    text += fmt::format(": {:.1f}.", 100 - of.lost - of.unearned);
    if (of.halved)
        text += fmt::format(" Halved, since {}: {}.", escaped(listed(why_halved(page.attempt))),
                            points_text(page.attempt.assessment->score()));
    return text + "</p>\n";
}

/// As people read it: the judge tells it in SI.
std::string reason_of(const Criterion& criterion) {
    return in_seat_units(criterion.reason().to_string());
}

/// A reason without what it cost: the column beside it has that in points of 100.
std::string without_weights(const std::string& reason) {
    static const std::regex kCost(
        ": (all of its|[0-9.]+ % of its|[0-9.]+ of [0-9]+) points lost"); // the last of older recordings
    return std::regex_replace(reason, kCost, "");
}

std::string deductions(const PageContext& page, const Judgement& judgement) {
    std::vector<std::string> columns{"time", "criterion", "points lost", "reason"};
    if (page.options.remedies) columns.emplace_back("what would have kept it");
    std::vector<std::vector<Cell>> rows;
    for (const Mark& mark : judgement.deductions()) {
        rows.push_back({html_cell(mark.time > 0 ? time_link(page, mark.time) : ""),
                        text_cell(title_of(*mark.criterion)),
                        figure_cell(share_text(mark.lost) + " of " + share_text(mark.points)),
                        text_cell(without_weights(reason_of(*mark.criterion)))});
        if (page.options.remedies)
            rows.back().push_back(html_cell(remedy(page, mark.criterion->code().to_string())));
    }
    if (rows.empty()) return "<h3>Deductions</h3>\n<p>No points were lost.</p>\n";
    const std::string& what_if = page.options.links.what_if;
    return "<h3>Deductions</h3>\n" + table("Points lost of 100, by when it first went wrong", columns, rows) +
           reckoning(page, judgement) +
           (what_if.empty() || page.options.remedies || !page.attempt.assessment->finished()
                ? ""
                : fmt::format(
                      "<p><a href=\"{}\">What would have kept them</a>: every answer is really played, "
                      "which takes some seconds to a minute or two each, and longer while a class runs: it "
                      "has what "
                      "the classes leave of the processor.</p>\n",
                      escaped(what_if)));
}

/// The two courses of one quantity as a plot: solid as it was, dashed as it would have been.
Plot plot_of(const Remedy& remedy, const TwoCourses& two, const std::string& id) {
    Plot plot{
        .id = id,
        .title = two.title,
        .unit = two.unit,
        .sentence = {},
        .from = two.was.front().time,
        .to = std::max(two.was.back().time, two.would.back().time),
        .height = 120,
        .from_zero = false,
        .lines = {{"as it was", two.was, 0, true, kOwn}, {"as it would have been", two.would, 1, true, kOwn}},
        .strips = {},
        .flags = {{remedy.changed, "changed"}, {remedy.lost, "lost"}}};
    const auto limit = [&](const std::optional<double>& value, const char* what) {
        if (value)
            plot.lines.push_back({fmt::format("{} {:.3g} {}", what, *value, two.unit),
                                  {{plot.from, *value}, {plot.to, *value}},
                                  2,
                                  true,
                                  kOwn});
    };
    limit(two.least, "at least");
    limit(two.most, "at most");
    const auto extremes = [&](const std::vector<Sample>& samples) {
        const auto [least, most] = std::ranges::minmax_element(samples, {}, &Sample::value);
        return fmt::format("largest {:.3g} {} at {}, least {:.3g} {} at {}", most->value, two.unit,
                           station::clock(most->time), least->value, two.unit, station::clock(least->time));
    };
    plot.sentence =
        fmt::format("As it was: {}. As it would have been: {}.", extremes(two.was), extremes(two.would));
    return plot;
}

std::string table_of(const TwoCourses& two) {
    constexpr int kRows = 16;
    const double from = two.was.front().time, to = std::max(two.was.back().time, two.would.back().time);
    const double step = round_time_step(std::max(to - from, 1.0), kRows);
    const auto at = [](const std::vector<Sample>& samples, double time) {
        const auto after = std::ranges::upper_bound(samples, time + 1e-6, {}, &Sample::time);
        const bool there =
            after != samples.begin() && (after != samples.end() || samples.back().time > time - 1);
        return figure_cell(there ? figure(std::prev(after)->value, 0.01) : "");
    };
    std::vector<std::vector<Cell>> rows;
    for (double time = std::ceil(from / step) * step; time <= to + 1e-6; time += step)
        rows.push_back({figure_cell(time_figure(time, step)), at(two.was, time), at(two.would, time)});
    return table(
        two.title,
        {"time", fmt::format("as it was, {}", two.unit), fmt::format("would have been, {}", two.unit)}, rows);
}

/// Both scenes at the same moment, side by side. pair: their number in the page.
std::string scenes(const PageContext& page, const Remedy& remedy, const std::string& name, std::size_t pair) {
    constexpr std::size_t kBehind = 100; // scenes of key moments come first: they are fewer
    if (!remedy.was || !remedy.would) return {};
    const std::string was = scene_figure(page, *remedy.was, remedy.side, kBehind + 2 * pair, "As it was");
    const std::string would =
        scene_figure(page, *remedy.would, remedy.side, kBehind + 2 * pair + 1, "As it would have been");
    if (was.empty() || would.empty()) return {};
    if (scene_words(*remedy.was, remedy.side) == scene_words(*remedy.would, remedy.side))
        return fmt::format("<p>Ship, cable and anchor stand the same in both at {}.</p>\n",
                           station::clock(remedy.was->time));
    return fmt::format("<h4>{}: the scene at {}</h4>\n<div class=\"pair\">\n{}{}</div>\n", escaped(name),
                       station::clock(remedy.was->time), was, would);
}

/// Both courses of each answer, under what was lost.
std::string courses(const PageContext& page, const Judgement& judgement) {
    if (!page.options.remedies) return {};
    std::string html;
    int plots = 0;
    std::size_t pairs = 0;
    for (const Mark& mark : judgement.deductions()) {
        const std::string code = mark.criterion->code().to_string();
        const auto remedy = std::ranges::find(*page.options.remedies, code, &Remedy::criterion);
        if (remedy == page.options.remedies->end()) continue;
        if (remedy->only_said)
            html += fmt::format(
                "<h4>{}</h4>\n<p>Cable, its speed and its load are the same in both: the change is "
                "one of words.</p>\n",
                escaped(name_of(*mark.criterion)));
        for (const TwoCourses& two : remedy->courses) {
            if (two.was.empty() || two.would.empty()) continue;
            Plot plot = plot_of(*remedy, two, fmt::format("both{}", ++plots));
            plot.title = fmt::format("{}: {}", name_of(*mark.criterion), two.title);
            html += plot_figure(plot, 4, table_of(two));
        }
        html += scenes(page, *remedy, name_of(*mark.criterion), ++pairs);
    }
    if (html.empty()) return {};
    return "<h3>As it was, and as it would have been</h3>\n<p>Each answer was really "
           "played: its one change with all other hands as recorded, or the model hands from there on. The "
           "plots go from twenty seconds before that until half a minute behind the loss, the pictures "
           "are of their last moment: a cable&#39;s line is wider and redder with its tension.</p>\n" +
           html;
}

std::string strengths(const Judgement& judgement) {
    std::string items;
    for (const Mark& mark : judgement.strongest(3)) {
        const std::string reason = reason_of(*mark.criterion);
        items += fmt::format("<li>{}{}</li>\n", escaped(name_of(*mark.criterion)),
                             reason.empty() ? "" : escaped(": " + reason));
    }
    return items.empty() ? "" : "<h3>What went well</h3>\n<ul>\n" + items + "</ul>\n";
}

/// What was murmured in an attempt for practice.
std::string hints(const PageContext& page) {
    if (page.attempt.assessment->hints().empty()) return "";
    std::vector<std::vector<Cell>> rows;
    for (const HintGiven& hint : page.attempt.assessment->hints())
        rows.push_back({html_cell(time_link(page, page.attempt.time_of(hint.tick()))),
                        text_cell(hint.forecastle() ? "forecastle" : "bridge"),
                        text_cell(hint.text().to_string()), text_cell(hint.criterion().to_string())});
    return "<h3>Hints</h3>\n" +
           table("Hints that were given, each to its seat", {"time", "to", "hint", "criterion"}, rows);
}

/// How one gets to a key moment: by its time, which is a link; where nobody serves the page, by commands.
std::string way_to_moments(const PageContext& page) {
    if (page.options.links.kind != Links::Kind::none) return "<p>A time opens the replay there.</p>\n";
    const double time = page.moments.front().time;
    return fmt::format("<p>To look at one by hand, with a replay running: <code>recorder control seek "
                       "{:.1f}</code>; to go on live from there: <code>instructor_console restore "
                       "recordings/{}@{}</code> (here the first of them).</p>\n",
                       page.attempt.position_of(time), escaped(page.attempt.origin.recording),
                       escaped(station::clock(time)));
}

std::string criteria(const Attempt& attempt, const Judgement& judgement) {
    std::vector<std::vector<Cell>> rows;
    const auto limited = limited_by(attempt.lesson);
    for (const Mark& mark : judgement.marks) {
        const Criterion& criterion = *mark.criterion;
        const auto its = limited.find(criterion.code().to_string());
        const std::string of = its == limited.end() ? "" : its->second;
        const bool limit = criterion.kind() == CRITERION_LIMIT;
        const bool looked_at = limit && was_looked_at(criterion);
        const std::string unit = criterion.unit().to_string();
        rows.push_back({text_cell(title_of(criterion) + (criterion.must() ? " (must)" : "") +
                                  (was_hinted(attempt, criterion) ? " (hinted)" : "")),
                        text_cell(station::words(criterion.kind())),
                        figure_cell(limit ? limited_text(criterion.limit(), unit, of) : ""),
                        figure_cell(looked_at ? limited_text(criterion.worst(), unit, of) : ""),
                        figure_cell(looked_at ? fmt::format("{:.1f}", criterion.time_outside()) : ""),
                        figure_cell(criterion.counts() ? share_text(mark.points - mark.lost) + " of " +
                                                             share_text(mark.points)
                                                       : ""),
                        figure_cell(criterion.counts() ? fmt::format("{} %", criterion.counted() / 10) : ""),
                        text_cell(station::words(criterion.state(), criterion.kind()))});
    }
    return "<h3>All criteria</h3>\n" +
           table("Criteria, with what they earned of the 100 points; a must is met from 50 % on",
                 {"criterion", "kind", "limit", "worst", "outside, s", "points", "mark", "state"}, rows);
}

} // namespace

std::string summary_part(const PageContext& page) {
    const Attempt& attempt = page.attempt;
    std::string html = "<section aria-labelledby=\"summary\">\n<h2 id=\"summary\">Summary</h2>\n";
    if (!attempt.origin.complete)
        html += "<p class=\"warning\">A part of the recording could not be read: what is here may lack "
                "something.</p>\n";
    html += "<dl>\n" + term("Exercise", attempt.exercise) + term("Lesson", attempt.lesson.title) +
            term("Begun", wall_time(attempt.origin.began_unix_ns)) +
            term("Time of exercise",
                 fmt::format("{} to {}, {} in all", station::clock(attempt.began),
                             station::clock(attempt.ended), station::clock(attempt.duration()))) +
            term("End", end_words(attempt)) + term("Trainees", page.options.who) +
            term("What was done", hands_words(attempt)) + term("What counts", counted_words(attempt));
    for (const Figure& each : figures_of(attempt))
        if (each.id != "duration" && each.id != "score") html += term(each.name, each.words);
    return html + "</dl>\n</section>\n";
}

std::string result_part(const PageContext& page) {
    const Attempt& attempt = page.attempt;
    std::string html = "<section aria-labelledby=\"result\">\n<h2 id=\"result\">Result</h2>\n";
    if (!attempt.assessment)
        return html + "<p>Nothing was assessed: the recording has no marks (topic Assessment), as of an "
                      "exercise without "
                      "a lesson. What follows are its facts.</p>\n</section>\n";
    const Assessment& assessment = *attempt.assessment;
    const Judgement judgement = judgement_of(attempt);
    html += fmt::format("<p class=\"score\">{} of 100 points, {}</p>\n", points_text(assessment.score()),
                        escaped(outcome_words(assessment.outcome().to_string())));
    if (assessment.practice())
        html += fmt::format("<p>This attempt was {}: it is no test of competence.</p>\n",
                            practice_words(attempt));
    if (const Event* restored = attempt.restored(); restored != nullptr)
        html += fmt::format("<p>It goes on from a moment that was there before ({}){}. Orders, questions and "
                            "points that stand here with an earlier time are of before; what was said then "
                            "is not of this attempt.</p>\n",
                            escaped(restored->text().to_string()),
                            assessment.practice() ? "" : ": it is no test of competence");
    if (assessment.score() != assessment.score_computed())
        html += fmt::format("<p>Computed: {} points; the assessor has set marks beside that.</p>\n",
                            points_text(assessment.score_computed()));
    for (const AssessorWord& word : attempt.words)
        if (word.command.criterion().size() == 0 && word.command.verdict() == VERDICT_CONFIRMED)
            html += fmt::format("<p>Confirmed by {}: {}</p>\n", escaped(word.by),
                                escaped(word.command.note().to_string()));
    if (const auto& since = page.options.word)
        html += fmt::format("<p>Set by {} since: <strong>{}</strong>. {}</p>\n", escaped(since->by),
                            escaped(since->stands()), escaped(since->note));
    return html + objectives(attempt) + strengths(judgement) + deductions(page, judgement) +
           courses(page, judgement) + hints(page) + criteria(attempt, judgement) + "</section>\n";
}

std::string LaterWord::stands() const {
    const std::string what = outcome_words(outcome);
    return points ? fmt::format("{} points, {}", points_text(*points), what) : what;
}

std::string moments_part(const PageContext& page) {
    std::string html = "<section aria-labelledby=\"moments\">\n<h2 id=\"moments\">Key moments</h2>\n";
    if (page.moments.empty()) return html + "<p>There are none.</p>\n</section>\n";
    std::vector<TimedRow> rows;
    for (std::size_t i = 0; i < page.moments.size(); ++i) {
        const Moment& moment = page.moments[i];
        rows.push_back({moment.time,
                        {figure_cell(fmt::format("{}", i + 1)), html_cell(time_link(page, moment.time)),
                         text_cell(moment.what),
                         figure_cell(fmt::format("{:.1f}", page.attempt.position_of(moment.time)))}});
    }
    html += timed_tables(page.attempt, "The numbers are those of the flags in the plots",
                         {"no.", "time", "what", "s of the recording"}, rows);
    return html + way_to_moments(page) + "</section>\n";
}

} // namespace windlass::debrief
