#pragma once
// Text that crosses the wire: UTF-8, one line, no control characters, within a bound of bytes.

#include <cstddef>
#include <string>
#include <string_view>

namespace windlass {

/// The text with every control character and every byte that is not valid UTF-8 replaced by '?'.
std::string printable(std::string_view text);

/// The first at most `bytes` bytes of a UTF-8 text, ending at a whole character.
std::string_view clipped(std::string_view text, std::size_t bytes);

} // namespace windlass
