#pragma once
// Pieces of an HTML document. Every text goes through escaped(): names and notes come from files and people.

#include <string>
#include <string_view>
#include <vector>

namespace windlass::debrief {

/// For element content and for attributes in double quotes; control characters become '?'.
std::string escaped(std::string_view text);

/// A cell of a table.
struct Cell {
    std::string html;    ///< already markup
    bool figure = false; ///< right-aligned
};
Cell text_cell(std::string_view text);
Cell figure_cell(std::string_view text);

/// A whole document that looks like a debriefing. style: what this one has beside that; in_head: markup for
/// its head, body: of its main part.
std::string document(std::string_view title, std::string_view body, std::string_view style = {},
                     std::string_view in_head = {});

/// A table with a caption, header cells with their scope, and of each row the first cell as its header.
std::string table(std::string_view caption, const std::vector<std::string>& columns,
                  const std::vector<std::vector<Cell>>& rows);

} // namespace windlass::debrief
