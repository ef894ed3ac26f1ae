#include "server/physics/base/state_visitor.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace windlass::physics {

std::string FieldName::text() const {
    std::string_view rest = list;
    for (int k = 0; k < index; ++k)
        rest.remove_prefix(std::min(rest.size(), rest.find(',') + 1));
    rest = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(rest.size(), rest.find_first_not_of(' ')));
    if (constexpr std::string_view kSelf = "self."; rest.starts_with(kSelf)) rest.remove_prefix(kSelf.size());
    while (!rest.empty() && rest.back() == '_')
        rest.remove_suffix(1);
    return std::string(rest);
}

void StateVisitor::all_within(const FieldName& name, const double* first, std::size_t count, double low,
                              double high) const {
    for (std::size_t i = 0; i < count; ++i)
        if (!(first[i] >= low && first[i] <= high))
            refuse(name.text() + '[' + std::to_string(i) + ']', first[i], low, high);
}

void StateVisitor::refuse(const std::string& name, double value, double low, double high) {
    std::array<char, 120> text{};
    std::snprintf(text.data(), text.size(), " = %g; allowed: %g..%g", value, low, high);
    throw StateError(name + text.data());
}

void StateVisitor::refuse(const std::string& name, std::int64_t value, std::int64_t low, std::int64_t high) {
    throw StateError(name + " = " + std::to_string(value) + "; allowed: " + std::to_string(low) + ".." +
                     std::to_string(high));
}

} // namespace windlass::physics
