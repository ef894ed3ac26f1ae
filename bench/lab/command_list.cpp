#include "bench/lab/commands.hpp"
#include "bench/problem/method.hpp"

#include <fmt/format.h>

namespace windlass::lab {

void add_list(CLI::App& app) {
    app.add_subcommand("list", "names the methods and what each leaves out")->callback([] {
        for (const MethodEntry& method : methods())
            fmt::print("{:<14} {}\n{:<14} leaves out: {}\n", method.name, method.title, "",
                       method.leaves_out.empty() ? "nothing" : method.leaves_out);
    });
}

} // namespace windlass::lab
