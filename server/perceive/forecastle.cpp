// What is seen, heard, smelt and felt on the forecastle, and what its gauges show: one rule for each field.

#include "server/perceive/perceive.hpp"
#include "server/perceive/senses.hpp"

#include "server/physics/windlass/prime_mover.hpp"
#include "words/words.hpp"

namespace windlass::perceive {

namespace {

using exercise::AnchorPhase;

constexpr std::size_t kNodesInView = 256, kMarksInView = 64; // bounds of the IDL

// Steps of gauges, so that nothing finer than their scale is worked back from them.
constexpr double kLoadStep = 1000;             ///< N, last figure of a load cell's display; tuned
constexpr double kCurrentStep = 5;             ///< A, as an ammeter is read; tuned
constexpr double kPressureStep = 2e5;          ///< Pa, as a pressure gauge is read; tuned
constexpr double kWorkStep = 10;               ///< s, as men say how long they need
constexpr double kCounterSpeedStep = 1.0 / 60; ///< m/s, whole m/min; tuned

/// kn, above which the wind has the next number (Beaufort, at 10 m; WMO): of whole knots, as people are told
/// the wind, so that 16 kn are force 4 wherever they are read.
constexpr std::array kBeaufort{0.5, 3.5, 6.5, 10.5, 16.5, 21.5, 27.5, 33.5, 40.5, 47.5, 55.5, 63.5};

/// W into the lining, from which it is heard to rub, squeal, scream.
constexpr std::array kBrakeNoise{words::limits::brake_rubs, words::limits::brake_squeals,
                                 words::limits::brake_screams};

/// m/s of cable over gypsy and lip, from which the deck trembles, shakes, bangs; tuned.
constexpr std::array kVibration{0.5, 3.0, 6.0};

int vibration(const exercise::TackleView& tackle, int brake_noise) {
    int felt = passed(kVibration, std::abs(tackle.windlass.cable_speed));
    if (tackle.anchor.phase == AnchorPhase::dragging) felt = std::max(felt, 1); // through the taut cable
    if (brake_noise == 3) felt = std::max(felt, 2);                             // the band grabs
    if (tackle.windlass.gypsy_jumping) felt = 3;
    return felt;
}

/// In sight where it is drawn: but for an anchor that is home, what is under water is no more than that.
AnchorSeen anchor_seen(const exercise::AnchorView& anchor) {
    if (anchor.phase == AnchorPhase::housed) return ANCHOR_SEEN_HOME;
    if (!above_water(anchor)) return ANCHOR_SEEN_UNDER_WATER;
    if (anchor.phase == AnchorPhase::acockbill) return ANCHOR_SEEN_ACOCKBILL;
    return anchor.fouled > 0 ? ANCHOR_SEEN_FOUL : ANCHOR_SEEN_CLEAR;
}

/// Hours as they are called: ahead is 12.
double clock_called(double hours) {
    const double called = in_steps(hours, 0.5);
    return called == 0 ? 12 : called;
}

/// 0..1, of the soil that an anchor brings up at most. What hangs on a foul one hides it.
double mud(const exercise::AnchorView& anchor) {
    if (anchor.fouled > 0 || anchor.weight <= 0) return 0;
    return in_steps(std::clamp(anchor.carried / (words::limits::mud_most * anchor.weight), 0.0, 1.0), 0.1);
}

void put(const Eigen::Vector3f& from, Point3f& to) {
    to.x(from.x());
    to.y(from.y());
    to.z(from.z());
}

void add(const Eigen::Vector3f& node, ForecastleView& to) {
    to.nodes().emplace_back();
    put(node, to.nodes().back());
}

/// The cable from the lip until it passes out of sight. The link that does is cut there: how far down it goes
/// is not seen, which way it leads is.
void look_at_cable(const std::vector<Eigen::Vector3f>& nodes, ForecastleView& to) {
    constexpr auto kDeepest = static_cast<float>(-words::limits::looked_through);
    for (std::size_t i = 0; i < nodes.size() && to.nodes().size() < kNodesInView; ++i) {
        if (nodes[i].z() >= kDeepest) {
            add(nodes[i], to);
            continue;
        }
        if (i == 0) return;
        const Eigen::Vector3f& above = nodes[i - 1];
        const float share = (above.z() - kDeepest) / (above.z() - nodes[i].z());
        Eigen::Vector3f cut = above + share * (nodes[i] - above);
        cut.z() = kDeepest;
        add(cut, to);
        return;
    }
}

/// All of the cable, in as many points as the view takes: with a camera under water.
void look_at_all_cable(const std::vector<Eigen::Vector3f>& nodes, ForecastleView& to) {
    if (nodes.empty()) return;
    const std::size_t every = (nodes.size() + kNodesInView - 3) / (kNodesInView - 2);
    for (std::size_t i = 0; i + 1 < nodes.size(); i += every)
        add(nodes[i], to);
    add(nodes.back(), to);
}

bool in_sight(const exercise::MarkView& mark, bool underwater) {
    if (mark.outboard <= 0) return mark.outboard > -words::limits::seen_on_deck;
    return underwater || mark.position.z() >= -words::limits::looked_through;
}

void look_at_marks(const std::vector<exercise::MarkView>& marks, bool underwater, ForecastleView& to) {
    for (const exercise::MarkView& mark : marks) {
        if (!in_sight(mark, underwater) || to.marks().size() == kMarksInView) continue;
        CableMark& seen = to.marks().emplace_back();
        seen.shackle(mark.shackle);
        seen.outboard(static_cast<float>(in_steps(mark.outboard, kMarkStep)));
        seen.white_links(mark.white_links);
        seen.last(mark.last);
        put(mark.position, seen.position());
    }
}

void look_at_anchor(const exercise::AnchorView& anchor, bool underwater, ForecastleView& to) {
    to.anchor(anchor_seen(anchor));
    to.anchor_position({});
    to.anchor_attitude({});
    to.fluke_angle(0);
    to.mud(0);
    const bool seen = above_water(anchor) || (underwater && anchor.phase != AnchorPhase::lost);
    if (!seen) return;
    put(anchor.position.cast<float>(), to.anchor_position());
    to.anchor_attitude().w(anchor.attitude.w());
    to.anchor_attitude().x(anchor.attitude.x());
    to.anchor_attitude().y(anchor.attitude.y());
    to.anchor_attitude().z(anchor.attitude.z());
    to.fluke_angle(anchor.fluke_angle);
    to.mud(mud(anchor));
}

} // namespace

SeatAids seat_aids(const exercise::ExerciseDef& def) {
    return {.counter = def.seats.counter,
            .load_cell = def.seats.load_cell,
            .lining_temperature = def.seats.lining_temperature,
            .underwater = def.seats.underwater};
}

SeatShip seat_ship(const exercise::ExerciseDef& def) {
    const double sounder = def.ship.hawse_forward;
    SeatShip ship{
        .draught = def.ship.draught, .sounder = sounder, .draught_at_sounder = def.ship.draught_at(sounder)};
    for (const exercise::GroundTackleDef& tackle : def.tackle) {
        const physics::WindlassDef& windlass = tackle.windlass;
        ship.motor_full_speed.at(static_cast<std::size_t>(tackle.side)) =
            physics::light_line_speed(windlass) / windlass.gypsy_radius * physics::kGearRatio;
    }
    return ship;
}

void perceive_forecastle(const exercise::Snapshot& from, const exercise::TackleView& tackle,
                         const SeatShip& ship, const SeatAids& aids, ForecastleView& to) {
    const exercise::WindlassView& windlass = tackle.windlass;
    const exercise::AnchorView& anchor = tackle.anchor;
    to.side(static_cast<int>(tackle.side));
    to.tick(from.tick);
    to.time(from.time);

    // The ship, felt and seen against the water
    to.ship_position().x(in_steps(from.ship.position.x(), 0.1));
    to.ship_position().y(in_steps(from.ship.position.y(), 0.1));
    to.ship_position().z(in_steps(from.ship.position.z(), 0.1));
    to.ship_heading(round_the_compass(from.ship.heading, 3600));
    to.ship_roll(tilt(from.ship).roll);
    to.ship_pitch(tilt(from.ship).pitch);
    const ApparentWind wind = apparent_wind(from);
    to.wind_felt(passed(kBeaufort, wind.speed / words::units::knot));
    to.wind_from_bow(to.wind_felt() == 0 ? 0 : round_the_compass(wind.from_bow, 16)); // the flag hangs

    // The stand: levers as they are
    to.brake_position(windlass.brake_position);
    to.speed_lever(windlass.speed_lever);
    to.clutch(static_cast<ClutchState>(windlass.clutch));
    to.clutch_offset(windlass.clutch_offset);
    to.stopper_closed(windlass.stopper_closed);
    to.stopper_sprung(windlass.stopper_sprung);
    to.emergency_stop(windlass.emergency_stop);

    // Gauges, lamps, plates
    to.counter_fitted(aids.counter);
    to.cable_out_indicated(aids.counter ? windlass.cable_out_indicated : 0);
    to.cable_speed_indicated(aids.counter ? in_steps(windlass.cable_speed_indicated, kCounterSpeedStep) : 0);
    to.load_cell_fitted(aids.load_cell);
    to.gypsy_load_indicated(aids.load_cell ? in_steps(windlass.gypsy_load_indicated, kLoadStep) : 0);
    to.breaking_load(windlass.breaking_load);
    to.brake_rating(windlass.brake_rating);
    to.motor_current(in_steps(windlass.motor_current, kCurrentStep));
    to.motor_pressure(in_steps(windlass.motor_pressure, kPressureStep));
    to.power(windlass.power);
    to.tripped(windlass.tripped);

    // The men on deck
    to.deck_work(static_cast<DeckWork>(tackle.deck_work.set));
    to.deck_work_left(std::ceil(tackle.deck_work.left / kWorkStep) * kWorkStep);
    to.deck_work_waits(static_cast<DeckHindrance>(tackle.deck_work.waits));

    // Eyes
    to.cable_speed_seen(in_steps(windlass.cable_speed, kSpeedSeenStep));
    to.gypsy_turn(windlass.gypsy_turn);
    to.gypsy_jumping(windlass.gypsy_jumping);
    look_at_anchor(anchor, aids.underwater, to);
    to.leads(to.anchor() != ANCHOR_SEEN_HOME && to.anchor() != ANCHOR_SEEN_ACOCKBILL);
    to.lead_clock(to.leads() ? clock_called(tackle.chain.lead_clock) : 0);
    to.top_angle(to.leads() ? in_steps(tackle.chain.top_angle, 10 * kDegree) : 0);
    to.nodes().reserve(kNodesInView); // all that it may ever need, taken the first time
    to.nodes().clear();
    if (aids.underwater)
        look_at_all_cable(tackle.chain.nodes, to);
    else
        look_at_cable(tackle.chain.nodes, to);
    to.marks().reserve(kMarksInView);
    to.marks().clear();
    look_at_marks(tackle.chain.marks, aids.underwater, to);

    // Ears, nose, feet
    to.lining(lining_noticed(windlass.lining_temperature));
    const double full = ship.motor_full_speed.at(static_cast<std::size_t>(tackle.side));
    to.motor_speed_heard(full > 0 ? in_steps(windlass.motor_speed / full, 0.1) : 0);
    to.motor_burst(windlass.motor_burst);
    to.brake_noise(passed(kBrakeNoise, std::abs(windlass.brake_power)));
    to.vibration(vibration(tackle, to.brake_noise()));

    // Aids
    to.lining_temperature_shown(aids.lining_temperature);
    to.lining_temperature(aids.lining_temperature ? windlass.lining_temperature : 0);
}

} // namespace windlass::perceive
