#pragma once
// What nobody shall guess: passwords, cookies, codes. By libsodium.

#include <string>

namespace windlass::door {

/// Before anything else here. Throws std::runtime_error.
void begin_secrets();

/// Argon2id of a password, as libsodium writes it: a tenth of a second and 64 MB. Throws std::runtime_error
/// when there is not so much memory.
std::string password_hash(const std::string& password);

/// As long as password_hash(), whether it is right or not; hash empty: it is not, after the same time.
bool is_password(const std::string& hash, const std::string& password);

/// 256 random bits in hexadecimal digits, for a cookie.
std::string make_secret();

/// 128 of them, for an address that somebody has to bring to a device.
std::string make_key();

/// By which a cookie is found and kept: nobody gets the cookie out of it. BLAKE2b, hexadecimal.
std::string digest(const std::string& secret);

/// Six letters that are not taken for one another; 24^6 of them.
std::string make_code();

/// A code as somebody types it: capitals, without blanks and dashes.
std::string plain_code(const std::string& typed);

} // namespace windlass::door
