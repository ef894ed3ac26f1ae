#include "lesson/cues.hpp"

#include "server/perceive/perceive.hpp"
#include "words/words.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace windlass::lesson {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kTenDegrees = 0.17, kPlumb = 1.4; // rad

/// One thing that somebody at a seat can tell: no difference smaller than a step.
struct Sense {
    const char* of;
    double value, step;
};

/// What is so at one look.
struct Look {
    double time = 0;
    std::vector<Sense> senses;
    std::vector<std::array<double, 4>> faults; ///< each one's code, side, phase, severity
    std::size_t noticed = 0;                   ///< how many events have been noticed
};

/// One run, as far as its seats are concerned.
struct Course {
    std::vector<Look> looks;
    std::vector<std::string> noticed; ///< texts of the events that a seat noticed, in their order
    std::vector<assess::HintResult> hints;
    double tick = 0; ///< s
};

/// The gauges first, which stand nearest to a cause. Steps are those of the view where it has some, else what
/// a dial's needle must move to be seen: a fiftieth of its range.
void sense(const ForecastleView& view, std::vector<Sense>& all) {
    const auto add = [&](const char* of, auto value, double step) {
        all.push_back({of, static_cast<double>(value), step});
    };
    add("load gauge", view.gypsy_load_indicated(), 0.02 * view.brake_rating());
    add("chain counter", view.cable_out_indicated(), 1);
    add("motor current", view.motor_current(), 10);
    add("motor pressure", view.motor_pressure(), 5e5);
    add("power lamp", view.power(), 1);
    add("trip lamp", view.tripped(), 1);
    add("motor, by ear", view.motor_speed_heard(), 0.1);
    add("burst motor", view.motor_burst(), 1);
    add("noise of the brake", view.brake_noise(), 1);
    add("lining, by eye and nose", view.lining(), 1);
    add("trembling of the deck", view.vibration(), 1);
    add("stopper that sprang", view.stopper_sprung(), 1);
    add("stopper", view.stopper_closed(), 1);
    add("clutch", view.clutch(), 1);
    add("men who wait", view.deck_work_waits(), 1);
    add("cable jumping on the gypsy", view.gypsy_jumping(), 1);
    add("speed of the cable, by eye", view.cable_speed_seen(), 0.25);
    add("anchor, by eye", view.anchor(), 1);
    add("stay of the cable", view.top_angle(), kTenDegrees);
    // Cable that hangs plumb leads to no hour that anybody could tell.
    add("lead of the cable", view.top_angle() < kPlumb ? view.lead_clock() : 0, 0.5);
    add("painted marks", view.marks().size(), 1);
}

void sense(const BridgeView& view, std::vector<Sense>& all) {
    const auto add = [&](const char* of, auto value, double step) {
        all.push_back({of, static_cast<double>(value), step});
    };
    add("VHF", view.vhf_works(), 1);
    add("CCTV", view.cctv_works(), 1);
    add("GPS", view.gps_works(), 1);
    add("gyro", view.gyro_works(), 1);
    add("log", view.log_works(), 1);
    add("anemometer", view.anemometer_works(), 1);
    add("echo sounder", view.echo_sounder_works(), 1);
    add("position by GPS", view.position().x(), 5);
    add("position by GPS", view.position().y(), 5);
    add("speed over the ground", view.speed_over_ground(), 0.1);
}

Course course_of(const exercise::ExerciseDef& def, const std::vector<trainee::Script>& scripts) {
    Course course;
    course.tick = 1.0 / def.tick_rate_hz;
    const perceive::SeatAids aids = perceive::seat_aids(def);
    const perceive::SeatShip ship = perceive::seat_ship(def);
    const auto every = static_cast<std::uint64_t>(std::llround(kLook * def.tick_rate_hz));
    ForecastleView deck;
    BridgeView bridge;
    const Played played = play(def, scripts, [&](const run::Session& session) {
        const exercise::Snapshot& seen = session.snapshot();
        for (const exercise::ExerciseEvent& event : session.events())
            if (const auto noticed = perceive::perceive_event(event, seen);
                noticed && !perceive::is_instruction(event))
                course.noticed.emplace_back(noticed->text().c_str());
        if (seen.tick % every != 0) return;
        Look& look = course.looks.emplace_back();
        look.time = seen.time;
        look.noticed = course.noticed.size();
        for (const exercise::TackleView& tackle : seen.tackle) {
            perceive::perceive_forecastle(seen, tackle, ship, aids, deck);
            sense(deck, look.senses);
        }
        perceive::perceive_bridge(seen, ship, bridge);
        sense(bridge, look.senses);
        look.senses.push_back({"orders of the bridge", static_cast<double>(seen.bridge_orders.size()), 1});
        for (const exercise::FaultView& fault : seen.faults)
            look.faults.push_back({static_cast<double>(fault.order.code),
                                   static_cast<double>(fault.order.side), static_cast<double>(fault.phase),
                                   fault.order.severity});
    });
    course.hints = played.result.hints;
    return course;
}

/// What is the first to differ at one look; empty: nothing that can be told.
std::string difference(const Course& a, const Course& b, std::size_t k) {
    const Look &one = a.looks[k], &other = b.looks[k];
    for (std::size_t i = 0; i < std::min(one.senses.size(), other.senses.size()); ++i)
        if (std::abs(one.senses[i].value - other.senses[i].value) >= 0.999 * one.senses[i].step)
            return one.senses[i].of;
    for (std::size_t i = 0; i < std::max(one.noticed, other.noticed); ++i)
        if (i >= one.noticed || i >= other.noticed || a.noticed[i] != b.noticed[i])
            return '"' + (i < one.noticed ? a.noticed[i] : b.noticed[i]) + '"';
    return {};
}

Cue cue_of(const std::string& fault, const Course& with, const Course& without) {
    Cue cue;
    cue.fault = fault;
    const std::size_t looks = std::min(with.looks.size(), without.looks.size());
    for (std::size_t k = 0; k < looks && cue.noticed < 0; ++k) {
        if (cue.raised < 0 && with.looks[k].faults != without.looks[k].faults)
            cue.raised = with.looks[k].time;
        if (cue.raised < 0) continue;
        cue.sign = difference(with, without, k);
        if (!cue.sign.empty()) cue.noticed = with.looks[k].time;
    }
    if (cue.raised < 0) return cue;
    std::set<std::pair<std::string, std::uint64_t>> anyway;
    for (const assess::HintResult& hint : without.hints)
        anyway.emplace(hint.id, hint.tick);
    for (const assess::HintResult& hint : with.hints) {
        const double time = static_cast<double>(hint.tick) * with.tick;
        if (time > cue.raised - kLook && (cue.noticed < 0 || time < cue.noticed) &&
            !anyway.contains({hint.id, hint.tick}))
            cue.hints.push_back(hint.id);
    }
    return cue;
}

} // namespace

std::vector<Cue> cues(const exercise::ExerciseDef& def, const std::vector<trainee::Script>& scripts) {
    std::vector<Cue> all;
    const Json lesson = def.lesson.empty() ? Json::object() : Json::parse(def.lesson);
    const Json faults = lesson.value("faults", Json::array());
    if (faults.empty() && def.faults.empty()) return all;
    const Course with = course_of(def, scripts);
    for (std::size_t k = 0; k < faults.size(); ++k) {
        exercise::ExerciseDef other = def;
        Json left_out = lesson;
        // It stays in its place, for what is drawn goes by that; only it never comes.
        left_out["faults"][k]["when"] = {{"time", 86400}};
        other.lesson = left_out.dump();
        all.push_back(cue_of(faults[k].at("code"), with, course_of(other, scripts)));
    }
    for (std::size_t k = 0; k < def.faults.size(); ++k) {
        exercise::ExerciseDef other = def;
        other.faults.erase(other.faults.begin() + static_cast<std::ptrdiff_t>(k));
        all.push_back(
            cue_of(std::string(words::row_of(def.faults[k].code).name), with, course_of(other, scripts)));
    }
    return all;
}

} // namespace windlass::lesson
