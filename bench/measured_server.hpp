#pragma once
// How the server runs that is measured, as the command line has it.

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace windlass::bench {

struct MeasuredServer {
    int domain = 98;
    int threads = 1; ///< of each process, that tick exercises
    int workers = 0; ///< processes that share the exercises; 0: one, and no supervisor
    bool realtime = false;

    void add_options(CLI::App& app) {
        app.add_option("--threads", threads, "of each process, that tick exercises")
            ->check(CLI::Range(1, 64))
            ->capture_default_str();
        app.add_option("--workers", workers, "processes that share the exercises, with a supervisor; 0: one")
            ->check(CLI::Range(0, 32))
            ->capture_default_str();
        app.add_flag("--realtime", realtime, "the server under SCHED_FIFO, which needs the right to");
        app.add_option("--domain", domain, "DDS domain, to itself")
            ->check(CLI::Range(0, 232))
            ->capture_default_str();
    }

    std::vector<std::string> arguments() const {
        std::vector<std::string> arguments{"--config-root", WINDLASS_CONFIG_DIR,
                                           "--domain",      std::to_string(domain),
                                           "--threads",     std::to_string(threads)};
        if (realtime) arguments.emplace_back("--realtime");
        if (workers > 0) arguments.insert(arguments.end(), {"--workers", std::to_string(workers)});
        return arguments;
    }
};

} // namespace windlass::bench
