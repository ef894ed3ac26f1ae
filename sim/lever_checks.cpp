// What Checks asks of orders and levers: each order was sent, and no lever moves without a hand.

#include "sim/checks.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace windlass::sim {

namespace {

constexpr double kMoved = -1; // s: a lever that lay there, and was moved since

std::array<double, 5> values_of(const exercise::Order& order) {
    if (const auto* windlass = std::get_if<exercise::WindlassOrder>(&order))
        return {windlass->brake, windlass->speed_lever, windlass->clutch_in ? 1.0 : 0.0,
                windlass->stopper_closed ? 1.0 : 0.0, windlass->emergency_stop ? 1.0 : 0.0};
    const auto& helm = std::get<exercise::HelmOrder>(order);
    return {helm.engine, helm.rudder, helm.bow_thruster, helm.stern_thruster, 0};
}

std::array<double, 5> values_of(const dds::Mailbox::Sample& sample) {
    if (const auto* windlass = std::get_if<WindlassCommand>(&sample))
        return {windlass->brake(), windlass->speed_lever(), windlass->clutch_in() ? 1.0 : 0.0,
                windlass->stopper_closed() ? 1.0 : 0.0, windlass->emergency_stop() ? 1.0 : 0.0};
    const auto& helm = std::get<HelmCommand>(sample);
    return {helm.engine(), helm.rudder(), helm.bow_thruster(), helm.stern_thruster(), 0};
}

/// 0 port, 1 starboard, 2 helm; -1: no levers.
int group_of(const exercise::Order& order) {
    const auto group = run::LeverOwnership::levers_of(order);
    return group ? static_cast<int>(*group) : -1;
}

int group_of(const dds::Mailbox::Sample& sample) {
    if (const auto* windlass = std::get_if<WindlassCommand>(&sample)) return windlass->side();
    return std::holds_alternative<HelmCommand>(sample) ? 2 : -1;
}

std::string source_of(const dds::Mailbox::Sample& sample) {
    return std::visit([](const auto& one) { return one.origin().source().to_string(); }, sample);
}

std::uint64_t serial_of(const dds::Mailbox::Sample& sample) {
    return std::visit([](const auto& one) { return one.origin().serial(); }, sample);
}

} // namespace

void Checks::find_levers(const exercise::ExerciseDef& def, const exercise::Exercise& in) {
    for (const auto& tackle : def.tackle)
        levers_.at(static_cast<std::size_t>(tackle.side)).at =
            values_of(exercise::Order(in.levers(tackle.side)));
    levers_[2].at = values_of(exercise::Order(in.helm()));
}

void Checks::hears(const Sent& sent) {
    if (group_of(sent.sample) >= 0) heard_.push_back(sent);
}

void Checks::leaves(const wire::WriterId& writer) {
    left_.insert(writer);
}

void Checks::comes(const wire::WriterId& writer) {
    left_.erase(writer);
}

/// A writer is there no more whose words they may have been.
bool Checks::has_left(const Levers& levers) const {
    return std::ranges::any_of(levers.writers, [this](const auto& writer) { return left_.contains(writer); });
}

void Checks::forget_hands() {
    for (Levers& levers : levers_) {
        levers.source.clear();
        levers.instructor = false;
        levers.lay_there = !levers.hand.empty();
        levers.lay_since = levers.moved;
    }
}

/// Of what was heard, a late word of a writer whose later one was taken already is not, and what found the
/// mailbox full came behind all that found room.
void Checks::leave_out_what_was_not_taken(const run::Inbox& inbox) {
    auto taken = std::ranges::count_if(inbox.orders, [](const run::ReceivedOrder& order) {
        const auto* command = std::get_if<exercise::Order>(&order.what);
        return command != nullptr && group_of(*command) >= 0;
    });
    std::erase_if(heard_, [&](const Sent& sent) {
        std::uint64_t& last = serials_[sent.writer];
        if (taken == 0 || serial_of(sent.sample) <= last) return true;
        last = serial_of(sent.sample);
        --taken;
        return false;
    });
    if (taken != 0) fail("levers", "no order but those that were sent", fmt::format("{} more", taken));
}

void Checks::look_at_orders(const run::Session& session) {
    const auto begin_run = [&] {
        run_ = session.status().run;
        forget_hands();
        holders_ = {}, takings_ = {};
        run_began_ = true;
        ran_ = false;
        world_.tell(fmt::format("run {} begins at tick {}", run_, session.now_tick()));
        const run::CheckpointView* base = session.checkpoint();
        if (base == nullptr || base->run != run_)
            fail("kept", "a checkpoint at the beginning of each run", "none");
        // Of the checkpoints since the last look the newest is told: it may have orders of the run in it.
        State state{.tick = base->tick, .hash = base->state_hash};
        if (session.assessor().assesses()) { // an answer is in no other part of the state
            assess::Assessor assessor;
            exercise::read_checkpoint(base->data, {}, &assessor);
            state.assessment = assessment_of(assessor);
        }
        std::ranges::copy_if(session.orders(), std::back_inserter(state.behind),
                             [&](const run::OrderView& order) {
                                 return order.run == run_ && order.number <= base->orders_taken;
                             });
        if (state.behind.size() != base->orders_taken)
            fail("orders", fmt::format("{} of run {}", base->orders_taken, run_),
                 std::to_string(state.behind.size()));
        const std::uint64_t begins_at = state.behind.empty() ? base->tick : state.behind.front().tick;
        // Where a run begins with words for every lever, its state does not tell whether it was set up.
        const bool set_up = std::ranges::any_of(
            session.events(), [](const auto& event) { return event.code == "exercise.ready"; });
        if (set_up)
            begin_line(session);
        else
            leave_line();
        if (!(set_up ? begins_at == 0 && orders_of(line(), 0, state) : go_on_from(line(), begins_at, state)))
            fail("state", fmt::format("that of the undisturbed course at tick {}", base->tick),
                 fmt::format("{:016x} after a {}", base->state_hash, set_up ? "reset" : "restore"));
        branch(session, begins_at);
    };
    for (const run::OrderView& order : session.orders()) {
        if (order.run != run_ && order.run == session.status().run) begin_run();
        if (order.run > run_) continue; // of a run that another one followed in the same tick
        if (order.run != run_)
            fail("orders", fmt::format("of run {}", run_), fmt::format("of run {}", order.run));
        if (order.number != line().orders.size() - run_base_ + 1)
            fail("orders", fmt::format("number {}", line().orders.size() - run_base_ + 1),
                 fmt::format("number {}", order.number));
        look_at_levers(order, world_.now());
        line().orders.push_back(order);
        if (auto* levers = std::get_if<exercise::WindlassOrder>(&line().orders.back().command);
            levers && sabotage_order)
            levers->brake = 1 - levers->brake, sabotage_order = false;
        add(order.tick), add(order.source);
    }
    if (session.status().run != run_) begin_run();
}

/// Whose order it is, and whether a hand moved what moves.
void Checks::look_at_levers(const run::OrderView& order, double) {
    const int group = group_of(order.command);
    if (group < 0) return;
    Levers& levers = levers_.at(static_cast<std::size_t>(group));
    const auto ordered = values_of(order.command);
    const char* const name = run::name(static_cast<run::LeverGroup>(group));
    if (order.source == run::kServerName) { // leaves a windlass as its hand did
        auto left = levers.at;
        left[1] = 0;
        if (ordered != left) fail("levers", "the server moves no lever but the speed lever, to zero", name);
        levers.at = ordered;
        levers.source.clear();
        holders_.at(static_cast<std::size_t>(group)).clear();
        return;
    }
    // Taken in the order in which they came; some were not heard, as an instructor had the levers.
    const auto may_be = [&](const Sent& one) {
        if (group_of(one.sample) != group || source_of(one.sample) != order.source) return false;
        const auto values = values_of(one.sample);
        for (std::size_t k = 0; k < values.size(); ++k)
            if (ordered[k] != values[k] && ordered[k] != levers.at[k] && !(k == 1 && ordered[k] == 0))
                return false;
        return true;
    };
    const auto sent = std::find_if(heard_.begin() + taken_, heard_.end(), may_be);
    if (sent == heard_.end())
        fail("levers", fmt::format("an order to the {} that {} sent", name, order.source),
             "one that nobody sent since the last tick");
    taken_ = sent - heard_.begin() + 1;
    if (levers.instructor && !sent->instructor && listened_ - levers.heard <= kHandSilent)
        fail("levers", fmt::format("the instructor has the {}", name), order.source + " is heard");
    // A hand that lay there as the run began moves a lever by moving it behind its last word that was heard
    // before, or, where it had not been heard, behind its first in this run: a word on its way is heard late.
    if (levers.hand != order.source) {
        levers.hand = order.source;
        levers.lay_there = sent->moved_in_run != 0 && sent->moved_in_run != run_;
        levers.lay_since = sent->moved_at;
    }
    for (std::size_t k = 0; k < ordered.size(); ++k) {
        if (sent->moved_at[k] > levers.lay_since[k]) { // it follows its hand from now on, late words of a
            levers.lay_since[k] = kMoved;              // program that was killed included
            continue;
        }
        if (ordered[k] == levers.at[k] || (group < 2 && k == 1 && ordered[k] == 0) || !levers.lay_there)
            continue;
        fail("levers",
             fmt::format("lever {} of the {} stays at {:g} until its hand moves it", k, name, levers.at[k]),
             fmt::format("at {:g}, which {} moved {:.2f} s before", ordered[k], order.source,
                         world_.now() - sent->moved_at[k]));
    }
    levers.moved = sent->moved_at;
    levers.at = ordered;
    levers.source = order.source;
    std::string& holder = holders_.at(static_cast<std::size_t>(group));
    if (holder != order.source)
        takings_.at(static_cast<std::size_t>(group))
            .push_back({order.source, std::exchange(holder, order.source)});
    levers.instructor = sent->instructor && !left_.contains(sent->writer); // his last word may come late
    levers.writers.clear();
    for (auto one = sent; one != heard_.end(); ++one)
        if (may_be(*one)) levers.writers.insert(one->writer);
    levers.heard = listened_;
}

/// A speed lever that is not at zero has a hand, or had one until a moment ago.
void Checks::look_for_silence(const run::Session& session) {
    constexpr double kLongest = kHandSilent + 0.2 + 0.15; // s
    if (!session.running()) {
        ran_ = false;
        return;
    }
    if (!std::exchange(ran_, true)) ran_since_ = listened_;
    for (const auto& tackle : session.def().tackle) {
        const Levers& levers = levers_.at(static_cast<std::size_t>(tackle.side));
        const double silent = listened_ - std::max(levers.heard, ran_since_);
        if (levers.at[1] != 0 && silent > kLongest)
            fail("levers", fmt::format("speed lever at zero after {:g} s of silence", kLongest),
                 fmt::format("at {:g} after {:.2f} s", levers.at[1], silent));
    }
}

/// Whose hand has which levers is told as it takes them, with whose they were, and once.
void Checks::look_at_takings(const run::Session& session) {
    for (std::size_t group = 0; group < takings_.size(); ++group) {
        const int side =
            group == static_cast<std::size_t>(run::LeverGroup::helm) ? -1 : static_cast<int>(group);
        const char* const name = run::name(static_cast<run::LeverGroup>(group));
        std::vector<std::string> told;
        for (const auto& event : session.events()) {
            if (event.side != side) continue;
            if (event.code == "levers.taken") told.push_back(event.text);
            if (event.code == "levers.lost") holders_.at(group).clear(); // behind all that was taken
        }
        std::vector<Taking> takings = std::exchange(takings_.at(group), {});
        if (!takings.empty() && std::exchange(sabotage_taking, false)) takings.front().source = "nobody";
        const auto text_of = [&](const Taking& taking, const char* how) {
            return fmt::format("{} has the {}{}", taking.source, name,
                               taking.before.empty() ? "" : how + taking.before);
        };
        // Of a run that another one followed in the same tick they stand before those of the present one.
        if (run_began_ && told.size() > takings.size())
            told.erase(told.begin(), told.end() - static_cast<std::ptrdiff_t>(takings.size()));
        if (told.size() != takings.size())
            fail("takings", fmt::format("{} of the {} told", takings.size(), name),
                 std::to_string(told.size()));
        for (std::size_t k = 0; k < told.size(); ++k) {
            counts_.takings += takings[k].before.empty() ? 0 : 1;
            if (told[k] != text_of(takings[k], ", taken from ") &&
                told[k] != text_of(takings[k], ", handed back by "))
                fail("takings", text_of(takings[k], ", taken from "), told[k]);
        }
    }
}

} // namespace windlass::sim
