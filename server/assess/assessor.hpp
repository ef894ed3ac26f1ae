#pragma once
// The assessment of one exercise: its lesson, where it stands, and what it says. For a session that runs the
// exercise, and for whoever goes through a recording of it: the same bits in both.

#include "server/assess/fold.hpp"
#include "server/assess/result.hpp"
#include "server/exercise/checkpoint.hpp"

#include <optional>

namespace windlass::assess {

class Assessor final : public exercise::KeptBeside {
public:
    /// Of no lesson: nothing is looked at.
    Assessor() = default;
    /// Of the exercise's lesson, if it has one. Throws exercise::ConfigError when its text cannot be read.
    explicit Assessor(const exercise::ExerciseDef& def);

    /// Begins the lesson at this picture.
    void begin(const exercise::Snapshot& seen);
    /// Takes the next tick; what it orders is put behind `due`.
    void fold(const exercise::Snapshot& seen, std::vector<exercise::Order>& due);
    /// Takes an order that goes into the exercise.
    void hear(const exercise::Order& order);

    /// Whether there is something to assess.
    bool assesses() const { return lesson_.has_value(); }
    bool ended() const { return state_.ending != Ending::none; }
    const Lesson* lesson() const { return lesson_ ? &*lesson_ : nullptr; }
    const State& state() const { return state_; }
    /// Place of the question that waits for an answer of that seat, the first one; -1: none does.
    int open_question(bool of_forecastle) const;
    Result result() const;
    /// The same as it would be had the assessor said nothing.
    Result computed() const;

    void begin(const exercise::ExerciseDef& def) override;
    void visit(physics::ConstStateVisitor& v) const override;
    void visit(physics::StateVisitor& v) override;

private:
    std::optional<Lesson> lesson_;
    State state_;
    int tick_rate_ = 300; // Hz
};

/// Number that differs when any bit of the assessment differs, or its lesson.
std::uint64_t assessment_hash(const Lesson& lesson, const State& state);

} // namespace windlass::assess
