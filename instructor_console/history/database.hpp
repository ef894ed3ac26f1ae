#pragma once
// SQLite, as far as the history needs it: a file, statements with bound values, transactions.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

struct sqlite3;

namespace windlass::history {

/// A value of a column; monostate: NULL.
using Value = std::variant<std::monostate, std::int64_t, double, std::string>;
using Row = std::vector<Value>;

/// Empty for NULL.
std::string text_of(const Value& value);
std::optional<std::int64_t> integer_of(const Value& value);

/// What is bound where there may be nothing.
Value or_null(const std::string& text); ///< empty: NULL
template <class Number>
Value or_null(const std::optional<Number>& value) {
    return value ? Value(*value) : Value();
}

class Database {
public:
    /// Opens the file or makes it, readable by its owner alone. Throws std::runtime_error, naming the file,
    /// when it is no database or cannot be written.
    explicit Database(const std::filesystem::path& file);

    /// One statement; values stand for its question marks, in their order. Returns its rows. Throws
    /// std::runtime_error with what SQLite says.
    std::vector<Row> run(const std::string& sql, const std::vector<Value>& values = {});
    /// Several statements without values.
    void run_all(const std::string& sql);
    /// Rows that the last statement changed.
    std::int64_t changed() const;

    /// All of it, or, when it throws, nothing.
    void all_or_nothing(const std::function<void()>& work);

private:
    [[noreturn]] void fail(const std::string& what) const;

    std::filesystem::path file_;
    struct Close {
        void operator()(sqlite3* database) const;
    };
    std::unique_ptr<sqlite3, Close> database_;
};

} // namespace windlass::history
