// Session: what a seat may ask for in an attempt for practice.

#include "server/assess/aids.hpp"
#include "server/run/session.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <utility>

namespace windlass::run {

namespace {

constexpr std::array<const char*, 2> kTopics{"ForecastleAnswer", "BridgeAnswer"};

/// In an attempt: whoever has asked so often is to watch the cable.
constexpr std::ptrdiff_t kMostHints = 12;

std::string words_of(unsigned aids) {
    if (aids == 0) return "nothing to be asked for";
    std::string text = (aids & aid_hint_wanted) != 0 ? "a hint is being looked for"
                       : (aids & aid_hints) != 0     ? "hints may be asked for"
                                                     : "no more hints";
    if ((aids & aid_ghost_on) != 0)
        text += "; the model's hands are shown";
    else if ((aids & aid_ghost) != 0)
        text += "; the model's hands may be shown";
    return text;
}

/// What the model's hands get, too: what neither a trainee's hand nor the lesson has brought.
bool stays(const exercise::Order& order, const std::string& source) {
    if (std::holds_alternative<exercise::FaultOrder>(order) ||
        std::holds_alternative<exercise::EnvironmentOrder>(order) ||
        std::holds_alternative<exercise::BridgeOrderGiven>(order))
        return source != kServerName;
    return std::holds_alternative<exercise::ChanceDrawn>(order);
}

} // namespace

/// As an attempt begins, or is gone on with that began elsewhere: definition and seed say how it began,
/// unless an instructor intervened in it.
void Session::look_for_the_beginning() {
    others_.reset();
    if (options_.model_hands && assessor_.assesses() && assess::may_have_ghost(*assessor_.lesson()) &&
        !assessor_.state().intervened)
        others_.emplace();
}

void Session::keep_for_the_model(const exercise::Order& command, const std::string& source) {
    if (others_ && stays(command, source)) others_->push_back(orders_.back());
}

/// After a restore: what came later did not happen.
void Session::forget_for_the_model() {
    if (others_) std::erase_if(*others_, [&](const OrderView& order) { return order.tick >= tick_; });
}

bool Session::practises() const {
    return assessor_.assesses() && assessor_.lesson()->practice && !assessor_.ended();
}

unsigned Session::aids(std::size_t seat) const {
    if (!practises()) return 0;
    const assess::State& state = assessor_.state();
    const auto told = std::ranges::count(state.aids, assess::AidKind::told, &assess::AidTaken::kind);
    unsigned aids = 0;
    if (told < kMostHints) aids |= aid_hints;
    if (state.hint_asked.at(seat) >= 0) aids |= aid_hint_wanted;
    if (others_ && !exercise_.foreign()) {
        aids |= aid_ghost;
        if (state.ghost_on.at(seat)) aids |= aid_ghost_on;
    }
    return aids;
}

/// To each seat alone, where it has changed.
void Session::tell_aids() {
    constexpr std::array<words::EventCode, 2> kCodes{"practice.forecastle", "practice.bridge"};
    for (std::size_t seat = 0; seat < kCodes.size(); ++seat) {
        const unsigned now = aids(seat);
        if (std::exchange(aids_told_.at(seat), now) == now) continue;
        log(kCodes.at(seat), fmt::format("for practice, {}: {}", assess::kSeatNames.at(seat), words_of(now)),
            -1, now);
    }
}

void Session::carry_out_aid(const AnswerOrder& order, const ReceivedOrder& from) {
    const std::size_t seat = order.of_forecastle ? 0 : 1;
    const std::string& question = order.answer.question;
    const auto refused = [&](std::string allowed) {
        refuse(kTopics.at(seat), from.source, "question", '"' + question + '"', std::move(allowed));
    };
    const auto word = assess::read_aid(order.answer);
    if (!word || word->kind == assess::AidKind::told || word->forecastle != order.of_forecastle)
        return refused(fmt::format("\"practice/ghost/{0}\" or \"practice/hint/{0}\", with choice 0 or 1",
                                   assess::kSeatNames.at(seat)));
    const unsigned now = aids(seat);
    if (!practises()) return refused("none: this is no attempt for practice that goes on");
    if (word->kind == assess::AidKind::ghost) {
        if ((now & aid_ghost) == 0) return refused("none: the model's hands are not to be had here");
        if (word->on == ((now & aid_ghost_on) != 0)) return;
    } else {
        if ((now & aid_hint_wanted) != 0) return refused("one at a time: a hint is being looked for");
        if ((now & aid_hints) == 0)
            return refused(fmt::format("{} hints in an attempt, which have been given", kMostHints));
    }
    apply(order.answer, from.source);
    new_assessment_ = assessor_.result();
    tell_aids();
}

std::optional<bool> Session::hint_wanted() const {
    for (std::size_t seat = 0; seat < assess::kSeatNames.size(); ++seat)
        if ((aids(seat) & aid_hint_wanted) != 0) return seat == 0;
    return std::nullopt;
}

bool Session::wants_ghost() const {
    return ((aids(0) | aids(1)) & aid_ghost_on) != 0;
}

bool Session::shows_ghost(bool forecastle) const {
    const std::size_t seat = forecastle ? 0 : 1;
    // Whoever is asked at a freeze is not to read the answer off other hands.
    return (aids(seat) & aid_ghost_on) != 0 && !status_.asked.at(seat) && !over();
}

/// Whether the lever that it would have moved has come there meanwhile, by the hand itself.
bool Session::is_done(const assess::AidWord& hint) const {
    constexpr double kAsSet = 0.05; // of a lever's way
    if (!hint.lever) return false;
    const exercise::WindlassOrder windlass =
        hint.lever->of_helm() ? exercise::WindlassOrder{} : exercise_.levers(hint.lever->side);
    const double place = assess::place_of(*hint.lever, windlass, exercise_.helm());
    return std::abs(place - hint.value) <= kAsSet;
}

void Session::tell_hint(const assess::AidWord& told) {
    const std::size_t seat = told.forecastle ? 0 : 1;
    if ((aids(seat) & aid_hint_wanted) == 0) return; // gone back, or over, meanwhile
    if (is_done(told)) return;                       // it is still wanted, and looked for from what is so now
    apply(assess::write_aid(told), kServerName);
    instructed_.at(seat) = true;
    log(told.forecastle ? words::EventCode("hint.forecastle") : words::EventCode("hint.bridge"),
        assess::told_words(told, *assessor_.lesson()),
        told.lever && !told.lever->of_helm() ? static_cast<int>(told.lever->side) : -1);
    new_assessment_ = assessor_.result();
    tell_aids();
}

} // namespace windlass::run
