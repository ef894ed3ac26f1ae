#include "common/json_file.hpp"

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace windlass {
namespace {

using Json = nlohmann::json;

/// Bytes of a file: a ground of some hundred thousand points takes two million.
constexpr off_t kMaxSize = 16 << 20;

std::string read_text(const std::filesystem::path& file) {
    const auto failed = [&file] {
        throw ConfigError(file.string() + ": cannot be read: " + std::strerror(errno));
    };
    const auto close_it = [](const int* descriptor) { close(*descriptor); };
    const int opened = open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC); // a FIFO has nobody wait for it
    if (opened < 0) failed();
    const std::unique_ptr<const int, decltype(close_it)> closes(&opened, close_it);
    struct stat about {};
    if (fstat(opened, &about) != 0) failed();
    if (S_ISDIR(about.st_mode)) throw ConfigError(file.string() + ": is a directory, not a file");
    if (!S_ISREG(about.st_mode)) throw ConfigError(file.string() + ": is no regular file");
    if (about.st_size > kMaxSize)
        throw ConfigError(file.string() + ": is longer than " + std::to_string(kMaxSize) + " bytes");
    std::string text(static_cast<std::size_t>(about.st_size), '\0');
    std::size_t size = 0;
    while (size < text.size()) {
        const ssize_t got = read(opened, text.data() + size, text.size() - size);
        if (got < 0) failed();
        if (got == 0) break;
        size += static_cast<std::size_t>(got);
    }
    text.resize(size);
    return text;
}

/// "line 3, column 7" of a byte in the text, both counted from 1.
std::string place(const std::string& text, std::size_t byte) {
    const std::string before = text.substr(0, byte);
    const std::size_t line = 1 + std::size_t(std::count(before.begin(), before.end(), '\n'));
    const std::size_t line_start = before.rfind('\n') + 1; // npos + 1 = 0: the first line
    return "line " + std::to_string(line) + ", column " + std::to_string(byte - line_start + 1);
}

/// The library's text without its own error number, position and guess at the last token read.
std::string reason(const Json::exception& error) {
    std::string text = error.what();
    for (const char* mark : {"] ", "column "})
        if (const std::size_t at = text.find(mark); at != std::string::npos)
            text = text.substr(text.find(' ', at + std::strlen(mark) - 1) + 1);
    return text;
}

/// Looks on while a document is read. Nothing is nested so deep that going through it exhausts the stack. And
/// no field stands twice in an object: the library keeps the last of two and says nothing, which would lose
/// what the writer meant by the first.
class Onlooker {
public:
    explicit Onlooker(const std::string& source) : source_(source) {}

    bool operator()(int depth, Json::parse_event_t event, const Json& parsed) {
        if (depth > kDeepest)
            throw ConfigError(source_ + ": is nested deeper than " + std::to_string(kDeepest));
        if (event == Json::parse_event_t::object_start)
            seen_.emplace_back();
        else if (event == Json::parse_event_t::object_end)
            seen_.pop_back();
        else if (event == Json::parse_event_t::key && !seen_.back().insert(parsed.get<std::string>()).second)
            throw ConfigError(source_ + ": field " + parsed.dump() + " is given twice in the same object");
        return true;
    }

private:
    static constexpr int kDeepest = 64;
    std::string source_;
    std::vector<std::set<std::string>> seen_; // fields of each object that is open, innermost last
};

} // namespace

Json read_json(const std::filesystem::path& file) {
    return parse_json(read_text(file), file.string());
}

Json parse_json(const std::string& text, const std::string& source) {
    Onlooker looks_on(source);
    try {
        return Json::parse(text, std::ref(looks_on));
    } catch (const Json::parse_error& error) {
        const std::size_t byte = error.byte > 0 ? error.byte - 1 : 0;
        throw ConfigError(source + ": " + place(text, byte) + ": not JSON: " + reason(error));
    } catch (const Json::out_of_range& error) { // "number overflow parsing '1e999'"
        const std::string what = reason(error);
        const std::size_t from = what.find('\'') + 1;
        const std::string number = what.substr(from, what.rfind('\'') - from);
        throw ConfigError(source + ": " + place(text, text.find(number)) + ": " + number +
                          " is not allowed: larger than any number that can be stored");
    }
}

} // namespace windlass
