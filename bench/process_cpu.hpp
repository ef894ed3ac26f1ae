#pragma once
// What another process has cost.

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>

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

/// Memory of a process that is its own and there, in no file, MB.
inline double memory_of(pid_t pid) {
    std::ifstream file("/proc/" + std::to_string(pid) + "/status");
    double kilobytes = 0;
    for (std::string word; file >> word && word != "RssAnon:";) {
    }
    file >> kilobytes;
    return kilobytes / 1024;
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
