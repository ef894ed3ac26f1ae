#include "common/json_schema.hpp"

#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include <algorithm>
#include <map>
#include <numeric>
#include <vector>

namespace windlass {
namespace {

using Json = nlohmann::json;
using Pointer = Json::json_pointer;

/// The choices of a list of rows, each with its "const", as one enum: of that an error tells what is allowed.
void gather_choices(Json& node) {
    if (!node.contains("oneOf")) return;
    Json choices = Json::array();
    for (const Json& row : node.at("oneOf")) {
        if (!row.contains("const")) return;
        choices.push_back(row.at("const"));
    }
    node = {{"enum", std::move(choices)}};
}

/// Replaces every {"$ref": "folder/other.schema.json#/place"} by the schema at that place of that file; what
/// stands beside the reference (its meaning, its default) goes before what that says.
void resolve_files(Json& node, const JsonSchema::Lookup& lookup) {
    if (node.is_object() && node.contains("$ref") && node["$ref"].get<std::string>().front() != '#') {
        const auto reference = node["$ref"].get<std::string>();
        const std::string path = reference.substr(0, reference.find('#'));
        Json other = Json::parse(lookup(path.substr(path.rfind('/') + 1)));
        if (path.size() < reference.size())
            other = Json(other.at(Pointer(reference.substr(path.size() + 1))));
        other.erase("$schema");
        gather_choices(other);
        node.erase("$ref");
        other.update(node);
        node = std::move(other);
    }
    if (node.is_structured())
        for (Json& child : node)
            resolve_files(child, lookup);
}

/// The schema with what it refers to put into it: by `$ref`, or by `allOf` beside fields of its own. Its own
/// fields count before those that it refers to; both descriptions stay.
Json resolved(const Json& root, Json schema) {
    while (schema.contains("$ref"))
        schema = root.at(Pointer(schema.at("$ref").get<std::string>().substr(1)));
    for (const Json& part : schema.value("allOf", Json::array())) {
        const Json base = resolved(root, part);
        for (const auto& [name, value] : base.items())
            if (!schema.contains(name))
                schema[name] = value;
            else if (name == "description")
                schema[name] = schema[name].get<std::string>() + "; " + value.get<std::string>();
    }
    return schema;
}

/// The schema that governs the value at a pointer; null where there is none. One without a description has
/// that of what it is part of: {"above": x} of a length is that length.
Json schema_at(const Json& root, const std::vector<std::string>& path) {
    std::string meaning = root.value("description", "");
    Json schema = resolved(root, root);
    for (const std::string& step : path) {
        Json part;
        if (schema.contains("properties") && schema.at("properties").contains(step))
            part = schema.at("properties").at(step);
        else if (schema.contains("items") && schema.at("items").is_object())
            part = schema.at("items");
        else
            return {};
        schema = resolved(root, part);
        if (!schema.contains("description")) schema["description"] = meaning;
        meaning = part.value("description", schema.at("description").get<std::string>());
    }
    return schema;
}

std::string shortened(const Json& value) {
    const std::string text = value.dump();
    return text.size() <= 60 ? text : text.substr(0, 57) + "...";
}

std::string range(const Json& schema) {
    const auto bound = [&](const char* key) { return schema.contains(key) ? schema.at(key).dump() : ""; };
    const std::string min = bound("minimum"), above = bound("exclusiveMinimum");
    const std::string max = bound("maximum"), below = bound("exclusiveMaximum");
    if (!min.empty() && !max.empty()) return " from " + min + " to " + max;
    std::string text;
    if (!min.empty()) text = " of at least " + min;
    if (!above.empty()) text = " above " + above;
    if (!max.empty() || !below.empty())
        text += (text.empty() ? "" : " and") + (max.empty() ? " below " + below : " of at most " + max);
    return text;
}

std::string list_size(const Json& schema, const char* min, const char* max, const std::string& of) {
    if (!schema.contains(min) && !schema.contains(max)) return "";
    return " of " + std::to_string(schema.value(min, 0)) +
           (schema.contains(max) ? " to " + schema.at(max).dump() : " or more") + of;
}

std::string allowed_type(const std::string& type, const Json& schema) {
    if (type == "number") return "a number" + range(schema);
    if (type == "integer") return "a whole number" + range(schema);
    if (type == "boolean") return "true or false";
    if (type == "string")
        return "text in quotes" + list_size(schema, "minLength", "maxLength", " characters") +
               (schema.contains("pattern") ? " matching " + schema.at("pattern").get<std::string>() : "");
    if (type == "array") return "a list [...]" + list_size(schema, "minItems", "maxItems", " entries");
    if (type == "object")
        return "an object {...}" + list_size(schema, "minProperties", "maxProperties", " fields");
    return type;
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
    if (words.empty()) return "";
    return std::accumulate(words.begin() + 1, words.end(), words.front(),
                           [&](const std::string& a, const std::string& b) { return a + between + b; });
}

std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0U);
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0]++;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] != b[j] ? 1 : 0);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

bool allows_object(const Json& schema) {
    const Json type = schema.value("type", Json("object")); // one type, or a list of them
    return type == "object" ||
           (type.is_array() && std::find(type.begin(), type.end(), "object") != type.end());
}

/// What is wrong with a field that the schema does not know: one of an earlier version is in its keyword
/// "gone", which has reasons, each with the names that it is of.
std::string unknown_field(const std::string& name, const std::vector<std::string>& known,
                          const Json& schema) {
    const Json gone = schema.value("gone", Json::object());
    for (const auto& [reason, names] : gone.items())
        if (std::find(names.begin(), names.end(), name) != names.end())
            return "a field of an earlier version; leave it out: " + reason;
    if (const Json now = schema.value("renamed", Json::object()); now.contains(name))
        return "no such field here; it is called \"" + now.at(name).get<std::string>() + "\" now";
    const std::string near = nearest_name(name, known);
    return "no such field here; " +
           (near.empty() ? "known are: " + joined(known, ", ") : "the nearest known one is \"" + near + "\"");
}

/// Faults of the object itself, not of what it holds: fields that are unknown, missing or too many.
std::vector<std::string> object_faults(const Json& object, const Json& schema) {
    const Json fields = schema.value("properties", Json::object());
    const Json required = schema.value("required", Json::array());
    std::vector<std::string> known, faults;
    for (const auto& [name, unused] : fields.items())
        known.push_back(name);
    if (schema.contains("additionalProperties") && schema.at("additionalProperties") == false)
        for (const auto& [name, unused] : object.items())
            if (std::find(known.begin(), known.end(), name) == known.end())
                faults.push_back("/" + name + ": " + unknown_field(name, known, schema));
    for (const Json& name : required)
        if (const auto text = name.get<std::string>(); !object.contains(text))
            faults.push_back("/" + text +
                             ": is missing: " + describe_allowed(fields.value(text, Json::object())));
    return faults;
}

} // namespace

struct JsonSchema::Compiled {
    Json json;
    valijson::Schema schema;
};

JsonSchema::JsonSchema(std::string_view text, const Lookup& lookup)
    : compiled_(std::make_unique<Compiled>()) {
    try {
        compiled_->json = Json::parse(text);
        resolve_files(compiled_->json, lookup);
        valijson::SchemaParser(valijson::SchemaParser::kDraft7)
            .populateSchema(valijson::adapters::NlohmannJsonAdapter(compiled_->json), compiled_->schema);
    } catch (const std::exception& error) {
        throw std::invalid_argument(std::string("not a JSON Schema: ") + error.what());
    }
}

JsonSchema::~JsonSchema() = default;

const Json& JsonSchema::json() const {
    return compiled_->json;
}

void JsonSchema::check(const Json& document, const std::string& source) const {
    valijson::ValidationResults results;
    if (valijson::Validator().validate(compiled_->schema, valijson::adapters::NlohmannJsonAdapter(document),
                                       &results))
        return;

    // valijson also reports each object and list around a fault. Only those without a fault further in, or
    // with one of their own, are worth a line. An outer path is a prefix of, and so sorts before, inner ones.
    std::map<std::vector<std::string>, std::string> faults;
    for (valijson::ValidationResults::Error error; results.popError(error);) {
        std::vector<std::string> path;
        for (std::size_t i = 1; i < error.context.size(); ++i) // "<root>", "[field]", "[3]"
            path.push_back(error.context[i].substr(1, error.context[i].size() - 2));
        faults.try_emplace(path, error.description);
    }

    std::vector<std::string> lines;
    for (auto fault = faults.begin(); fault != faults.end(); ++fault) {
        const auto& [path, description] = *fault;
        Pointer pointer;
        for (const std::string& step : path)
            pointer /= step;
        const Json& value = document.at(pointer);
        const Json schema = schema_at(json(), path);
        const std::string at = source + ": " + pointer.to_string();

        if (value.is_object() && allows_object(schema)) {
            const std::vector<std::string> own = object_faults(value, schema);
            for (const std::string& text : own)
                lines.push_back(at + text);
            if (!own.empty()) continue;
        }
        const auto next = std::next(fault);
        const bool fault_further_in = next != faults.end() && next->first.size() > path.size() &&
                                      std::equal(path.begin(), path.end(), next->first.begin());
        if (fault_further_in) continue;
        const std::string allowed = schema.is_null() ? "" : describe_allowed(schema);
        lines.push_back(at + (path.empty() ? "/" : "") + ": " + shortened(value) +
                        " is not allowed: " + (allowed.empty() ? description : allowed));
    }
    throw ConfigError(joined(lines, "\n"));
}

std::string describe_allowed(const Json& value_schema) {
    std::vector<std::string> kinds;
    if (value_schema.contains("enum")) {
        for (const Json& choice : value_schema.at("enum"))
            kinds.push_back(choice.dump());
    } else if (value_schema.contains("const")) {
        kinds.push_back(value_schema.at("const").dump());
    } else if (const Json type = value_schema.value("type", Json()); type.is_string()) {
        kinds.push_back(allowed_type(type.get<std::string>(), value_schema));
    } else {
        for (const Json& one : type)
            kinds.push_back(allowed_type(one.get<std::string>(), value_schema));
    }
    const std::string text = (value_schema.contains("enum") ? "one of " : "") +
                             joined(kinds, value_schema.contains("enum") ? ", " : " or ");
    const std::string description = value_schema.value("description", "");
    return text.empty() || description.empty() ? text + description : text + " (" + description + ")";
}

std::string nearest_name(const std::string& name, const std::vector<std::string>& known) {
    std::string nearest;
    std::size_t min = std::max<std::size_t>(2, name.size() / 2) + 1;
    for (const std::string& candidate : known)
        if (const std::size_t distance = edit_distance(name, candidate); distance < min) {
            min = distance;
            nearest = candidate;
        }
    return nearest;
}

} // namespace windlass
