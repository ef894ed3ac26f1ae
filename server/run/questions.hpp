#pragma once
// What a lesson asks a seat at a freeze.

#include "server/assess/assessor.hpp"
#include "server/run/status.hpp"

namespace windlass::run {

/// What the forecastle, or the bridge, is asked now; without an id: nothing. Run, tick and time are left
/// open.
QuestionView question_to(bool forecastle, const assess::Assessor& assessor);

} // namespace windlass::run
