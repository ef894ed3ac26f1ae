#pragma once
// What a browser would not send.

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <string>

namespace windlass::test {

/// A TCP connection by hand, from that address of this computer. receive_buffer: bytes; 0: as usual.
class Plain {
public:
    explicit Plain(unsigned short port, const std::string& from = "127.0.0.1", int receive_buffer = 0)
        : socket_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
        if (receive_buffer > 0)
            setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof receive_buffer);
        const auto here = end(from, 0), there = end("127.0.0.1", port);
        connected = bind(socket_, reinterpret_cast<const sockaddr*>(&here), sizeof here) == 0 &&
                    connect(socket_, reinterpret_cast<const sockaddr*>(&there), sizeof there) == 0;
    }
    ~Plain() { close(socket_); }
    Plain(const Plain&) = delete;
    Plain& operator=(const Plain&) = delete;

    void say(const std::string& text) const { (void)!send(socket_, text.data(), text.size(), MSG_NOSIGNAL); }
    /// All that comes until the other side ends it.
    std::string answer() const {
        std::string all;
        char part[4096];
        for (ssize_t n = 0; (n = recv(socket_, part, sizeof part, 0)) > 0;)
            all.append(part, static_cast<std::size_t>(n));
        return all;
    }
    int descriptor() const { return socket_; }
    bool connected = false;

private:
    static sockaddr_in end(const std::string& address, unsigned short port) {
        sockaddr_in made{};
        made.sin_family = AF_INET;
        made.sin_port = htons(port);
        inet_pton(AF_INET, address.c_str(), &made.sin_addr);
        return made;
    }
    int socket_;
};

} // namespace windlass::test
