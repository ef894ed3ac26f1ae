#pragma once
// Splits IDL into words; comments behind a member on its line are kept, others are passed over.

#include <string>
#include <string_view>
#include <vector>

namespace windlass::idl {

struct IdlToken {
    std::string text;    ///< a word, a number, "::" or one sign; empty: the end
    std::string comment; ///< "// ..." that follows on the same line, without the slashes
    int line = 0;
    bool key = false; ///< "@key" stands before it
};

/// Ends with an empty token. Other annotations ("@final", with what stands in brackets) are left out.
std::vector<IdlToken> idl_tokens(std::string_view text);

} // namespace windlass::idl
