#pragma once
// A shipped lesson, played by scripts and recorded.

#include "instructor_console/lesson_files.hpp"
#include "lesson/play.hpp"
#include "lesson/seat.hpp"
#include "server/run/questions.hpp"
#include "tests/recorder/taped_session.hpp"

#include "idl/topics.hpp"

namespace windlass::test {

namespace fs = std::filesystem;

inline const fs::path kConfig = WINDLASS_CONFIG_DIR;

inline console::LessonFile lesson_file(const char* name) {
    return console::read_lesson_file(kConfig / "exercises" / name);
}

/// A lesson played by scripts and recorded into the folder, the load as often as a server tells it.
inline fs::path recorded(const fs::path& folder, const console::LessonFile& file,
                         const assess::LessonRun& run) {
    std::vector<lesson::Seat> seats;
    for (const std::string& script : run.scripts)
        seats.emplace_back(
            lesson::Part{.script = trainee::load_script(file.root / script, trainee::Eyes::seat)}, file.def,
            "trainee-" + std::to_string(seats.size() + 1));
    TapedSession taped(folder, file.def);
    taped.every = file.def.tick_rate_hz / static_cast<int>(wire::topics::windlass_load.rate);
    const int look = static_cast<int>(lesson::kLook * file.def.tick_rate_hz);
    std::size_t noticed = 0;
    while (!taped.session().assessor().ended()) {
        if (taped.session().now_tick() % static_cast<std::uint64_t>(look) == 0) {
            for (run::ReceivedOrder& order :
                 lesson::look_and_act(seats, taped.session().snapshot(), taped.session().status()))
                taped.give(std::move(order.what), order.source.c_str());
        }
        taped.run(1);
        for (const bool forecastle : {true, false})
            if (taped.session().assessor().open_question(forecastle) >= 0)
                if (auto answer =
                        lesson::answer_to(run::question_to(forecastle, taped.session().assessor()), seats))
                    taped.give(std::move(answer->what), answer->source.c_str());
        for (; noticed < taped.heard().size(); ++noticed)
            for (lesson::Seat& seat : seats)
                seat.notice(taped.heard()[noticed], taped.session().snapshot());
    }
    taped.run(file.def.tick_rate_hz); // as somebody is a while in stopping the recorder
    taped.close();
    return folder;
}

} // namespace windlass::test
