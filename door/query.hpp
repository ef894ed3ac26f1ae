#pragma once
// What a request's address says beside the path.

#include <string>

namespace windlass::door {

/// Of a target's query, "?a=1&b=2"; empty: there is none of that name. Nothing that we are asked with needs
/// an escape.
inline std::string value_in(const std::string& target, const std::string& name) {
    for (std::size_t at = target.find('?'); at != std::string::npos; at = target.find('&', at + 1))
        if (target.compare(at + 1, name.size() + 1, name + '=') == 0) {
            const auto begin = at + name.size() + 2;
            return target.substr(begin, target.find('&', begin) - begin);
        }
    return {};
}

} // namespace windlass::door
