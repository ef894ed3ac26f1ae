#pragma once
// The exercise files of a folder for a page that edits them: listed, read, checked as "lesson check" does,
// saved. Nothing outside the folder is read for its text or written.

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

namespace windlass::console {

/// What is wrong with an exercise, and where.
struct Mistake {
    std::string at;   ///< JSON pointer of the field, e.g. "/lesson/criteria/2/max"; empty: the whole
    std::string text; ///< what is wrong with it, and what is allowed
};

/// A name that a file of the folder may have: 1 to 64 letters, digits, dots, dashes, underscores, the first
/// of them a letter or digit, without ".json". No such name leads out of a folder.
bool is_file_name(const std::string& name);

class ExerciseFiles {
public:
    /// folder: "exercises" of a config folder.
    explicit ExerciseFiles(std::filesystem::path folder);

    /// request: "what" is list, read, check or save, with "name", "text", "over" as docs/gateway.md says.
    /// Throws std::exception with what is wrong. From any thread.
    nlohmann::json answer(const nlohmann::json& request);

    nlohmann::json list() const;
    nlohmann::json read(const std::string& name) const;
    /// name: under which it will be saved; empty: not known yet.
    nlohmann::json check(const std::string& name, const std::string& text) const;
    /// over: the stamp that a file of that name had when it was read; empty: there must be none yet.
    nlohmann::json save(const std::string& name, const std::string& text, const std::string& over);

    std::vector<Mistake> mistakes(const std::string& name, const std::string& text) const;

private:
    /// Throws std::runtime_error for a name that is none, or that leads elsewhere.
    std::filesystem::path file_of(const std::string& name) const;
    bool begins_with_itself(const std::string& name, const std::string& from) const;
    nlohmann::json inherited(const std::string& text) const;
    std::vector<std::string> doubts(const std::string& name, const std::string& text) const;
    void write(const std::filesystem::path& file, const std::string& text, bool replace) const;

    std::filesystem::path folder_, root_;
    std::mutex saving_; // one page after the other
};

} // namespace windlass::console
