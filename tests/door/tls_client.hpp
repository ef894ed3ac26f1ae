#pragma once
// One HTTPS connection of somebody who trusts one authority. By OpenSSL.

#include "tests/door/door_rig.hpp"

#include <openssl/ssl.h>

namespace windlass::test {

class TlsClient {
public:
    /// Throws std::runtime_error when the server is not whom it was expected to be.
    TlsClient(unsigned short port, const std::string& authority, const std::string& name) : tcp_(port) {
        context_ = SSL_CTX_new(TLS_client_method());
        SSL_CTX_load_verify_locations(context_, authority.c_str(), nullptr);
        SSL_CTX_set_verify(context_, SSL_VERIFY_PEER, nullptr);
        ssl_ = SSL_new(context_);
        SSL_set_tlsext_host_name(ssl_, name.c_str());
        SSL_set1_host(ssl_, name.c_str());
        SSL_set_fd(ssl_, tcp_.descriptor());
        if (SSL_connect(ssl_) == 1) return;
        const long why = SSL_get_verify_result(ssl_);
        free();
        throw std::runtime_error(std::string("no handshake: ") + X509_verify_cert_error_string(why));
    }
    ~TlsClient() { free(); }
    TlsClient(const TlsClient&) = delete;
    TlsClient& operator=(const TlsClient&) = delete;

    Answer get(const std::string& target) const {
        const std::string request =
            "GET " + target + " HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n";
        SSL_write(ssl_, request.data(), static_cast<int>(request.size()));
        std::string all;
        char part[4096];
        for (int n = 0; (n = SSL_read(ssl_, part, sizeof part)) > 0;)
            all.append(part, static_cast<std::size_t>(n));
        return answer_of(all);
    }

private:
    void free() {
        SSL_free(ssl_);
        SSL_CTX_free(context_);
        ssl_ = nullptr;
        context_ = nullptr;
    }

    Plain tcp_;
    SSL_CTX* context_ = nullptr;
    SSL* ssl_ = nullptr;
};

} // namespace windlass::test
