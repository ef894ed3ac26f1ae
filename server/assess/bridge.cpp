#include "server/assess/bridge.hpp"

#include "server/assess/order_done.hpp"
#include "server/assess/quantities.hpp"
#include "server/exercise/talk/bridge_orders.hpp"
#include "server/exercise/talk/talk.hpp"
#include "server/physics/base/units.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace windlass::assess {

namespace {

using exercise::BridgeOrderCode;
using exercise::BridgeOrderGiven;
using exercise::ReportCode;

// How often it asks or gives an order once more; then it gives up.
constexpr auto kMostAsked = static_cast<int>(words::limits::bridge_asks);
constexpr double kCorrects = 2;     // s after a wrong repeat
constexpr double kWaitsRepeat = 5;  // s after a repeat should have come
constexpr double kWaitsAnswer = 30; // s after an order should have been carried out, and since the last word
constexpr double kWaitsTruth = 30;  // s after an answer to its question that is not so
constexpr double kWaitsLonger = 30; // s for the repeat of an order where it waits longer
constexpr const char* kLastCall = "this is my last call, then I send another man forward";
// To an answer that is not so: he is to look, and not to try figures.
constexpr const char* kDoubts = "that does not agree with my reckoning; look again and report";
// To who tries one figure after the other until one is taken.
constexpr const char* kGuesses = "do not guess; look again, and report what you see";
constexpr const char* kSendsToLook = "I send a man forward to look";
constexpr std::size_t kMostText = 256; // bytes of an order's text; of the IDL
constexpr double kRenews = 8;          // s after it has heard that less was done than it ordered
constexpr double kAsOrdered = 0.5;     // shackles, by which a reported length may differ from the ordered one
constexpr double kDoneAlready = 0.25;  // shackles short of an order that need not be given any more

bool of_length(const BridgeOrderGiven& order) {
    switch (order.code) {
    case BridgeOrderCode::pay_out:
    case BridgeOrderCode::veer:
    case BridgeOrderCode::walk_back:
    case BridgeOrderCode::hold_on:
    case BridgeOrderCode::heave_to:
        return order.value > 0;
    default:
        return false;
    }
}

bool is_shackles(ReportCode code) {
    return code == ReportCode::shackles_on_deck || code == ReportCode::shackles_in_pipe ||
           code == ReportCode::shackles_in_water;
}

/// Whether a report tells of a fault that stops the work.
bool is_trouble(ReportCode code) {
    switch (code) {
    case ReportCode::no_power:
    case ReportCode::does_not_run:
    case ReportCode::brake_does_not_hold:
    case ReportCode::defect:
        return true;
    default:
        return false;
    }
}

/// The reports that tell that an order is carried out, or answer a question, first the one for which the
/// bridge calls; those of shackles are apart.
std::vector<ReportCode> told_by(BridgeOrderCode order) {
    switch (order) {
    case BridgeOrderCode::stand_by:
    case BridgeOrderCode::clear_away:
        return {ReportCode::standing_by, ReportCode::anchor_ready};
    case BridgeOrderCode::gear_in:
    case BridgeOrderCode::walk_out:
        return {ReportCode::anchor_ready, ReportCode::standing_by};
    case BridgeOrderCode::let_go:
        return {ReportCode::let_go, ReportCode::on_the_bottom};
    case BridgeOrderCode::heave:
        return {ReportCode::heaving, ReportCode::short_stay, ReportCode::up_and_down,
                ReportCode::anchor_aweigh, ReportCode::anchor_home};
    case BridgeOrderCode::secure:
        return {ReportCode::secured};
    case BridgeOrderCode::buoy_cable:
        return {ReportCode::ready_to_slip};
    case BridgeOrderCode::slip:
        return {ReportCode::slipped};
    case BridgeOrderCode::clear_anchor:
        return {ReportCode::clear_anchor};
    case BridgeOrderCode::how_leading:
        return {ReportCode::lead, ReportCode::short_stay, ReportCode::up_and_down};
    case BridgeOrderCode::how_growing:
        return {ReportCode::growing};
    case BridgeOrderCode::how_much_weight:
        return {ReportCode::weight};
    case BridgeOrderCode::brought_up:
        return {ReportCode::brought_up, ReportCode::growing, ReportCode::dragging, ReportCode::lead};
    default:
        return {};
    }
}

bool is_told_in_shackles(BridgeOrderCode order) {
    switch (order) {
    case BridgeOrderCode::walk_out:
    case BridgeOrderCode::how_much:
    case BridgeOrderCode::pay_out:
    case BridgeOrderCode::veer:
    case BridgeOrderCode::walk_back:
    case BridgeOrderCode::hold_on:
    case BridgeOrderCode::heave_to:
        return true;
    default:
        return false;
    }
}

/// Whether a report tells that an order is carried out, or answers a question.
bool answers(const BridgeOrderGiven& order, ReportCode report) {
    if (is_shackles(report)) return is_told_in_shackles(order.code);
    return std::ranges::count(told_by(order.code), report) > 0;
}

/// The report by which the bridge wants to hear that an order is carried out; nothing: it is a question, or
/// to a length, for which it asks, or no report tells it.
std::optional<ReportCode> called_for(BridgeOrderCode order) {
    const std::vector<ReportCode> told = told_by(order);
    return told.empty() || is_question(order) ? std::nullopt : std::optional(told.front());
}

/// As its button is called: "ready".
std::string label_of(ReportCode report) {
    return '"' + std::string(words::row_of(report).label) + '"';
}

/// The question of its own that it asked last, which is one.
BridgeOrderGiven asked_last(const State& state) {
    return {.code = static_cast<BridgeOrderCode>(state.question)};
}

/// What the bridge asks when it has heard nothing of what it waits for.
BridgeOrderCode question_for(ReportCode report) {
    switch (report) {
    case ReportCode::brought_up:
        return BridgeOrderCode::brought_up;
    case ReportCode::lead:
    case ReportCode::short_stay:
    case ReportCode::up_and_down:
        return BridgeOrderCode::how_leading;
    case ReportCode::growing:
    case ReportCode::dragging:
        return BridgeOrderCode::how_growing;
    case ReportCode::weight:
        return BridgeOrderCode::how_much_weight;
    default:
        return BridgeOrderCode::how_much;
    }
}

/// As a bridge reckons a reported length, mark in the pipe: a mark in the water is about a quarter of a
/// shackle farther out, one on deck a tenth farther in.
double in_the_pipe(const Heard& report) {
    return report.code == ReportCode::shackles_in_water  ? report.value + 0.25
           : report.code == ReportCode::shackles_on_deck ? report.value - 0.1
                                                         : report.value;
}

/// Place of the last order that has been given; -1: none.
int newest_given(const State& state) {
    int newest = -1;
    for (std::size_t k = 0; k < state.orders.size(); ++k)
        if (state.orders[k].given >= 0) newest = static_cast<int>(k);
    return newest;
}

/// The report that a condition waits for and that has not come since then; nothing: it waits for none.
std::optional<ReportCode> awaited(const Condition& condition, const Lesson& lesson, const State& state,
                                  std::int64_t since) {
    for (const Sign& sign : condition.signs)
        if (sign.kind == SignKind::report && came(sign, state) < since)
            return lesson.reports[static_cast<std::size_t>(sign.index)].code;
    for (const Condition& one : condition.either)
        if (const auto report = awaited(one, lesson, state, since)) return report;
    return std::nullopt;
}

/// Place of the order that a report calls unsafe: the one that it names, or the last that he was given, which
/// no question is. -1: none.
int called_unsafe(const Lesson& lesson, const State& state, const Heard& report) {
    for (int k = newest_given(state); k >= 0; --k) {
        const OrderCourse& course = state.orders[static_cast<std::size_t>(k)];
        const BridgeOrderGiven& given = lesson.orders[static_cast<std::size_t>(k)].given;
        const bool his = report.side < 0 || given.side < 0 || report.side == given.side;
        const bool meant =
            report.order_number > 0 ? report.order_number == course.number : !is_question(given.code);
        if (course.given >= 0 && course.challenged < 0 && his && meant) return k;
    }
    return -1;
}

/// Place of an order that was called unsafe, to which the bridge has yet to say something; -1: none.
int doubted(const State& state) {
    for (std::size_t k = 0; k < state.orders.size(); ++k)
        if (state.orders[k].doubted >= 0) return static_cast<int>(k);
    return -1;
}

/// Whether the bridge waits for a repeat or an answer to an order that it has given.
bool waits_for(const Lesson& lesson, const State& state, int k) {
    const OrderCourse& course = state.orders[static_cast<std::size_t>(k)];
    const BridgeOrderGiven& given = lesson.orders[static_cast<std::size_t>(k)].given;
    const bool repeat = repeat_within(given) > 0 && course.repeated < 0;
    if (course.challenged >= 0) return false;
    if (repeat && course.misrepeated) return true; // whatever he reports: he has not understood it
    return course.given >= 0 && course.answered < 0 && (repeat || !answered_by_repeat(given));
}

/// Of the orders whose answers a condition waits for, the first that has none; -1: none.
int unanswered(const Condition& condition, const Lesson& lesson, const State& state) {
    for (const Sign& sign : condition.signs)
        if (sign.kind == SignKind::order_answered && waits_for(lesson, state, sign.index)) return sign.index;
    for (const Condition& one : condition.either)
        if (const int k = unanswered(one, lesson, state); k >= 0) return k;
    return -1;
}

/// What the bridge waits for before it orders the next, or is content; nothing: no order and no end.
const Condition* comes_next(const Lesson& lesson, const State& state) {
    for (std::size_t k = 0; k < lesson.orders.size(); ++k) {
        const OrderCourse& course = state.orders[k];
        if (!course.asked_for && course.number == 0 && !course.skipped) return &lesson.orders[k].when;
    }
    return lesson.good ? &*lesson.good : nullptr;
}

/// The order that the bridge waits to have answered: the one that it gave last, or one before that the next
/// hangs on, as where both sides were told at once; -1: none.
int open_order(const Lesson& lesson, const State& state) {
    const int newest = newest_given(state);
    if (newest < 0 || waits_for(lesson, state, newest)) return newest;
    const Condition* next = comes_next(lesson, state);
    return next == nullptr ? -1 : unanswered(*next, lesson, state);
}

/// Whether the forecastle has said nothing yet in this lesson.
bool is_silent_yet(const State& state) {
    return state.heard_at < 0 && std::ranges::none_of(state.orders, [](const OrderCourse& course) {
               return course.repeated >= 0 || course.misrepeated;
           });
}

/// s that it waits for an order to be repeated, after it has given it: longer for a first word, since he may
/// still be finding his way about; where it sees by its camera that what it ordered was so already and
/// nothing but the word is left; and after its last call, which he is to have time to answer.
double waits_for_repeat(const BridgeOrderGiven& given, const OrderCourse& course, const State& state) {
    const double usual = repeat_within(given) + kWaitsRepeat;
    const bool no_hurry = course.was_so && answered_by_repeat(given);
    const bool longer = is_silent_yet(state) || no_hurry || state.asked >= kMostAsked;
    return longer ? std::max(usual, kWaitsLonger) : usual;
}

/// s that it waits before it asks again where it was told what is not so, however often it is told that.
double waits_for_truth(const Lesson& lesson) {
    return std::min(lesson.patience, kWaitsTruth);
}

/// It goes on from here.
void has_its_answer(State& state) {
    state.asked = 0;
    state.misled_at = -1;
    state.tried.clear();
}

/// Whether he tries figures, and has yet to be told that none is taken any more.
bool is_guessing(const State& state) {
    return state.question >= 0 && state.tried.size() >= kMostTried;
}

bool say_the_same(const Heard& one, const Heard& other) {
    return one.code == other.code && one.side == other.side && one.value == other.value &&
           one.lead == other.lead && one.stay == other.stay && one.growing == other.growing &&
           one.weight == other.weight;
}

/// Whether a report is a guess, and no answer to what the bridge has asked: the first figure is the answer, a
/// second one puts it right, and who has a third has not looked. The same once more is no other.
bool is_a_guess(const Heard& report, const Look& look) {
    State& state = look.state;
    if (state.asked == 0 || state.question < 0 || !answers(asked_last(state), report.code) ||
        !gives_a_figure(report.code))
        return false;
    const bool may_be_taken = state.tried.size() + 1 < kMostTried;
    if (may_be_taken && !is_false(report, look)) return false;
    const bool is_new =
        std::ranges::none_of(state.tried, [&](const Heard& before) { return say_the_same(before, report); });
    if (is_new && !is_guessing(state)) state.tried.push_back(report);
    if (!is_guessing(state)) return false;
    for (OrderCourse& course : state.orders) // nor does it renew one by what he tried
        course.short_of = -1;
    return true;
}

/// What it says when it asks, first that it has heard of a fault: what to do about it is not said by a bridge
/// that tests who knows. at_last: what it adds the last time, of what comes then.
std::string call_words(std::string says, const char* at_last, const std::string& text, const State& state) {
    if (state.trouble != ReportCode::text)
        says = "understood, " + words::report_text({.code = static_cast<std::size_t>(state.trouble)}) +
               (says.empty() ? "" : "; ") + says;
    const std::string last =
        state.asked < kMostAsked ? "" : (says.empty() ? "" : "; ") + std::string(at_last);
    const std::string order = text.empty() ? "" : ": " + text;
    const bool fits = says.size() + last.size() + order.size() <= kMostText;
    return says + (fits ? last : "") + order;
}

/// Whether what has been reported is all that an order to pay out would ask for.
bool reported_done(const LessonOrder& order, const State& state) {
    const BridgeOrderGiven& given = order.given;
    const bool out = given.code == BridgeOrderCode::pay_out || given.code == BridgeOrderCode::veer;
    if (!out || given.side < 0) return false;
    return state.told.at(static_cast<std::size_t>(given.side)) >= given.value - kDoneAlready;
}

/// The bridge's turn at one tick.
class Turn {
public:
    Turn(const Lesson& lesson, State& state, const exercise::Snapshot& seen, int tick_rate,
         std::vector<exercise::Order>& due)
        : lesson_(lesson), state_(state), seen_(seen), rate_(tick_rate), due_(due) {}

    bool speak() {
        if (lesson_.bridge_manned) return true;
        if (const int k = doubted(state_); k >= 0) return answer_challenge(static_cast<std::size_t>(k));
        const int next = next_order();
        if (next >= 0 && gives(static_cast<std::size_t>(next))) return true;
        if (lesson_.patience <= 0) return true;
        if (is_guessing(state_)) return stop_guesses(newest_given(state_));
        const int k = open_order(lesson_, state_);
        return k >= 0 ? prompt(static_cast<std::size_t>(k)) : ask_for_report(newest_given(state_));
    }

private:
    bool passed(std::int64_t since, double seconds) const {
        return state_.tick - since >= std::llround(seconds * rate_);
    }

    std::int64_t last_word() const { return std::max({state_.begin, state_.heard_at, state_.spoke_at}); }

    bool heard(const BridgeOrderGiven& given) const {
        return gets_through(given, exercise::talk_of(seen_.faults, seen_.environment.now.visibility));
    }

    /// Whether a condition waits for an order that was taken back.
    bool waits_in_vain(const Condition& when) const {
        return std::ranges::any_of(when.signs, [&](const Sign& sign) {
            const bool follows = sign.kind == SignKind::order_repeated ||
                                 sign.kind == SignKind::order_answered || sign.kind == SignKind::order_done;
            return follows && state_.orders[static_cast<std::size_t>(sign.index)].challenged >= 0;
        });
    }

    /// Place of the next order in the sequence, those left out that are reported done or that hang on one
    /// that was taken back; -1: none.
    int next_order() {
        for (std::size_t k = 0; k < lesson_.orders.size(); ++k) {
            OrderCourse& course = state_.orders[k];
            if (course.asked_for || course.number != 0 || course.skipped) continue;
            if (waits_in_vain(lesson_.orders[k].when)) {
                course.skipped = true;
                course.challenged = state_.tick; // with it
                continue;
            }
            if (lesson_.patience <= 0 || !reported_done(lesson_.orders[k], state_))
                return static_cast<int>(k);
            course.skipped = true;
            course.was_so = is_out(lesson_.orders[k].given);
            course.repeated = course.answered = course.done = state_.tick;
        }
        return -1;
    }

    /// Whether as much cable is out as an order to pay out asks for.
    bool is_out(const BridgeOrderGiven& given) const {
        const exercise::TackleView* tackle = tackle_of(seen_, given.side);
        return tackle != nullptr &&
               tackle->chain.cable_out >= (given.value - kThereShort) * physics::kShackleLength;
    }

    /// Whether the reports that a condition goes by have come since the last order: one that came before was
    /// about something else.
    bool is_news(const Condition& when) const {
        const int newest = newest_given(state_);
        const std::int64_t since = newest < 0 ? 0 : state_.orders[static_cast<std::size_t>(newest)].given;
        return std::ranges::all_of(when.signs,
                                   [&](const Sign& sign) {
                                       return sign.kind != SignKind::report || came(sign, state_) >= since;
                                   }) &&
               (when.either.empty() ||
                std::ranges::any_of(when.either, [&](const Condition& one) { return is_news(one); }));
    }

    /// Whether the last order was repeated back wrongly and not put right yet, however often it was given
    /// again.
    bool misunderstood() const {
        const int newest = newest_given(state_);
        return newest >= 0 && state_.orders[static_cast<std::size_t>(newest)].repeated < 0 &&
               state_.orders[static_cast<std::size_t>(newest)].misrepeated;
    }

    bool gives(std::size_t k) {
        const LessonOrder& next = lesson_.orders[k];
        if (!holds(next.when, lesson_, state_, seen_, rate_)) return false;
        if (lesson_.patience > 0 && (!is_news(next.when) || misunderstood())) return false;
        // The bridge sees that its VHF is dead: it waits with an order that no hand signal tells.
        if (!heard(next.given)) return false;
        state_.orders[k].asked_for = true;
        say(next.given);
        has_its_answer(state_);
        return true;
    }

    /// Takes an order back that was rightly called unsafe, and orders what was proposed; insists on any
    /// other.
    bool answer_challenge(std::size_t k) {
        OrderCourse& course = state_.orders[k];
        const BridgeOrderGiven& order = lesson_.orders[k].given;
        const BridgeOrderGiven back{.code = BridgeOrderCode::cancel,
                                    .side = order.side,
                                    .text = "it is unsafe, as you say",
                                    .by = "bridge",
                                    .cancels = course.number};
        if (!passed(last_word(), kCorrects) || course.number == 0 || !heard(back)) return true;
        course.doubted = -1;
        if (!course.unsafe) return again(k, "that is safe; carry it out");
        course.challenged = state_.tick;
        has_its_answer(state_);
        say(back);
        orders_what_is_proposed(course, order.side);
        return true;
    }

    /// In the lesson's own words where it has that order still to give.
    void orders_what_is_proposed(const OrderCourse& course, int side) {
        if (course.proposed == BridgeOrderCode::text || is_question(course.proposed)) return;
        BridgeOrderGiven proposed{.code = course.proposed,
                                  .side = side,
                                  .value = course.proposed_value,
                                  .text = "as you propose",
                                  .by = "bridge"};
        for (std::size_t k = 0; k < lesson_.orders.size(); ++k) {
            const BridgeOrderGiven& own = lesson_.orders[k].given;
            OrderCourse& its = state_.orders[k];
            const bool same = own.code == proposed.code && own.side == side && own.value == proposed.value;
            if (!same || its.asked_for || its.number != 0 || its.skipped) continue;
            its.asked_for = true;
            proposed = own;
            break;
        }
        say(proposed);
    }

    void say(const BridgeOrderGiven& given) {
        state_.spoke_at = state_.tick;
        state_.misled_at = -1;
        state_.trouble = ReportCode::text;
        // Who has put a figure right once is to look before he says another.
        if (state_.tried.size() > 1) state_.tried.resize(1);
        due_.emplace_back(given);
    }

    /// Has a wrong repeat put right, and asks for what was to be done.
    bool prompt(std::size_t k) {
        const OrderCourse& course = state_.orders[k];
        const BridgeOrderGiven& given = lesson_.orders[k].given;
        const double repeat = repeat_within(given);
        if (course.number == 0) return true; // it is on its way
        if (course.repeated < 0 && repeat > 0) {
            if (course.wrong_now)
                return !passed(last_word(), kCorrects) || again(k, "that is wrong; I say again");
            if (!passed(last_word(), waits_for_repeat(given, course, state_))) return true;
            return again(k, "I say again");
        }
        if (course.short_of >= 0)
            return !passed(std::max(course.short_of, last_word()), kRenews) || again(k, "not enough yet");
        if (men_work() || !passed(std::max(course.given, course.do_by), kWaitsAnswer) ||
            !passed(last_word(), kWaitsAnswer))
            return true;
        return of_length(given) ? ask(BridgeOrderCode::how_much, given.side) : again(k, calls_for(given));
    }

    /// An order once more that was repeated back, and nobody has said since that it is carried out: with the
    /// report by which to say so.
    static std::string calls_for(const BridgeOrderGiven& given) {
        const auto report = called_for(given.code);
        return report ? "I say again; report " + label_of(*report) + " when it is so" : "I say again";
    }

    /// Whether men forward are at what they were set to. The bridge sees them, and that is as good as a word:
    /// it asks no sooner than it would have, had they told it so when they were done.
    bool men_work() {
        const bool work = std::ranges::any_of(seen_.tackle, [](const exercise::TackleView& tackle) {
            const exercise::DeckWorkView& men = tackle.deck_work;
            return men.set != exercise::DeckWork::none && men.waits == words::DeckHindrance::none &&
                   men.left > 0;
        });
        if (work) state_.heard_at = state_.tick;
        return work;
    }

    /// Asks for the report that the next order or the end hangs on, when it has heard nothing for long, or
    /// what is not so.
    bool ask_for_report(int newest) {
        const Condition* when = comes_next(lesson_, state_);
        const bool waited = state_.misled_at < 0 ? passed(last_word(), lesson_.patience)
                                                 : passed(state_.misled_at, waits_for_truth(lesson_));
        if (when == nullptr || men_work() || !waited) return true;
        const std::int64_t since = newest < 0 ? 0 : state_.orders[static_cast<std::size_t>(newest)].given;
        const auto report = awaited(*when, lesson_, state_, since);
        return !report || ask(question_for(*report), side_of(newest));
    }

    /// Of the order in that place; -1: the lesson's.
    int side_of(int order) const {
        return order >= 0 ? lesson_.orders[static_cast<std::size_t>(order)].given.side : lesson_.side;
    }

    /// Asks once more him who tries figures: what he has said is no answer.
    bool stop_guesses(int newest) {
        return !passed(state_.tried.back().tick, kCorrects) || ask(asked_last(state_).code, side_of(newest));
    }

    bool patient() {
        if (state_.asked >= kMostAsked) {
            state_.gave_up = true;
            return false;
        }
        ++state_.asked;
        return true;
    }

    bool ask(BridgeOrderCode question, int side) {
        BridgeOrderGiven given{.code = question, .side = side, .by = "bridge"};
        if (!heard(given)) return true;
        if (!patient()) return false;
        const bool doubts = state_.misled_at >= 0;
        const char* words = is_guessing(state_) ? kGuesses : doubts ? kDoubts : "";
        given.text = call_words(words, doubts ? kSendsToLook : kLastCall, "", state_);
        state_.question = static_cast<int>(question);
        say(given);
        return true;
    }

    bool again(std::size_t k, const std::string& words) {
        BridgeOrderGiven given = lesson_.orders[k].given;
        if (!heard(given)) return true;
        if (!patient()) return false;
        given.text = call_words(words, kLastCall, given.text, state_);
        state_.orders[k].short_of = -1;
        state_.renewing = static_cast<int>(k);
        say(given);
        return true;
    }

    const Lesson& lesson_;
    State& state_;
    const exercise::Snapshot& seen_;
    int rate_;
    std::vector<exercise::Order>& due_;
};

} // namespace

bool answered_by_repeat(const BridgeOrderGiven& order) {
    switch (order.code) {
    case BridgeOrderCode::text:
    case BridgeOrderCode::check:
    case BridgeOrderCode::gear_out:
    case BridgeOrderCode::stop_heaving:
    case BridgeOrderCode::stand_clear:
    case BridgeOrderCode::cancel:
        return true;
    case BridgeOrderCode::hold_on:
    case BridgeOrderCode::walk_back:
    case BridgeOrderCode::heave_to:
        return order.value <= 0;
    default:
        return false;
    }
}

void take_answer(const Heard& report, const Look& look) {
    const Lesson& lesson = look.lesson;
    State& state = look.state;
    state.heard_at = state.tick;
    if (is_trouble(report.code)) state.trouble = report.code;
    if (report.code == ReportCode::unsafe) {
        if (const int k = called_unsafe(lesson, state, report); k >= 0) {
            OrderCourse& course = state.orders[static_cast<std::size_t>(k)];
            course.doubted = state.tick;
            course.proposed = report.proposed;
            course.proposed_value = report.value;
        }
        return;
    }
    if (is_a_guess(report, look)) return;
    if (is_shackles(report.code))
        for (int side = 0; side < 2; ++side)
            if (report.side < 0 || report.side == side)
                state.told.at(static_cast<std::size_t>(side)) = in_the_pipe(report);
    // What is not so is no answer: the bridge reckons by her place, depth and time, or has a man look.
    if (state.question >= 0 && answers(asked_last(state), report.code)) {
        if (!is_false(report, look)) {
            state.question = -1;
            has_its_answer(state);
        } else if (state.asked > 0 && state.misled_at < 0) {
            state.misled_at = state.tick;
        }
    }
    for (FurtherOrder& order : state.further) {
        const bool his = report.side < 0 || order.side < 0 || report.side == order.side;
        if (order.done < 0 && is_question(order.code) && his && answers({.code = order.code}, report.code))
            order.done = state.tick;
    }
    for (std::size_t k = 0; k < state.orders.size(); ++k) {
        OrderCourse& course = state.orders[k];
        const BridgeOrderGiven& given = lesson.orders[k].given;
        if (course.given < 0 || course.answered >= 0 || !answers(given, report.code)) continue;
        if (report.side >= 0 && given.side >= 0 && report.side != given.side) continue;
        if (of_length(given)) {
            const double more = in_the_pipe(report) - given.value; // than was ordered
            const bool less =
                given.code == BridgeOrderCode::heave_to ? more > kAsOrdered : more < -kAsOrdered;
            course.short_of = less ? state.tick : -1;
            if (less) continue;
        }
        course.answered = state.tick;
        has_its_answer(state);
    }
}

bool speak(const Lesson& lesson, State& state, const exercise::Snapshot& seen, int tick_rate,
           std::vector<exercise::Order>& due) {
    return Turn(lesson, state, seen, tick_rate, due).speak();
}

std::int64_t gives_up_at(const Lesson& lesson, const State& state, int tick_rate) {
    if (lesson.bridge_manned || lesson.patience <= 0 || state.asked == 0 || state.ending != Ending::none)
        return -1;
    std::int64_t since = std::max({state.begin, state.heard_at, state.spoke_at});
    double wait = lesson.patience, at_last = 0; // s; at_last: after its last call, at least
    double sooner = 0;                          // s, by which it waits less this time
    if (const int k = open_order(lesson, state); k >= 0) {
        const OrderCourse& course = state.orders[static_cast<std::size_t>(k)];
        const BridgeOrderGiven& given = lesson.orders[static_cast<std::size_t>(k)].given;
        const bool not_repeated = course.repeated < 0 && repeat_within(given) > 0;
        wait = not_repeated ? waits_for_repeat(given, course, state) : kWaitsAnswer;
        at_last = not_repeated ? kWaitsLonger : 0;
        if (!not_repeated) since = std::max({since, course.given, course.do_by});
    } else if (state.misled_at >= 0) {
        since = state.misled_at;
        sooner = wait - waits_for_truth(lesson);
    }
    if (is_guessing(state)) {
        since = state.tried.back().tick;
        sooner = wait - kCorrects;
    }
    const double in_all = (kMostAsked - state.asked) * wait + std::max(wait, at_last) - sooner;
    return since + std::llround(in_all * tick_rate);
}

namespace {

/// Place of the order that it gave up over; -1: it had given none.
int given_up(const Lesson& lesson, const State& state) {
    const int open = open_order(lesson, state);
    return open >= 0 ? open : newest_given(state);
}

} // namespace

bool was_misunderstood(const Lesson& lesson, const State& state) {
    const int k = state.gave_up ? given_up(lesson, state) : -1;
    if (k < 0) return false;
    const OrderCourse& course = state.orders[static_cast<std::size_t>(k)];
    return course.repeated < 0 && course.wrong_now;
}

bool was_told_falsely(const Lesson& lesson, const State& state) {
    if (!state.gave_up || state.question < 0 || state.misled_at < 0 || was_misunderstood(lesson, state))
        return false;
    // Of an order that is open it asks nothing but how much is out.
    const int open = open_order(lesson, state);
    return open < 0 || (asked_last(state).code == BridgeOrderCode::how_much &&
                        of_length(lesson.orders[static_cast<std::size_t>(open)].given));
}

std::string gave_up_words(const Lesson& lesson, const State& state) {
    if (was_told_falsely(lesson, state))
        return "the bridge was told what is not so when it asked \"" +
               exercise::order_words(asked_last(state).code, lesson.side, 0) + '"';
    if (open_order(lesson, state) < 0 && state.question >= 0) // nothing else was left to wait for
        return "the bridge had no answer to \"" +
               exercise::order_words(static_cast<BridgeOrderCode>(state.question), lesson.side, 0) + '"';
    const int k = given_up(lesson, state);
    if (k < 0) return "the bridge heard nothing";
    const BridgeOrderGiven& given = lesson.orders[static_cast<std::size_t>(k)].given;
    const OrderCourse& course = state.orders[static_cast<std::size_t>(k)];
    const std::string words = exercise::order_words(given.code, given.side, given.value);
    const auto report = called_for(given.code);
    if (report && course.repeated >= 0 && course.answered < 0)
        return "the bridge heard no " + label_of(*report) + " after \"" + words + '"';
    const char* what = was_misunderstood(lesson, state) ? "the bridge was repeated wrongly: \""
                       : course.answered >= 0           ? "the bridge heard no more after \""
                                                        : "the bridge had no answer to \"";
    return what + (words.empty() ? given.text : words) + '"';
}

} // namespace windlass::assess
