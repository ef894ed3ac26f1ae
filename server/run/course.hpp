#pragma once
// An exercise that goes once more through what it went through, from one of its checkpoints: each order at
// the tick at which it was taken, and a lesson's marks made anew. Comes to the same bits.

#include "server/assess/assessor.hpp"
#include "server/exercise/exercise.hpp"
#include "server/run/status.hpp"

namespace windlass::run {

class Course {
public:
    /// orders_taken: of its run, up to this state.
    Course(exercise::Exercise exercise, assess::Assessor assessor, std::uint64_t orders_taken)
        : exercise_(std::move(exercise)), assessor_(std::move(assessor)), orders_taken_(orders_taken) {}

    /// Whether it is the next one, and was taken at the present tick.
    bool is_next(const OrderView& order) const {
        return order.number == orders_taken_ + 1 && order.tick == exercise_.tick();
    }
    void take(const OrderView& order);
    /// One tick. False when the state ceases to be finite.
    bool step();

    /// What a lesson ordered in the last step. A recording has it among its orders; who leaves the recorded
    /// course takes it from here.
    const std::vector<exercise::Order>& ordered() const { return ordered_; }
    /// The picture after the last step, of an exercise with a lesson.
    const exercise::Snapshot& seen() const { return seen_; }

    const exercise::Exercise& exercise() const { return exercise_; }
    const assess::Assessor& assessor() const { return assessor_; }
    std::uint64_t orders_taken() const { return orders_taken_; }
    std::uint64_t state_hash() const;
    std::vector<std::uint8_t> checkpoint() const; ///< of the present state

private:
    exercise::Exercise exercise_;
    assess::Assessor assessor_;
    std::uint64_t orders_taken_;
    exercise::Snapshot seen_;              // of an exercise with a lesson
    std::vector<exercise::Order> ordered_; // by the lesson, in the last step
};

/// An attempt as it begins. seed: of its lesson's chances (assess::State::seed). Throws std::exception when
/// the exercise cannot be set up.
Course beginning_of(const exercise::ExerciseDef& def, std::int64_t seed);

/// From a checkpoint of this program's own, which was checked as it came in. Throws
/// exercise::CheckpointError.
Course course_of(const std::vector<std::uint8_t>& checkpoint);

} // namespace windlass::run
