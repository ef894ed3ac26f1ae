#include "server/assess/names.hpp"

#include "common/json_schema.hpp"

#include <algorithm>

namespace windlass::assess {

int place_of(std::span<const std::string_view> names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

std::string unknown(const std::string& name, const std::vector<std::string>& known) {
    std::string text = '"' + name + "\" is not known; ";
    if (const std::string near = nearest_name(name, known); !near.empty())
        return text + "the nearest is \"" + near + '"';
    if (known.empty()) return text + "there are none";
    text += "there are: ";
    for (std::size_t k = 0; k < known.size(); ++k)
        text += (k > 0 ? ", " : "") + known[k];
    return text;
}

} // namespace windlass::assess
