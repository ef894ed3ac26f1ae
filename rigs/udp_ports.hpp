#pragma once
// Where a process hears UDP.

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

namespace windlass::rigs {

/// The ports at which that process hears UDP over IPv4 now, in its own network namespace.
inline std::set<int> udp_ports_of(pid_t pid) {
    const std::filesystem::path process = std::filesystem::path("/proc") / std::to_string(pid);
    std::set<std::string> sockets;
    std::error_code gone;
    for (const auto& file : std::filesystem::directory_iterator(process / "fd", gone)) {
        const std::string name = std::filesystem::read_symlink(file.path(), gone).string();
        if (name.starts_with("socket:[")) sockets.insert(name.substr(8, name.size() - 9));
    }
    std::set<int> ports;
    std::ifstream table(process / "net/udp");
    std::string line;
    std::getline(table, line); // names of the columns
    while (std::getline(table, line)) {
        std::istringstream fields(line);
        std::string number, local, word, inode;
        fields >> number >> local;
        for (int column = 3; column <= 10; ++column)
            fields >> (column == 10 ? inode : word);
        if (sockets.contains(inode)) ports.insert(std::stoi(local.substr(local.find(':') + 1), nullptr, 16));
    }
    return ports;
}

} // namespace windlass::rigs
