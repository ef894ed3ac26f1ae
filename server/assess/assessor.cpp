#include "server/assess/assessor.hpp"

#include "server/assess/questions.hpp"
#include "server/exercise/state_hash.hpp"

namespace windlass::assess {

namespace {

/// Of a windlass by its rated pull, which is half as much again (UR A3 3.1.3).
constexpr double kDutyOfRated = 1 / 1.5;

Gear gear_of(const exercise::GroundTackleDef& tackle, const exercise::ExerciseDef& def) {
    return {.cable_weight = physics::weight_in_water(tackle.chain, def.environment.water_density),
            .duty_pull = kDutyOfRated * tackle.windlass.rated_pull};
}

} // namespace

Assessor::Assessor(const exercise::ExerciseDef& def) {
    begin(def);
}

void Assessor::begin(const exercise::ExerciseDef& def) {
    tick_rate_ = def.tick_rate_hz;
    lesson_.reset();
    state_ = {};
    if (def.lesson.empty()) return;
    std::vector<int> sides;
    for (const auto& tackle : def.tackle)
        sides.push_back(static_cast<int>(tackle.side));
    lesson_ = read_lesson(def.lesson, sides);
    for (const auto& tackle : def.tackle)
        lesson_->gear.at(static_cast<std::size_t>(tackle.side)) = gear_of(tackle, def);
    state_ = fresh(*lesson_);
}

void Assessor::begin(const exercise::Snapshot& seen) {
    if (lesson_) assess::begin(*lesson_, state_, seen);
}

void Assessor::fold(const exercise::Snapshot& seen, std::vector<exercise::Order>& due) {
    if (lesson_) assess::fold(*lesson_, state_, seen, tick_rate_, due);
}

void Assessor::hear(const exercise::Order& order) {
    if (lesson_) assess::hear(*lesson_, state_, order, tick_rate_);
}

int Assessor::open_question(bool of_forecastle) const {
    return lesson_ ? assess::open_question(*lesson_, state_, of_forecastle) : -1;
}

Result Assessor::result() const {
    return lesson_ ? assess::result(*lesson_, state_, tick_rate_) : Result{};
}

Result Assessor::computed() const {
    if (!lesson_) return {};
    State unsaid = state_;
    for (Mark& mark : unsaid.marks)
        mark.overridden = false;
    return assess::result(*lesson_, unsaid, tick_rate_);
}

void Assessor::visit(physics::ConstStateVisitor& v) const {
    if (lesson_) v.fields_of(state_);
}

void Assessor::visit(physics::StateVisitor& v) {
    if (!lesson_) return;
    v.fields_of(state_);
    const int first = state_.ending == Ending::abort ? 0 : -1;
    v.within({"aborted_by"}, state_.aborted_by, first, static_cast<int>(lesson_->abort.size()) - 1);
    v.within({"changes"}, state_.changes, 0, static_cast<int>(lesson_->schedule.size()));
    v.within({"further"}, static_cast<int>(state_.further.size()), 0,
             lesson_->bridge_manned ? static_cast<int>(kMostOrders)
                                    : 0); // else there is nothing to hold it by
    for (const auto* reports : {&state_.waiting, &state_.unasked})
        for (const JudgedReport& report : *reports)
            v.within({"unasked"}, report.criterion, 0, static_cast<int>(lesson_->unasked.size()) - 1);
    for (std::size_t k = 0; k < lesson_->questions.size(); ++k) {
        const QuestionCourse& course = state_.questions[k];
        const auto choices = static_cast<int>(lesson_->questions[k].choices.size());
        const bool chosen = course.answer == exercise::AnswerKind::choice;
        v.within({"choice"}, course.choice, 0, chosen ? choices - 1 : 0);
    }
}

std::uint64_t assessment_hash(const Lesson& lesson, const State& state) {
    exercise::StateHash hash;
    hash.integer({"lesson"}, static_cast<std::int64_t>(lesson.hash));
    physics::ConstStateVisitor& v = hash;
    v.fields_of(state);
    return hash.value();
}

} // namespace windlass::assess
