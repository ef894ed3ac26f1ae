#pragma once
// What classes have to do with the history: their attempts and assessors' words on them go into it, and it
// tells those words and what is to be practised next.

#include "door/door_host.hpp"
#include "recorder/debrief/page.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace windlass::door {

class ClassHistory {
public:
    /// history: the file. recordings: the folder of those that classes make. exercises: the folder whose
    /// lessons are offered.
    ClassHistory(std::filesystem::path history, std::filesystem::path recordings,
                 std::filesystem::path exercises)
        : history_(std::move(history)),
          recordings_(std::move(recordings)),
          exercises_(std::move(exercises)) {}

    /// An attempt with all who worked in it, known by the names that they gave; one of its recording goes.
    /// Throws what reading the recording or writing the history throws.
    void put(const AttemptMade& made) const;

    /// What each of these is to practise next: [{name, file, title, why, practice, after, from, no_from}],
    /// without those who are in no history. lessons: as the lessons page lists them; "file" is the lesson's,
    /// as a class is opened with it. from: whence the last attempt is done again, for practice alone; null:
    /// from nowhere, and no_from says why, where it is for practice.
    nlohmann::json next(const std::vector<std::string>& names, const nlohmann::json& lessons) const;

    /// Puts an assessor's word in. Why it is not taken; empty: it stands.
    std::string judge(const AttemptJudged& judged) const;

    /// The words that stand on the attempts of these recordings.
    std::vector<AttemptJudged> words(const std::vector<std::string>& recordings) const;

    /// The same on one, for its debriefing; nothing: there is none.
    std::optional<debrief::LaterWord> word_on(const std::string& recording) const;

private:
    struct AgainFrom {
        nlohmann::json from = nullptr;
        std::string why_not = {};
    };
    AgainFrom again_from(const std::filesystem::path& recording) const;

    std::filesystem::path history_, recordings_, exercises_;
};

} // namespace windlass::door
