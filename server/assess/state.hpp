#pragma once
// What the fold carries from tick to tick: whole numbers, and figures that are compared and never summed, so
// that the same course gives the same bits whoever goes through it.

#include "server/assess/growth.hpp"
#include "server/assess/lesson.hpp"
#include "server/physics/base/state_visitor.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace windlass::assess {

/// When something came, in ticks; -1: it has not.
struct Came {
    std::int64_t first = -1, last = -1;
    int times = 0;
};

struct OrderCourse {
    bool asked_for = false;                            ///< the lesson has given it out
    int number = 0;                                    ///< of the BridgeOrder that it became; 0: none yet
    std::int64_t given = -1, repeated = -1, done = -1; ///< done: by all that it is to
    std::array<std::int64_t, 2> each_since{-1, -1};    ///< in the order of LessonOrder::done: has held since
    std::array<std::int64_t, 2> each_done{-1, -1};     ///< the same: carried out
    bool in_time = false;                              ///< repeated in time
    bool misrepeated = false;                          ///< once
    bool wrong_now = false;                            ///< newest word on it: repeated wrongly
    std::int64_t do_by = -1;                           ///< tick; -1: no deadline
    std::int64_t answered = -1; ///< when a report told the bridge that it is carried out
    std::int64_t short_of = -1; ///< when one told that less was done than was ordered; -1: it was not
    bool was_so = false;        ///< what it asks for was so when it was given, or left out
    bool skipped = false;       ///< not given: what was reported is more than it asks for
    bool unsafe = false;        ///< at this tick it is right to challenge it
    std::int64_t doubted = -1; ///< when it was called unsafe, and the bridge has yet to say something to that
    exercise::BridgeOrderCode proposed = exercise::BridgeOrderCode::text; ///< instead of it; text: nothing
    double proposed_value = 0;                                            ///< figure of what was proposed
    std::int64_t challenged = -1; ///< when the bridge took it back because it was unsafe
    double figure = 0;       ///< that a bridge which is manned has put to an order that has none; 0: none
    bool taken_back = false; ///< before it was carried out: what comes of it later is no deed
};

/// What a bridge that is manned orders besides: once more, another length, or what the lesson does not wait
/// for.
struct FurtherOrder {
    int number = 0; ///< of the BridgeOrder
    exercise::BridgeOrderCode code = exercise::BridgeOrderCode::text;
    int side = -1;
    double figure = 0;                              ///< that it is to; 0: none
    std::int64_t done = -1;                         ///< by all that it is to; of a question: answered
    std::array<std::int64_t, 2> each_since{-1, -1}; ///< port, starboard: has held since
    std::array<std::int64_t, 2> each_done{-1, -1};  ///< the same: carried out
};
inline constexpr std::size_t kMostOrders = 64; ///< in all, the first of them; of the IDL

/// An order to pay out that the bridge has left out because of a report that was not so: who lied has not
/// carried it out.
inline bool left_out_falsely(const OrderCourse& course) {
    return course.skipped && course.challenged < 0 && !course.was_so;
}

/// One criterion's course.
struct Mark {
    CriterionState state = CriterionState::not_in_play;
    int milli = 0;             ///< 0..1000
    std::int64_t decided = -1; ///< tick; -1: not yet
    std::int64_t began = -1;   ///< when it came into play
    std::int64_t outside = 0; ///< ticks beyond the limit; report of a state: at which it was last said before
                              ///< it was asked for, 0: it was not
    std::int64_t since = -1; ///< when it went beyond, the last report came, or what is to be reported came to
                             ///< be so; final: since it is as it is; report of orders: of a wrong one before
                             ///< the first of them
    double worst = 0;        ///< farthest from what is allowed; what the condition that is `missing` was
    std::int64_t worst_tick = -1;
    int missing = -1;       ///< part of the condition that did not hold (missing_part()); -1: none
    int step = 0;           ///< of a sequence: steps taken; of reports: those judged
    int wrong = 0;          ///< steps out of order; reports that were wrong
    bool holds = false;     ///< final, limit: now
    bool held = false;      ///< final: once
    bool acted = false;     ///< final, state_at: it was not so once, so that something was to be done for it
    std::int64_t slots = 0; ///< report of orders: kSlots bits each, of those answered, half right, wrong
    std::int64_t pending = -1; ///< report of a state that was not so yet: when it came
    exercise::Growing said = exercise::Growing::not_given; ///< reported, and waits for its ten seconds
    std::int64_t reported = -1; ///< when the report came that waits for its truth; of a state: unasked; of
                                ///< orders: that was wrong, and may be put right
    double shown = 0, shown_angle = 0; ///< report of a moment: what the tackle showed then (JudgedReport)
    bool overridden = false;           ///< an assessor's word stands in its place
    int given_milli = 0;               ///< by him; -1: not applicable
    std::string note{}, by{};
};

/// Shackles short of an order to pay out that are still its place.
inline constexpr double kThereShort = 0.75;
inline constexpr int kSlots = 20; ///< orders that a criterion of reports may name

/// A report that waits for the next tick's truth.
struct Heard {
    std::int64_t tick = -1; ///< at which it came
    exercise::ReportCode code = exercise::ReportCode::text;
    int side = -1;
    double value = 0;
    int lead = 0;
    exercise::StayGiven stay = exercise::StayGiven::not_given;
    exercise::Growing growing = exercise::Growing::not_given;
    exercise::CableWeight weight = exercise::CableWeight::not_given;
    int order_number = 0; ///< unsafe: of the order; 0: the newest
    exercise::BridgeOrderCode proposed = exercise::BridgeOrderCode::text; ///< unsafe: what he proposes
};

/// A report as a criterion has judged it.
struct JudgedReport {
    int criterion = 0;                                      ///< place in Lesson::criteria
    std::int64_t tick = -1;                                 ///< at which it came
    int milli = 0;                                          ///< that it has earned, 0..1000
    exercise::ReportCode code = exercise::ReportCode::text; ///< text: the criterion's
    std::int64_t so =
        -1;           ///< when that came to be so which it tells; -1: it never was, or tells no such thing
    double said = 0;  ///< figure: as reported; of a lead the hour, of a weight its class
    double truth = 0; ///< figure: what was so, as `said`; state: what the `missing` part was; moment: what
                      ///< the tackle showed, of a lead its hour, of a drive whether it had power, of a
                      ///< cable that does not run its speed, else the anchor's phase
    double top_angle = 0; ///< deg, of the cable below the horizontal
    int missing = -1;     ///< state: part of the condition that did not hold
    exercise::StayGiven stay = exercise::StayGiven::not_given;
    exercise::Growing growing = exercise::Growing::not_given;
};

/// How a question went.
struct QuestionCourse {
    std::int64_t asked = -1; ///< tick at which the exercise held for it; -1: it has not
    bool open = false;       ///< it waits for its answer
    double truth = 0;        ///< number: what was so, in the question's unit
    std::int64_t right = 0;  ///< choice: a bit for each that was so
    exercise::AnswerKind answer = exercise::AnswerKind::passed_over;
    double value = 0; ///< number: as answered
    int choice = 0;   ///< choice: the same
};

/// What a seat may have beside the lesson's own hints, in practice (aids.hpp).
enum class AidKind {
    ghost, ///< the model's hands shown over its own levers
    hint,  ///< asked for
    told   ///< the hint that was searched for
};
constexpr AidKind last_of(AidKind) {
    return AidKind::told;
}

/// One that it had, for the record.
struct AidTaken {
    std::int64_t tick = -1;
    AidKind kind = AidKind::ghost; ///< ghost, or told
    bool forecastle = true;        ///< who; false: the bridge
    int criterion = -1;            ///< told: place of what it keeps; -1: nothing was being lost
    int lever = -1;                ///< told: LeverKind; -1: none was known
    int side = 0;                  ///< told: of that lever
    double value = 0;              ///< told: where it was to go
};
inline constexpr std::size_t kMostAids = 32; ///< the first of them; of the IDL

inline constexpr std::size_t kMostTried = 3;    ///< figures to one asking: the third is a guess
inline constexpr std::size_t kMostJudged = 256; ///< reports, the first of them; of the IDL
inline constexpr std::size_t kMostUnasked = 64; ///< of those that no criterion asks for, the false ones

enum class Ending { none, good, time, abort, instructor };
constexpr Ending last_of(Ending) {
    return Ending::instructor;
}

struct State {
    std::int64_t begin = -1; ///< tick at which the lesson began; -1: it has not
    std::int64_t tick = -1;  ///< the last that was looked at
    std::int64_t ended = -1;
    Ending ending = Ending::none;
    int aborted_by = -1;   ///< place in Lesson::abort
    int last_order = 0;    ///< number of the newest BridgeOrder that was looked at
    int changes = 0;       ///< entries of the schedule carried out
    int renewing = -1;     ///< place of the order that the bridge gives once more at this tick; -1: none
    int asked = 0;         ///< how often the bridge has asked since it went on, or had a true answer
    bool gave_up = false;  ///< the bridge asked as often as it does, and had no answer that is so
    std::int64_t seed = 0; ///< of this attempt's chances; 0: nothing is left to chance
    int own_due = 0;       ///< faults and changes of the weather that it has ordered, and not heard go in yet
    bool intervened = false;                   ///< others went in, by an instructor
    int question = -1;                         ///< BridgeOrderCode that it asked last; -1: it was answered
    std::int64_t heard_at = -1, spoke_at = -1; ///< ticks of the last words of forecastle and bridge
    std::int64_t misled_at = -1; ///< of the first answer that is not so; -1: none since it asked
    /// Figures that differ and were not so, in answer to what it asked last: his answer and what puts it
    /// right. A third, so or not, is a guess.
    std::vector<Heard> tried;
    /// Of a fault that stops the work, reported since the bridge's last word; text: none.
    exercise::ReportCode trouble = exercise::ReportCode::text;
    std::array<double, 2> told{-1, -1}; ///< shackles in the pipe as last reported; -1: never
    bool confirmed = false;
    std::vector<Came> events, reports, moments;
    std::vector<OrderCourse> orders;
    std::vector<FurtherOrder> further;     ///< by their numbers
    std::vector<int> faults;               ///< 0 to come, 1 there, 2 gone
    std::vector<std::int64_t> fault_since; ///< when its condition first held; -1: it has not
    std::vector<Mark> marks;
    std::vector<std::int64_t> held;  ///< since when a condition has held; -1: it does not
    std::vector<std::int64_t> hints; ///< when each was given; -1: it was not
    std::vector<Heard> heard;
    std::vector<JudgedReport> judged; ///< by when they were judged
    /// Reports that no criterion asks for; `criterion` is a place in Lesson::unasked. Those that may come to
    /// be so yet, and those that were false.
    std::vector<JudgedReport> waiting, unasked;
    std::array<Growth, 2> growth{}; ///< port, starboard
    std::vector<QuestionCourse> questions;
    std::vector<AidTaken> aids;
    std::array<bool, 2> ghost_on{};                 ///< forecastle, bridge
    std::array<std::int64_t, 2> hint_asked{-1, -1}; ///< tick at which a hint that it waits for was asked for
};

/// A lesson that has not begun.
State fresh(const Lesson& lesson);

template <class Visitor, physics::StateOf<State> Self>
void visit_state(Visitor& v, Self& self);

} // namespace windlass::assess
