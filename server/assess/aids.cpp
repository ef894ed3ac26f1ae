#include "server/assess/aids.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace windlass::assess {

namespace {

using exercise::AnswerGiven;
using exercise::AnswerKind;

constexpr std::string_view kAids = "practice/"; // no criterion's code has a stroke in it
constexpr std::array<std::string_view, 3> kKinds{"ghost", "hint", "told"};
constexpr std::array<std::string_view, 6> kLevers{"brake", "speed", "clutch", "stopper", "engine", "rudder"};
constexpr std::array<std::string_view, 2> kSides{"port", "starboard"};
constexpr std::string_view kNothingLost = "nothing-lost", kNoneKnown = "none-known", kNotFound = "not-found";

/// Up to the next stroke, which goes too.
std::string_view take_part(std::string_view& text) {
    const std::size_t end = std::min(text.find('/'), text.size());
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return part;
}

template <std::size_t N>
std::optional<std::size_t> place_of(std::string_view name, const std::array<std::string_view, N>& names) {
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) return std::nullopt;
    return static_cast<std::size_t>(found - names.begin());
}

/// "starboard-brake", "engine"
std::string name_of(const Lever& lever) {
    const std::string name(kLevers.at(static_cast<std::size_t>(lever.kind)));
    if (lever.of_helm()) return name;
    return std::string(kSides.at(static_cast<std::size_t>(lever.side))) + '-' + name;
}

std::optional<Lever> lever_of(std::string_view name) {
    for (const exercise::Side side : {exercise::Side::port, exercise::Side::starboard})
        for (std::size_t kind = 0; kind < kLevers.size(); ++kind)
            if (const Lever lever{static_cast<LeverKind>(kind), side}; name_of(lever) == name) return lever;
    return std::nullopt;
}

std::string capital(std::string text) {
    if (!text.empty())
        text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return text;
}

} // namespace

bool is_aid(std::string_view question) {
    return question.starts_with(kAids);
}

std::optional<AidWord> read_aid(const AnswerGiven& answer) {
    std::string_view rest = answer.question;
    if (!is_aid(rest)) return std::nullopt;
    rest.remove_prefix(kAids.size());
    const auto kind = place_of(take_part(rest), kKinds);
    const auto seat = place_of(take_part(rest), kSeatNames);
    if (!kind || !seat) return std::nullopt;
    AidWord word{.kind = static_cast<AidKind>(*kind), .forecastle = *seat == 0};
    if (word.kind != AidKind::told) {
        if (!rest.empty() || answer.kind != AnswerKind::choice || answer.choice < 0 || answer.choice > 1)
            return std::nullopt;
        word.on = answer.choice == 1;
        return word;
    }
    if (rest == kNothingLost) return word;
    if (rest == kNotFound) {
        word.found = false;
        return word;
    }
    word.criterion = answer.choice;
    if (rest == kNoneKnown) return word;
    word.lever = lever_of(rest);
    word.value = answer.value;
    if (!word.lever || answer.kind != AnswerKind::number || !std::isfinite(word.value)) return std::nullopt;
    return word;
}

AnswerGiven write_aid(const AidWord& word) {
    AnswerGiven answer{.question = std::string(kAids) +
                                   std::string(kKinds.at(static_cast<std::size_t>(word.kind))) + '/' +
                                   std::string(kSeatNames.at(word.forecastle ? 0 : 1)),
                       .kind = AnswerKind::choice,
                       .value = 0,
                       .choice = word.on ? 1 : 0};
    if (word.kind != AidKind::told) return answer;
    answer.choice = std::max(word.criterion, 0);
    answer.question += '/' + (word.lever           ? name_of(*word.lever)
                              : !word.found        ? std::string(kNotFound)
                              : word.criterion < 0 ? std::string(kNothingLost)
                                                   : std::string(kNoneKnown));
    if (!word.lever) return answer;
    answer.kind = AnswerKind::number;
    answer.value = word.value;
    return answer;
}

bool may_have_ghost(const Lesson& lesson) {
    return lesson.practice && lesson.ghost && !lesson.model_run.scripts.empty();
}

void take_aid(const Lesson& lesson, State& state, const AidWord& word) {
    if (!lesson.practice || word.criterion >= static_cast<int>(lesson.criteria.size())) return;
    const std::size_t seat = word.forecastle ? 0 : 1;
    AidTaken aid{.tick = state.tick, .kind = word.kind, .forecastle = word.forecastle};
    switch (word.kind) {
    case AidKind::hint:
        state.hint_asked.at(seat) = state.tick;
        return;
    case AidKind::ghost: {
        state.ghost_on.at(seat) = word.on;
        const bool told = std::ranges::any_of(state.aids, [&](const AidTaken& one) {
            return one.kind == AidKind::ghost && one.forecastle == word.forecastle;
        });
        if (!word.on || told) return;
        break;
    }
    case AidKind::told:
        state.hint_asked.at(seat) = -1;
        if (!word.found) return;
        aid.criterion = word.criterion;
        aid.lever = word.lever ? static_cast<int>(word.lever->kind) : -1;
        aid.side = word.lever ? static_cast<int>(word.lever->side) : 0;
        aid.value = word.value;
        break;
    }
    if (state.aids.size() < kMostAids) state.aids.push_back(aid);
}

namespace {

std::string lost_words(const Criterion& criterion) {
    if (criterion.kind == CriterionKind::order) return "orders, repeated back and carried out in time";
    return criterion.text.empty() ? criterion.id : criterion.text;
}

} // namespace

std::string told_words(const AidWord& word, const Lesson& lesson) {
    if (word.lever)
        return capital(lever_words(*word.lever, lesson.two_sides)) + ' ' +
               value_words(*word.lever, word.value) + " now.";
    if (!word.found) return "There was no time to find out what is being lost: ask again.";
    if (word.criterion < 0)
        return "Nothing that a lever keeps is lost in the next minute if everything stays as it is.";
    return "No single lever is known that would keep what is being lost: " +
           lost_words(lesson.criteria.at(static_cast<std::size_t>(word.criterion)));
}

std::string told_words(const AidTaken& aid, const Lesson& lesson) {
    if (aid.kind == AidKind::ghost)
        return "The model's hands were shown over the trainee's own levers from here on.";
    AidWord word{
        .kind = aid.kind, .forecastle = aid.forecastle, .value = aid.value, .criterion = aid.criterion};
    if (aid.lever >= 0)
        word.lever = Lever{static_cast<LeverKind>(aid.lever), static_cast<exercise::Side>(aid.side)};
    return told_words(word, lesson);
}

bool helps(const AidTaken& aid) {
    return aid.kind != AidKind::told || aid.lever >= 0;
}

} // namespace windlass::assess
