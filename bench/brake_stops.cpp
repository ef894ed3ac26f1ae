// What a sound brake stops and what it does not, what heats it, and whether a hand can work it: docs/brake.md
// is what this writes. 78 mm cable, 9.9 t anchor, rated brake of 2.05 MN.

#include "rigs/tackle_rig.hpp"

#include "server/physics/base/units.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <optional>
#include <random>

using namespace windlass;
using namespace windlass::physics;

namespace {

constexpr double kSternway = 0.5; ///< m/s, a knot: the cable does not all lie in one heap
constexpr double kSmell = 423.15; ///< K, as a seat is told of it (150 C)
constexpr double kAtMost = 180;   ///< s, of each run

/// A cable that runs, and what it does to its brake.
class Run {
public:
    explicit Run(double depth, const TackleSetup& setup = {}, const EquipmentFaults& causes = {})
        : rig_(without_heap(setup), rigs::quiet_water(depth)) {
        rig_.causes = causes;
        rig_.lip_velocity = {-kSternway, 0, 0};
    }
    /// Steps until the condition holds or the cable is gone. False when it was not so in time.
    template <class Condition>
    bool until(const Condition& condition, double seconds = kAtMost) {
        rig_.run_until(
            [&] {
                skin_ = std::max(skin_, rig_.windlass().brake.skin);
                return condition() || gone();
            },
            seconds);
        return condition() && !gone();
    }
    void wheel(double position) { rig_.levers.brake = position; }
    void grip(double share) { rig_.grip(share); }
    void lie_still() { rig_.lip_velocity.setZero(); }
    double out() const { return rig_.windlass().cable_out; }
    double speed() const { return rig_.windlass().cable_speed; }
    double position() const { return rig_.windlass().brake.position; }
    double skin() const { return rig_.windlass().brake.skin; }
    double hottest() const { return skin_; } ///< K, of the skin so far
    double energy() const { return rig_.windlass().brake.heat; }
    /// The connection in the locker has parted: nothing is there to be stopped.
    bool gone() const { return rig_.windlass().bitter_end_parted; }

private:
    /// A heap costs half of the time and takes 7 % off the speed (docs/physics.md).
    static TackleSetup without_heap(TackleSetup setup) {
        setup.self_contact = false;
        return setup;
    }

    rigs::TackleRig rig_;
    double skin_ = kAirTemperature;
};

std::string celsius(double kelvin) {
    return fmt::format("{:.0f}", celsius_from_kelvin(kelvin));
}

/// Let go from the waterline, the wheel at `opened`; hard on is ordered at so many metres.
struct Stop {
    double speed = 0;    ///< m/s, when it was ordered
    double distance = 0; ///< m, from there
    double skin = 0;     ///< K, at its hottest
    bool held = false;
};

std::optional<Stop> stop(double depth, double ordered_at, double opened, const EquipmentFaults& causes = {}) {
    Run run(depth, {}, causes);
    run.wheel(opened);
    if (!run.until([&] { return run.out() > ordered_at; })) return std::nullopt;
    Stop result{.speed = run.speed()};
    const double from = run.out();
    run.wheel(1);
    result.held = run.until([&] { return run.speed() <= 0; });
    result.distance = run.out() - from;
    result.skin = run.hottest();
    return result;
}

std::string told(const std::optional<Stop>& stop) {
    if (!stop) return "does not run so far";
    return stop->held ? fmt::format("{:.0f} m, {} °C", stop->distance, celsius(stop->skin))
                      : fmt::format("**lost**, {} °C", celsius(stop->skin));
}

/// Least share of the lining's friction with which hard on still stops it, in hundredths.
double least_friction(double depth, double ordered_at) {
    int holds = 100, loses = 0; // hundredths that are left
    while (holds - loses > 1) {
        const int left = (holds + loses) / 2;
        const auto result = stop(depth, ordered_at, 0, {.lining_faded = 1 - 0.01 * left});
        (result && result->held ? holds : loses) = left;
    }
    return 0.01 * holds;
}

void write_stops(std::ostream& out) {
    const double free_play = WindlassDef{}.brake_free_play;
    fmt::print(
        out, "\n## What hard on stops\n\nLet go from the waterline by a ship that falls astern at a knot. "
             "*Wide open*: the wheel has five turns to go; *lining clear*: three. *Wet*: a full film. "
             "*Spent*: wet, glazed and worn through. *Friction*: the least share of the lining's with which "
             "hard on, from wide open, still stops it.\n\n"
             "| depth | ordered at | speed | wide open | lining clear | wet | spent | friction |\n"
             "|---|---|---|---|---|---|---|---|\n");
    const EquipmentFaults wet{.lining_wet = 1}, spent{.lining_wet = 1, .lining_glazed = 1, .lining_worn = 1};
    for (const double depth : {25, 60, 90, 120}) {
        for (const double shackles : {1.5, 3.0, 5.0, 8.0}) {
            const double at = metres_from_shackles(shackles);
            const auto open = stop(depth, at, 0);
            fmt::print(out, "| {} m | {} shackles | {:.1f} m/s | {} | {} | {} | {} | {:.2f} |\n", depth,
                       shackles, open ? open->speed : 0, told(open), told(stop(depth, at, free_play)),
                       told(stop(depth, at, 0, wet)), told(stop(depth, at, 0, spent)),
                       least_friction(depth, at));
        }
    }
}

/// A hand that looks every so often and turns the wheel by what he sees: share of the grip for 1 m/s too
/// fast.
void keep_speed(Run& run, double wanted, double& share) {
    constexpr double kLook = 0.3, kTurns = 0.003;
    share = std::clamp(share + kTurns * (run.speed() - wanted), 0.0, 1.0);
    run.grip(share);
    run.until([] { return false; }, kLook);
}

/// Eight shackles on the brake, then hard on.
void write_rides(std::ostream& out) {
    constexpr double kShackles = 8;
    fmt::print(
        out, "\n## What heats it\n\nEight shackles paid out on the brake and then held, 11 on board. "
             "*In one run*: the hand keeps a speed, and looks every 0.3 s. *A shackle at a time*: the same, "
             "held at each shackle for a minute. Smells, smokes, burns: 150, 250, 400 °C of the skin.\n\n"
             "| depth | how | energy | smells at | smokes at | burns at | hottest | fastest | held after "
             "|\n|---|---|---|---|---|---|---|---|---|\n");
    const auto ride = [&](double depth, double speed, bool by_shackles) {
        Run run(depth);
        double share = 0.02, fastest = 0;
        double passed[3] = {0, 0, 0}; // m out
        const double temperature[3] = {kSmell, kFadeStart, 673.15};
        for (double next = 1; run.out() < metres_from_shackles(kShackles) && !run.gone();) {
            keep_speed(run, speed, share);
            fastest = std::max(fastest, run.speed());
            for (int k = 0; k < 3; ++k)
                if (passed[k] == 0 && run.hottest() > temperature[k]) passed[k] = run.out();
            if (by_shackles && run.out() > metres_from_shackles(next)) {
                run.wheel(1);
                run.until([] { return false; }, 60);
                run.grip(share);
                ++next;
            }
        }
        const double from = run.out();
        run.wheel(1);
        const bool held = run.until([&] { return run.speed() <= 0; });
        fmt::print(out, "| {} m | {:.0f} m/s, {} | {:.1f} MJ |", depth, speed,
                   by_shackles ? "a shackle at a time" : "in one run", 1e-6 * run.energy());
        for (const double at : passed)
            fmt::print(out, " {} |", at > 0 ? fmt::format("{:.0f} m", at) : "-");
        fmt::print(out, " {} °C | {:.1f} m/s | {} |\n", celsius(run.hottest()), fastest,
                   held ? fmt::format("{:.0f} m", run.out() - from) : "**lost**");
    };
    for (const double depth : {25, 60, 90, 120, 200})
        for (const double speed : {2, 4, 6})
            ride(depth, speed, false);
    for (const double depth : {25, 60, 90, 120, 200})
        ride(depth, 2, true);
}

/// A hand with a reaction time, an unsteady wrist and a look at the counter now and then, at a wheel of five
/// turns.
struct Tries {
    int held = 0, stopped = 0; ///< of ten
    double worst = 0;          ///< m, from the mark
};

/// nudge: degrees of the wheel, by which he corrects.
Tries hands(const WindlassDef& windlass, double nudge) {
    constexpr double kWheel = 5 * 360;       // degrees from open to hard on
    constexpr double kUnsteady = 5;          // degrees, of each placing
    constexpr double kReaction = 0.3;        // s
    constexpr double kMark = 45;             // m out; from 5, in 60 m of water: nothing but the fall
    constexpr double kBefore = 2;            // m before the mark at which he screws it on
    constexpr double kSlow = 2.5, kFast = 4; // m/s, between which the fall is to be
    constexpr double kBegins = 6;            // s, after which it is to be there
    constexpr double kMost = 0.9;            // of the time, that counts as held
    Tries tries;
    for (unsigned seed = 1; seed <= 10; ++seed) {
        std::mt19937 random(seed);
        std::normal_distribution<double> wrist(0, kUnsteady / kWheel);
        TackleSetup setup;
        setup.windlass = windlass;
        Run run(60, setup);
        run.lie_still();
        // He knows his wheel: where it holds the half of what hangs on it.
        double place = position_of_grip(windlass, 0.02);
        int looks = 0, good = 0;
        double seconds = 0;
        const auto wait = [&](double time) {
            for (double end = seconds + time; seconds < end - 1e-9; seconds += 0.1) {
                run.until([] { return false; }, 0.1);
                if (seconds < kBegins || run.out() > kMark - kBefore) continue;
                ++looks;
                good += run.speed() > kSlow && run.speed() < kFast ? 1 : 0;
            }
        };
        const double turn = nudge / kWheel;
        for (double before = 0; run.out() < kMark - kBefore && seconds < 60;) {
            run.wheel(std::clamp(place + wrist(random), 0.0, 1.0));
            // What he sees at this look he acts on a reaction later, if it does not mend by itself.
            const double seen = run.speed();
            const bool faster = seen > before, there = std::abs(run.position() - place) < 2 * turn + 0.01;
            before = seen;
            wait(kReaction);
            if (seen > kFast - 0.4 && faster) place += turn;
            if (seen < kSlow + 0.4 && !faster && there) place -= turn;
        }
        wait(kReaction);
        run.wheel(1);
        run.until([&] { return run.speed() <= 0; }, 30);
        const double off = std::abs(run.out() - kMark);
        tries.held += looks > 0 && good >= kMost * looks ? 1 : 0;
        tries.stopped += off <= 2 ? 1 : 0;
        tries.worst = std::max(tries.worst, off);
    }
    return tries;
}

void write_hands(std::ostream& out) {
    fmt::print(
        out,
        "\n## A hand at the wheel\n\nTen tries at a fall of 40 m: a look at the counter every 0.3 s, and "
        "0.3 s later a nudge of the wheel where the speed goes the wrong way; wrist unsteady by 5 degrees "
        "(standard deviation); five turns of wheel. Held: nine tenths of the fall from 6 s on between 2.5 "
        "and 4 m/s. Stopped: within 2 m of the mark.\n\n"
        "| grip | nudge | held | stopped | farthest off |\n|---|---|---|---|---|\n");
    WindlassDef in_proportion;
    in_proportion.brake_free_play = 0, in_proportion.brake_stiffening = 1;
    in_proportion.brake_travel_time = 2;
    for (const double nudge : {5, 10, 20}) {
        const auto row = [&](const char* name, const WindlassDef& windlass) {
            const Tries tries = hands(windlass, nudge);
            fmt::print(out, "| {} | {:.0f} degrees | {} of 10 | {} of 10 | {:.1f} m |\n", name, nudge,
                       tries.held, tries.stopped, tries.worst);
        };
        row("in proportion to the wheel, 2 s from open to hard on", in_proportion);
        row("with free play and stiffness, 5 s", {});
    }
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app(
        "What the band brake of a 78 mm windlass stops, what heats it and how it takes a hand, as Markdown. "
        "Exit codes: 0 done, 1 not written, 2 bad option.");
    std::string path;
    app.add_option("--out", path, "file; the terminal without");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    std::ofstream file;
    if (!path.empty()) file.open(path);
    std::ostream& out = path.empty() ? std::cout : file;
    fmt::print(
        out, "# What the band brake stops\n\nWritten by `build/release/bin/brake_stops --out docs/brake.md`: "
             "78 mm cable, anchor of 9.9 t, a brake of 2.05 MN that a man screws on. What stands behind it: "
             "[physics.md](physics.md#the-band-brake).\n");
    write_stops(out);
    write_rides(out);
    write_hands(out);
    out.flush();
    return out ? 0 : 1;
}
