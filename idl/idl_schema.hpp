#pragma once
// The types of an IDL text, as far as they are needed to go through payloads without compiled types: to look
// at what they claim before they are opened, and to open recorded ones, which carry the IDL that they were
// made with.

#include <cstdint>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace windlass::idl {

/// The IDL text is not understood; what() says the line and why.
struct IdlError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

enum class Kind {
    boolean,
    octet,
    int8,
    int16,
    int32,
    int64,
    uint16,
    uint32,
    uint64,
    float32,
    float64,
    text,
    enumeration,
    structure
};

struct Type;

struct Member {
    std::string name;
    std::string unit; ///< that its comment begins with ("m/s", "0..1"); empty: none
    const Type* type = nullptr;
    bool sequence = false;
    std::uint64_t bound = 0;      ///< of the sequence; 0: none
    std::uint64_t text_bound = 0; ///< of the text, or of each in the sequence, in bytes; 0: none
    bool key = false;             ///< tells instances of the topic apart
};

struct Type {
    Kind kind{};
    std::string name;                       ///< with its modules
    std::string unit{};                     ///< of a structure: of all its members
    std::vector<std::string> enumerators{}; ///< of an enumeration, counted from 0
    std::vector<Member> members{};          ///< of a structure

    bool has_sequence = false;    ///< anywhere in it
    std::uint32_t numbers = 0;    ///< that it is made of, all of one size; 0: of something else
    std::uint8_t number_size = 0; ///< bytes of each
};

/// Modules, constants, enums, structs of basic types, strings, sequences and structs: what windlass.idl
/// uses.
class IdlSchema {
public:
    /// Throws IdlError.
    explicit IdlSchema(std::string_view text);

    /// The structure of that name ("windlass::v12::Event"), or nothing.
    const Type* find(const std::string& name) const;

private:
    friend class IdlParser;
    std::map<std::string, std::unique_ptr<Type>> types_;
};

/// The unit that a comment in the IDL begins with: "m/s over ground" -> "m/s"; empty when it begins with
/// none.
std::string unit_of(std::string_view comment);

} // namespace windlass::idl
