#pragma once
// What a search found, in words and for programs.

#include "lesson/whatif/search.hpp"

#include <nlohmann/json_fwd.hpp>

namespace windlass::whatif {

/// "0:29.0 the port wheel hard on, 2.4 s earlier than at 0:31.4".
std::string change_words(const Trials& trials, const Change& change);

/// What would have kept it, what would have come of that, and how sure it is. Several sentences.
std::string remedy_words(const Trials& trials, const Answer& answer);

/// "41.2 -> 92.0": points of the attempt, and with the change.
std::string marks_words(const Trials& trials, const Answer& answer);

/// All that is to be said of a lost point: what it was, what would have kept it and how sure that is.
std::string answer_words(const Trials& trials, const Answer& answer);

/// The same, for programs. The same attempt gives the same bytes.
nlohmann::ordered_json json_of(const Trials& trials, const std::vector<Answer>& answers);

} // namespace windlass::whatif
