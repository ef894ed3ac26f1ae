#include "sim/hands.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::sim {

namespace {

constexpr double kSpeaks = 0.05; // s, between two words of a hand
constexpr const char* kDesk = "desk";

wire::WriterId writer_of(std::uint64_t number) {
    wire::WriterId id{};
    for (std::size_t k = 0; k < 8; ++k)
        id.at(k) = static_cast<std::uint8_t>(number >> (8 * k));
    return id;
}

} // namespace

Hands::Hands(World& world, Network& network, std::uint64_t seed, std::size_t sides)
    : world_(world),
      network_(network),
      second_desk_(seed * 0x9E3779B97F4A7C15ULL + 3),
      sides_(sides),
      desk_(writer_of(++writers_)) {
    const auto add = [&](const char* name, int levers, bool instructor, int strength, Chance& chance) {
        hands_.push_back(std::make_unique<Hand>());
        Hand& hand = *hands_.back();
        hand.name = name, hand.levers = levers, hand.instructor = instructor, hand.strength = strength;
        hand.chance = &chance;
        const double first = instructor ? chance.spread(5, 200) : chance.spread(0.05, 5);
        world_.at(first, [this, &hand] { work(hand); });
    };
    Chance& chance = world_.chance();
    add("anna", 0, false, 10, chance);
    add("script", 0, false, 5, chance);
    if (sides > 1) add("ben", 1, false, 10, chance);
    add("mate", 2, false, 10, chance);
    add(kDesk, 0, true, 10, chance);
    if (second_desk_.in(0.3)) add("desk-2", 0, true, 10, second_desk_);
    world_.at(1, [this] { desk(); });
}

void Hands::tell(Told told) {
    world_.at(world_.now() + world_.chance().spread(0.002, 0.3),
              [this, told = std::move(told)] { told_ = told; });
}

/// With a writer of its own; its hand has taken the levers in this run, an instructor's from whoever has
/// them.
void Hands::join(Hand& hand) {
    hand.joined = true;
    hand.writer = writer_of(++writers_);
    hand.serial = 0;
    if (hand.instructor) hand.strength = network_.outrank(hand.levers);
    hand.moved_in_run = told_.run;
    hand.moved_at.fill(world_.now());
}

void Hands::work(Hand& hand) {
    Chance& chance = *hand.chance;
    double next = kSpeaks;
    if (!hand.joined) join(hand);
    if (chance.in(0.08)) move(hand);
    speak(hand);
    if (chance.in(hand.instructor ? 0.02 : 0.003)) { // lets go
        network_.leave(hand.writer);
        hand.joined = false;
        next = hand.instructor ? chance.spread(5, 200) : chance.spread(0.1, 30);
    } else if (chance.in(0.003)) { // is killed; DDS may miss it later
        world_.at(world_.now() + chance.spread(0.5, 20),
                  [this, gone = hand.writer] { network_.leave(gone); });
        hand.joined = false;
        next = chance.spread(0.3, 20);
    } else if (chance.in(0.004)) { // hangs
        next = chance.spread(0.1, 15);
        network_.hold_up(hand.writer, world_.now() + next);
    }
    world_.at(world_.now() + next, [this, &hand] { work(hand); });
}

void Hands::move(Hand& hand) {
    Chance& chance = *hand.chance;
    const std::size_t lever = chance.below(hand.levers == 2 ? 4 : 5);
    double& at = hand.at.at(lever);
    if (hand.levers == 2) {
        at = chance.between(-0.3, 0.3);
    } else if (lever == 0) { // the brake, most of the time so that the cable is held or runs slowly
        at = chance.in(0.3) ? 1 : chance.between(0.2, 0.8);
    } else if (lever == 1) {
        at = chance.in(0.4) ? 0 : chance.between(-1, 1);
    } else {
        at = chance.in(lever == 4 ? 0.05 : 0.3) ? 1 : 0;
    }
    hand.moved_at.at(lever) = world_.now();
    hand.moved_in_run = told_.run;
}

void Hands::speak(Hand& hand) {
    Sent sent;
    if (hand.levers == 2) {
        HelmCommand helm;
        helm.engine(hand.at[0]), helm.rudder(hand.at[1]);
        helm.bow_thruster(hand.at[2]), helm.stern_thruster(hand.at[3]);
        helm.origin().source(hand.name), helm.origin().serial(++hand.serial);
        sent.sample = helm;
    } else {
        WindlassCommand levers;
        levers.side(hand.levers);
        levers.brake(hand.at[0]), levers.speed_lever(hand.at[1]), levers.clutch_in(hand.at[2] > 0);
        levers.stopper_closed(hand.at[3] > 0), levers.emergency_stop(hand.at[4] > 0);
        levers.origin().source(hand.name), levers.origin().serial(++hand.serial);
        sent.sample = levers;
    }
    sent.writer = hand.writer;
    sent.instructor = hand.instructor;
    sent.moved_in_run = hand.moved_in_run;
    sent.strength = hand.strength;
    sent.moved_at = hand.moved_at;
    network_.send(std::move(sent));
}

template <class Sample>
void Hands::order(Sample sample) {
    sample.origin().source(kDesk);
    sample.origin().serial(++desk_serial_);
    network_.send({.sample = std::move(sample), .writer = desk_});
}

void Hands::run_order(ExerciseAction action, double value) {
    ExerciseCommand command;
    command.action(action);
    command.time_scale(action == EXERCISE_TIME_SCALE ? value : 1);
    command.restore_time(action == EXERCISE_RESTORE ? value : 0);
    command.predict(action == EXERCISE_PREDICT && value != 0);
    order(command);
}

/// More than the mailbox holds, and what no exercise may be told.
void Hands::flood() {
    for (std::size_t k = 0; k < 3000; ++k) { // each by a writer of its own, or its gate would stop them
        AlertCommand command;
        command.code(k % 2 == 0 ? "no.such" : "");
        command.side(static_cast<int>(k % 5));
        command.origin().source("flood"), command.origin().serial(1);
        network_.send({.sample = command, .writer = writer_of(++writers_)});
    }
}

void Hands::desk() {
    Chance& chance = world_.chance();
    using exercise::RunState;
    const bool stands = told_.state == RunState::paused || told_.state == RunState::ready;
    const bool over = told_.state == RunState::finished || told_.state == RunState::stopped_by_fault;
    const double drawn = chance.unit();
    if (over) {
        run_order(EXERCISE_RESET);
    } else if (stands && chance.in(0.9)) {
        run_order(EXERCISE_START);
    } else if (drawn < 0.1) {
        run_order(EXERCISE_PAUSE);
    } else if (drawn < 0.2) {
        constexpr std::array kScales{1.0, 1.0, 4.0, 8.0, 20.0, 0.0};
        run_order(EXERCISE_TIME_SCALE, kScales.at(chance.below(kScales.size())));
    } else if (drawn < 0.25) {
        run_order(EXERCISE_SNAPSHOT);
    } else if (drawn < 0.28) {
        run_order(EXERCISE_RESTORE, chance.between(0, told_.time));
    } else if (drawn < 0.29) {
        run_order(EXERCISE_RESET);
    } else if (drawn < 0.30) {
        run_order(EXERCISE_STOP);
    } else if (drawn < 0.35) {
        run_order(EXERCISE_BOOKMARK);
    } else if (drawn < 0.40) {
        run_order(EXERCISE_PREDICT, chance.in(0.8) ? 1 : 0);
    } else if (drawn < 0.50) {
        FaultCommand fault;
        fault.code(static_cast<FaultCode>(chance.below(8)));
        fault.side(static_cast<int>(chance.below(sides_)));
        fault.severity(chance.unit());
        fault.ramp(chance.between(0, 5));
        fault.clear(chance.in(0.5));
        order(fault);
    } else if (drawn < 0.60) {
        const exercise::Weather calm;
        EnvironmentCommand command;
        auto& weather = command.weather();
        weather.wind_speed(chance.between(0, 15)), weather.wind_from(chance.between(0, 6));
        weather.gust_factor(calm.gust_factor), weather.wave_period(calm.wave_period);
        weather.swell_period(calm.swell_period), weather.wave_seed(calm.wave_seed);
        weather.current_speed(chance.between(0, 1)), weather.visibility(calm.visibility);
        weather.time_of_day(calm.time_of_day);
        command.ramp(chance.between(0, 20));
        order(command);
    } else if (drawn < 0.70) {
        BridgeOrderCommand command;
        command.code(chance.in(0.5) ? BRIDGE_ORDER_LET_GO : BRIDGE_ORDER_HOLD_ON);
        order(command);
    } else if (drawn < 0.80) {
        WatchCircle circle;
        circle.kept(chance.in(0.8)), circle.radius(chance.spread(10, 300));
        circle.x(chance.between(-50, 50));
        order(circle);
    } else if (drawn < 0.95 && !told_.alerts.empty()) {
        const run::AlertView& alert = told_.alerts.at(chance.below(told_.alerts.size()));
        AlertCommand command;
        command.code(alert.code), command.side(alert.side);
        command.action(chance.in(0.6) ? ALERT_ACKNOWLEDGE : ALERT_SILENCE);
        order(command);
    } else if (drawn < 0.97) {
        flood();
    } else {
        FaultCommand fault; // of no side that there is
        fault.side(7);
        order(fault);
    }
    world_.at(world_.now() + (stands || over ? chance.spread(0.1, 3) : chance.spread(0.3, 15)),
              [this] { desk(); });
}

} // namespace windlass::sim
