#include "recorder/debrief/html.hpp"

#include "common/text.hpp"
#include "recorder/debrief/page_style.hpp"

#include <fmt/format.h>

namespace windlass::debrief {

std::string escaped(std::string_view text) {
    std::string html;
    for (const char c : printable(text)) {
        switch (c) {
        case '&':
            html += "&amp;";
            break;
        case '<':
            html += "&lt;";
            break;
        case '>':
            html += "&gt;";
            break;
        case '"':
            html += "&quot;";
            break;
        case '\'':
            html += "&#39;";
            break;
        default:
            html += c;
        }
    }
    return html;
}

Cell text_cell(std::string_view text) {
    return {escaped(text), false};
}
Cell figure_cell(std::string_view text) {
    return {escaped(text), true};
}

std::string document(std::string_view title, std::string_view body, std::string_view style,
                     std::string_view in_head) {
    return fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                       "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                       "{}<title>{}</title>\n<style>\n{}{}</style>\n</head>\n<body>\n<main>\n"
                       "{}</main>\n</body>\n</html>\n",
                       in_head, escaped(title), kStyle, style, body);
}

std::string table(std::string_view caption, const std::vector<std::string>& columns,
                  const std::vector<std::vector<Cell>>& rows) {
    // A table that is too wide for a small screen is scrolled by itself; a keyboard must reach it then. On a
    // phone its cells stand under each other, each with its column's name (page_style.hpp).
    std::string html = "<div class=\"wide\" role=\"group\" tabindex=\"0\" aria-label=\"" + escaped(caption) +
                       "\"><table><caption>" + escaped(caption) + "</caption><thead><tr>";
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const bool figures = !rows.empty() && i < rows.front().size() && rows.front()[i].figure;
        html += std::string("<th scope=\"col\"") + (figures ? " class=\"figure\">" : ">") +
                escaped(columns[i]) + "</th>";
    }
    html += "</tr></thead><tbody>";
    for (const auto& row : rows) {
        html += "<tr>";
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string of = row[i].figure ? " class=\"figure\"" : "";
            const std::string column = i < columns.size() ? escaped(columns[i]) : "";
            html += i == 0 ? "<th scope=\"row\"" + of + ">" + row[i].html + "</th>"
                           : "<td" + of + " data-column=\"" + column + "\">" + row[i].html + "</td>";
        }
        html += "</tr>\n";
    }
    return html + "</tbody></table></div>\n";
}

} // namespace windlass::debrief
