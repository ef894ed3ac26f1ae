// What the comparison measures, held against what is known beforehand; and the drawings.

#include "bench/lab/accuracy/work_precision.hpp"
#include "bench/lab/draw/chart.hpp"
#include "tests/lab/problems.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace windlass::lab {
namespace {

Trace swing(int rate, double until = 2) {
    Case given = load_case(std::string(WINDLASS_CASES_DIR) + "/swing.json");
    given.problem.duration = until;
    return trace(given, method_named("production"), 20, rate, {until, 1e9});
}

TEST(WorkPrecision, ErrorOfARunAgainstItselfIsZero) {
    const Trace run = swing(240);
    const Errors errors = errors_of(run, run, 2);
    EXPECT_EQ(errors.tension, 0);
    EXPECT_EQ(errors.position, 0);
    EXPECT_EQ(errors.link, 0);
    EXPECT_EQ(errors.peak, 0);
    EXPECT_EQ(run.positions.size(), 30U); // 15 a second; none before the first step
    EXPECT_GT(run.cost, 0);
}

TEST(WorkPrecision, ErrorsAreRelativeToTensionLineAndLink) {
    const Trace run = swing(240);
    Trace other = run;
    for (double& tension : other.top_tension)
        tension *= 1.01;
    for (auto& nodes : other.positions)
        for (Vec3& node : nodes)
            node.y() += 2; // 1 % of 200 m
    const Errors errors = errors_of(other, run, 2);
    EXPECT_NEAR(errors.tension, 0.01, 1e-9);
    EXPECT_NEAR(errors.position, 0.01, 1e-9);
    EXPECT_NEAR(errors.link, 0, 1e-12);
}

TEST(WorkPrecision, ProductionIsOfSecondOrderInPositionOnTheSwing) {
    const Trace exact = swing(15360);
    const double coarse = errors_of(swing(120), exact, 2).position,
                 fine = errors_of(swing(240), exact, 2).position;
    EXPECT_GT(coarse / fine, 3.4);
    EXPECT_LT(coarse / fine, 4.6);
}

TEST(WorkPrecision, GivesUpARunThatWouldTakeTooLong) {
    Case given = load_case(std::string(WINDLASS_CASES_DIR) + "/swing.json");
    EXPECT_EQ(trace(given, method_named("production"), 200, 61440, {10, 1e-6}).end, Trace::End::too_long);
}

TEST(Svg, DrawsNoPointThatAPixelDoesNotShow) {
    std::vector<Point> wave;
    for (int i = 0; i <= 3000; ++i)
        wave.push_back({0.1 * i, 50 * std::sin(0.01 * i)});
    const std::vector<Point> few = simplified(wave, 0.15);
    EXPECT_LT(few.size(), 200U); // of 3001
    EXPECT_GT(few.size(), 20U);
    // No place of the wave lies further from what is drawn.
    for (std::size_t k = 0; k + 1 < few.size(); ++k)
        for (double x = few[k].x; x < few[k + 1].x; x += 0.1) {
            const double share = (x - few[k].x) / (few[k + 1].x - few[k].x);
            EXPECT_NEAR(few[k].y + share * (few[k + 1].y - few[k].y), 50 * std::sin(0.1 * x), 1.0);
        }
    Svg svg(300, 100);
    svg.dots({{1, 1}, {1.2, 1}, {9, 1}}, 2, "#000");
    EXPECT_NE(svg.document().find("M1 1h0M9 1h0\""), std::string::npos) << svg.document();
}

TEST(Chart, LeavesOutWhatALogAxisCannotShowAndLabelsEveryCurve) {
    Svg svg(400, 300);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    draw(
        svg,
        {.title = "a < b",
         .x = {"cost, ms", true},
         .y = {"error", true},
         .curves = {{.name = "one", .points = {{1, 0.1}, {10, 0.01}, {100, 0}, {100, nan}}, .colour = "#000"},
                    {.name = "two", .points = {{1, 0.1}, {10, 0.01}}, .colour = "#000"}}},
        {0, 0}, 400, 300);
    const std::string document = svg.document();
    EXPECT_NE(document.find(">one</text>"), std::string::npos);
    EXPECT_NE(document.find(">two</text>"), std::string::npos);
    EXPECT_NE(document.find("a &lt; b"), std::string::npos);
    EXPECT_EQ(document.find("nan"), std::string::npos);
    EXPECT_EQ(document.find("inf"), std::string::npos);
}

} // namespace
} // namespace windlass::lab
