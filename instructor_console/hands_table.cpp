#include "instructor_console/hands_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace windlass::console {

namespace {

/// A line of a table in Markdown: its first cell, and one for each hand.
template <class Cell>
std::string line(const std::string& first, const Cell& cell) {
    std::string text = "| " + first + " |";
    for (const lesson::HandRow& row : lesson::hand_rows())
        text += " " + cell(row) + " |";
    return text + "\n";
}

/// What a hand should get, if that is not what it usually should; else nothing.
std::string unusual(const lesson::Hand& hand) {
    const auto rows = lesson::hand_rows();
    const auto usual = std::ranges::find_if(
        rows, [&](const lesson::HandRow& row) { return std::string(row.name) == hand.name; });
    return usual == rows.end() || usual->should == hand.should
               ? ""
               : fmt::format(" ({})", lesson::should_name(hand.should));
}

/// "98.8 +": points of 100, and whether it was achieved (+), not yet (-) or not shown (nothing).
std::string cell_of(const assess::Result& result) {
    const char* sign = result.outcome == assess::Outcome::achieved  ? " +"
                       : result.outcome == assess::Outcome::not_yet ? " -"
                                                                    : "";
    return points(result.tenths) + sign;
}

} // namespace

std::string points(int tenths) {
    return fmt::format("{}.{}", tenths / 10, tenths % 10);
}

void HandsTable::add(const std::string& lesson, const lesson::Hand& hand, const lesson::Played& played) {
    if (rows_.empty() || rows_.back().lesson != lesson) rows_.push_back({.lesson = lesson, .cells = {}});
    rows_.back().cells[hand.name] =
        cell_of(played.result) + unusual(hand) + (lesson::fault_of(hand, played).empty() ? "" : " **?**");
}

std::string HandsTable::table() const {
    std::string text = line("lesson", [](const lesson::HandRow& row) { return std::string(row.name); }) +
                       line("---", [](const lesson::HandRow&) { return std::string("---"); }) +
                       line("*should*", [](const lesson::HandRow& row) {
                           return fmt::format("*{}*", lesson::should_name(row.should));
                       });
    for (const Row& row : rows_)
        text += line(row.lesson, [&](const lesson::HandRow& hand) {
            const auto cell = row.cells.find(hand.name);
            return cell == row.cells.end() ? std::string() : cell->second;
        });
    return text;
}

std::string HandsTable::document(const std::string& file, const std::string& note) const {
    std::string text = fmt::format(
        "# Every lesson against hands that its author did not write\n\n"
        "Written by `./run console lesson try --hands --output {}`{}. "
        "[lessons.md](lessons.md#hands-that-the-author-did-not-write) says what these hands are for; a test "
        "holds every cell ([hands_test.cpp](../tests/lesson/hands_test.cpp)).\n\n"
        "Points of 100; `+` achieved, `-` not yet, nothing behind them: not shown. *fail*: not achieved and "
        "{} at most (idle: below {}); *pass*: achieved; *end*: either, since what counts is that the lesson "
        "ends and says why. In brackets: what this lesson should make of him, where that is another thing. "
        "`?`: not as it should be. An empty cell is a hand who differs in nothing from the model run "
        "there, or, where a trainee has the conn, in how he takes the orders that he then gives "
        "himself.\n\n{}\n",
        file, note.empty() ? "" : ": " + note, lesson::kWrongMost, lesson::kIdleMost, table());
    text += "| hand | what he does | should |\n|---|---|---|\n";
    for (const lesson::HandRow& row : lesson::hand_rows())
        text += fmt::format("| {} | {} | {} |\n", row.name, row.about, lesson::should_name(row.should));
    return text;
}

} // namespace windlass::console
