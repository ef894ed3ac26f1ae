// chain_lab: computes single lines by every method there is, and tells how wrong and how fast each is.

#include "bench/lab/commands.hpp"
#include "common/json_file.hpp"

#include <fmt/format.h>

int main(int argc, char** argv) {
    using namespace windlass;
    int exit_code = lab::kDone;
    CLI::App app("chain_lab: computes single lines by many methods, and compares these", "chain_lab");
    app.set_version_flag("--version", std::string("chain_lab ") + WINDLASS_VERSION);
    app.require_subcommand(1);
    app.footer(R"(
Exit codes:
  0  done
  1  the method blew up; the result ends there
  2  bad option
  3  a case, suite, table or result file cannot be read, is not allowed or cannot be written
  4  the method cannot do the case)");
    lab::add_run(app, exit_code);
    lab::add_list(app);
    lab::add_compare(app);
    lab::add_converge(app);
    lab::add_shapes(app);
    lab::add_stability(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? lab::kDone : lab::kBadOption;
    } catch (const std::invalid_argument& error) {
        fmt::print(stderr, "chain_lab: {}\n", error.what());
        return lab::kCannotDo;
    } catch (const std::runtime_error& error) { // what a file lacks, line by line
        fmt::print(stderr, "{}\n", error.what());
        return lab::kBadFile;
    }
    return exit_code;
}
