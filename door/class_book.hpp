#pragma once
// Classes: exercises, a code, and who sits where. Pure: time, codes and keys are given; keeping it in a file
// is somebody else's.

#include "door/denied.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace windlass::door {

/// Where in an exercise somebody sits.
enum class Place { ship, forecastle, bridge, watch };
inline constexpr std::array kPlaceNames{"ship", "forecastle", "bridge", "watch"};

inline const char* name_of(Place place) {
    return kPlaceNames.at(static_cast<std::size_t>(place));
}
std::optional<Place> place_named(const std::string& name);

struct Trainee {
    std::string name;
    std::string key; ///< of the one browser that has the seat; empty: the class is over
    std::string exercise;
    Place place = Place::ship;
    double since = 0; ///< s of exercise: when he took it
};

/// Somebody who had a seat of an exercise and has it no more: moved, freed, gone.
struct Relieved {
    std::string name, exercise;
    Place place = Place::ship;
    double since = 0, until = 0; ///< s of exercise
};

/// What came of one exercise so far.
struct Result {
    std::string recording;             ///< its name; empty: none was made
    std::optional<double> points = {}; ///< 0..100; nothing: it is not marked
    std::string outcome =
        {}; ///< Assessment's: achieved, not_yet, not_shown, or practice; empty: not marked to the end
    std::optional<double> lost = {}; ///< 0..100, while points are of what is decided so far
    std::optional<double> pass = {}; ///< 0..100, that the lesson needs; nothing: it is not marked
    std::string abort = {};  ///< why the lesson ended before it was done; empty: it did not, or by a hand
    bool in_history = false; ///< the attempt that this recording has
    double time = 0;         ///< s of exercise, as it was heard last
    bool running = false;    ///< the same
    /// s of exercise: when it was heard running first, and marked to the end. The book's own.
    std::optional<double> began = {}, marked = {};
};

/// Whose work an exercise was, of one seat of it.
struct Part {
    std::string name;
    Place place = Place::ship;
    std::optional<double> since = {}, until = {}; ///< s of exercise; nothing: from its beginning, to its end
    bool judged = true; ///< the marks are of what is done there; false: of another seat
};

/// A moment of a recording.
struct Moment {
    std::string recording; ///< its name
    double position = 0;   ///< s from its beginning
};

struct TrainingClass {
    std::string id;     ///< 1 to 24 letters, digits, dashes; exercises are ID-1, ID-2 ...
    std::string lesson; ///< file of the server's exercise folder
    std::string code;
    std::int64_t until = 0; ///< s since 1970: the code is good no longer
    bool practice = false;  ///< the lesson is played with its hints
    int crew = 1;           ///< to an exercise: 1 on the ship; 2 forecastle and bridge; 3 and one who watches
    std::vector<std::string> exercises;
    std::vector<std::string> names; ///< who may join; empty: whoever has the code
    std::vector<Trainee> trainees;
    std::vector<Relieved> relieved;
    std::map<std::string, Result> results; ///< by exercise
    bool over = false;
    std::string launch = {}; ///< of a learning system: its session; empty: an instructor's class
    std::optional<Moment> from =
        {};                     ///< its exercises go on from there, as practice; nothing: they begin anew
    bool bridge_judged = false; ///< a trainee on the bridge leads, and the forecastle does as it is ordered
    std::map<std::string, Place> places = {}; ///< by name: the seat that it has where that one is free

    const Trainee* find(const std::string& name) const;
    /// Exercises in which somebody has a seat.
    std::vector<std::string> manned() const;
    /// Who worked in an exercise, by seat and then time: who sits there, and who was relieved after it had
    /// begun and before it was marked. Who comes back, with nobody in between, never was away.
    std::vector<Part> parts(const std::string& exercise) const;
};

/// One thread.
class ClassBook {
public:
    static constexpr int kExercises = 64, kCrew = 3; ///< of a class, at most
    static constexpr std::size_t kLongestName = 24;  ///< letters of its id
    static constexpr std::size_t kClasses = 16;      ///< that are not over, and as many that are
    static constexpr std::size_t kLaunched = 64;     ///< the same of those that learning systems start
    static constexpr std::int64_t kGood = 24 * 3600; ///< s that a code is good for

    /// A book as to_json() gave it. Throws std::exception when it is none.
    explicit ClassBook(const nlohmann::json& kept = nlohmann::json());
    nlohmann::json to_json() const;

    const std::vector<TrainingClass>& classes() const { return classes_; }
    const TrainingClass* find(const std::string& id) const;

    /// A name that no class has, also none that is over: that one, or the same with a letter behind it,
    /// "sun-b". With a number it would be called as an exercise of the first.
    std::string free_name(const std::string& wanted) const;

    /// What a class is opened with, beside its name and code.
    struct Wanted {
        std::string lesson; ///< file of the server's exercise folder
        int exercises = 1, crew = 1;
        std::vector<std::string> names = {}; ///< who may join; empty: whoever has the code
        bool practice = false;
        std::optional<Moment> from = {};
        bool bridge_judged = false;
        std::map<std::string, Place> places = {};
    };
    /// Opens a class. now: s since 1970. Throws Denied for an id that is no name, is a class's already, be it
    /// over, or begins with "replay" (in replays seats hear all), for more exercises or crew than there may
    /// be, for a crew of one where the bridge is judged, for more names than seats, one twice, and beyond
    /// kClasses.
    const TrainingClass& open(const std::string& id, Wanted wanted, const std::string& code,
                              std::int64_t now);

    /// Opens a class of one for whom a learning system sends: nobody else joins, and no device has a seat
    /// there. session: not empty; the rest as open() and join() have it. Throws Denied.
    Trainee launch(const std::string& id, const std::string& session, const std::string& lesson,
                   bool practice, const std::string& name, const std::string& key, std::int64_t now);
    /// Whether one more may be launched.
    bool can_launch() const;
    /// The class of that session; nullptr: none.
    const TrainingClass* launched(const std::string& session) const;
    /// What is left of a class that was launched and is over is kept elsewhere.
    void forget(const std::string& id);

    /// Its code and its seats are nobody's any more; who sat where is kept, with what came of it, until
    /// kClasses others are over.
    void end(const std::string& id);

    /// What is known of an exercise now; of a class that is over, too. True: another recording or outcome
    /// than before, or it has begun, which has to be kept; points come again by themselves. Where its time
    /// goes back (a reset, an earlier moment), what was done behind that is nobody's work.
    bool note(const std::string& id, const std::string& exercise, const Result& result);

    /// The attempt of that recording is in the history, and need not be put there again.
    void note_in_history(const std::string& recording);

    /// A class whose code it is, and good now; nullptr: none.
    const TrainingClass* with_code(const std::string& code, std::int64_t now) const;

    /// The first free seat of a class, or his, for somebody who has its code. Throws Denied when somebody of
    /// that name has one already, the name is not on the class's list, or none is free.
    Trainee join(const std::string& id, const std::string& name, const std::string& key);

    /// A device's own seat: of the class that was opened last, of those under way whose exercise of that
    /// number, counted from 1, has that place, or whose list has the device's name: then it sits where the
    /// class has it, or else where there is room at its place. nullptr: none has.
    const TrainingClass* with_seat(const std::string& name, int exercise, Place place) const;
    /// It sits there. Throws Denied when the seat or the name is somebody's, or the class has a list without
    /// it.
    Trainee sit(const std::string& id, const std::string& name, const std::string& key, int exercise,
                Place place);

    /// Whose browser that is: class and trainee, while the class is not over.
    struct Seated {
        std::string class_id;
        Trainee trainee;
    };
    std::optional<Seated> seated(const std::string& key) const;

    /// Another seat; who sits there changes places. Returns both names, or one. Throws Denied.
    std::vector<std::string> move(const std::string& id, const std::string& name, const std::string& exercise,
                                  Place place);

    /// The seat is free again. Returns the key that is nobody's any more. Throws Denied.
    std::string remove(const std::string& id, const std::string& name);

private:
    TrainingClass& mine(const std::string& id);
    std::size_t count(bool launched, bool over) const;

    std::vector<TrainingClass> classes_;
};

/// "", "to 4:00", "from 4:00", "from 2:00 to 1:04:00".
std::string part_words(const Part& of);

/// An assessor's word on an attempt of a class that is over.
struct AttemptJudged {
    std::string recording; ///< its name
    std::string by;
    std::string outcome;               ///< achieved, not_yet, not_shown
    std::optional<double> points = {}; ///< 0..100; nothing: as they stand
    std::string note;
};

/// A class for a table: RFC 4180, one row a part of a seat that was taken. words: that stand on its attempts.
std::string marks_csv(const TrainingClass& of, const std::vector<AttemptJudged>& words = {});

/// The seats of each exercise of a crew of so many.
std::vector<Place> places_of(int crew);

} // namespace windlass::door
