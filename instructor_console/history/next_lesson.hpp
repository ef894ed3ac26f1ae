#pragma once
// What somebody should practise next, by a rule that he can read: docs/instructor.md, "What next".

#include "instructor_console/history/database.hpp"

#include <optional>
#include <string>
#include <vector>

namespace windlass::history {

/// A trainee's part of an attempt whose marks are of another's work: the forecastle's, say, that does what a
/// judged bridge orders. It is none of his.
inline constexpr const char* kNotJudged = "not judged";

/// A lesson that a centre offers.
struct Offered {
    std::string id, title; ///< id: as in its file, "L01"
    std::string exercise;  ///< by which recordings know it: the exercise's name, "L01-let-go-25m"
};

struct NextLesson {
    Offered lesson;
    std::string why;       ///< in words
    std::string recording; ///< of the attempt that it follows from; empty: of none
    std::string began_at;  ///< of the same: "2023-11-14T22:13:20Z"
    bool practice = false; ///< for practice, with hints, before it is a test again: he missed it
};

/// The lesson that he did last, as long as he has not achieved it, with every objective of it, in a test;
/// else the first one offered, in their order, that he has not; nothing: he has achieved them all. An
/// assessor's word on the whole stands for its objectives, too. Throws std::invalid_argument when there is no
/// such trainee.
std::optional<NextLesson> next_lesson(Database& database, const std::string& pseudonym,
                                      const std::vector<Offered>& offered);

} // namespace windlass::history
