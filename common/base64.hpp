#pragma once
// Octets as text (RFC 4648, section 4).

#include <cstdint>
#include <span>
#include <string>

namespace windlass {

std::string base64(std::span<const std::uint8_t> bytes);

} // namespace windlass
