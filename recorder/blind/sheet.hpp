#pragma once
// A recording as a sheet to be marked by one who knows neither whose it is nor what we have made of it.

#include "recorder/blind/questions.hpp"
#include "recorder/debrief/attempt.hpp"

#include <filesystem>

namespace windlass::blind {

struct Sheet {
    debrief::Attempt attempt;
    assess::Lesson lesson;
    assess::Result computed; ///< without an assessor's words
    std::vector<Question> questions;
};

/// The last attempt of a recording, marked again by the fold that marked it live. Throws std::runtime_error
/// where it is at no lesson, the lesson did not come to its end, or the recorded marks do not come out again;
/// recorder::Gap where an order is missing; mcap::Damage.
Sheet read_sheet(const std::filesystem::path& recording);

/// What the master looks at, as one HTML document without script: briefing, what was ordered and reported,
/// what happened, the curves, the questions. Neither marks nor names are in it, nor the recording's.
std::string page_of(const Sheet& sheet, const std::string& code);

/// What he fills in: columns sheet, item, question, allowed, answer, remark.
std::string form_of(const Sheet& sheet, const std::string& code);

} // namespace windlass::blind
