#pragma once
// What the schema of landmarks cannot say.

#include <string>
#include <vector>

namespace windlass::config {

/// Of landmarks as the JSON text of a file's section, which the schema has passed: names that are
/// longer than the wire allows, given twice or lead nowhere, shores without their ridge, flashes that no
/// light makes. JSON pointer, value and what is allowed.
std::vector<std::string> landmark_faults(const std::string& landmarks);

} // namespace windlass::config
