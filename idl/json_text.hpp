#pragma once
// A payload as JSON text: keys as in the IDL, numbers as short as they can be read back, enumerators by
// name, octets in base64; a number that is none (NaN, infinity) is null.

#include "idl/cdr_walk.hpp"

#include <string>

namespace windlass::idl {

class JsonText final : public CdrVisitor {
public:
    explicit JsonText(std::string& out) : out_(out) {} ///< appends to out

    void begin_structure(const Type&) override;
    void member(const Member& member) override;
    void end_structure() override;
    void begin_sequence(std::size_t) override;
    void end_sequence() override;
    void boolean(bool value) override;
    void integer(std::int64_t value) override;
    void natural(std::uint64_t value) override;
    void real(float value) override;
    void real(double value) override;
    void text(std::string_view value) override;
    void enumerator(std::uint32_t value, const Type& type) override;
    void octets(Bytes value) override;

private:
    void separate();

    std::string& out_;
    bool first_ = true;       // of its structure or sequence
    bool after_name_ = false; // the value belongs to a name
};

/// Appends the payload. Throws PayloadError, out being whatever then.
void append_json(const Type& type, Bytes payload, std::string& out);

/// Text in quotes, as JSON wants it; bytes that are no UTF-8 are replaced.
std::string json_quoted(std::string_view text);

} // namespace windlass::idl
