#pragma once
// What a JSON file may say, taken from its JSON Schema alone, and faults put in words a seaman can act on.

#include "common/json_file.hpp"

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace windlass {

/// One JSON Schema (draft-07) that files are held against. valijson judges; the text of an error is made from
/// the schema at that place: type, range or choice, and its description ("unit, meaning").
class JsonSchema {
public:
    /// Gives the text of another schema that is referred to by file name.
    using Lookup = std::function<std::string_view(const std::string& name)>;

    /// Throws std::invalid_argument when the text is no schema. A `$ref` to a file is replaced by that
    /// schema, found by lookup; rows of words.json by the list of their names.
    /// An object's `renamed` says what a field is called now that files of before may still have: {"load":
    /// "tension"}.
    explicit JsonSchema(std::string_view text, const Lookup& lookup = {});
    ~JsonSchema();
    JsonSchema(const JsonSchema&) = delete;
    JsonSchema& operator=(const JsonSchema&) = delete;

    /// Throws ConfigError with one line for every fault in the document; source names the file.
    void check(const nlohmann::json& document, const std::string& source) const;

    /// The schema itself, references to files resolved.
    const nlohmann::json& json() const;

private:
    struct Compiled;
    std::unique_ptr<Compiled> compiled_;
};

/// `an integer from 60 to 1200 (Hz, steps per second)`: what the schema of one value allows.
std::string describe_allowed(const nlohmann::json& value_schema);

/// The name among known that differs least from the given one, or "" when none is near.
std::string nearest_name(const std::string& name, const std::vector<std::string>& known);

} // namespace windlass
