#include "door/secrets.hpp"

#include <sodium.h>

#include <array>
#include <cctype>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace windlass::door {

namespace {

constexpr std::string_view kLetters = "ABCDEFGHJKLMNPQRSTUVWXYZ"; // no I, no O
constexpr int kCodeLength = 6;

std::string hexadecimal(const std::array<unsigned char, 32>& octets) {
    std::array<char, 65> text{};
    return sodium_bin2hex(text.data(), text.size(), octets.data(), octets.size());
}

} // namespace

void begin_secrets() {
    if (sodium_init() < 0) throw std::runtime_error("libsodium does not start: no random numbers");
}

std::string password_hash(const std::string& password) {
    std::array<char, crypto_pwhash_STRBYTES> hash{};
    if (crypto_pwhash_str_alg(hash.data(), password.data(), password.size(),
                              crypto_pwhash_OPSLIMIT_INTERACTIVE, crypto_pwhash_MEMLIMIT_INTERACTIVE,
                              crypto_pwhash_ALG_ARGON2ID13) != 0)
        throw std::runtime_error("a password needs 64 MB of memory for a moment, which are not there");
    return hash.data();
}

bool is_password(const std::string& hash, const std::string& password) {
    static const std::string kNobodys = password_hash(make_secret());
    const std::string& against = hash.empty() ? kNobodys : hash;
    return crypto_pwhash_str_verify(against.c_str(), password.data(), password.size()) == 0 && !hash.empty();
}

std::string make_secret() {
    std::array<unsigned char, 32> octets{};
    randombytes_buf(octets.data(), octets.size());
    return hexadecimal(octets);
}

std::string make_key() {
    return make_secret().substr(0, 32);
}

std::string digest(const std::string& secret) {
    std::array<unsigned char, 32> octets{};
    crypto_generichash(octets.data(), octets.size(), reinterpret_cast<const unsigned char*>(secret.data()),
                       secret.size(), nullptr, 0);
    return hexadecimal(octets);
}

std::string make_code() {
    std::string code;
    for (int i = 0; i < kCodeLength; ++i)
        code += kLetters[randombytes_uniform(kLetters.size())];
    return code;
}

std::string plain_code(const std::string& typed) {
    std::string plain;
    for (const char c : typed)
        if (c != ' ' && c != '-') plain += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return plain;
}

} // namespace windlass::door
