#include "instructor_console/history/database.hpp"

#include <sqlite3.h>

#include <stdexcept>

namespace windlass::history {

namespace {

constexpr int kPatience = 5000; // ms, while another program writes

struct Finalize {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};

int bind(sqlite3_stmt* statement, int index, const Value& value) {
    if (const auto* number = std::get_if<std::int64_t>(&value))
        return sqlite3_bind_int64(statement, index, *number);
    if (const auto* number = std::get_if<double>(&value))
        return sqlite3_bind_double(statement, index, *number);
    if (const auto* text = std::get_if<std::string>(&value))
        return sqlite3_bind_text(statement, index, text->data(), static_cast<int>(text->size()),
                                 SQLITE_TRANSIENT);
    return sqlite3_bind_null(statement, index);
}

Value column(sqlite3_stmt* statement, int index) {
    switch (sqlite3_column_type(statement, index)) {
    case SQLITE_INTEGER:
        return std::int64_t{sqlite3_column_int64(statement, index)};
    case SQLITE_FLOAT:
        return sqlite3_column_double(statement, index);
    case SQLITE_NULL:
        return {};
    default:
        return std::string(reinterpret_cast<const char*>(sqlite3_column_text(statement, index)),
                           static_cast<std::size_t>(sqlite3_column_bytes(statement, index)));
    }
}

} // namespace

std::string text_of(const Value& value) {
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    if (const auto* number = std::get_if<std::int64_t>(&value)) return std::to_string(*number);
    if (const auto* number = std::get_if<double>(&value)) return std::to_string(*number);
    return {};
}

std::optional<std::int64_t> integer_of(const Value& value) {
    const auto* number = std::get_if<std::int64_t>(&value);
    return number == nullptr ? std::nullopt : std::optional(*number);
}

Value or_null(const std::string& text) {
    return text.empty() ? Value() : Value(text);
}

void Database::Close::operator()(sqlite3* database) const {
    sqlite3_close(database);
}

Database::Database(const std::filesystem::path& file) : file_(file) {
    const bool made = !std::filesystem::exists(file);
    if (made && file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
    sqlite3* opened = nullptr;
    const int code =
        sqlite3_open_v2(file.c_str(), &opened, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
    database_.reset(opened);
    if (code != SQLITE_OK) fail("cannot open");
    namespace fs = std::filesystem;
    if (made) fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
    sqlite3_busy_timeout(opened, kPatience);
}

void Database::fail(const std::string& what) const {
    throw std::runtime_error(file_.string() + ": " + what + ": " +
                             (database_ ? sqlite3_errmsg(database_.get()) : "out of memory"));
}

std::vector<Row> Database::run(const std::string& sql, const std::vector<Value>& values) {
    sqlite3_stmt* prepared = nullptr;
    if (sqlite3_prepare_v2(database_.get(), sql.c_str(), -1, &prepared, nullptr) != SQLITE_OK)
        fail("cannot use");
    const std::unique_ptr<sqlite3_stmt, Finalize> statement(prepared);
    for (std::size_t i = 0; i < values.size(); ++i)
        if (bind(prepared, static_cast<int>(i) + 1, values[i]) != SQLITE_OK) fail("cannot use");
    std::vector<Row> rows;
    for (;;) {
        const int code = sqlite3_step(prepared);
        if (code == SQLITE_DONE) return rows;
        if (code != SQLITE_ROW) fail("cannot use");
        Row& row = rows.emplace_back();
        for (int i = 0; i < sqlite3_column_count(prepared); ++i)
            row.push_back(column(prepared, i));
    }
}

void Database::run_all(const std::string& sql) {
    if (sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
        fail("cannot use");
}

std::int64_t Database::changed() const {
    return sqlite3_changes(database_.get());
}

void Database::all_or_nothing(const std::function<void()>& work) {
    run("BEGIN IMMEDIATE");
    try {
        work();
        run("COMMIT");
    } catch (...) {
        sqlite3_exec(database_.get(), "ROLLBACK", nullptr, nullptr, nullptr); // what went wrong first is told
        throw;
    }
}

} // namespace windlass::history
