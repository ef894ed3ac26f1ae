#include "idl/json_text.hpp"

#include "common/base64.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace windlass::idl {

std::string json_quoted(std::string_view text) {
    return nlohmann::json(std::string(text)).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void append_json(const Type& type, Bytes payload, std::string& out) {
    JsonText visitor(out);
    walk(type, payload, visitor);
}

void JsonText::separate() {
    if (!first_ && !after_name_) out_ += ',';
    first_ = after_name_ = false;
}

void JsonText::begin_structure(const Type&) {
    separate();
    out_ += '{';
    first_ = true;
}
void JsonText::member(const Member& member) {
    separate();
    out_ += '"' + member.name + "\":";
    after_name_ = true;
}
void JsonText::end_structure() {
    out_ += '}';
    first_ = after_name_ = false;
}
void JsonText::begin_sequence(std::size_t) {
    separate();
    out_ += '[';
    first_ = true;
}
void JsonText::end_sequence() {
    out_ += ']';
    first_ = after_name_ = false;
}
void JsonText::boolean(bool value) {
    separate();
    out_ += value ? "true" : "false";
}
void JsonText::integer(std::int64_t value) {
    separate();
    out_ += fmt::format("{}", value);
}
void JsonText::natural(std::uint64_t value) {
    separate();
    out_ += fmt::format("{}", value);
}
void JsonText::real(float value) {
    separate();
    out_ += std::isfinite(value) ? fmt::format("{}", value) : "null";
}
void JsonText::real(double value) {
    separate();
    out_ += std::isfinite(value) ? fmt::format("{}", value) : "null";
}
void JsonText::text(std::string_view value) {
    separate();
    out_ += json_quoted(value);
}
void JsonText::enumerator(std::uint32_t value, const Type& type) {
    separate();
    out_ += value < type.enumerators.size() ? '"' + type.enumerators[value] + '"' : fmt::format("{}", value);
}
void JsonText::octets(Bytes value) {
    separate();
    out_ += '"' + base64(value) + '"';
}

} // namespace windlass::idl
