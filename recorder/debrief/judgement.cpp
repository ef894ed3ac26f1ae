#include "recorder/debrief/judgement.hpp"

#include <algorithm>
#include <array>

namespace windlass::debrief {

namespace {

/// In the order of the enumerators of windlass.idl.
struct Names {
    std::string_view name, words;
};
constexpr std::array<Names, 8> kKinds{{{"limit", "limit"},
                                       {"sequence", "order of steps"},
                                       {"state_at", "state at a moment"},
                                       {"order", "order carried out"},
                                       {"report", "report against the truth"},
                                       {"prohibited", "must not happen"},
                                       {"final", "state at the end"},
                                       {"rubric", "assessor's own"}}};
constexpr std::array<Names, 5> kStates{{{"not_in_play", "not shown"},
                                        {"open", "open"},
                                        {"met", "met"},
                                        {"not_met", "not met"},
                                        {"overridden", "set by the assessor"}}};

template <std::size_t N>
Names at(const std::array<Names, N>& names, std::uint32_t index) {
    return index < N ? names[index] : Names{"unknown", "unknown"};
}

constexpr std::uint32_t kFull = 1000; // milli

/// The assessor's last word on a criterion; nullptr: he has said none.
const AssessorWord* word_on(const Attempt& attempt, const Criterion& criterion) {
    const AssessorWord* last = nullptr;
    for (const AssessorWord& word : attempt.words)
        if (word.command.criterion() == criterion.code()) last = &word;
    return last;
}

std::uint32_t milli_of(const Criterion& criterion, const AssessorWord* word) {
    if (word == nullptr) return std::min(kFull, criterion.milli());
    switch (word->command.verdict()) {
    case VERDICT_MET:
        return kFull;
    case VERDICT_NOT_MET:
        return 0;
    case VERDICT_POINTS:
        return std::min(kFull, word->command.milli());
    case VERDICT_NOT_APPLICABLE:
    case VERDICT_CONFIRMED:
        break;
    }
    return std::min(kFull, criterion.milli());
}

} // namespace

bool Mark::in_play() const {
    if (word != nullptr && word->command.verdict() == VERDICT_NOT_APPLICABLE) return false;
    if (word == nullptr && criterion->kind() == CRITERION_RUBRIC) return false; // no machine marks it
    return word != nullptr || criterion->state() != CRITERION_NOT_IN_PLAY;
}

Judgement judgement_of(const Attempt& attempt) {
    Judgement all;
    if (!attempt.assessment) return all;
    double weight = 0;
    for (const Criterion& criterion : attempt.assessment->criteria()) {
        const AssessorWord* word = word_on(attempt, criterion);
        const Mark mark{.criterion = &criterion,
                        .points = 0,
                        .lost = 0,
                        .time = attempt.time_of(criterion.tick()),
                        .milli = milli_of(criterion, word),
                        .word = word};
        if (mark.in_play()) weight += criterion.weight();
        all.marks.push_back(mark);
    }
    for (Mark& mark : all.marks) {
        if (!mark.in_play() || weight <= 0) continue;
        mark.points = 100 * mark.criterion->weight() / weight;
        mark.lost = mark.points * (kFull - mark.milli) / kFull;
    }
    return all;
}

std::vector<Mark> Judgement::deductions() const {
    std::vector<Mark> found;
    std::ranges::copy_if(marks, std::back_inserter(found), [](const Mark& mark) { return mark.lost > 0; });
    std::ranges::stable_sort(found, {}, &Mark::time);
    return found;
}

std::vector<Mark> Judgement::strongest(int most) const {
    std::vector<Mark> found;
    std::ranges::copy_if(marks, std::back_inserter(found), [](const Mark& mark) {
        return mark.points > 0 && mark.lost == 0 && mark.criterion->state() != CRITERION_OPEN;
    });
    std::ranges::stable_sort(found, std::greater{}, &Mark::points);
    found.resize(std::min(found.size(), static_cast<std::size_t>(most)));
    return found;
}

std::vector<Achievement> achievements_of(const Attempt& attempt) {
    std::vector<Achievement> all;
    if (!attempt.assessment) return all;
    for (const auto& each : attempt.lesson.objectives)
        all.push_back({each.id, each.text, each.stcw, "", 0, each.pass});
    for (const Criterion& criterion : attempt.assessment->criteria()) {
        const std::string id = criterion.objective().to_string();
        if (!id.empty() && std::ranges::find(all, id, &Achievement::id) == all.end())
            all.push_back({id, "", "", "", 0, LessonText::Objective{}.pass});
    }
    const Judgement judgement = judgement_of(attempt);
    for (Achievement& each : all) {
        double weight = 0, points = 0;
        bool musts_met = true, musts_shown = true;
        for (const Mark& mark : judgement.marks) {
            const Criterion& criterion = *mark.criterion;
            if (criterion.objective().to_string() != each.id) continue;
            if (!mark.in_play()) {
                musts_shown = musts_shown && (!criterion.must() || mark.word != nullptr);
                continue;
            }
            weight += criterion.weight();
            points += criterion.weight() * mark.milli / double{kFull};
            // Steps in a wrong order are not met, though the steps that were taken have their points.
            const bool met =
                mark.milli == kFull && (mark.word != nullptr || criterion.state() != CRITERION_NOT_MET);
            musts_met = musts_met && (!criterion.must() || met);
        }
        each.score = weight > 0 ? 100 * points / weight : 0;
        if (!attempt.assessment->finished()) continue;
        each.outcome = !musts_met               ? "not_yet"
                       : weight <= 0            ? "not_shown"
                       : each.score < each.pass ? "not_yet"
                       : !musts_shown           ? "not_shown"
                                                : "achieved";
    }
    return all;
}

std::string title_of(const Criterion& criterion) {
    std::string title = criterion.code().to_string();
    std::ranges::replace_if(
        title, [](char c) { return c == '_' || c == '-'; }, ' ');
    const std::string why = criterion.text().to_string();
    return why.empty() ? title : title + ": " + why;
}

std::string outcome_words(const std::string& outcome) {
    if (outcome.empty()) return "not finished";
    std::string text = outcome;
    std::ranges::replace(text, '_', ' ');
    return text;
}

std::string_view words(CriterionKind kind) {
    return at(kKinds, kind).words;
}
std::string_view words(CriterionState state) {
    return at(kStates, state).words;
}
std::string_view name(CriterionKind kind) {
    return at(kKinds, kind).name;
}
std::string_view name(CriterionState state) {
    return at(kStates, state).name;
}

} // namespace windlass::debrief
