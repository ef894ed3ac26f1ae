#pragma once
// What another process has cost.

#include "rigs/udp_ports.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace windlass::bench {

/// Processor time of a process so far, s.
inline double cpu_of(pid_t pid) {
    std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
    std::string text{std::istreambuf_iterator<char>(file), {}};
    std::istringstream fields(text.substr(text.rfind(')') + 2));
    std::string word;
    for (int i = 3; i < 14; ++i) // up to utime, the 14th
        fields >> word;
    double user = 0, system = 0;
    fields >> user >> system;
    return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

/// MB behind a word of a file of /proc.
inline double megabytes(pid_t pid, const std::string& name, const std::string& behind) {
    std::ifstream file("/proc/" + std::to_string(pid) + '/' + name);
    double kilobytes = 0;
    for (std::string word; file >> word && word != behind;) {
    }
    file >> kilobytes;
    return kilobytes / 1024;
}

/// Memory of a process that is its own and there, in no file, MB.
inline double memory_of(pid_t pid) {
    return megabytes(pid, "status", "RssAnon:");
}

/// Its share of what it has in memory: what several processes have together counts once, MB.
inline double share_of_memory(pid_t pid) {
    return megabytes(pid, "smaps_rollup", "Pss:");
}

/// A process and those that it has started, by whichever of its threads, all the way down.
inline std::vector<pid_t> family_of(pid_t pid) {
    std::vector<pid_t> all{pid};
    for (std::size_t k = 0; k < all.size(); ++k) {
        std::error_code gone;
        for (const auto& task :
             std::filesystem::directory_iterator("/proc/" + std::to_string(all[k]) + "/task", gone)) {
            std::ifstream children(task.path() / "children");
            for (pid_t child = 0; children >> child;)
                all.push_back(child);
        }
    }
    return all;
}

/// DDS participants of a process in that domain: each has a port of its own for discovery
/// (DDSI-RTPS 9.6.1.1).
inline int participants_of(pid_t pid, int domain) {
    int count = 0;
    for (const int port : rigs::udp_ports_of(pid)) {
        const int behind = port - (7400 + 250 * domain + 10);
        count += behind >= 0 && behind < 240 && behind % 2 == 0 ? 1 : 0;
    }
    return count;
}

/// Processor time so far of the threads of a process that have one name, s, by name. Threads that have ended
/// are not among them.
inline std::map<std::string, double> cpu_by_thread(pid_t pid) {
    std::map<std::string, double> sum;
    std::error_code gone; // a thread may end while it is looked at
    for (const auto& task :
         std::filesystem::directory_iterator("/proc/" + std::to_string(pid) + "/task", gone)) {
        std::ifstream name_file(task.path() / "comm"), time_file(task.path() / "schedstat");
        std::string name;
        double on_cpu = 0; // ns
        if (std::getline(name_file, name) && time_file >> on_cpu) sum[name] += 1e-9 * on_cpu;
    }
    return sum;
}

} // namespace windlass::bench
