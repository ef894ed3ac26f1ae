#pragma once
// The debriefing for machines: a table, an object, and statements for a learning record store.

#include "recorder/debrief/attempt.hpp"

#include <nlohmann/json_fwd.hpp>

namespace windlass::debrief {

/// A UUID of version 8 (RFC 9562) out of a text: the same for the same text.
std::string uuid_of(std::string_view text);

/// Of an attempt: out of its recording's hash and its run, so that a debriefing that is made again has the
/// same.
std::string attempt_id(const Attempt& attempt);

/// "good", "time", "abort", "instructor"; empty: it had not ended when the recording did.
std::string ended_by(const Attempt& attempt);

/// RFC 4180, one row a fact: section, time (s of exercise), recorded (s), side, name, value, unit, text.
std::string csv_of(const Attempt& attempt);

/// All that the page tells but the lines of its plots.
nlohmann::ordered_json json_of(const Attempt& attempt);

/// Who an attempt is of, for a learning record store: an account, never a mail address.
struct Actor {
    std::string home_page; ///< of the account, an IRI
    std::string pseudonym;
};

/// Statements of xAPI 1.0.3 (github.com/adlnet/xAPI-Spec): initialized; completed where it ended; passed or
/// failed where it was assessed to the end, and the same of each objective shown; terminated. Their ids are
/// those of the attempt, so that statements that are sent twice are one.
nlohmann::ordered_json xapi_of(const Attempt& attempt, const Actor& actor);

} // namespace windlass::debrief
