#pragma once
// What was done at the door, and by whom: lines of JSON that are only ever added to.

#include <nlohmann/json.hpp>

#include <filesystem>
#include <functional>
#include <string>

namespace windlass::door {

class Audit {
public:
    /// failed: told when a line could not be written. The file is opened for each line, so that it may be
    /// taken away (logrotate); mode 0600.
    Audit(std::filesystem::path file, std::function<void(const std::string&)> failed)
        : file_{std::move(file)}, failed_{std::move(failed)} {}

    /// what: e.g. "login"; the rest: fields beside "at" (UTC) and "what".
    void write(const std::string& what, nlohmann::json fields) const;

private:
    const std::filesystem::path file_;
    const std::function<void(const std::string&)> failed_;
};

} // namespace windlass::door
