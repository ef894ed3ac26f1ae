#include "recorder/recording/sha256.hpp"

#include <openssl/evp.h>

#include <array>
#include <fstream>
#include <memory>
#include <stdexcept>

namespace windlass::recording {

namespace {

/// OpenSSL's digest, fed piece by piece.
class Digest {
public:
    Digest() {
        if (!context_ || EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) != 1) fail();
    }
    void add(std::string_view bytes) {
        if (EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()) != 1) fail();
    }
    std::string hexadecimal() {
        std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
        unsigned size = 0;
        if (EVP_DigestFinal_ex(context_.get(), digest.data(), &size) != 1) fail();
        constexpr std::string_view digits = "0123456789abcdef";
        std::string text;
        for (unsigned i = 0; i < size; ++i) {
            text += digits[digest[i] >> 4];
            text += digits[digest[i] & 15];
        }
        return text;
    }

private:
    [[noreturn]] static void fail() { throw std::runtime_error("OpenSSL has no SHA-256"); }

    std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_{EVP_MD_CTX_new(), EVP_MD_CTX_free};
};

} // namespace

std::string sha256(std::string_view text) {
    Digest digest;
    digest.add(text);
    return digest.hexadecimal();
}

std::string sha256(const std::vector<std::filesystem::path>& files) {
    Digest digest;
    std::vector<char> piece(1 << 20);
    for (const auto& file : files) {
        std::ifstream in(file, std::ios::binary);
        while (in.read(piece.data(), static_cast<std::streamsize>(piece.size())) || in.gcount() > 0)
            digest.add({piece.data(), static_cast<std::size_t>(in.gcount())});
        if (!in.eof()) throw std::runtime_error(file.string() + ": cannot be read");
    }
    return digest.hexadecimal();
}

} // namespace windlass::recording
