#include "instructor_console/history/history.hpp"

#include "common/figure_text.hpp"
#include "instructor_console/history/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace windlass::history {

History::History(const std::filesystem::path& file) : database_(file) {
    // Erased bytes are overwritten, in the file and in its log.
    database_.run_all("PRAGMA journal_mode = WAL; PRAGMA foreign_keys = ON; PRAGMA secure_delete = ON");
    database_.all_or_nothing([&] {
        const auto version = integer_of(database_.run("PRAGMA user_version").at(0).at(0)).value_or(0);
        if (version > kSchemaVersion)
            throw std::runtime_error(
                fmt::format("{}: made by a later version of this program (its tables are of version "
                            "{}, {} is known here)",
                            file.string(), version, kSchemaVersion));
        if (version == kSchemaVersion) return;
        if (version >= 1) {
            if (version == 1) database_.run_all(kFromVersion1);
            if (version <= 2) database_.run_all(kFromVersion2);
            database_.run_all(kFromVersion3);
            database_.run_all(fmt::format("PRAGMA user_version = {}", kSchemaVersion));
            return;
        }
        if (!database_.run("SELECT name FROM sqlite_master").empty())
            throw std::runtime_error(file.string() + ": is a database of something else");
        database_.run_all(kSchema);
        database_.run_all(fmt::format("PRAGMA user_version = {}", kSchemaVersion));
    });
}

std::string History::attempt_of(const std::string& beginning) {
    const auto found =
        database_.run("SELECT id FROM attempt WHERE substr(id, 1, length(?1)) = ?1", {beginning});
    if (beginning.empty() || found.empty())
        throw std::invalid_argument(
            fmt::format("\"{}\": no attempt has an id that begins so; `history list` shows them", beginning));
    if (found.size() > 1)
        throw std::invalid_argument(
            fmt::format("\"{}\": {} attempts have ids that begin so", beginning, found.size()));
    return text_of(found[0][0]);
}

namespace {

std::string in_words(std::string outcome) {
    std::ranges::replace(outcome, '_', ' ');
    return outcome.empty() ? "no outcome" : outcome;
}

/// The outcome of a score, in tenths, that an assessor has given without one: by the lesson's pass and by
/// what was computed, and not by the outcome of a score before it.
std::string outcome_of(std::int64_t tenths, std::optional<std::int64_t> pass, const std::string& computed) {
    if (computed.empty()) return ""; // nothing was assessed
    const std::string say = "; say --outcome achieved, not_yet or not_shown beside --score";
    if (!pass)
        throw std::invalid_argument("this history does not know the lesson's pass" + say +
                                    ", or put the recording in again");
    if (tenths < 10 * *pass) return "not_yet";
    if (computed == "achieved") return "achieved";
    throw std::invalid_argument(
        fmt::format("{} points reach the lesson's pass of {}, and {} was computed: points, a must or an "
                    "objective are missed, and a score does not say whether that still stands{}",
                    figure_text(0.1 * static_cast<double>(tenths), ""), *pass, in_words(computed), say));
}

} // namespace

std::string History::confirm(const std::string& beginning, const Word& word, const std::string& now) {
    if (word.note.size() < kShortestNote)
        throw std::invalid_argument(
            fmt::format("note \"{}\": {} characters at least are needed", word.note, kShortestNote));
    if (!word.outcome.empty() && word.outcome != "achieved" && word.outcome != "not_yet" &&
        word.outcome != "not_shown")
        throw std::invalid_argument(fmt::format(
            "outcome \"{}\" is not known; there are: achieved, not_yet, not_shown", word.outcome));
    std::string stands;
    database_.all_or_nothing([&] {
        const std::string id = attempt_of(beginning);
        const Row row = database_
                            .run("SELECT coalesce(score_final, score_computed), pass, outcome, practice, "
                                 "coalesce(outcome_final, outcome) FROM attempt WHERE id = ?",
                                 {id})
                            .at(0);
        if (integer_of(row[3]) == 1)
            throw std::invalid_argument("attempt " + id.substr(0, 8) +
                                        " is for practice, and shows no competence; have the lesson done "
                                        "without hints, and confirm that");
        const auto pass = integer_of(row[1]);
        const auto tenths = word.score ? std::optional(points_in_tenths(*word.score)) : integer_of(row[0]);
        const bool follows = word.outcome.empty() && word.score;
        const std::string outcome = !word.outcome.empty() ? word.outcome
                                    : word.score          ? outcome_of(*tenths, pass, text_of(row[2]))
                                                          : text_of(row[4]); // as it stood
        database_.run("UPDATE attempt SET score_final = ?, outcome_final = ?, confirmed_by = ?, "
                      "confirmed_at = ? WHERE id = ?",
                      {or_null(tenths), or_null(outcome), word.by, now, id});
        database_.run(
            "INSERT INTO override(attempt, criterion, by, at, verdict, milli, note) VALUES(?, '', ?, ?, "
            "'confirmed', ?, ?)",
            {id, word.by, now, or_null(tenths), word.note});
        stands = fmt::format("{}, {}",
                             tenths ? points_text(0.1 * static_cast<double>(*tenths)) + " points"
                                    : std::string("no points"),
                             in_words(outcome));
        if (follows && pass) stands += fmt::format(", by the lesson's pass of {}", *pass);
    });
    return stands;
}

namespace {

/// The note beside the assessor's word that stands on an attempt.
constexpr const char* kNote =
    "(SELECT note FROM override WHERE override.attempt = attempt.id AND criterion = '' AND "
    "by = confirmed_by AND at = confirmed_at ORDER BY override.rowid DESC LIMIT 1)";

} // namespace

std::vector<Listed> History::list(const Wanted& wanted) {
    std::vector<Listed> all;
    const auto rows = database_.run(fmt::format(R"(
SELECT attempt.id, began_at, lesson.name, lesson.title,
  (SELECT group_concat(who, ', ') FROM (SELECT pseudonym || ' (' || trim(seat || ' ' || part) || ')' AS who FROM seat
    JOIN trainee ON trainee.id = seat.trainee WHERE seat.attempt = attempt.id ORDER BY seat.rowid)),
  coalesce(score_final, score_computed), CASE WHEN practice THEN 'practice' ELSE coalesce(outcome_final, outcome) END,
  ended, confirmed_by, recording, hints, {}
FROM attempt JOIN lesson ON lesson.hash = lesson_hash
WHERE (?1 = '' OR EXISTS(SELECT 1 FROM seat JOIN trainee ON trainee.id = seat.trainee
    WHERE seat.attempt = attempt.id AND pseudonym = ?1)) AND (?2 = '' OR lesson.name = ?2)
ORDER BY began_at, attempt.id)",
                                                kNote),
                                    {wanted.trainee, wanted.lesson});
    for (const Row& row : rows)
        all.push_back({.attempt = text_of(row[0]),
                       .began_at = text_of(row[1]),
                       .lesson = text_of(row[2]),
                       .title = text_of(row[3]),
                       .trainees = text_of(row[4]),
                       .score = integer_of(row[5]),
                       .outcome = text_of(row[6]),
                       .ended = text_of(row[7]),
                       .confirmed_by = text_of(row[8]),
                       .recording = text_of(row[9]),
                       .hints = integer_of(row[10]).value_or(0),
                       .note = text_of(row[11])});
    return all;
}

namespace {

std::string field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == text.npos) return text;
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

} // namespace

std::string History::csv(bool with_names) {
    std::string csv =
        "attempt,began_at,lesson,title,seat,part,pseudonym,group,score_computed,"
        "score_final,outcome,outcome_computed,ended,confirmed_by,confirmed_at,note,assessment_hash,"
        "recording_sha256,hints";
    csv += with_names ? ",name\r\n" : "\r\n";
    const auto rows = database_.run(fmt::format(R"(
SELECT attempt.id, began_at, lesson.name, lesson.title, seat.seat, part, pseudonym, group_name, score_computed / 10.0,
  score_final / 10.0, CASE WHEN practice THEN 'practice' ELSE coalesce(outcome_final, outcome) END, outcome, ended,
  confirmed_by, confirmed_at, {}, assessment_hash, recording_sha256, hints{}
FROM attempt JOIN lesson ON lesson.hash = lesson_hash LEFT JOIN seat ON seat.attempt = attempt.id
  LEFT JOIN trainee ON trainee.id = seat.trainee
ORDER BY began_at, attempt.id, seat.seat, seat.rowid)",
                                                kNote, with_names ? ", trainee.name" : ""));
    for (const Row& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            const auto* score = std::get_if<double>(&row[i]);
            csv += (i == 0 ? "" : ",") + (score ? fmt::format("{:.1f}", *score) : field(text_of(row[i])));
        }
        csv += "\r\n";
    }
    return csv;
}

History::Erased History::erase(const std::string& pseudonym, const std::string& now) {
    Erased erased;
    database_.all_or_nothing([&] {
        const auto found = database_.run("SELECT id FROM trainee WHERE pseudonym = ?", {pseudonym});
        if (found.empty())
            throw std::invalid_argument(
                fmt::format("\"{}\": there is no trainee of that pseudonym", pseudonym));
        const Value id = found[0][0];
        erased.pseudonym = "removed-" + text_of(id);
        for (const Row& row :
             database_.run("SELECT DISTINCT recording FROM attempt JOIN seat ON seat.attempt = "
                           "attempt.id WHERE trainee = ? AND recording IS NOT NULL",
                           {id}))
            erased.recordings.push_back(text_of(row[0]));
        const std::string alone =
            "attempt.id IN (SELECT attempt FROM seat GROUP BY attempt HAVING min(trainee) = ?1 AND "
            "max(trainee) = ?1)";
        database_.run("UPDATE override SET note = 'removed' WHERE attempt IN (SELECT id FROM attempt WHERE " +
                          alone + ")",
                      {id});
        database_.run("UPDATE attempt SET recording = NULL WHERE " + alone, {id});
        database_.run(
            "UPDATE trainee SET pseudonym = ?, name = NULL, group_name = NULL, removed_at = ? WHERE id = ?",
            {erased.pseudonym, now, id});
    });
    sweep();
    return erased;
}

std::int64_t History::keep_since(const std::string& time) {
    std::int64_t removed = 0;
    database_.all_or_nothing([&] {
        const std::string old = "(SELECT id FROM attempt WHERE began_at < ?)";
        for (const char* table : {"seat", "mark", "objective", "override", "said"})
            database_.run(fmt::format("DELETE FROM {} WHERE attempt IN {}", table, old), {time});
        database_.run("UPDATE attempt SET parent = NULL WHERE parent IN " + old, {time});
        database_.run("DELETE FROM attempt WHERE began_at < ?", {time});
        removed = database_.changed();
        database_.run("DELETE FROM trainee WHERE id NOT IN (SELECT trainee FROM seat)");
        database_.run("DELETE FROM lesson WHERE hash NOT IN (SELECT lesson_hash FROM attempt)");
    });
    sweep();
    return removed;
}

void History::sweep() {
    database_.run("VACUUM");
    database_.run("PRAGMA wal_checkpoint(TRUNCATE)");
}

} // namespace windlass::history
