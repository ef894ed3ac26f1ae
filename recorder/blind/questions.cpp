#include "recorder/blind/questions.hpp"

#include "server/assess/quantities.hpp"
#include "words/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

namespace windlass::blind {

namespace {

using assess::Condition;
using assess::Criterion;
using assess::Lesson;
using assess::SignKind;

constexpr int kWellTenths = 850; // tenths of a point

/// An id as words.
std::string plain(std::string id) {
    std::ranges::replace_if(
        id, [](char c) { return c == '-' || c == '_'; }, ' ');
    return id;
}

std::string order_words(const Lesson& lesson, int order) {
    const auto& given = lesson.orders[static_cast<std::size_t>(order)].given;
    const std::string words =
        words::order_text(static_cast<std::size_t>(given.code), given.side, given.value);
    return words.empty() ? given.text : words;
}

/// What a report says, with dots where its figures stand.
std::string report_words(exercise::ReportCode code) {
    const std::string_view said = words::row_of(code).said;
    std::string words;
    for (std::size_t i = 0; i < said.size(); ++i) {
        const auto end = said[i] == '{' ? said.find('}', i) : std::string_view::npos;
        if (end == std::string_view::npos) {
            words += said[i];
            continue;
        }
        const std::string_view name = said.substr(i + 1, end - i - 1);
        words += name == "anchor" || name == "cable" ? name : "...";
        i = end;
    }
    return words.empty() ? std::string(words::row_of(code).name) : words;
}

std::string sign_words(const Lesson& lesson, const assess::Sign& sign) {
    const auto index = static_cast<std::size_t>(sign.index);
    const auto order = [&](const char* what) {
        return fmt::format("order \"{}\" {}", order_words(lesson, sign.index), what);
    };
    switch (sign.kind) {
    case SignKind::event: {
        const std::string code = lesson.events[index].code.substr(lesson.events[index].code.find('.') + 1);
        return plain(code);
    }
    case SignKind::report:
        return fmt::format("report \"{}\"", report_words(lesson.reports[index].code));
    case SignKind::moment:
        return plain(lesson.moments[index].id);
    case SignKind::order_given:
        return order("given");
    case SignKind::order_repeated:
        return order("repeated");
    case SignKind::order_answered:
        return order("answered");
    case SignKind::order_done:
        return order("carried out");
    case SignKind::order_challenged:
        return order("called unsafe");
    }
    return {};
}

/// What a condition looks at, without its figures.
std::string condition_words(const Lesson& lesson, const Condition& condition) {
    std::vector<std::string> parts;
    for (const assess::Sign& sign : condition.signs)
        parts.push_back(sign_words(lesson, sign));
    for (const assess::Bounds& bounds : condition.bounds)
        parts.emplace_back(assess::quantity_at(bounds.quantity).text);
    if (condition.phases != 0) parts.emplace_back("what the anchor does");
    std::vector<std::string> either, neither;
    for (const Condition& each : condition.either)
        either.push_back(condition_words(lesson, each));
    for (const Condition& each : condition.neither)
        neither.push_back(condition_words(lesson, each));
    if (!either.empty()) parts.push_back(fmt::format("either of ({})", fmt::join(either, "; ")));
    if (!neither.empty()) parts.push_back(fmt::format("not ({})", fmt::join(neither, "; ")));
    return fmt::format("{}", fmt::join(parts, "; "));
}

std::string asked(const Lesson& lesson, const Criterion& criterion) {
    using assess::CriterionKind;
    const auto that = [&] { return condition_words(lesson, criterion.that); };
    switch (criterion.kind) {
    case CriterionKind::limit:
        return fmt::format("How well was this kept within what you hold right: {}?",
                           assess::quantity_at(criterion.quantity).text);
    case CriterionKind::sequence: {
        std::vector<std::string> steps;
        for (const Condition& step : criterion.steps)
            steps.push_back(condition_words(lesson, step));
        return fmt::format("Was this done, in order and in time: {}?", fmt::join(steps, ", then "));
    }
    case CriterionKind::state_at:
        return fmt::format("Was this as it should be, when it had to be, at \"{}\": {}?",
                           plain(lesson.moments[static_cast<std::size_t>(criterion.at)].id), that());
    case CriterionKind::order: {
        std::vector<std::string> orders;
        for (const int order : criterion.orders)
            orders.push_back(order_words(lesson, order));
        return fmt::format("Were these orders repeated back rightly, and carried out in time: {}?",
                           fmt::join(orders, "; "));
    }
    case CriterionKind::report:
        return fmt::format("Was this reported truly, and when it was so: {}?",
                           report_words(criterion.report));
    case CriterionKind::prohibited:
        return fmt::format("Was this kept from happening as long as it had to be: {}?", that());
    case CriterionKind::final:
        return fmt::format("Was this as it should be at the end: {}?", that());
    case CriterionKind::question:
        return fmt::format("Was this answered rightly, while the exercise held for it: {}",
                           lesson.questions[static_cast<std::size_t>(criterion.question)].ask);
    case CriterionKind::rubric:
        break;
    }
    return {};
}

std::string question(const Lesson& lesson, const Criterion& criterion) {
    std::string words = plain(criterion.id) + ". " + asked(lesson, criterion);
    words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
    const auto when = [&](const char* how, const std::optional<Condition>& condition) {
        if (condition && !condition->signs.empty())
            words += fmt::format(" {}: {}.", how, condition_words(lesson, *condition));
    };
    when("Looked at from", criterion.from);
    when("Looked at until", criterion.to);
    if (std::ranges::any_of(lesson.criteria, [&](const auto& other) { return other.side != criterion.side; }))
        words += criterion.side == 0 ? " Port cable." : " Starboard cable.";
    return criterion.text.empty() ? words : words + " Why: " + criterion.text + ".";
}

} // namespace

int on_scale(int milli) {
    return std::clamp(milli / 250, 0, kTopMark);
}

int on_scale(const assess::Result& result) {
    if (result.outcome == assess::Outcome::achieved) return result.tenths_computed >= kWellTenths ? 3 : 2;
    return 2 * result.tenths_computed >= 10 * result.pass ? 1 : 0;
}

std::vector<Question> questions_of(const Lesson& lesson, const assess::Result& computed) {
    std::vector<Question> all;
    for (std::size_t k = 0; k < lesson.criteria.size(); ++k) {
        if (lesson.criteria[k].kind == assess::CriterionKind::rubric) continue;
        const assess::CriterionResult& mark = computed.criteria[k];
        all.push_back({lesson.id + "/" + lesson.criteria[k].id, question(lesson, lesson.criteria[k]),
                       mark.state == assess::CriterionState::not_in_play
                           ? std::nullopt
                           : std::optional(on_scale(mark.milli))});
    }
    all.push_back({kOverall,
                   "Overall. Had this been your ship: would you call the hand that did this competent?",
                   on_scale(computed)});
    return all;
}

} // namespace windlass::blind
