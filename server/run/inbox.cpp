#include "server/run/inbox.hpp"

#include "server/run/limits.hpp"

#include <spdlog/fmt/fmt.h>

namespace windlass::run {

std::string Refusal::text() const {
    return fmt::format("{} from {}: {} = {} refused; allowed: {}", topic,
                       source.empty() ? "(unnamed)" : source, field, value, allowed);
}

bool stays_in_folder(const std::string& name) {
    return !name.empty() && name.front() != '/' && name.find("..") == std::string::npos &&
           name.find('\\') == std::string::npos;
}

} // namespace windlass::run
