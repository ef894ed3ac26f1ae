#include "idl/idl_schema.hpp"

#include "idl/cdr.hpp"
#include "idl/idl_tokens.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace windlass::idl {

namespace {

const std::map<std::string, Kind>& basic_kinds() {
    static const std::map<std::string, Kind> kinds{
        {"boolean", Kind::boolean}, {"octet", Kind::octet},
        {"char", Kind::octet},      {"uint8", Kind::octet},
        {"int8", Kind::int8},       {"short", Kind::int16},
        {"int16", Kind::int16},     {"unsigned short", Kind::uint16},
        {"uint16", Kind::uint16},   {"long", Kind::int32},
        {"int32", Kind::int32},     {"unsigned long", Kind::uint32},
        {"uint32", Kind::uint32},   {"long long", Kind::int64},
        {"int64", Kind::int64},     {"unsigned long long", Kind::uint64},
        {"uint64", Kind::uint64},   {"float", Kind::float32},
        {"double", Kind::float64},  {"string", Kind::text},
    };
    return kinds;
}

/// Works out what of a type can be known without a payload.
void measure(Type& type) {
    const bool is_structure = type.kind == Kind::structure;
    if (!is_structure && type.kind != Kind::text) {
        type.numbers = 1;
        type.number_size =
            type.kind == Kind::enumeration
                ? sizeof(std::uint32_t)
                : with_number_of(type.kind, [](auto zero) { return std::uint8_t{sizeof zero}; });
    }
    for (const Member& member : type.members)
        type.has_sequence = type.has_sequence || member.sequence || member.type->has_sequence;
    const bool alike = !type.members.empty() && std::ranges::all_of(type.members, [&](const Member& member) {
        return !member.sequence && member.type->numbers > 0 &&
               member.type->number_size == type.members[0].type->number_size;
    });
    if (!alike) return;
    type.number_size = type.members[0].type->number_size;
    for (const Member& member : type.members)
        type.numbers += member.type->numbers;
}

} // namespace

class IdlParser {
public:
    IdlParser(std::string_view text, IdlSchema& schema) : tokens_(idl_tokens(text)), schema_(schema) {
        for (const auto& [name, kind] : basic_kinds())
            add(name, kind);
        definitions("");
    }

private:
    const std::string& word() const { return tokens_[at_].text; }
    std::string take() {
        if (word().empty()) fail("the text ends too early");
        return tokens_[at_++].text;
    }
    void take(const char* expected) {
        if (word() != expected) fail(std::string("\"") + expected + "\" is expected, not \"" + word() + "\"");
        ++at_;
    }
    [[noreturn]] void fail(const std::string& why) const {
        throw IdlError("IDL line " + std::to_string(tokens_[at_].line) + ": " + why);
    }

    Type& add(const std::string& name, Kind kind) {
        auto& type = schema_.types_[name];
        type = std::make_unique<Type>();
        type->kind = kind;
        type->name = name;
        measure(*type);
        return *type;
    }

    /// Up to the closing bracket of the module, or the end. The scope ends with "::", or is empty.
    void definitions(const std::string& scope) {
        while (!word().empty() && word() != "}") {
            const std::string what = take();
            if (what == "module") {
                const std::string name = take();
                take("{");
                definitions(scope + name + "::");
                take("}");
            } else if (what == "const") {
                constant();
            } else if (what == "enum") {
                enumeration(scope);
            } else if (what == "struct") {
                structure(scope);
            } else {
                --at_;
                fail("\"" + what + "\" is not known here");
            }
            take(";");
        }
    }

    void constant() {
        std::string name;
        while (word() != "=")
            name = take();
        take("=");
        if (!word().empty() && std::isdigit(static_cast<unsigned char>(word()[0])) != 0)
            constants_[name] = std::stoull(word());
        while (word() != ";")
            take();
    }

    void enumeration(const std::string& scope) {
        Type& type = add(scope + take(), Kind::enumeration);
        take("{");
        while (word() != "}") {
            type.enumerators.push_back(take());
            if (word() == ",") take();
        }
        take("}");
    }

    void structure(const std::string& scope) {
        const std::string name = scope + take();
        Type made{.kind = Kind::structure, .name = name};
        take("{");
        made.unit = unit_of(tokens_[at_ - 1].comment);
        while (word() != "}")
            made.members.push_back(member(scope));
        take("}");
        measure(made);
        add(name, Kind::structure) = std::move(made);
    }

    Member member(const std::string& scope) {
        Member member;
        member.key = tokens_[at_].key;
        if (word() == "sequence") {
            take();
            take("<");
            member.sequence = true;
            member.type = &type(scope, member.text_bound);
            if (word() == ",") {
                take();
                member.bound = number();
            }
            take(">");
        } else {
            member.type = &type(scope, member.text_bound);
        }
        member.name = take();
        if (word() == "[") fail("arrays are not known here");
        take(";");
        member.unit = unit_of(tokens_[at_ - 1].comment);
        return member;
    }

    const Type& type(const std::string& scope, std::uint64_t& text_bound) {
        std::string name = take();
        while ((name == "unsigned" || name == "long" || name == "unsigned long") &&
               (word() == "long" || word() == "short"))
            name += " " + take();
        while (word() == "::") {
            name += take();
            name += take();
        }
        if (name == "string" && word() == "<") {
            take();
            text_bound = number();
            take(">");
        }
        for (std::string around = scope;; around = outer(around)) { // from the innermost module outwards
            if (const auto found = schema_.types_.find(around + name); found != schema_.types_.end())
                return *found->second;
            if (around.empty()) break;
        }
        --at_;
        fail("type \"" + name + "\" is not known here");
    }

    /// "a::b::" -> "a::" -> "".
    static std::string outer(const std::string& scope) {
        const auto end = scope.rfind("::", scope.size() - 3);
        return end == std::string::npos ? std::string() : scope.substr(0, end + 2);
    }

    std::uint64_t number() {
        const std::string text = take();
        if (const auto known = constants_.find(text); known != constants_.end()) return known->second;
        if (text.size() > 18 || text.find_first_not_of("0123456789") != std::string::npos) {
            --at_;
            fail("a number is expected, not \"" + text + "\"");
        }
        return std::stoull(text);
    }

    std::vector<IdlToken> tokens_;
    std::size_t at_ = 0;
    IdlSchema& schema_;
    std::map<std::string, std::uint64_t> constants_;
};

IdlSchema::IdlSchema(std::string_view text) {
    IdlParser(text, *this);
}

const Type* IdlSchema::find(const std::string& name) const {
    const auto found = types_.find(name);
    return found != types_.end() && found->second->kind == Kind::structure ? found->second.get() : nullptr;
}

std::string unit_of(std::string_view comment) {
    // The longer one of two that begin alike stands first.
    static constexpr std::array<std::string_view, 22> units{
        "shackles", "deg", "0..100", "-1..1", "rad/s", "rad/m", "kg", "hours", "0..1", "N m", "m/s",
        "rad",      "ns",  "Pa",     "Hz",    "m",     "s",     "N",  "W",     "J",    "K",   "A"};
    for (const auto unit : units) {
        if (!comment.starts_with(unit)) continue;
        const std::string_view behind = comment.substr(unit.size());
        if (behind.empty() || std::string_view(" ,;.:").find(behind[0]) != std::string_view::npos)
            return std::string(unit);
    }
    return {};
}

} // namespace windlass::idl
