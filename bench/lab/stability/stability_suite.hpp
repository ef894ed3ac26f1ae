#pragma once
// Stability suites: maps of a quantity against the step, for every method. The format is
// bench/schema/stability.schema.json.

#include "bench/lab/case/table.hpp"
#include "bench/lab/stability/stability.hpp"

#include <functional>

namespace windlass::lab {

/// A method under the name that it has in the maps, with its settings: "leapfrog, raw".
struct StabilityMethod {
    std::string name;
    const MethodEntry* entry = nullptr;
    MethodSettings settings;
};

/// One line of a map: a case with its number of links.
struct StabilityLine {
    std::string value; ///< its label on the axis, and in the CSV
    Case given;
    int links = 0;
};

struct StabilityMap {
    std::string name, title, axis;    ///< axis: what the values are, with unit
    std::vector<StabilityLine> lines; ///< from the bottom up
};

struct StabilitySuite {
    std::vector<StabilityMethod> methods;
    std::vector<int> rates; ///< steps in a second
    double max_seconds = 1;
    std::vector<StabilityMap> maps;
};

/// Throws exercise::ConfigError: file, JSON pointer, value, what is allowed.
StabilitySuite load_stability(const std::filesystem::path& file);

/// A case whose anchor is ratio times as heavy as a link: by a lighter or heavier anchor up to that of the
/// case, beyond that by lighter chain, so that the load stays one that the chain bears. The lower end must be
/// a mass.
Case with_mass_ratio(Case given, int links, double ratio);

/// One cell.
struct StabilityRow {
    std::string map, method, value;
    int rate = 0;
    Verdict verdict;
};

/// What to run; what is empty leaves nothing out.
struct StabilitySelection {
    std::vector<std::string> methods, maps;
    bool missing = false; ///< only cells that are not among the rows yet
};

/// Judges every cell that is selected and puts it among the rows, in place of what was there. progress and
/// keep as for run_suite().
void run_stability(const StabilitySuite& suite, const StabilitySelection& selection,
                   std::vector<StabilityRow>& rows,
                   const std::function<void(double share, const std::string& what)>& progress,
                   const std::function<void()>& keep);

/// The data of a map: stability_NAME.csv in the folder.
std::filesystem::path cells_file(const std::filesystem::path& folder, const std::string& map);

/// As CSV, the cells of one map: a line for each fate on each line of the map, with the steps at which it was
/// met, in the order of the suite. Throws std::runtime_error naming the file.
void write_stability(const std::filesystem::path& file, const StabilitySuite& suite, const std::string& map,
                     std::vector<StabilityRow> rows, const Notes& notes = {});

/// Reads what write_stability() wrote, fates alone; nothing when there is no file. Throws
/// exercise::ConfigError.
std::vector<StabilityRow> read_stability(const std::filesystem::path& file, const std::string& map);

/// A map as a drawing: a panel for each method, a cell for each step and value. Throws std::runtime_error
/// naming the file when it cannot be written.
void draw_stability(const StabilitySuite& suite, const StabilityMap& map,
                    const std::vector<StabilityRow>& rows, const std::filesystem::path& file);

} // namespace windlass::lab
