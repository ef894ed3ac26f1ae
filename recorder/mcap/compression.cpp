#include "recorder/mcap/compression.hpp"

#include <lz4frame.h>
#include <zstd.h>

#include <memory>

namespace windlass::mcap {

namespace {

// Level 1: a chunk of 1 MiB takes a few milliseconds; higher levels gain some per cent for several times
// that.
constexpr int kZstdLevel = 1;

void decompress_zstd(Bytes compressed, Buffer& out) {
    const std::size_t made = ZSTD_decompress(out.data(), out.size(), compressed.data(), compressed.size());
    if (ZSTD_isError(made)) throw Damage(std::string("zstd: ") + ZSTD_getErrorName(made));
    if (made != out.size()) throw Damage("zstd: a chunk has not the size that it says");
}

void decompress_lz4(Bytes compressed, Buffer& out) {
    LZ4F_dctx* made = nullptr;
    if (LZ4F_isError(LZ4F_createDecompressionContext(&made, LZ4F_VERSION))) throw std::bad_alloc();
    const std::unique_ptr<LZ4F_dctx, decltype(&LZ4F_freeDecompressionContext)> context(
        made, LZ4F_freeDecompressionContext);
    std::size_t read = 0;
    std::size_t written = 0;
    std::size_t expected = 1; // 0: the frame is at its end
    while (expected != 0 && read < compressed.size()) {
        std::size_t to_read = compressed.size() - read;
        std::size_t to_write = out.size() - written;
        expected = LZ4F_decompress(context.get(), out.data() + written, &to_write, compressed.data() + read,
                                   &to_read, nullptr);
        if (LZ4F_isError(expected)) throw Damage(std::string("lz4: ") + LZ4F_getErrorName(expected));
        if (to_read == 0 && to_write == 0) break; // it wants to write more than there should be
        read += to_read;
        written += to_write;
    }
    if (expected != 0 || written != out.size()) throw Damage("lz4: a chunk has not the size that it says");
}

} // namespace

std::string_view compression_name(Compression compression) {
    switch (compression) {
    case Compression::lz4:
        return "lz4";
    case Compression::zstd:
        return "zstd";
    case Compression::none:
        break;
    }
    return "";
}

void compress(Compression compression, Bytes bytes, Buffer& out) {
    std::size_t made = 0;
    switch (compression) {
    case Compression::none:
        out.assign(bytes.begin(), bytes.end());
        return;
    case Compression::zstd:
        out.resize(ZSTD_compressBound(bytes.size()));
        made = ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), kZstdLevel);
        if (ZSTD_isError(made)) throw std::runtime_error(std::string("zstd: ") + ZSTD_getErrorName(made));
        break;
    case Compression::lz4:
        out.resize(LZ4F_compressFrameBound(bytes.size(), nullptr));
        made = LZ4F_compressFrame(out.data(), out.size(), bytes.data(), bytes.size(), nullptr);
        if (LZ4F_isError(made)) throw std::runtime_error(std::string("lz4: ") + LZ4F_getErrorName(made));
        break;
    }
    out.resize(made);
}

void decompress(std::string_view name, Bytes compressed, std::uint64_t size, Buffer& out) {
    out.resize(size);
    if (name.empty()) {
        if (compressed.size() != size) throw Damage("a chunk has not the size that it says");
        out.assign(compressed.begin(), compressed.end());
    } else if (name == "zstd") {
        decompress_zstd(compressed, out);
    } else if (name == "lz4") {
        decompress_lz4(compressed, out);
    } else {
        throw Damage("compression \"" + std::string(name) + "\" is not known here: zstd and lz4 are");
    }
}

} // namespace windlass::mcap
