#include "door/audit.hpp"

#include <cerrno>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <unistd.h>

namespace windlass::door {

namespace {

std::string utc() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    gmtime_r(&now, &parts);
    char text[32];
    return {text, std::strftime(text, sizeof text, "%FT%TZ", &parts)};
}

} // namespace

void Audit::write(const std::string& what, nlohmann::json fields) const {
    nlohmann::ordered_json line{{"at", utc()}, {"what", what}};
    if (fields.is_object()) line.update(fields);
    const std::string text = line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
    const int to = open(file_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
    const bool whole = to >= 0 && ::write(to, text.data(), text.size()) == static_cast<ssize_t>(text.size());
    const std::string why = whole ? "" : std::strerror(errno);
    if (to >= 0) close(to);
    if (!whole) failed_("cannot write " + file_.string() + ": " + why);
}

} // namespace windlass::door
