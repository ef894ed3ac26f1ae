// Orders and reports, events, questions, where it all comes from.

#include "recorder/debrief/html.hpp"
#include "recorder/debrief/page_parts.hpp"
#include "recorder/debrief/said.hpp"
#include "recorder/debrief/seat_units.hpp"
#include "recorder/debrief/wall_time.hpp"
#include "station/format.hpp"
#include "station/line_view.hpp"

#include <fmt/format.h>

namespace windlass::debrief {

namespace {

Cell seconds_cell(std::optional<double> seconds) {
    return figure_cell(seconds ? fmt::format("{:.1f}", *seconds) : "");
}

std::optional<double> since(std::optional<double> time, double from) {
    return time ? std::optional(*time - from) : std::nullopt;
}

/// When an order was carried out, or that it was not; empty where nobody knows it, and of a question, which
/// has its answer.
Cell done_cell(const PageContext& page, const OrderSaid& order) {
    if (order.question) return text_cell("");
    if (order.done_before) return {time_link(page, *order.done_before) + ", before it was said again", false};
    if (!order.judged) return text_cell("");
    return order.done ? Cell{time_link(page, *order.done), false} : text_cell("not");
}

/// How long that took; of what was so when it was ordered, that.
Cell taken_cell(const OrderSaid& order) {
    constexpr double kAtOnce = 0.05; // s: a tick or two, in which no hand does anything
    if (order.question) return figure_cell("");
    if (order.done && *order.done < order.given + kAtOnce) return figure_cell("so already");
    return seconds_cell(since(order.done, order.given));
}

} // namespace

std::string talk_part(const PageContext& page) {
    std::string html = "<section aria-labelledby=\"talk\">\n<h2 id=\"talk\">Orders and reports</h2>\n";
    std::vector<std::vector<Cell>> rows;
    for (const OrderSaid& order : orders_said(page.attempt))
        rows.push_back({figure_cell(fmt::format("{}", order.number)),
                        {time_link(page, order.given), false},
                        text_cell(order.words),
                        text_cell(order.by),
                        text_cell(order.state),
                        seconds_cell(since(order.repeated, order.given)),
                        seconds_cell(since(order.repeat_by, order.given)),
                        done_cell(page, order),
                        taken_cell(order),
                        seconds_cell(since(order.do_by, order.given)),
                        text_cell(order.answer),
                        seconds_cell(since(order.answered, order.given))});
    if (rows.empty())
        html += "<p>The bridge gave no orders.</p>\n";
    else
        html += table("Orders of the bridge; s count from when it was given",
                      {"no.", "given", "order", "by", "repeat-back", "after, s", "allowed, s", "carried out",
                       "after, s", "allowed, s", "answer", "after, s"},
                      rows);
    std::vector<TimedRow> reports;
    for (const ReportSaid& report : reports_said(page.attempt))
        reports.push_back({report.time,
                           {{time_link(page, report.time), false},
                            text_cell(report.words),
                            text_cell(report.by),
                            text_cell(report.truth),
                            seconds_cell(report.delay)}});
    if (reports.empty())
        html += "<p>Nothing was reported.</p>\n";
    else
        html +=
            timed_tables(page.attempt, "Reports of the forecastle, and what was so; free text is not judged",
                         {"time", "report", "by", "the truth", "delay, s"}, reports);
    return html + "</section>\n";
}

std::string events_part(const PageContext& page) {
    std::string html = "<section aria-labelledby=\"events\">\n<h2 id=\"events\">Events</h2>\n";
    std::vector<TimedRow> rows;
    for (const Event& event : page.attempt.events)
        rows.push_back({event.time(),
                        {{time_link(page, event.time()), false},
                         text_cell(in_seat_units(station::told(event))),
                         {fmt::format("<code>{}</code>", escaped(event.code().to_string())), false}}});
    html += rows.empty() ? "<p>There were none.</p>\n"
                         : timed_tables(page.attempt, "What happened, as the server told it",
                                        {"time", "what", "code"}, rows);
    if (!page.attempt.lesson.questions.empty()) {
        html += "</section>\n<section aria-labelledby=\"questions\">\n<h2 id=\"questions\">Questions to "
                "ask</h2>\n<ol>\n";
        for (const std::string& question : page.attempt.lesson.questions)
            html += fmt::format("<li>{}</li>\n", escaped(question));
        html += "</ol>\n";
    }
    return html + "</section>\n";
}

std::string ahead_part(const PageContext& page) {
    const Attempt& attempt = page.attempt;
    if (attempt.ahead.empty()) return {};
    std::string html =
        "<section aria-labelledby=\"ahead\">\n<h2 id=\"ahead\">A minute ahead, as the instructor "
        "saw it</h2>\n<p>Predictions were shown";
    for (const auto& [from, until] : attempt.ahead)
        html += fmt::format("{} from {} to {}", from == attempt.ahead.front().first ? "" : ",",
                            time_link(page, from), time_link(page, until));
    html += ": what would come if nobody did anything.</p>\n";
    std::vector<std::vector<Cell>> rows;
    for (const Foreseen& each : attempt.foreseen)
        rows.push_back({{time_link(page, each.told), false},
                        {time_link(page, each.last_told), false},
                        text_cell(station::clock(each.event.time())),
                        text_cell(in_seat_units(station::told(each.event)))});
    html += rows.empty()
                ? "<p>They told of no event.</p>\n"
                : table("Events that they told of", {"told first", "told last", "for", "what"}, rows);
    return html + "</section>\n";
}

std::string origin_part(const PageContext& page) {
    const Origin& origin = page.attempt.origin;
    std::string html = fmt::format(
        "<section aria-labelledby=\"origin\">\n<h2 id=\"origin\">Where this comes from</h2>\n<dl>\n"
        "<dt>Recording</dt><dd>{}, begun {}</dd>\n<dt>SHA-256 of its files</dt><dd><code>{}</code></dd>\n"
        "<dt>Run</dt><dd>{} (the recording has {})</dd>\n<dt>Exercise&#39;s "
        "definition</dt><dd><code>{:016x}</code></dd>\n",
        escaped(origin.recording), escaped(wall_time(origin.recording_began_unix_ns)), escaped(origin.sha256),
        origin.run, origin.runs, page.attempt.definition_hash);
    if (!origin.taken_up_from.empty())
        html += fmt::format(
            "<dt>Server lost</dt><dd>{} time{}; each time the exercise was taken up where it stopped, "
            "and is one attempt</dd>\n",
            origin.taken_up_from.size(), origin.taken_up_from.size() == 1 ? "" : "s");
    if (!origin.recorder_version.empty())
        html += fmt::format("<dt>Recorder</dt><dd>version {}</dd>\n", escaped(origin.recorder_version));
    if (page.attempt.assessment)
        html +=
            fmt::format("<dt>Lesson and assessment</dt><dd><code>{:016x}</code>, <code>{:016x}</code></dd>\n",
                        page.attempt.assessment->lesson_hash(), page.attempt.assessment->assessment_hash());
    if (page.options.ghost) {
        const std::string& sha256 = page.options.ghost->attempt->origin.sha256;
        html +=
            fmt::format("<dt>Paler lines</dt><dd>the lesson {}{}</dd>\n", escaped(page.options.ghost->name),
                        sha256.empty() ? ": its scripts, played from the recording&#39;s first state"
                                       : fmt::format(": <code>{}</code>", escaped(sha256)));
    }
    return html + "</dl>\n<p>Made by <code>recorder debrief</code> from the recording alone. Lines in the "
                  "plots are thinned, "
                  "but no largest and no least value is left out.</p>\n</section>\n";
}

} // namespace windlass::debrief
