#include "recorder/blind/answers.hpp"

#include "common/json_file.hpp"
#include "recorder/blind/questions.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>

namespace windlass::blind {

namespace {

using nlohmann::json;

struct Row {
    std::size_t line = 0; ///< 1: the first of the file
    std::vector<std::string> cells;
    const std::string& at(std::size_t column) const {
        static const std::string none;
        return column < cells.size() ? cells[column] : none;
    }
};

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// RFC 4180, by whichever of comma and semicolon comes first. Rows without any text are left out.
std::vector<Row> rows_of(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    const auto mark = text.find_first_of(",;");
    const char separator = mark == std::string_view::npos ? ',' : text[mark];
    std::vector<Row> rows;
    Row row{.line = 1, .cells = {""}};
    bool quoted = false;
    std::size_t line = 1;
    const auto end_row = [&] {
        bool empty = true;
        for (std::string& cell : row.cells) {
            cell = trimmed(cell);
            empty = empty && cell.empty();
        }
        if (!empty) rows.push_back(std::move(row));
        row = {.line = line, .cells = {""}};
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '\n') ++line;
        if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"')
            row.cells.back() += text[++i];
        else if (c == '"')
            quoted = !quoted;
        else if (!quoted && c == separator)
            row.cells.emplace_back();
        else if (!quoted && c == '\n')
            end_row();
        else if (c != '\r')
            row.cells.back() += c;
    }
    end_row();
    return rows;
}

/// The forms of one file, as far as they were read.
class FormReader {
public:
    FormReader(const std::filesystem::path& file, const Key& key, std::string& faults)
        : file_(file.string()), key_(key), faults_(faults) {
        std::ifstream in(file, std::ios::binary);
        if (!in) throw ConfigError(file_ + ": cannot be read");
        const auto rows = rows_of(std::string{std::istreambuf_iterator<char>(in), {}});
        const auto column = [&](const char* name) -> std::size_t {
            for (std::size_t k = 0; !rows.empty() && k < rows[0].cells.size(); ++k)
                if (rows[0].cells[k] == name) return k;
            throw ConfigError(
                fmt::format("{}:1: column {} is missing: sheet, item and answer are needed", file_, name));
        };
        const std::size_t sheet = column("sheet"), item = column("item"), answer = column("answer");
        for (std::size_t k = 1; k < rows.size(); ++k)
            take(rows[k].line, rows[k].at(sheet), rows[k].at(item), rows[k].at(answer));
    }

    /// Puts them to those of their raters, once each is whole.
    void add_to(std::map<std::string, Rater>& raters) const {
        for (const auto& [sheet, form] : forms_) {
            for (const auto& [item, ours] : key_.at(sheet))
                if (!form.seen.contains(item))
                    faults_ += fmt::format("{}: sheet {}: item {} is missing\n", file_, sheet, item);
            if (form.rater.empty()) {
                faults_ += fmt::format("{}: sheet {}: item {} is missing\n", file_, sheet, kRaterItem);
                continue;
            }
            Rater& rater = raters[form.rater];
            rater.name = form.rater;
            if (!rater.marks.emplace(sheet, form.marks).second)
                faults_ +=
                    fmt::format("{}: sheet {}: {} has marked it in another file\n", file_, sheet, form.rater);
        }
    }

private:
    struct Form {
        std::string rater;
        std::map<std::string, std::size_t> seen; ///< item, line
        std::map<std::string, int> marks;
    };

    void refuse(std::size_t line, const std::string& field, const std::string& value,
                const std::string& allowed) {
        faults_ += fmt::format("{}:{}: {}: \"{}\" is not allowed: {}\n", file_, line, field, value, allowed);
    }

    void take(std::size_t line, const std::string& sheet, const std::string& item,
              const std::string& answer) {
        const auto known = key_.find(sheet);
        if (known == key_.end()) return refuse(line, "sheet", sheet, "a sheet of the key");
        const bool rater = item == kRaterItem;
        if (!rater && !known->second.contains(item))
            return refuse(line, "item", item, "an item of sheet " + sheet);
        Form& form = forms_[sheet];
        if (const auto [first, fresh] = form.seen.emplace(item, line); !fresh)
            return refuse(line, "item", item, fmt::format("once; it stands in line {}, too", first->second));
        const std::string field = "answer of " + item;
        if (rater) {
            if (answer.empty() || answer == kOurs)
                return refuse(line, field, answer, "a name or a number, but not ours");
            form.rater = answer;
        } else if (answer.size() == 1 && answer[0] >= '0' && answer[0] <= '0' + kTopMark) {
            form.marks.emplace(item, answer[0] - '0');
        } else if (answer != "-") {
            refuse(line, field, answer, fmt::format("0 to {}, or - where it cannot be told", kTopMark));
        }
    }

    const std::string file_;
    const Key& key_;
    std::string& faults_;
    std::map<std::string, Form> forms_;
};

} // namespace

Key read_key(const std::filesystem::path& file) {
    const json read = read_json(file);
    const auto refuse = [&](const std::string& what) {
        throw ConfigError(file.string() + ": " + what +
                          ": it is no key that `recorder blind sheets` has written");
    };
    if (!read.is_object() || read.value("format", json()) != kKeyFormat)
        refuse(fmt::format("/format: only \"{}\" is allowed", kKeyFormat));
    Key key;
    try {
        for (const auto& [code, sheet] : read.at("sheets").items())
            for (const auto& [item, mark] : sheet.at("marks").items()) {
                auto& ours = key[code][item];
                if (mark.is_null()) continue;
                ours = mark.get<int>();
                if (!mark.is_number_integer() || *ours < 0 || *ours > kTopMark)
                    refuse(fmt::format("/sheets/{}/marks/{}: {} is not allowed: 0 to {}, or null", code, item,
                                       mark.dump(), kTopMark));
            }
    } catch (const json::exception& error) {
        refuse(error.what());
    }
    return key;
}

Rater ours_of(const Key& key) {
    Rater ours{.name = kOurs, .marks = {}};
    for (const auto& [sheet, items] : key)
        for (const auto& [item, mark] : items)
            if (mark) ours.marks[sheet].emplace(item, *mark);
    return ours;
}

std::vector<Rater> read_forms(const std::vector<std::filesystem::path>& files, const Key& key) {
    std::string faults;
    std::map<std::string, Rater> raters;
    for (const auto& file : files)
        FormReader(file, key, faults).add_to(raters);
    if (!faults.empty()) throw ConfigError(faults.substr(0, faults.size() - 1));
    std::vector<Rater> all;
    for (auto& [name, rater] : raters)
        all.push_back(std::move(rater));
    return all;
}

} // namespace windlass::blind
