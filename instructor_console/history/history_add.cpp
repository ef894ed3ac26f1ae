// An attempt into the history.

#include "instructor_console/history/history.hpp"

#include "recorder/debrief/judgement.hpp"
#include "recorder/debrief/records.hpp"
#include "recorder/debrief/said.hpp"
#include "recorder/debrief/wall_time.hpp"
#include "station/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace windlass::history {

namespace {

constexpr std::size_t kLongestName = 64;

/// SQLite's integers have a sign.
Value integer(std::uint64_t value) {
    return static_cast<std::int64_t>(value);
}

std::string hex(std::uint64_t hash) {
    return fmt::format("{:016x}", hash);
}

void must_be_a_word(const char* what, const std::string& text) {
    const bool fits = !text.empty() && text.size() <= kLongestName &&
                      std::ranges::none_of(text, [](unsigned char c) { return c < 0x20 || c == ','; });
    if (!fits)
        throw std::invalid_argument(
            fmt::format("{} \"{}\" is not allowed: 1 to {} bytes, no comma and no control "
                        "character",
                        what, text, kLongestName));
}

std::string_view verdict_name(AssessorVerdict verdict) {
    switch (verdict) {
    case VERDICT_MET:
        return "met";
    case VERDICT_NOT_MET:
        return "not_met";
    case VERDICT_NOT_APPLICABLE:
        return "not_applicable";
    case VERDICT_POINTS:
        return "points";
    case VERDICT_CONFIRMED:
        return "confirmed";
    case VERDICT_ENDED:
        break; // no assessor's word
    }
    return "unknown";
}

/// Of a judged report, by the mark that it has earned.
const char* verdict_name(std::uint32_t milli) {
    return milli >= 1000 ? "right" : milli == 0 ? "wrong" : "half";
}

std::string wall_time_of(const debrief::Attempt& attempt, double time) {
    return debrief::iso_time(attempt.origin.recording_began_unix_ns +
                             static_cast<std::int64_t>(attempt.position_of(time) * 1e9));
}

std::optional<std::int64_t> ticks(const debrief::Attempt& attempt, std::optional<double> seconds) {
    if (!seconds || attempt.dt <= 0) return std::nullopt;
    return std::llround(*seconds / attempt.dt);
}

} // namespace

std::int64_t History::trainee(const Seated& seated) {
    database_.run(
        "INSERT INTO trainee(pseudonym, name, group_name) VALUES(?, ?, ?) ON CONFLICT(pseudonym) DO UPDATE "
        "SET "
        "name = coalesce(excluded.name, name), group_name = coalesce(excluded.group_name, group_name)",
        {seated.pseudonym, or_null(seated.name), or_null(seated.group)});
    return integer_of(
               database_.run("SELECT id FROM trainee WHERE pseudonym = ?", {seated.pseudonym}).at(0).at(0))
        .value();
}

void History::put_lesson(const debrief::Attempt& attempt, const std::string& hash) {
    const std::string& title = attempt.lesson.title.empty() ? attempt.title : attempt.lesson.title;
    database_.run("INSERT INTO lesson(hash, name, title, json) VALUES(?, ?, ?, ?) ON CONFLICT(hash) DO "
                  "UPDATE SET json = "
                  "excluded.json WHERE excluded.json <> ''",
                  {hash, attempt.exercise, title, attempt.lesson.json});
}

void History::put_marks(const debrief::Attempt& attempt, const std::string& id) {
    database_.run("DELETE FROM mark WHERE attempt = ?", {id});
    database_.run("DELETE FROM objective WHERE attempt = ?", {id});
    for (const debrief::Mark& mark : debrief::judgement_of(attempt).marks) {
        const Criterion& criterion = *mark.criterion;
        database_.run("INSERT INTO mark VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?)",
                      {id, criterion.code().to_string(), std::string(station::name(criterion.state())),
                       integer(criterion.milli()), integer(criterion.weight()), integer(criterion.tick()),
                       criterion.worst(), or_null(ticks(attempt, criterion.time_outside())),
                       criterion.reason().to_string()});
    }
    for (const debrief::Achievement& each : debrief::achievements_of(attempt))
        database_.run("INSERT INTO objective VALUES(?, ?, ?, ?)",
                      {id, each.id, each.stcw, or_null(each.outcome)});
}

void History::put_said(const debrief::Attempt& attempt, const std::string& id) {
    database_.run("DELETE FROM said WHERE attempt = ?", {id});
    const auto put = [&](double time, const char* kind, const char* seat, const std::string& code,
                         std::optional<double> value, std::optional<double> truth,
                         std::optional<double> delay, const std::string& verdict) {
        database_.run("INSERT INTO said VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?)",
                      {id, or_null(ticks(attempt, time)), std::string(kind), std::string(seat), code,
                       or_null(value), or_null(truth), or_null(ticks(attempt, delay)), or_null(verdict)});
    };
    const auto orders = debrief::orders_said(attempt);
    for (std::size_t i = 0; i < orders.size(); ++i) {
        const auto& order = orders[i];
        put(order.given, "order", "bridge", std::string(station::name(attempt.orders[i].order.code())),
            attempt.orders[i].order.value(), {},
            order.repeated ? std::optional(*order.repeated - order.given) : std::nullopt, order.state);
    }
    for (const auto& report : debrief::reports_said(attempt))
        put(report.time, "report", "forecastle", std::string(report.code), report.value, report.true_value,
            report.delay, report.milli ? verdict_name(*report.milli) : "");
}

void History::put_words(const debrief::Attempt& attempt, const std::string& id) {
    for (const debrief::AssessorWord& word : attempt.words) {
        const std::string at = wall_time_of(attempt, word.time),
                          criterion = word.command.criterion().to_string(),
                          note = word.command.note().to_string();
        const AssessorVerdict verdict = word.command.verdict();
        if (verdict == VERDICT_ENDED) continue;       // the server's: nobody has confirmed anything
        if (!criterion.empty() && attempt.assessment) // what stands with it, until the whole is confirmed
            database_.run("UPDATE attempt SET score_final = ? WHERE id = ? AND confirmed_at IS NULL",
                          {Value(std::int64_t{std::llround(attempt.assessment->score() * 10)}), id});
        if (criterion.empty() && verdict == VERDICT_CONFIRMED)
            database_.run(
                "UPDATE attempt SET score_final = ?, confirmed_by = ?, confirmed_at = ?, outcome_final = ? "
                "WHERE id = ? AND (confirmed_at IS NULL OR confirmed_at < ?3)",
                {attempt.assessment ? Value(std::int64_t{std::llround(attempt.assessment->score() * 10)})
                                    : Value(),
                 word.by, at, or_null(attempt.assessment ? attempt.assessment->outcome().to_string() : ""),
                 id});
        if (!database_
                 .run("SELECT 1 FROM override WHERE attempt = ? AND criterion = ? AND by = ? AND at = ?",
                      {id, criterion, word.by, at})
                 .empty())
            continue; // it was put in before
        database_.run("INSERT INTO override VALUES(?, ?, ?, ?, ?, ?, ?)",
                      {id, criterion, word.by, at, std::string(verdict_name(verdict)),
                       integer(word.command.milli()), note});
    }
}

namespace {

/// That each has a seat of his own.
void must_be_apart(const std::vector<Seated>& seats) {
    for (std::size_t i = 0; i < seats.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (seats[i].seat == seats[k].seat && seats[i].part == seats[k].part)
                throw std::invalid_argument(fmt::format(
                    "{} and {} cannot both have the seat \"{}\": give a --seat for each --trainee, e.g. "
                    "--seat port --seat starboard",
                    seats[k].pseudonym, seats[i].pseudonym, seats[i].seat));
}

} // namespace

void History::seat(const std::string& id, const Seated& seated, bool replace) {
    const auto others = database_.run(
        "SELECT pseudonym FROM seat JOIN trainee ON trainee.id = seat.trainee WHERE attempt = ? "
        "AND seat = ? AND part = ? AND pseudonym <> ?",
        {id, seated.seat, seated.part, seated.pseudonym});
    if (!others.empty() && !replace)
        throw std::invalid_argument(fmt::format("the seat \"{}\" of this attempt is {}'s: give another "
                                                "--seat, or --replace to put {} in that place",
                                                seated.seat, text_of(others[0][0]), seated.pseudonym));
    database_.run("INSERT INTO seat(attempt, trainee, seat, part) VALUES(?, ?, ?, ?) "
                  "ON CONFLICT(attempt, seat, part) DO UPDATE SET trainee = excluded.trainee",
                  {id, trainee(seated), seated.seat, seated.part});
}

std::string History::add(const debrief::Attempt& attempt, const std::vector<Seated>& seats,
                         const std::filesystem::path& recording, bool replace) {
    for (const Seated& each : seats) {
        must_be_a_word("pseudonym", each.pseudonym);
        must_be_a_word("seat", each.seat);
        if (each.pseudonym.find('@') != std::string::npos)
            throw std::invalid_argument(
                fmt::format("pseudonym \"{}\" is not allowed: a mail address is none", each.pseudonym));
    }
    must_be_apart(seats);
    const std::string id = debrief::attempt_id(attempt);
    const auto& assessment = attempt.assessment;
    const std::string lesson = hex(assessment ? assessment->lesson_hash() : attempt.definition_hash);
    const auto score = assessment
                           ? std::optional<std::int64_t>(std::llround(assessment->score_computed() * 10))
                           : std::nullopt;
    database_.all_or_nothing([&] {
        put_lesson(attempt, lesson);
        database_.run(
            "INSERT INTO attempt(id, lesson_hash, began_at, seed, run, recording, recording_sha256, ended, "
            "score_computed, "
            "outcome, assessment_hash, pass, practice, hints) VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
            "?) ON CONFLICT(id) DO "
            "UPDATE SET "
            "lesson_hash = "
            "excluded.lesson_hash, recording = excluded.recording, ended = excluded.ended, score_computed = "
            "excluded.score_computed, outcome = excluded.outcome, assessment_hash = "
            "excluded.assessment_hash, pass = "
            "excluded.pass, practice = excluded.practice, hints = excluded.hints",
            {id, lesson, debrief::iso_time(attempt.origin.began_unix_ns), integer(attempt.wave_seed),
             integer(attempt.origin.run), std::filesystem::absolute(recording).lexically_normal().string(),
             attempt.origin.sha256, or_null(debrief::ended_by(attempt)), or_null(score),
             or_null(assessment ? assessment->outcome().to_string() : ""),
             or_null(assessment ? hex(assessment->assessment_hash()) : ""),
             assessment ? integer(assessment->pass()) : Value(),
             integer((assessment && assessment->practice()) || attempt.restored() != nullptr ? 1 : 0),
             integer(assessment ? assessment->hints().size() : 0)});
        put_marks(attempt, id);
        put_said(attempt, id);
        put_words(attempt, id);
        if (replace)
            for (const Seated& each : seats)
                database_.run("DELETE FROM seat WHERE attempt = ? AND seat = ?", {id, each.seat});
        for (const Seated& each : seats)
            seat(id, each, replace);
    });
    return id;
}

} // namespace windlass::history
