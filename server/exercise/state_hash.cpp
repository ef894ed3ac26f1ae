#include "server/exercise/state_hash.hpp"

namespace windlass::exercise {

void StateHash::numbers(const physics::FieldName&, const double* first, std::size_t count) {
    std::size_t i = 0;
    for (; i + 2 < count; i += 3)
        mix(0, first[i]), mix(1, first[i + 1]), mix(2, first[i + 2]);
    for (; i < count; ++i)
        mix(0, first[i]);
}

void StateHash::text(const physics::FieldName&, const std::string& value) {
    for (const char letter : value)
        lane_[0] = stirred(lane_[0], static_cast<unsigned char>(letter));
}

} // namespace windlass::exercise
