#pragma once
// The compressions that MCAP knows for chunks: zstd, LZ4 frames, and none.

#include "recorder/mcap/bytes.hpp"

namespace windlass::mcap {

enum class Compression { none, lz4, zstd };

/// As it stands in the file: "", "lz4", "zstd".
std::string_view compression_name(Compression compression);

/// Puts the compressed bytes into out, replacing what was there. Throws std::runtime_error.
void compress(Compression compression, Bytes bytes, Buffer& out);

/// Puts exactly `size` bytes into out. Throws Damage when that is not what they are, or when the name is
/// none of the three.
void decompress(std::string_view name, Bytes compressed, std::uint64_t size, Buffer& out);

} // namespace windlass::mcap
