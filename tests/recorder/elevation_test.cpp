// Pictures of key moments: of the recorded places, in true shape.

#include "recorder/debrief/elevation.hpp"
#include "recorder/debrief/moments.hpp"
#include "recorder/debrief/page.hpp"
#include "recorder/debrief/read_attempt.hpp"
#include "recorder/debrief/scenes.hpp"
#include "words/words.hpp"

#include "tests/recorder/debriefed.hpp"
#include "tests/recorder/folder.hpp"

#include <gmock/gmock.h>

#include <numbers>
#include <regex>

namespace windlass::debrief {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kTonne = words::units::tonne;
constexpr double kTenth = 0.05; // px: coordinates are written to a tenth of one

Point3f point(double x, double y, double z) {
    Point3f made;
    made.x(static_cast<float>(x));
    made.y(static_cast<float>(y));
    made.z(static_cast<float>(z));
    return made;
}

/// A straight cable from the lip, 6 m over the water, to the bed, 25 m under it, 93 m away in that direction.
SceneAt scene(double direction, double far = 93) {
    SceneAt made;
    made.ship.emplace();
    made.ship->attitude().w(1);
    made.ship->heading(30 * kDegree);
    made.chains[0].emplace();
    for (int i = 0; i <= 10; ++i)
        made.chains[0]->nodes().push_back(
            point(far * i / 10 * std::sin(direction), far * i / 10 * std::cos(direction), 6 - 3.1 * i));
    made.chains[0]->tension() = std::vector<float>(10, 50e3F);
    return made;
}

Attempt attempt(const SceneAt& of) {
    Attempt made;
    made.bed.emplace();
    made.bed->depth(25);
    made.scenes = {of};
    return made;
}

/// The places of the first path of a class, px.
std::vector<std::pair<double, double>> path(const std::string& svg, const std::string& kind) {
    static const std::regex number(R"([ML](-?[0-9.]+) (-?[0-9.]+))");
    const auto at = svg.find("class=\"" + kind + "\" d=\"");
    if (at == svg.npos) return {};
    const std::string d = svg.substr(at, svg.find('/', at) - at);
    std::vector<std::pair<double, double>> places;
    for (std::sregex_iterator each(d.begin(), d.end(), number), end; each != end; ++each)
        places.emplace_back(std::stod((*each)[1]), std::stod((*each)[2]));
    return places;
}

std::string drawn(const SceneAt& of, const TensionLimits& limits = {25e3, 75e3, 100e3}) {
    return elevation_svg(attempt(of), of, SIDE_PORT, limits, 1, "title", "words");
}

TEST(Elevation, ShowsTheCableInTrueShapeWhereverItLeads) {
    for (const double direction : {0.0, 90.0, 200.0}) {
        const std::string svg = drawn(scene(direction * kDegree));
        const auto cable = path(svg, "cable pull1");
        ASSERT_THAT(cable, SizeIs(2)) << "a straight one needs no more";
        const double right = cable[1].first - cable[0].first, down = cable[1].second - cable[0].second;
        // 93 m to the right and 31 m down: one third.
        EXPECT_NEAR(down, right / 3, 2 * kTenth);
        // Its end lies on the bed, 25 of those metres under the water.
        const auto bed = path(svg, "bed");
        ASSERT_FALSE(bed.empty());
        EXPECT_NEAR(bed.front().second, cable[1].second, 2 * kTenth);
        const auto water = path(svg, "surface");
        EXPECT_NEAR(bed.front().second - water.front().second, down * 25 / 31, 3 * kTenth);
    }
}

TEST(Elevation, LooksAcrossTheCableAndAlongTheShipWhereItHangsPlumb) {
    EXPECT_NEAR(elevation_of(scene(60 * kDegree), SIDE_PORT)->direction, 60 * kDegree, 1e-6);
    EXPECT_NEAR(elevation_of(scene(60 * kDegree, 2), SIDE_PORT)->direction, 30 * kDegree, 1e-6);
    EXPECT_FALSE(elevation_of(scene(0), SIDE_STARBOARD));
    EXPECT_FALSE(elevation_of(SceneAt{}, SIDE_PORT));
}

TEST(Elevation, ShowsTheTensionOfEachLinkByAClassOfItsOwn) {
    SceneAt of = scene(0);
    of.chains[0]->tension() = {120e3F, 120e3F, 90e3F, 90e3F, 90e3F, 30e3F, 30e3F, 10e3F, 10e3F, 0};
    const std::string svg = drawn(of);
    const auto cable = path(svg, "cable pull3");
    const double length = path(svg, "cable pull2").at(1).first - path(svg, "cable pull2").at(0).first;
    EXPECT_NEAR(length, 1.5 * (cable.at(1).first - cable.at(0).first), 2 * kTenth) << "three links, and two";
    for (const char* kind : {"pull0", "pull1"})
        EXPECT_THAT(svg, HasSubstr(kind));
    EXPECT_THAT(tension_limits({of}),
                ElementsAre(DoubleEq(5 * kTonne), DoubleEq(10 * kTonne), DoubleEq(15 * kTonne)))
        << "round quarters of 20 t";
    EXPECT_THAT(tension_limits({}),
                ElementsAre(DoubleEq(5 * kTonne), DoubleEq(10 * kTonne), DoubleEq(15 * kTonne)))
        << "never finer than that";
}

TEST(Elevation, DrawsHerPlatingWhereSheIs) {
    SceneAt of = scene(0); // the cable leads north; she heads north as well and lies south of the lip
    of.ship->position().y(-20);
    of.ship->attitude().w(std::sqrt(0.5)); // her axes: forward is x, and x is turned to the north
    of.ship->attitude().z(std::sqrt(0.5));
    Attempt with = attempt(of);
    with.ship_form.emplace();
    with.ship_form->hull_corners() = {point(-40, 0, -8), point(20, 0, -8), point(20, 0, 5), point(-40, 0, 5)};
    with.ship_form->hull_triangles() = {0, 1, 2, 0, 2, 3};
    const std::string svg = elevation_svg(with, of, SIDE_PORT, {25e3, 75e3, 100e3}, 1, "t", "w");
    const auto hull = path(svg, "plating");
    ASSERT_FALSE(hull.empty());
    const auto [left, right] = std::ranges::minmax(hull);
    const auto lip = path(svg, "cable pull1").front(), end = path(svg, "cable pull1").back();
    const double metre = (end.first - lip.first) / 93;
    EXPECT_NEAR(right.first, lip.first, 2 * kTenth) << "her bow, 20 m ahead of midships, is at the lip";
    EXPECT_NEAR(right.first - left.first, 60 * metre, 2 * kTenth);
}

// ground.hpp: a peak of one point loses 7/16 of its height; an even slope is kept.
TEST(Elevation, HasTheBedOfTheExercise) {
    SeabedDescription bed;
    bed.depth(20);
    bed.slope(std::atan(0.1));
    bed.slope_towards(90 * kDegree);
    EXPECT_NEAR(bed_height(bed, 30, -500), -17, 1e-9);
    bed.slope(0);
    bed.columns(5);
    bed.rows(5);
    bed.spacing(10);
    bed.heights() = std::vector<float>(25, 0);
    bed.heights()[12] = 8;
    EXPECT_NEAR(bed_height(bed, 20, 20), -20 + 8 * (1 - 7.0 / 16), 1e-6);
    EXPECT_NEAR(bed_height(bed, -1000, 20), -20, 1e-6);
    for (std::size_t i = 0; i < 25; ++i)
        bed.heights()[i] = static_cast<float>(i % 5); // a metre in ten, to the east
    EXPECT_NEAR(bed_height(bed, 17, 12), -20 + 1.7, 1e-6);
}

TEST(Scenes, MomentsThatLieCloseTogetherShareOne) {
    const auto at = [](double time, int side = -1) { return Moment{time, "what", side}; };
    const auto groups = pictured({at(10), at(12.5, 1), at(14), at(40)});
    ASSERT_THAT(groups, SizeIs(3));
    EXPECT_THAT(groups[0].numbers, ElementsAre(0U, 1U));
    EXPECT_EQ(groups[0].side, 1);
    EXPECT_EQ(groups[1].time, 14);
    std::vector<Moment> many;
    for (int i = 0; i < 30; ++i)
        many.push_back(at(10 * i));
    EXPECT_LE(pictured(many).size(), 12U);
    EXPECT_TRUE(pictured({}).empty());
}

// From before it a picture would show the anchor hanging that has just touched the bottom.
TEST(Scenes, AreTheFirstThatWereRecordedFromTheirMomentOn) {
    const test::Folder folder;
    recorder::Tape tape({.folder = folder / "monday"});
    test::write_run(tape, {});
    tape.close({});
    recording::Recording recording({folder / "monday"});
    Attempt attempt = read_attempt(recording);
    read_scenes(recording, attempt);
    ASSERT_THAT(attempt.scenes, SizeIs(pictured(moments_of(attempt)).size()));
    for (const SceneAt& each : attempt.scenes) {
        ASSERT_TRUE(each.ship && each.chains[0]);
        EXPECT_FALSE(each.chains[1]);
        for (const double time : {each.ship->time(), each.chains[0]->time(), each.anchors[0]->time()}) {
            EXPECT_GE(time, each.time - 1e-6);
            EXPECT_LT(time, each.time + 0.2 + 1e-6) << "they come five times a second";
        }
    }
    EXPECT_THAT(page_of(attempt, {}), HasSubstr("The scene at key moments"));
    attempt.scenes.clear();
    EXPECT_THAT(page_of(attempt, {}), Not(HasSubstr("The scene at key moments")));
}

} // namespace
} // namespace windlass::debrief
