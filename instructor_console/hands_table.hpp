#pragma once
// The table of all lessons against all generic hands, as the console prints it or writes it as a document.

#include "lesson/hands.hpp"

#include <map>
#include <string>
#include <vector>

namespace windlass::console {

/// Points of 100 with their tenth: "98.8".
std::string points(int tenths);

/// Rows are lessons, in the order in which they came; columns are hands, in that of hand_rows().
class HandsTable {
public:
    /// What a lesson made of a hand. lesson: its id.
    void add(const std::string& lesson, const lesson::Hand& hand, const lesson::Played& played);

    /// In Markdown. A cell says what the hand should get where its lesson says another thing than is usual,
    /// and **?** where that is not what it got; it is empty where there is no such hand.
    std::string table() const;

    /// Table and hands as a document. file: as the command was told to write it; note: date, machine, commit,
    /// or nothing.
    std::string document(const std::string& file, const std::string& note) const;

private:
    struct Row {
        std::string lesson;
        std::map<std::string, std::string> cells; ///< by the hand's name
    };
    std::vector<Row> rows_;
};

} // namespace windlass::console
