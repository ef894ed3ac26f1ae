#include "recorder/debrief/judgement.hpp"

#include "recorder/debrief/seat_units.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::debrief {

namespace {

constexpr std::uint32_t kFull = 1000; // milli

/// The assessor's last word on a criterion; nullptr: he has said none.
const AssessorWord* word_on(const Attempt& attempt, const Criterion& criterion) {
    const AssessorWord* last = nullptr;
    for (const AssessorWord& word : attempt.words)
        if (word.command.criterion() == criterion.code()) last = &word;
    return last;
}

/// Why the bridge gave up, in the server's words (server/assess/bridge.cpp), all of which begin with it;
/// empty: it did not.
std::string gave_up_words(const Assessment& assessment) {
    const std::string why = assessment.abort().to_string();
    return assessment.ending() == LESSON_TIME_UP && why.starts_with("the bridge ") ? why : "";
}

} // namespace

Judgement judgement_of(const Attempt& attempt) {
    Judgement all;
    if (!attempt.assessment) return all;
    double weight = 0;
    for (const Criterion& criterion : attempt.assessment->criteria()) {
        const std::uint64_t tick = criterion.lost_tick() > 0 ? criterion.lost_tick() : criterion.tick();
        all.marks.push_back({.criterion = &criterion,
                             .points = 0,
                             .lost = 0,
                             .time = attempt.time_of(tick),
                             .word = word_on(attempt, criterion)});
        if (criterion.counts()) weight += criterion.weight();
    }
    for (Mark& mark : all.marks) {
        if (!mark.criterion->counts() || weight <= 0) continue;
        mark.points = 100 * mark.criterion->weight() / weight;
        mark.lost = mark.points * (kFull - std::min(kFull, mark.criterion->counted())) / kFull;
    }
    return all;
}

std::vector<Mark> Judgement::deductions() const {
    std::vector<Mark> found;
    std::ranges::copy_if(marks, std::back_inserter(found), [](const Mark& mark) { return mark.lost > 0; });
    std::ranges::stable_sort(found, {}, &Mark::time);
    return found;
}

std::optional<Reckoning> reckoning_of(const Attempt& attempt, const Judgement& judgement) {
    if (!attempt.assessment) return std::nullopt;
    constexpr double kRounded = 0.1; // points: the score is told in tenths, marks in thousandths
    Reckoning all;
    double to_do = 0, done = 0, kept = 0;
    for (const Mark& mark : judgement.marks) {
        all.lost += mark.lost;
        (mark.criterion->deed() ? done : kept) += mark.points - mark.lost;
        if (mark.criterion->deed()) to_do += mark.points;
    }
    if (to_do > 0) all.done = done / to_do;
    all.unearned = kept * (1 - all.done);
    const double left = 100 - all.lost - all.unearned, score = attempt.assessment->score();
    all.halved = std::abs(left - score) > kRounded;
    if (all.halved && std::abs(left / 2 - score) > kRounded) return std::nullopt;
    return all;
}

std::vector<std::string> why_halved(const Attempt& attempt) {
    std::vector<std::string> all;
    if (!attempt.assessment) return all;
    const auto& criteria = attempt.assessment->criteria();
    const auto missed = [](const Criterion& one) { return one.must() && one.counts() && !one.met(); };
    const auto never_came = [](const Criterion& one) { return one.state() == CRITERION_NOT_IN_PLAY; };
    if (std::ranges::any_of(criteria, [&](const Criterion& one) { return missed(one) && !never_came(one); }))
        all.emplace_back("a criterion marked (must) was missed");
    if (std::ranges::any_of(criteria, [&](const Criterion& one) { return one.must() && never_came(one); }))
        all.emplace_back("a criterion marked (must) was not come to");
    if (std::ranges::any_of(attempt.assessment->objectives(), [](const ObjectiveMark& one) {
            return one.outcome() == "not_yet" &&
                   one.score() < std::min<double>(one.pass(), words::limits::objective_fails);
        }))
        all.emplace_back("an objective has less than half of its points");
    if (std::string why = gave_up_words(*attempt.assessment); !why.empty()) all.push_back(std::move(why));
    return all;
}

std::optional<Mark> went_wrong(const Attempt& attempt, const Judgement& judgement) {
    if (!attempt.assessment) return std::nullopt;
    constexpr double kAtTheEnd = 1; // s
    const LessonEnding ending = attempt.assessment->ending();
    const Event* over = attempt.event("lesson.over");
    const double end = over != nullptr ? over->time() : attempt.ended;
    std::optional<Mark> first;
    for (const Mark& mark : judgement.deductions()) {
        if ((ending == LESSON_TIME_UP || ending == LESSON_ENDED_EARLY) && mark.time > end - kAtTheEnd)
            continue;
        if (mark.criterion->state() == CRITERION_NOT_IN_PLAY) continue; // it never came to that
        if (!first || (mark.criterion->must() && !first->criterion->must())) first = mark;
    }
    return first;
}

std::vector<Mark> Judgement::strongest(int most) const {
    std::vector<Mark> found;
    std::ranges::copy_if(marks, std::back_inserter(found), [](const Mark& mark) {
        return mark.criterion->deed() && mark.points > 0 && mark.lost == 0 &&
               mark.criterion->state() != CRITERION_OPEN;
    });
    std::ranges::stable_sort(found, std::greater{}, &Mark::points);
    found.resize(std::min(found.size(), static_cast<std::size_t>(most)));
    return found;
}

std::vector<Achievement> achievements_of(const Attempt& attempt) {
    std::vector<Achievement> all;
    if (!attempt.assessment) return all;
    for (const ObjectiveMark& each : attempt.assessment->objectives())
        all.push_back({each.id().to_string(), each.text().to_string(), each.stcw().to_string(),
                       each.outcome().to_string(), each.score(), static_cast<double>(each.pass())});
    return all;
}

std::string practice_words(const Attempt& attempt) {
    if (!attempt.assessment || !attempt.assessment->practice()) return "";
    const std::size_t hints = attempt.assessment->hints().size();
    return "for practice, " + std::to_string(hints) + (hints == 1 ? " hint" : " hints");
}

bool was_hinted(const Attempt& attempt, const Criterion& criterion) {
    return attempt.assessment && std::ranges::any_of(attempt.assessment->hints(), [&](const HintGiven& hint) {
               return hint.criterion() == criterion.code();
           });
}

bool was_looked_at(const Criterion& limit) {
    // Also where an assessor's word stands in its place: one that was looked at and kept has its full mark.
    return limit.milli() > 0 || limit.time_outside() > 0;
}

std::string name_of(const Criterion& criterion) {
    std::string name = criterion.code().to_string();
    std::ranges::replace_if(
        name, [](char c) { return c == '_' || c == '-'; }, ' ');
    return name;
}

std::string title_of(const Criterion& criterion) {
    const std::string why = in_seat_units(criterion.text().to_string());
    return why.empty() ? name_of(criterion) : name_of(criterion) + ": " + why;
}

std::string outcome_words(const std::string& outcome) {
    if (outcome.empty()) return "not finished";
    std::string text = outcome;
    std::ranges::replace(text, '_', ' ');
    return text;
}

} // namespace windlass::debrief
