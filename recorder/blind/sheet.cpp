#include "recorder/blind/sheet.hpp"

#include "recorder/blind/answers.hpp"
#include "recorder/debrief/compare.hpp"
#include "recorder/debrief/curves.hpp"
#include "recorder/debrief/html.hpp"
#include "recorder/debrief/page_parts.hpp"
#include "recorder/debrief/page_style.hpp"
#include "recorder/debrief/read_attempt.hpp"
#include "recorder/debrief/seat_units.hpp"
#include "recorder/export/csv_text.hpp"
#include "recorder/resimulate/reassessment.hpp"
#include "station/format.hpp"
#include "station/line_view.hpp"
#include "station/names.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace windlass::blind {

namespace {

using debrief::Attempt;
using debrief::Cell;
using debrief::escaped;
using debrief::figure_cell;
using debrief::text_cell;

/// What happened to anchor, cable, gear and ship. What people did to the exercise has their names, and is
/// left out.
std::vector<debrief::Moment> happened(const Attempt& attempt) {
    std::vector<debrief::Moment> all;
    for (const Event& event : attempt.events) {
        const std::string code = event.code().to_string();
        const words::Event* row = words::find_event(code);
        const bool of_people =
            code.starts_with("exercise.") || code.starts_with("classroom.") || code.starts_with("levers.");
        if (row != nullptr && row->moment && !of_people)
            all.push_back({event.time(), debrief::in_seat_units(station::told(event)), event.side()});
    }
    return all;
}

std::string happened_part(const std::vector<debrief::Moment>& moments) {
    std::vector<std::vector<Cell>> rows;
    for (std::size_t i = 0; i < moments.size(); ++i)
        rows.push_back({figure_cell(fmt::format("{}", i + 1)), figure_cell(station::clock(moments[i].time)),
                        text_cell(moments[i].what)});
    return debrief::table("What happened; the numbers are those of the flags in the plots",
                          {"no.", "time", "what"}, rows);
}

/// What was said, with cable, tension and way as they were then.
std::string said_part(const Attempt& attempt) {
    struct Said {
        double time = 0;
        const char* who = "";
        std::string words;
    };
    std::vector<Said> said;
    for (const debrief::GivenOrder& given : attempt.orders) {
        said.push_back({given.order.time(), "bridge", station::words(given.order)});
        if (given.order.state() == ORDER_CANCELLED)
            said.push_back({given.changed, "bridge", "takes back: " + station::words(given.order)});
    }
    for (const debrief::SaidReport& report : attempt.reports)
        said.push_back({report.time, "forecastle", station::words(report.report)});
    std::ranges::stable_sort(said, {}, &Said::time);

    std::vector<std::string> columns{"time", "who", "what"};
    for (const std::size_t side : {SIDE_PORT, SIDE_STARBOARD})
        if (attempt.sides[side].worked)
            for (const char* what : {"cable out", "leads", "tension at the lip"})
                columns.push_back(fmt::format("{}, {}", what, side == SIDE_PORT ? "port" : "starboard"));
    columns.emplace_back("ship's speed");
    std::vector<std::vector<Cell>> rows;
    for (const Said& each : said) {
        std::vector<Cell> row{figure_cell(station::clock(each.time)), text_cell(each.who),
                              text_cell(each.words)};
        for (const debrief::Side& side : attempt.sides) {
            if (!side.worked) continue;
            const auto out = side.curves[debrief::kCableOut].at(each.time);
            const auto pull = side.curves[debrief::kTension].at(each.time);
            row.push_back(figure_cell(
                out ? fmt::format("{}, {}", station::cable(*out), debrief::shackles_text(*out)) : ""));
            const debrief::Truth* truth = side.truth_at(each.time);
            row.push_back(text_cell(truth == nullptr ? ""
                                                     : fmt::format("{}, {}", station::lead(truth->lead_clock),
                                                                   station::words(truth->stay))));
            row.push_back(figure_cell(pull ? station::tonnes(*pull * words::units::tonne) : ""));
        }
        const auto speed = attempt.ship[debrief::kSpeedOverGround].at(each.time);
        row.push_back(figure_cell(speed ? fmt::format("{:.1f} kn", *speed) : ""));
        rows.push_back(std::move(row));
    }
    return debrief::table("What was said, and how it was then", columns, rows);
}

/// "0 not done; 1 poor; 2 fair; 3 good; - cannot be told", or that of the whole.
std::string scale_of(const Question& question) {
    std::string words;
    for (std::size_t mark = 0; mark <= kTopMark; ++mark)
        words += fmt::format("{} {}; ", mark, question.item == kOverall ? kWholeScale[mark] : kScale[mark]);
    return words + "- cannot be told";
}

std::string questions_part(const Sheet& sheet) {
    std::vector<std::vector<Cell>> rows;
    for (const Question& question : sheet.questions) {
        std::vector<Cell> row{
            text_cell(question.words + (question.item == kOverall ? " " + scale_of(question) : ""))};
        for (const char* mark : {"0", "1", "2", "3", "-"})
            row.push_back({fmt::format("\u2610\u00a0{}", mark), false});
        rows.push_back(std::move(row));
    }
    return debrief::table(scale_of(sheet.questions.front()), {"question", "", "", "", "", ""}, rows);
}

} // namespace

Sheet read_sheet(const std::filesystem::path& path) {
    recording::Recording recording(std::vector{path});
    const auto refuse = [&](const char* why) {
        throw std::runtime_error(fmt::format("{}: {}", path.string(), why));
    };
    auto found = recorder::reassess(recording);
    Sheet sheet{.attempt = debrief::read_attempt(recording), .lesson = {}, .computed = {}, .questions = {}};
    if (!sheet.attempt.origin.complete) refuse("a part of it could not be read");
    if (found.runs.empty() || !sheet.attempt.assessment) refuse("its last attempt is at no lesson");
    if (!found.runs.back().result.finished) refuse("the lesson of its last attempt did not come to its end");
    if (found.runs.back().result.assessment_hash != sheet.attempt.assessment->assessment_hash())
        refuse("its recorded marks do not come out again: another version of the model has made it");
    sheet.lesson = std::move(found.runs.back().taught);
    sheet.computed = std::move(found.runs.back().computed);
    sheet.questions = questions_of(sheet.lesson, sheet.computed);
    return sheet;
}

std::string page_of(const Sheet& sheet, const std::string& code) {
    const Attempt& attempt = sheet.attempt;
    const debrief::PageOptions nothing;
    const debrief::PageContext context{attempt, nothing, happened(attempt),
                                       debrief::tension_limits(attempt.scenes)};
    std::string facts = fmt::format("<dt>To be marked</dt><dd>{} to {}; then the lesson was over</dd>\n",
                                    station::clock(attempt.began), station::clock(sheet.computed.time));
    for (const debrief::Figure& each : debrief::figures_of(attempt))
        if (each.id != "score")
            facts += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped(each.name), escaped(each.words));
    const std::string title = fmt::format("Sheet {}: {}", code, sheet.lesson.title);
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>{0}</title>\n<style>\n{1}</style>\n</head>\n<body>\n<main>\n<h1>{0}</h1>\n"
        "<p>Mark it alone, and talk to nobody about it before all are marked. What the program has made of "
        "it you are "
        "not told. Answer on paper, or in <code>{2}.csv</code>.</p>\n"
        "<h2>What the trainee was told</h2>\n<p>{3}</p>\n<h2>What was done</h2>\n<dl>\n{4}</dl>\n{5}{6}{7}"
        "<section>\n<h2>Your marks</h2>\n{8}</section>\n</main>\n</body>\n</html>\n",
        escaped(title), debrief::kStyle, escaped(code),
        escaped(debrief::in_seat_units(sheet.lesson.briefing)), facts, happened_part(context.moments),
        said_part(attempt), debrief::plots_part(context), questions_part(sheet));
}

std::string form_of(const Sheet& sheet, const std::string& code) {
    using recorder::csv_cell;
    std::string csv = "sheet,item,question,allowed,answer,remark\r\n";
    csv += fmt::format("{},{},Who marks this?,a name or a number; the same on all sheets,,\r\n", code,
                       kRaterItem);
    for (const Question& question : sheet.questions)
        csv += fmt::format("{},{},{},{},,\r\n", code, csv_cell(question.item), csv_cell(question.words),
                           csv_cell(scale_of(question)));
    return csv;
}

} // namespace windlass::blind
