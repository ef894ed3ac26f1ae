#pragma once
// Who did which lesson when, and how it went: a file on the instructor's computer, from which nothing goes
// anywhere unless somebody exports it.

#include "instructor_console/history/database.hpp"
#include "instructor_console/history/next_lesson.hpp"
#include "recorder/debrief/attempt.hpp"

namespace windlass::history {

/// Somebody at a seat.
struct Seated {
    std::string pseudonym; ///< by which he is known here
    std::string name;      ///< empty: it stays as it is
    std::string group;     ///< the same
    std::string seat = "forecastle";
    std::string part =
        {}; ///< of the attempt in which he had it, "from 4:00", or kNotJudged; empty: all of it
};

/// One row of the list.
struct Listed {
    std::string attempt, began_at, lesson, title, trainees; ///< trainees: "t1 (forecastle), t2 (bridge)"
    std::optional<std::int64_t> score;                      ///< tenths; the assessor's, else the computed one
    std::string outcome; ///< "practice" where it was for that: it counts as no test, whatever came of it
    std::string ended, confirmed_by, recording;
    std::int64_t hints = 0; ///< that were given
    std::string note;       ///< of the assessor whose word stands
};

/// What is listed; empty: all.
struct Wanted {
    std::string trainee, lesson; ///< pseudonym; name of the lesson or exercise
};

class History {
public:
    static constexpr std::size_t kShortestNote = 10; ///< characters, of an assessor's note

    /// Opens the file or makes it. Throws std::runtime_error when it cannot be used, or was made by a later
    /// version.
    explicit History(const std::filesystem::path& file);

    /// Puts an attempt in, or what is made of it now in the place of what was; seats are added to those that
    /// it has. recording: where it is. replace: whoever has one of these seats already gives way. Returns its
    /// id. Throws std::invalid_argument for a seat or pseudonym that is none, and for a seat that two would
    /// have.
    std::string add(const debrief::Attempt& attempt, const std::vector<Seated>& seats,
                    const std::filesystem::path& recording, bool replace = false);

    /// What an assessor confirms of an attempt, and why.
    struct Word {
        std::string by;
        std::optional<double> score{}; ///< of 100; nothing: as it stands
        std::string outcome{}; ///< achieved, not_yet, not_shown; empty: it follows from the score, and
                               ///< without one is as it stands
        std::string note;
    };
    /// An assessor's word on the whole. It stands until another takes its place: who confirms without a score
    /// confirms what was confirmed before, else what was computed with what was set of criteria. Of a score
    /// alone the outcome follows by the lesson's pass. attempt:
    /// its id, or as many of its first characters as tell it apart. Returns what stands from now on, for
    /// people. Throws std::invalid_argument, also for a score that reaches the pass of an attempt whose
    /// computed outcome is another than achieved: only the assessor knows what he means.
    std::string confirm(const std::string& attempt, const Word& word, const std::string& now);

    std::vector<Listed> list(const Wanted& wanted = {});

    /// As next_lesson() has it.
    std::optional<NextLesson> next(const std::string& pseudonym, const std::vector<Offered>& offered) {
        return next_lesson(database_, pseudonym, offered);
    }

    /// RFC 4180: a row for each seat of each attempt. Names only where they are asked for.
    std::string csv(bool with_names);

    /// What an erasure left behind.
    struct Erased {
        std::string pseudonym;               ///< by which the rows of the trainee are known from now on
        std::vector<std::string> recordings; ///< that may show him: files are not touched
    };
    /// Takes out of the file who the trainee was: name, group, pseudonym; of the attempts that he was alone
    /// in, also the names of recordings and the assessors' notes. Marks stay, of nobody. Throws
    /// std::invalid_argument when there is no such trainee.
    Erased erase(const std::string& pseudonym, const std::string& now);

    /// Takes out all attempts that began before that time, and trainees and lessons that are left without
    /// any. Returns how many attempts.
    std::int64_t keep_since(const std::string& time);

private:
    std::int64_t trainee(const Seated& seated);
    void seat(const std::string& attempt, const Seated& seated, bool replace);
    void put_lesson(const debrief::Attempt& attempt, const std::string& hash);
    void put_marks(const debrief::Attempt& attempt, const std::string& id);
    void put_said(const debrief::Attempt& attempt, const std::string& id);
    void put_words(const debrief::Attempt& attempt, const std::string& id);
    /// The one id that begins so. Throws std::invalid_argument.
    std::string attempt_of(const std::string& beginning);
    /// So that what was taken out is in the file no more.
    void sweep();

    Database database_;
};

} // namespace windlass::history
