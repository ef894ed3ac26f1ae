#include "instructor_console/debrief_page.hpp"

#include "recorder/debrief/page.hpp"
#include "recorder/debrief/read_attempt.hpp"

namespace windlass::console {

std::string debrief_page(const std::filesystem::path& path) {
    recording::Recording recording({path});
    const auto attempt = debrief::read_attempt(recording);
    return debrief::page_of(
        attempt, {.links = {.kind = debrief::Links::Kind::beside, .station = {}, .token = {}}, .over = {}});
}

} // namespace windlass::console
