#include "server/exercise/published.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::exercise {

namespace {

struct FiniteCheck {
    static constexpr bool kNamed = false;
    bool finite = true;

    template <class Leaf>
    void field(const std::string&, const Leaf& value) {
        if constexpr (std::is_floating_point_v<Leaf>) finite = finite && std::isfinite(value);
    }
    template <class Number>
    void numbers(const std::string&, const Number* first, std::size_t count) {
        finite = finite && std::all_of(first, first + count, [](Number n) { return std::isfinite(n); });
    }
};

} // namespace

bool is_finite(const Snapshot& snapshot) {
    FiniteCheck check;
    visit_published(check, snapshot);
    return check.finite;
}

std::string published::name_in(std::string_view list, int index) {
    for (; index > 0; --index)
        list.remove_prefix(std::min(list.size(), list.find(',') + 1));
    list.remove_prefix(std::min(list.size(), list.find_first_not_of(' ')));
    return std::string(list.substr(0, list.find(',')));
}

} // namespace windlass::exercise
