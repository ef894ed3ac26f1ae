#include "common/base64.hpp"

#include <openssl/evp.h>

namespace windlass {

std::string base64(std::span<const std::uint8_t> bytes) {
    std::string text((bytes.size() + 2) / 3 * 4, '\0'); // and the zero behind it, which OpenSSL writes, too
    EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()), bytes.data(),
                    static_cast<int>(bytes.size()));
    return text;
}

} // namespace windlass
