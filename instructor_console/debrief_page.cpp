#include "instructor_console/debrief_page.hpp"

#include "recorder/debrief/page.hpp"
#include "recorder/debrief/read_attempt.hpp"
#include "recorder/debrief/scenes.hpp"
#include "recorder/ghost.hpp"

namespace windlass::console {

std::string debrief_page(const std::filesystem::path& path, const std::filesystem::path& config) {
    recording::Recording recording({path});
    auto attempt = debrief::read_attempt(recording);
    debrief::read_scenes(recording, attempt);
    debrief::PageOptions options{.links = {.kind = debrief::Links::Kind::beside, .station = {}, .token = {}}};
    std::optional<debrief::Attempt> model;
    if (attempt.assessment) {
        try {
            model = recorder::model_ghost(recording, attempt, config);
            options.ghost = debrief::Ghost{&*model, "as the model hands did it"};
        } catch (const std::runtime_error& error) {
            options.no_ghost = error.what();
        }
    }
    return debrief::page_of(attempt, options);
}

} // namespace windlass::console
