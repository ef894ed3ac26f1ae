#include "bench/lab/commands.hpp"
#include "bench/lab/progress_bar.hpp"
#include "bench/lab/stability/stability_suite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>

namespace windlass::lab {
namespace {

struct Options {
    std::string suite, out, note;
    StabilitySelection selection;
    bool draw_only = false;
};

template <typename List>
void check_choice(const char* option, const std::vector<std::string>& chosen, const List& list) {
    for (const std::string& name : chosen)
        if (std::none_of(list.begin(), list.end(), [&](const auto& one) { return one.name == name; }))
            throw CLI::ValidationError(option, name + " is not in the suite");
}

/// How many cells of each map came to what, method by method.
void tell(const StabilitySuite& suite, const std::vector<StabilityRow>& rows) {
    for (const StabilityMap& map : suite.maps) {
        if (std::none_of(rows.begin(), rows.end(),
                         [&](const StabilityRow& row) { return row.map == map.name; }))
            continue;
        fmt::print("{}: cells\n{:<20}", map.title, "");
        for (const char* name : kFateNames)
            fmt::print(" {:>12}", name);
        for (const StabilityMethod& method : suite.methods) {
            if (std::none_of(rows.begin(), rows.end(), [&](const StabilityRow& row) {
                    return row.map == map.name && row.method == method.name;
                }))
                continue;
            fmt::print("\n{:<20}", method.name);
            for (std::size_t fate = 0; fate < kFateNames.size(); ++fate)
                fmt::print(" {:>12}", std::count_if(rows.begin(), rows.end(), [&](const StabilityRow& row) {
                               return row.map == map.name && row.method == method.name &&
                                      row.verdict.fate == Fate(fate);
                           }));
        }
        fmt::print("\n\n");
    }
}

void map_stability(const Options& options) {
    const StabilitySuite suite = load_stability(options.suite);
    check_choice("--methods", options.selection.methods, suite.methods);
    check_choice("--maps", options.selection.maps, suite.maps);
    const std::filesystem::path folder = options.out;
    const StabilitySelection& selection = options.selection;
    std::filesystem::create_directories(folder);
    std::vector<StabilityRow> rows;
    for (const StabilityMap& map : suite.maps) {
        const std::vector<StabilityRow> some = read_stability(cells_file(folder, map.name), map.name);
        rows.insert(rows.end(), some.begin(), some.end());
    }
    if (!options.draw_only) {
        const bool anew = selection.methods.empty() && !selection.missing;
        std::map<std::string, Notes> notes;
        for (const StabilityMap& map : suite.maps)
            if (selection.maps.empty() || std::ranges::count(selection.maps, map.name) > 0)
                notes[map.name] = notes_after(cells_file(folder, map.name), anew, options.note);
        ProgressBar bar;
        run_stability(
            suite, selection, rows, [&](double share, const std::string& what) { bar.show(share, what); },
            [&] {
                for (const auto& [name, told] : notes)
                    write_stability(cells_file(folder, name), suite, name, rows, told);
            });
    }
    for (const StabilityMap& map : suite.maps)
        draw_stability(suite, map, rows, cells_file(folder, map.name).replace_extension(".svg"));
    tell(suite, rows);
}

} // namespace

void add_stability(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    CLI::App* command =
        app.add_subcommand("stability", "maps where each method stays bounded, and how it fails");
    command->add_option("SUITE", options->suite, "suite file (JSON; bench/schema/stability.schema.json)")
        ->required();
    command->add_option("--out", options->out, "folder for the data and maps; made when it is not there")
        ->type_name("DIR")
        ->required();
    command
        ->add_option("--methods", options->selection.methods,
                     "only these, by their names in the suite; what DIR has of others stays")
        ->type_name("A,B")
        ->delimiter(',');
    command->add_option("--maps", options->selection.maps, "only these")->type_name("A,B")->delimiter(',');
    command->add_flag("--resume", options->selection.missing, "only cells that DIR does not have yet");
    add_note(*command, options->note);
    command->add_flag("--draw-only", options->draw_only, "no runs: draws what DIR has");
    command->callback([options] { map_stability(*options); });
}

} // namespace windlass::lab
