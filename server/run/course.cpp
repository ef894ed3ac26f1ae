#include "server/run/course.hpp"

#include "server/assess/chance.hpp"
#include "server/exercise/checkpoint.hpp"
#include "server/exercise/state_hash.hpp"

namespace windlass::run {

void Course::take(const OrderView& order) {
    exercise_.apply(order.command);
    assessor_.hear(order.command);
    orders_taken_ = order.number;
}

bool Course::step() {
    if (!exercise_.step(1.0 / exercise_.def().tick_rate_hz)) return false;
    if (!assessor_.assesses()) return true;
    exercise_.view_unhashed(seen_);
    ordered_.clear();
    assessor_.fold(seen_, ordered_);
    return true;
}

std::uint64_t Course::state_hash() const {
    exercise::StateHash hash;
    exercise_.visit_state(hash);
    return hash.value();
}

std::vector<std::uint8_t> Course::checkpoint() const {
    return exercise::write_checkpoint(exercise_, &assessor_);
}

Course beginning_of(const exercise::ExerciseDef& def, std::int64_t seed) {
    exercise::Exercise exercise(def);
    assess::Assessor assessor(def);
    exercise::Snapshot seen;
    exercise.view(seen);
    assessor.begin(seen);
    assessor.hear(assess::drawn_for(seed));
    return {std::move(exercise), std::move(assessor), 0};
}

Course course_of(const std::vector<std::uint8_t>& checkpoint) {
    assess::Assessor assessor;
    exercise::Exercise exercise = exercise::read_checkpoint(checkpoint, {}, &assessor);
    return {std::move(exercise), std::move(assessor), 0};
}

} // namespace windlass::run
