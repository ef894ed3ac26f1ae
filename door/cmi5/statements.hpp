#pragma once
// The statements of one session, by the rules of cmi5. Pure: ids and time are given.

#include "door/cmi5/launch.hpp"

#include <cstdint>
#include <functional>

namespace windlass::cmi5 {

/// What a recording says of an attempt.
struct Marks {
    struct Objective {
        std::string id, text, stcw, outcome;
        double score = 0; ///< 0..100
    };
    bool ended_by_itself = false; ///< the lesson was over; false: it was ended before, which proves nothing
    bool practice = false;
    std::string outcome; ///< achieved, not_yet, not_shown
    double score = 0;    ///< 0..100
    double duration = 0; ///< s
    std::vector<Objective> objectives;
    std::string recording, recording_sha256;
};

/// Whose statements they are.
struct About {
    nlohmann::json actor;
    std::string registration, activity;
    nlohmann::json context_template;
    bool normal = true;
    std::optional<double> mastery_score = {};
    bool has_passed = false, has_completed = false; ///< in this registration, by an earlier launch
};

enum class Verdict { none, passed, failed };

/// Passed: the lesson was achieved, and the learning system's mastery score reached; it may ask for more than
/// the lesson does, never for less, since no points buy off a must. None: in browse and review, of practice,
/// of an attempt that was ended before it was over.
Verdict verdict_of(const About& about, const Marks& marks);

/// What a statement is given beside its session.
struct Stamp {
    std::string id; ///< a UUID
    std::int64_t at_unix_ms = 0;
};

nlohmann::json initialized(const About& about, const Stamp& stamp);
/// Passed or failed. A score that would contradict the verdict stands in the extensions alone.
nlohmann::json judged(const About& about, const Marks& marks, Verdict verdict, const Stamp& stamp);
nlohmann::json completed(const About& about, const Marks& marks, const Stamp& stamp);
/// duration: s since initialized().
nlohmann::json terminated(const About& about, double duration, const Stamp& stamp);

/// All that an attempt leaves, in order, the last of them terminated. marks: nothing when there is no
/// recording, which proves nothing. next: a stamp for each.
std::vector<nlohmann::json> last_statements(const About& about, const std::optional<Marks>& marks,
                                            double duration, const std::function<Stamp()>& next);

} // namespace windlass::cmi5
