#pragma once
// The tables of the history, version 4. Scores are in tenths of a point of 100; times of day are ISO 8601 in
// UTC.

namespace windlass::history {

inline constexpr int kSchemaVersion = 4; ///< PRAGMA user_version

inline constexpr const char* kSchema = R"(
CREATE TABLE trainee(id INTEGER PRIMARY KEY, pseudonym TEXT UNIQUE NOT NULL, name TEXT, group_name TEXT, removed_at TEXT);
CREATE TABLE lesson(hash TEXT PRIMARY KEY, name TEXT NOT NULL, title TEXT NOT NULL, json TEXT NOT NULL);
CREATE TABLE attempt(id TEXT PRIMARY KEY, lesson_hash TEXT NOT NULL REFERENCES lesson, parent TEXT REFERENCES attempt,
  began_at TEXT NOT NULL, seed INTEGER NOT NULL, run INTEGER NOT NULL, recording TEXT, recording_sha256 TEXT,
  server_version TEXT, ended TEXT CHECK(ended IN('good','time','abort','instructor')), score_computed INTEGER,
  score_final INTEGER, outcome TEXT, assessment_hash TEXT, confirmed_by TEXT, confirmed_at TEXT, outcome_final TEXT,
  pass INTEGER, practice INTEGER NOT NULL DEFAULT 0, hints INTEGER NOT NULL DEFAULT 0);
CREATE TABLE seat(attempt TEXT REFERENCES attempt, trainee INTEGER REFERENCES trainee, seat TEXT,
  part TEXT NOT NULL DEFAULT '', PRIMARY KEY(attempt, seat, part));
CREATE TABLE mark(attempt TEXT REFERENCES attempt, criterion TEXT, state TEXT, milli INTEGER, weight INTEGER, tick INTEGER,
  worst REAL, ticks_outside INTEGER, reason TEXT, PRIMARY KEY(attempt, criterion));
CREATE TABLE objective(attempt TEXT REFERENCES attempt, id TEXT, stcw TEXT, outcome TEXT, PRIMARY KEY(attempt, id));
CREATE TABLE override(attempt TEXT REFERENCES attempt, criterion TEXT, by TEXT, at TEXT, verdict TEXT, milli INTEGER,
  note TEXT NOT NULL);
CREATE TABLE said(attempt TEXT REFERENCES attempt, tick INTEGER, kind TEXT, seat TEXT, code TEXT, value REAL, truth REAL,
  delay_ticks INTEGER, verdict TEXT);
)";

/// From version 1, which had no outcome beside the computed one, and took an exercise that was ended early
/// for one that "server" had confirmed.
inline constexpr const char* kFromVersion1 = R"(
ALTER TABLE attempt ADD COLUMN outcome_final TEXT;
ALTER TABLE attempt ADD COLUMN pass INTEGER;
UPDATE attempt SET score_final = NULL, confirmed_by = NULL, confirmed_at = NULL WHERE confirmed_by = 'server';
DELETE FROM override WHERE by = 'server';
)";

/// From version 2, in which every attempt was a test.
inline constexpr const char* kFromVersion2 = R"(
ALTER TABLE attempt ADD COLUMN practice INTEGER NOT NULL DEFAULT 0;
ALTER TABLE attempt ADD COLUMN hints INTEGER NOT NULL DEFAULT 0;
)";

/// From version 3, in which a seat was one trainee's from beginning to end.
inline constexpr const char* kFromVersion3 = R"(
CREATE TABLE seat_4(attempt TEXT REFERENCES attempt, trainee INTEGER REFERENCES trainee, seat TEXT,
  part TEXT NOT NULL DEFAULT '', PRIMARY KEY(attempt, seat, part));
INSERT INTO seat_4 SELECT attempt, trainee, seat, '' FROM seat;
DROP TABLE seat;
ALTER TABLE seat_4 RENAME TO seat;
)";

} // namespace windlass::history
