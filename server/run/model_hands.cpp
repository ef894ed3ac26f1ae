#include "server/run/model_hands.hpp"

namespace windlass::run {

bool is_ahead(const assess::State& hands, const assess::State& trainee) {
    if (hands.changes > trainee.changes) return true;
    for (std::size_t k = 0; k < hands.faults.size(); ++k)
        if (hands.faults[k] > trainee.faults[k]) return true;
    for (std::size_t k = 0; k < hands.orders.size(); ++k) {
        const assess::OrderCourse &theirs = hands.orders[k], &his = trainee.orders[k];
        if (theirs.given >= 0 && his.given < 0 && !his.skipped) return true;
    }
    return false;
}

} // namespace windlass::run
