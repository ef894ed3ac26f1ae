#include "sim/network.hpp"

#include <algorithm>

namespace windlass::sim {

namespace {

constexpr double kDeadline = 1; // s, of levers: then the next strongest is heard
constexpr double kLease = 5;    // s, of silence: then a program is missed; of idl/network.cpp a quarter,
                                // so that many are

/// Levers that have one owner at a time; -1: none.
int levers_of(const dds::Mailbox::Sample& sample) {
    if (const auto* windlass = std::get_if<WindlassCommand>(&sample)) return windlass->side();
    return std::holds_alternative<HelmCommand>(sample) ? 2 : -1;
}

} // namespace

Network::Network(World& world) : world_(world), bad_(world.chance().in(0.25)) {}

double Network::arrival(const wire::WriterId& writer) {
    Chance& chance = world_.chance();
    const double now = world_.now();
    if (now > congested_until_ && chance.in(0.0003)) congested_until_ = now + chance.spread(0.2, 8);
    const double sent_on = chance.in(0.9) ? now : std::max(now, congested_until_);
    const double arrives = sent_on + chance.spread(0.0002, 0.02);
    double& last = last_[writer];
    last = std::max(last, arrives);
    return bad_ && chance.in(0.05) ? arrives + chance.spread(0.01, 2) : last;
}

void Network::send(Sent sent) {
    Chance& chance = world_.chance();
    sent.at = world_.now();
    if (const int levers = levers_of(sent.sample); levers >= 0 && sent.instructor)
        strongest_[levers] = std::max(strongest_[levers], sent.strength);
    if (bad_ && chance.in(0.02)) return;
    const int copies = bad_ && chance.in(0.02) ? 2 : 1;
    for (int k = 0; k < copies; ++k)
        world_.at(arrival(sent.writer), [this, sent] { arrive(sent); });
}

int Network::outrank(int levers) {
    return strongest_[levers] + 1;
}

void Network::leave(const wire::WriterId& writer) {
    world_.at(arrival(writer), [this, writer] { miss(writer); });
}

void Network::hold_up(const wire::WriterId& writer, double until) {
    const double missed = world_.now() + kLease;
    if (until <= missed) return;
    world_.at(missed, [this, writer] { miss(writer); });
    world_.at(until, [this, writer] {
        if (met_) met_(writer, true);
    });
}

void Network::miss(const wire::WriterId& writer) {
    for (auto& [levers, owner] : owners_)
        if (owner.writer == writer) owner = {};
    if (met_) met_(writer, false);
}

void Network::serve(Heard heard, Met met) {
    heard_ = std::move(heard);
    met_ = std::move(met);
    served_since_ = world_.now();
    owners_.clear();
}

void Network::arrive(const Sent& sent) {
    if (sent.at < served_since_) return;
    if (const int levers = levers_of(sent.sample); levers >= 0) {
        Owner& owner = owners_[{levers, sent.instructor}];
        const bool silent = world_.now() - owner.heard > kDeadline;
        if (owner.writer != sent.writer && !silent && sent.strength <= owner.strength) return;
        owner = {sent.writer, sent.strength, world_.now()};
        if (overheard_) overheard_(sent);
    }
    if (heard_) heard_(sent);
}

} // namespace windlass::sim
