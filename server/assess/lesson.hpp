#pragma once
// A lesson: what the bridge orders, what goes wrong, what is looked at and when it ends. Plain data, read
// from the section "lesson" of an exercise file (config/schema/lesson.schema.json says what each field
// means).

#include "server/exercise/definition/orders.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace windlass::assess {

inline constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// Limits of one quantity; at_least includes its limit, above and below do not. SI.
struct Bounds {
    int quantity = 0; ///< place in quantities()
    double at_least = -kNoLimit, above = -kNoLimit, below = kNoLimit;

    bool hold(double value) const { return value >= at_least && value > above && value < below; }
};

/// What comes at some time and then has come.
enum class SignKind {
    event,
    report,
    moment,
    order_given,
    order_repeated,
    order_answered,
    order_done,
    order_challenged
};
struct Sign {
    SignKind kind = SignKind::event;
    int index = 0; ///< place in the lesson's events, reports, moments or orders
};

/// All that is given must hold; without anything it holds at once.
struct Condition {
    int side = 0;    ///< 0 port, 1 starboard: whose cable and windlass
    double time = 0; ///< s of the lesson, at least
    int times = 1;   ///< how often each of its events and reports has come, at least
    std::vector<Bounds> bounds{};
    unsigned phases = 0; ///< bit for each AnchorPhase that will do; 0: any
    std::vector<Sign> signs{};
    double since = 0;                 ///< s since the last of the signs came
    double hold = 0;                  ///< s, for which all of it has held on end
    int memory = -1;                  ///< place in State::held; -1: hold is 0
    std::vector<Condition> either{};  ///< of which at least one must hold; empty: none is asked for
    std::vector<Condition> neither{}; ///< of which none may hold
};

/// An event that some condition waits for.
struct WatchedEvent {
    std::string code;
    int side = 0; ///< as Condition; an event of no side is of both
};

/// A report that some condition waits for.
struct WatchedReport {
    exercise::ReportCode code = exercise::ReportCode::text;
    int side = 0; ///< as Condition; a report of no side is of both
};

struct Moment {
    std::string id;
    Condition when;
};

/// An order of the bridge, given by the lesson itself unless the bridge is manned.
struct LessonOrder {
    std::string id;
    exercise::BridgeOrderGiven given;
    Condition when; ///< given once it holds and the order before has been given
    /// So long as it is so, the bridge takes the order back from whoever calls it unsafe; nothing: it
    /// insists.
    std::optional<Condition> unsafe{};
    std::vector<Condition> done; ///< one for each windlass that it is to: carried out once each has held for
                                 ///< kDoneFor, or kStandsFor, after it was given, each at its time
};

/// A fault that comes once its condition holds, and goes once the other does.
struct LessonFault {
    exercise::FaultOrder order;
    Condition when;
    std::optional<Condition> clear{};
    std::array<double, 2> delay{};                   ///< s after `when` holds: drawn between these
    std::optional<std::array<double, 2>> severity{}; ///< drawn between these; nothing: that of the order
    std::string one_of{};                            ///< of all that have this name one is drawn
};

/// A change of wind or stream: the values that are not given stay.
struct WeatherChange {
    double at = 0, over = 0; ///< s of the lesson
    std::optional<double> wind_speed{}, wind_from{}, current_speed{}, current_towards{}, visibility{};
};

using words::CriterionKind;
using words::CriterionState;

/// How a report is held against the truth.
enum class ReportTruth {
    moment, ///< how late it comes after something happened
    figure, ///< what was reported against what is
    state,  ///< whether it is so when it is said
    growth  ///< whether the cable grew so about then
};

struct Criterion {
    std::string id, text; ///< code and words for people: why it matters
    CriterionKind kind = CriterionKind::limit;
    int weight = 10;
    bool must = false;
    std::string objective{};
    int side = 0;

    int quantity = 0; ///< limit: of what
    double min = -kNoLimit, max = kNoLimit;
    double fail_below = -kNoLimit, fail_above = kNoLimit; ///< beyond these the mark is 0 at once
    double grace = 0;                                     ///< s outside that cost nothing
    double zero = 10;                                     ///< s outside at which nothing is left
    std::optional<Condition> from{}, to{}; ///< limit, sequence, prohibited: when it is looked at. from, of a
                                           ///< final: it counts once that has been so; of a question: since
                                           ///< when it counts, asked or not

    int at = -1;                    ///< state_at: place in moments
    double after = 0;               ///< state_at: s after it
    bool graded = false;            ///< state_at: the mark falls evenly from `after` to `zero`, s after it
    bool put_right = false;         ///< limit: nothing is left of what the lesson's end finds beyond it
    Condition that{};               ///< state_at, prohibited, final; report of a state
    std::vector<Condition> steps{}; ///< sequence
    double within = kNoLimit;       ///< sequence: s from its beginning
    std::vector<int> orders{};      ///< order: places in orders; report: those it belongs to, one to each

    exercise::ReportCode report = exercise::ReportCode::text;
    ReportTruth truth = ReportTruth::figure;
    int truth_moment = -1;                ///< place in moments
    double early = 0, full = 0, half = 0; ///< s before and after the truth
    int false_calls = 0;                  ///< that are forgiven, and then cost half
    double full_off = 0, half_off = 0;    ///< of a figure: by how much it may be wrong
    int count = 1;                        ///< of a figure: how many reports are asked for

    int question = -1; ///< question: place in questions
};

/// One of the answers that a question offers.
struct Choice {
    std::string text;
    Condition right; ///< whether it is right at the freeze
};

/// What a seat is asked at a freeze: the exercise holds, and the truth of that tick judges the answer. A
/// number earns all of the mark within its tolerance and half of it within twice that.
struct Question {
    int criterion = 0; ///< place in criteria, whose side is its own
    std::string ask{};
    bool forecastle = true; ///< who is asked; false: the bridge
    Condition when{};       ///< asked once, at the first tick at which it holds
    int quantity = -1;      ///< that has the truth of a number; -1: a choice is asked for
    std::string unit{};     ///< of the number, as the seat reads it
    double one = 1;         ///< of that unit, in the quantity's
    double period = 0;      ///< in that unit, after which the figure comes round again; 0: it does not
    double tolerance = 0;   ///< in that unit
    double step = 0;        ///< the same, by which the page's buttons go
    std::vector<Choice> choices{};
    double meant_for = 0; ///< s of wall time that it is meant to take; judges nobody. 0: not said
};

/// What reports of growing and weight are held against, of the gear on one side.
struct Gear {
    double cable_weight = 0; ///< N/m in water
    double duty_pull = 0;    ///< N, that the motor bears for half an hour: Zcont (UR A3)
};

/// It is achieved once its musts are met and its criteria reach `pass`.
struct Objective {
    std::string id, text, stcw;
    int pass = 70; ///< points of 100; the lesson's own, unless it has others

    /// Points of 100 below which it fails the lesson, too. From there to `pass` it is not achieved yet, and
    /// the lesson may be: one word that was left out makes a ship that was handled safely no failure.
    int least() const { return std::min(pass, static_cast<int>(words::limits::objective_fails)); }
};

/// What a seat is told in an attempt for practice, once, when its condition first holds.
struct Hint {
    std::string id, say;
    Condition when;
    bool forecastle = true; ///< to whom; false: to the bridge
    int side = -1;          ///< whose cable it is about, where the condition names one; -1: neither
    int criterion = -1;     ///< place in criteria that it helps with; -1: none
};

/// What ends the lesson as "not yet": an event, or what may come to be so of ship, anchor and cable.
struct Accident {
    std::string what;                ///< code of the event; with `when`, what is told of it
    std::optional<Condition> when{}; ///< ends it once it holds; nothing: the event does
};

/// How the lesson goes with scripted hands.
struct LessonRun {
    std::vector<std::string> scripts; ///< one for each windlass that is worked, paths from the config folder
    std::string about{};              ///< what he does wrong
    std::vector<std::string> fails{}; ///< criteria that must be missed; the good one misses no must
};

struct Lesson {
    std::uint64_t hash = 0; ///< of its text
    std::string id, title;
    std::string briefing;                   ///< that every trainee reads
    std::array<std::string, 2> briefings{}; ///< beside it, that one seat alone reads: forecastle, bridge
    bool practice = false; ///< this attempt is for practice: it has the hints, and is no test of competence
    bool ghost = true;     ///< for practice, the model's hands may be shown beside the trainee's (aids.hpp)
    bool bridge_manned = false;
    int side = 0;
    bool two_sides = false;            ///< the exercise has two windlasses
    int pass = 70;                     ///< points of 100
    bool marks_when_confirmed = false; ///< seats are told their marks then, and not at the lesson's end
    std::vector<Objective> objectives;
    std::vector<WatchedEvent> events;   ///< that are waited for
    std::vector<WatchedReport> reports; ///< the same
    std::vector<Moment> moments;
    std::vector<LessonOrder> orders;
    /// Of a bridge that is manned: when an order that none of these stands for is carried out, for each code
    /// and side; nothing in it: the windlass does not show it.
    std::array<std::vector<Condition>, 2> usually_done{};
    std::vector<LessonFault> faults;
    std::vector<WeatherChange> schedule;
    std::vector<Criterion> criteria;
    std::vector<Criterion> unasked;  ///< what makes the reports true that these do not ask for (unasked.hpp)
    std::vector<Question> questions; ///< in the order of their criteria
    std::vector<Hint> hints;
    std::array<Gear, 2> gear{}; ///< port, starboard; of the exercise, not of the file
    std::optional<Condition> good;
    double time_limit = 0; ///< s of the lesson; 0: none
    double patience = 0;   ///< s without a word after which the bridge asks; 0: it waits, and asks nothing
    std::vector<Accident> abort;
    int held = 0; ///< conditions that must hold for a while
    LessonRun model_run;
    std::vector<LessonRun> errors;
    std::vector<LessonRun> also_right; ///< other hands who do it right, in another style
    /// What the lesson should make of generic hands, where that is not usual: name (lesson/hands), and
    /// "pass", "fail" or "end".
    std::vector<std::pair<std::string, std::string>> hands;
};

inline constexpr double kDoneFor = 1;   ///< s for which a condition of an order has held when it is done
inline constexpr double kStandsFor = 3; ///< the same, of cable that is to stand at a figure

/// Reads the text of a lesson, which fits its schema. Throws exercise::ConfigError with a line for each
/// fault:
/// "/lesson/criteria/2/order: ...", and what to do. sides: those that the exercise has a windlass for.
Lesson read_lesson(const std::string& text, const std::vector<int>& sides);

/// The same text for an attempt for practice. The lesson's hash stays what it is; an empty text stays empty.
/// Throws exercise::ConfigError when it is no JSON.
std::string for_practice(const std::string& text);

} // namespace windlass::assess
