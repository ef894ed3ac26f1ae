#include "instructor_console/debrief_page.hpp"

#include "recorder/debrief/page.hpp"
#include "recorder/debrief/read_attempt.hpp"
#include "recorder/debrief/scenes.hpp"

namespace windlass::console {

std::string debrief_page(const std::filesystem::path& path) {
    recording::Recording recording({path});
    auto attempt = debrief::read_attempt(recording);
    debrief::read_scenes(recording, attempt);
    return debrief::page_of(
        attempt, {.links = {.kind = debrief::Links::Kind::beside, .station = {}, .token = {}}, .over = {}});
}

} // namespace windlass::console
