#include "server/physics/base/state_visitor.hpp"

#include <algorithm>

namespace windlass::physics {

std::string FieldName::text() const {
    std::string_view rest = list;
    for (int k = 0; k < index; ++k)
        rest.remove_prefix(std::min(rest.size(), rest.find(',') + 1));
    rest = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(rest.size(), rest.find_first_not_of(' ')));
    while (!rest.empty() && rest.back() == '_')
        rest.remove_suffix(1);
    return std::string(rest);
}

} // namespace windlass::physics
