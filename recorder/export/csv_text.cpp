#include "recorder/export/csv_text.hpp"

#include "recorder/recording/typed.hpp"

#include "idl/json_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace windlass::recorder {

using idl::Kind;
using idl::Member;
using idl::Type;

namespace {

std::string heading(const std::string& name, const std::string& unit) {
    return unit.empty() ? name : name + " (" + unit + ")";
}

/// Unit of a member: its own, or that of what it is made of.
const std::string& unit_of(const Member& member) {
    return member.unit.empty() ? member.type->unit : member.unit;
}

void columns(const Type& type, const std::string& prefix, const std::string& unit,
             std::vector<std::string>& out) {
    for (const auto& member : type.members) {
        // What a part is in ("m, world") stands at the whole; the part's own comment speaks for all its uses.
        const std::string& own = unit.empty() ? unit_of(member) : unit;
        if (member.sequence)
            out.push_back(heading(prefix + member.name, unit_of(member)));
        else if (member.type->kind == Kind::structure)
            columns(*member.type, prefix + member.name + ".", own, out);
        else
            out.push_back(heading(prefix + member.name, own));
    }
}

bool only_numbers(const Type& type) {
    if (type.kind == Kind::structure)
        return std::ranges::all_of(type.members,
                                   [](const Member& m) { return !m.sequence && only_numbers(*m.type); });
    return type.kind != Kind::text && type.kind != Kind::enumeration;
}

class CsvText final : public idl::CdrVisitor {
public:
    explicit CsvText(std::string& out) : out_(out) {}

    void begin_structure(const Type& type) override {
        if (json_) return json_->begin_structure(type);
        if (in_sequence_ && cell_.size() > 0) cell_ += ';';
        fresh_ = true;
    }
    void member(const Member& member) override {
        if (json_) return json_->member(member);
        if (!in_sequence_) member_ = &member;
    }
    void end_structure() override {
        if (json_) json_->end_structure();
    }
    void begin_sequence(std::size_t size) override {
        if (json_) { // one inside the other
            ++inner_;
            return json_->begin_sequence(size);
        }
        cell_.clear();
        in_sequence_ = fresh_ = true;
        if (!only_numbers(*member_->type)) json_.emplace(cell_).begin_sequence(size);
    }
    void end_sequence() override {
        if (json_) json_->end_sequence();
        if (inner_ > 0) {
            --inner_;
            return;
        }
        json_.reset();
        in_sequence_ = false;
        out_ += ',' + csv_cell(cell_);
    }
    void boolean(bool value) override { json_ ? json_->boolean(value) : put(value ? "1" : "0"); }
    void integer(std::int64_t value) override {
        json_ ? json_->integer(value) : put(fmt::format("{}", value));
    }
    void natural(std::uint64_t value) override {
        json_ ? json_->natural(value) : put(fmt::format("{}", value));
    }
    void real(float value) override { json_ ? json_->real(value) : put(fmt::format("{}", value)); }
    void real(double value) override { json_ ? json_->real(value) : put(fmt::format("{}", value)); }
    void text(std::string_view value) override { json_ ? json_->text(value) : put(value); }
    void enumerator(std::uint32_t value, const Type& type) override {
        if (json_) return json_->enumerator(value, type);
        put(value < type.enumerators.size() ? type.enumerators[value] : fmt::format("{}", value));
    }
    void octets(idl::Bytes value) override {
        json_ ? json_->octets(value) : put(fmt::format("{} bytes", value.size()));
    }

private:
    void put(std::string_view text) {
        if (!in_sequence_) {
            out_ += ',' + csv_cell(text);
            return;
        }
        if (!fresh_) cell_ += ' ';
        fresh_ = false;
        cell_ += text;
    }

    std::string& out_;
    std::string cell_;
    const Member* member_ = nullptr;
    bool in_sequence_ = false;
    bool fresh_ = true; // nothing of this element yet
    int inner_ = 0;
    std::optional<idl::JsonText> json_;
};

} // namespace

std::string csv_cell(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string cell = "\"";
    for (const char c : text) {
        if (c == '"') cell += '"';
        cell += c;
    }
    return cell + '"';
}

std::vector<std::string> csv_columns(const Type& type) {
    std::vector<std::string> out;
    columns(type, "", "", out);
    return out;
}

void append_csv(const Type& type, idl::Bytes payload, std::string& out) {
    CsvText visitor(out);
    recording::walk(type, payload, visitor);
}

} // namespace windlass::recorder
