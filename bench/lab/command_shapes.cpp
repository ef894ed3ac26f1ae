#include "bench/lab/commands.hpp"
#include "bench/lab/shapes/shapes.hpp"

#include <fmt/format.h>

#include <memory>

namespace windlass::lab {
namespace {

struct Options {
    std::string file, out, note;
    std::vector<std::string> figures;
    bool draw_only = false;
};

void tell(const std::vector<LineShape>& shapes) {
    fmt::print("{:<40} {:<24} {:>6} {:>9} {:>9} {:>10} {:>9} {:>9}\n", "", "", "s", "longest", "shortest",
               "nearest, m", "bend, deg", "lowest, m");
    for (const LineShape& s : shapes)
        fmt::print("{:<40} {:<24} {:>6.3g} {:>8.2f}% {:>8.2f}% {:>10.3g} {:>9.3g} {:>9.4g}\n", s.panel, s.run,
                   s.time, 100 * s.longest_link, 100 * s.shortest_link, s.nearest, s.sharpest, s.lowest);
}

void make(const Options& options) {
    const std::filesystem::path folder = options.out;
    std::filesystem::create_directories(folder);
    for (const ShapeFigure& figure : load_shapes(options.file)) {
        if (!options.figures.empty() && std::ranges::count(options.figures, figure.name) == 0) continue;
        const std::filesystem::path file = folder / (figure.name + ".csv");
        if (!options.draw_only) write_shapes(file, run_shapes(figure), notes_after(file, true, options.note));
        const std::vector<LineShape> shapes = read_shapes(file);
        draw_shapes(std::filesystem::path(file).replace_extension(".svg"), figure, shapes);
        fmt::print("{}\n", figure.title);
        tell(shapes);
    }
}

} // namespace

void add_shapes(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    CLI::App* command =
        app.add_subcommand("shapes", "draws where lines lie at some times, by settings and methods");
    command->add_option("FIGURES", options->file, "figures file (JSON; bench/schema/shapes.schema.json)")
        ->required();
    command->add_option("--out", options->out, "folder for the data and drawings; made when it is not there")
        ->type_name("DIR")
        ->required();
    command->add_option("--figures", options->figures, "only these")->type_name("A,B")->delimiter(',');
    add_note(*command, options->note);
    command->add_flag("--draw-only", options->draw_only, "no runs: draws what DIR has");
    command->callback([options] { make(*options); });
}

} // namespace windlass::lab
