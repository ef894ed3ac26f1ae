#pragma once
// What every program here does with its command line.

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <functional>

namespace windlass::bench {

/// Reads the command line, and does the work. The exit code: 0 done, 1 it threw, and says why, 2 bad option.
inline int run_program(CLI::App& app, int argc, char** argv, const std::function<void()>& work) {
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    try {
        work();
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}: {}\n", app.get_name(), error.what());
        return 1;
    }
    return 0;
}

} // namespace windlass::bench
