#pragma once
// A recording's assessment made again, by the same fold over the run gone through again, and held against the
// assessments that were recorded.

#include "recorder/resimulate/resimulation.hpp"

namespace windlass::recorder {

/// What came of one run.
struct Reassessed {
    std::size_t run = 0; ///< 1: the first of the recording
    std::string lesson;  ///< its id
    assess::Result result;
    assess::Result computed; ///< without the assessor's words
    assess::Lesson taught;
};

struct Reassessment {
    std::vector<Reassessed> runs;        ///< those with a lesson
    std::size_t recorded = 0, equal = 0; ///< assessments in the recording, and those that came out again
    std::string first_that_differs;      ///< in words; empty: none
};

/// Goes through every run that has a lesson. An assessment is equal when a run comes, at its tick, to its
/// hash. Throws Gap, mcap::Damage.
Reassessment reassess(recording::Recording& recording);

} // namespace windlass::recorder
