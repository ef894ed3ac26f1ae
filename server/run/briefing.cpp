#include "server/run/briefing.hpp"

#include "common/text.hpp"
#include "server/assess/bridge.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>

namespace windlass::run {

namespace {

constexpr std::size_t kPiece = 255; // bytes that an event's text has room for

/// The beginning of a text that fits, without the space at which it breaks; a word that is too long is cut.
std::string_view first_piece(std::string_view text) {
    if (text.size() <= kPiece) return text;
    const std::size_t space = text.rfind(' ', kPiece);
    return space == std::string_view::npos || space == 0 ? clipped(text, kPiece) : text.substr(0, space);
}

std::vector<std::string> pieces_of(std::string whole) {
    std::ranges::replace(whole, '\n', ' ');
    whole = printable(whole);
    std::vector<std::string> pieces;
    std::string_view left = whole;
    while (!left.empty()) {
        pieces.emplace_back(first_piece(left));
        left.remove_prefix(pieces.back().size());
        if (left.starts_with(' ')) left.remove_prefix(1);
    }
    return pieces;
}

} // namespace

std::vector<std::string> briefing_pieces(const assess::Lesson& lesson) {
    std::string whole = lesson.briefing + (lesson.briefing.empty() ? "" : " ") +
                        (lesson.bridge_manned ? "The bridge's orders come from its own seat."
                                              : "The bridge's orders come by themselves.");
    if (whole.find("shackle") != std::string::npos)
        whole += " Where no other place is said, shackles are counted in the pipe.";
    if (whole.find("secure") != std::string::npos)
        whole += " Secured is: brake hard on, stopper on, gear out.";
    if (lesson.practice)
        whole += " This attempt is for practice: you may be given a hint, and it is no test of competence.";
    return pieces_of(std::move(whole));
}

std::array<std::vector<std::string>, 2> own_briefing_pieces(const assess::Lesson& lesson) {
    return {pieces_of(lesson.briefings[0]), pieces_of(lesson.briefings[1])};
}

void put_to_practice(exercise::ExerciseDef& def) {
    if (def.lesson.empty())
        throw std::invalid_argument("for practice: " + def.name +
                                    " has no lesson; name an exercise that has one, or leave practice out");
    def.lesson = assess::for_practice(def.lesson);
}

std::string lesson_over_text(const assess::Lesson& lesson, const assess::State& state) {
    switch (state.ending) {
    case assess::Ending::good:
        return "the lesson is over: it has run its course";
    case assess::Ending::time:
        if (assess::was_misunderstood(lesson, state))
            return "the lesson is over: an order was repeated back wrongly to the last";
        if (assess::was_told_falsely(lesson, state))
            return "the lesson is over: the bridge was told what is not so";
        return state.gave_up ? "the lesson is over: the bridge had no answer"
                             : "the lesson is over: its time is up";
    case assess::Ending::abort:
        return "the lesson is over: what has happened ends it";
    case assess::Ending::instructor:
    case assess::Ending::none:
        break;
    }
    return "the lesson is over: it was ended";
}

} // namespace windlass::run
