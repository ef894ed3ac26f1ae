// Figures of shapes: what is read, run, kept and drawn.

#include "bench/lab/shapes/shapes.hpp"
#include "common/json_file.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace windlass::lab {
namespace {

const std::filesystem::path kCases = WINDLASS_CASES_DIR;

std::filesystem::path written(const std::string& figures) {
    const std::filesystem::path file = testing::TempDir() + "/shapes.json";
    std::ofstream(file) << R"({"figures": [{"name": "one", "title": "One", "x": [-1, 20], "z": [-20, 1], )"
                        << R"("panels": [{"title": "left", "case": ")" << (kCases / "seed_fall.json").string()
                        << "\", " << figures << "}]}]}";
    return file;
}

TEST(Shapes, FiguresOfTheSourceCanBeRead) {
    const std::vector<ShapeFigure> figures = load_shapes(kCases / "seed_figures.json");
    ASSERT_EQ(figures.size(), 7U);
    const ShapeFigure& thickness = figures[3];
    EXPECT_EQ(thickness.name, "fig08_thickness");
    ASSERT_EQ(thickness.panels.size(), 3U);
    for (const auto& [panel, metres] : {std::pair(0, 0.08), std::pair(1, 0.0), std::pair(2, -0.05)}) {
        const Case& given = thickness.panels[panel].runs[0].given;
        EXPECT_EQ(given.links, 99); // 100 particles
        EXPECT_EQ(given.problem.obstacles[0].material.thickness, metres);
    }
}

TEST(Shapes, AreMeasuredKeptAndDrawn) {
    const ShapeFigure figure =
        load_shapes(written(R"("at": [0, 0.5], "lines": [{"name": "pbd"}, {"name": "direct", )"
                            R"("method": "production", "set": ["dt=0.002"]}])"))
            .at(0);
    const std::vector<LineShape> shapes = run_shapes(figure);
    ASSERT_EQ(shapes.size(), 4U);
    EXPECT_EQ(shapes[0].lowest, 0); // straight and level
    EXPECT_NEAR(shapes[0].longest_link, 0, 1e-12);
    EXPECT_NEAR(shapes[0].nearest, 0.4, 1e-12);
    EXPECT_NEAR(shapes[3].lowest, -0.5 * 9.81 * 0.25, 0.05); // its loose end falls freely
    EXPECT_GT(shapes[3].sharpest, 1);

    const std::filesystem::path csv = testing::TempDir() + "/one.csv", svg = testing::TempDir() + "/one.svg";
    write_shapes(csv, shapes, {"made here"});
    EXPECT_EQ(read_notes(csv), Notes{"made here"});
    const std::vector<LineShape> again = read_shapes(csv);
    ASSERT_EQ(again.size(), 4U);
    EXPECT_EQ(again[2].run, "direct");
    EXPECT_EQ(again[3].time, 0.5);
    ASSERT_EQ(again[3].x.size(), 100U);
    for (std::size_t i = 0; i < 100; ++i)
        EXPECT_NEAR(again[3].z[i], shapes[3].z[i], 0.0005001);

    draw_shapes(svg, figure, again);
    std::ifstream in(svg);
    const std::string drawing{std::istreambuf_iterator<char>(in), {}};
    for (const char* part : {">One<", ">left<", ">pbd, 0.5 s<", ">direct, 0 s<"})
        EXPECT_NE(drawing.find(part), std::string::npos) << part;
}

TEST(Shapes, RefuseAMethodThatIsNoneAndTimesThatFall) {
    const auto said = [](const std::string& figures) -> std::string {
        try {
            load_shapes(written(figures));
            return "";
        } catch (const ConfigError& error) {
            return error.what();
        }
    };
    EXPECT_EQ(said(R"("at": [0, 1], "lines": [{"name": "pbd"}])"), "");
    EXPECT_NE(said(R"("at": [1], "lines": [{"name": "a", "method": "magic"}])").find("lines/0/method"),
              std::string::npos);
    EXPECT_NE(said(R"("at": [1, 0], "lines": [{"name": "a"}])").find("times that rise"), std::string::npos);
}

} // namespace
} // namespace windlass::lab
