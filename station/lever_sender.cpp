#include "station/lever_sender.hpp"

#include "idl/moved_in_run.hpp"

#include <algorithm>

namespace windlass::station {

namespace {

using namespace std::chrono_literals;

// Twenty words within the silence after which a weaker hand's word counts (kCommandDeadline).
constexpr auto kResendPeriod = 50ms;
constexpr auto kLeaveTime = 1s;

void keep_in_range(LeverSet& set) {
    const auto keep = [](double& value, double low, double high) { value = std::clamp(value, low, high); };
    keep(set.windlass.brake, 0, 1);
    keep(set.windlass.speed_lever, -1, 1);
    keep(set.helm.engine, -1, 1);
    keep(set.helm.rudder, -kRudderMax, kRudderMax);
    keep(set.helm.bow_thruster, -1, 1);
    keep(set.helm.stern_thruster, -1, 1);
}

WindlassLevers levers_of(const WindlassCommand& command) {
    return {.brake = command.brake(),
            .speed_lever = command.speed_lever(),
            .clutch_in = command.clutch_in(),
            .stopper_closed = command.stopper_closed(),
            .emergency_stop = command.emergency_stop()};
}

/// Where they are; WindlassLoad and ForecastleView name them alike.
template <class Sample>
WindlassLevers levers_now(const Sample& now) {
    return {.brake = now.brake_position(),
            .speed_lever = now.speed_lever(),
            .clutch_in = now.clutch() != CLUTCH_OUT,
            .stopper_closed = now.stopper_closed(),
            .emergency_stop = now.emergency_stop()};
}

/// As they stand, not what engine, rudder and thrusters do.
HelmLevers helm_of(const BridgeView& view) {
    return {.engine = view.engine_ordered(),
            .rudder = view.rudder_ordered(),
            .bow_thruster = view.bow_thruster_ordered(),
            .stern_thruster = view.stern_thruster_ordered()};
}

WindlassCommand to_command(const WindlassLevers& levers, int side, const Origin& origin) {
    WindlassCommand command;
    command.side(side);
    command.origin(origin);
    command.brake(levers.brake);
    command.speed_lever(levers.speed_lever);
    command.clutch_in(levers.clutch_in);
    command.stopper_closed(levers.stopper_closed);
    command.emergency_stop(levers.emergency_stop);
    return command;
}

HelmCommand to_command(const HelmLevers& levers, const Origin& origin) {
    HelmCommand command;
    command.origin(origin);
    command.engine(levers.engine);
    command.rudder(levers.rudder);
    command.bow_thruster(levers.bow_thruster);
    command.stern_thruster(levers.stern_thruster);
    return command;
}

} // namespace

bool levers_known(const Picture& picture, int side) {
    const auto& tackle = picture.tackle.at(static_cast<std::size_t>(side));
    return tackle.view || tackle.load;
}

LeverSender::LeverSender(Client& client, int side, int strength) : client_{client}, side_{side} {
    const bool instructor = client.seat() == Seat::instructor;
    if (instructor || on_forecastle(client.seat()))
        windlass_.emplace(client.participant(),
                          instructor ? wire::topics::instructor_windlass_command
                                     : wire::topics::windlass_command,
                          strength);
    if (instructor || on_bridge(client.seat()))
        helm_.emplace(client.participant(),
                      instructor ? wire::topics::instructor_helm_command : wire::topics::helm_command,
                      strength);
    sender_ = std::thread{[this] { send_until_stopped(); }};
}

LeverSender::~LeverSender() {
    {
        const std::scoped_lock lock{mutex_};
        stop_ = true;
    }
    moved_.notify_all();
    sender_.join();
    // Whoever lets go of the levers leaves them as set, so the last orders must have arrived.
    if (windlass_) windlass_->wait_acknowledged(kLeaveTime);
    if (helm_) helm_->wait_acknowledged(kLeaveTime);
}

LeverSet LeverSender::get() const {
    const Picture picture = client_.picture();
    const auto& tackle = picture.tackle.at(static_cast<std::size_t>(side_));
    LeverSet set;
    if (tackle.view) set.windlass = levers_now(*tackle.view);
    if (tackle.load) set.windlass = levers_now(*tackle.load);
    const double speed_lever = set.windlass.speed_lever;
    if (const auto& levers = tackle.levers_in_force()) set.windlass = levers_of(*levers);
    // What was commanded last stands, but for this one, which has sprung back if that hand is gone.
    if (tackle.view || tackle.load) set.windlass.speed_lever = speed_lever;
    if (picture.bridge) set.helm = helm_of(*picture.bridge);
    keep_in_range(set);
    const std::scoped_lock lock{mutex_};
    return {windlass_taken_ ? set_.windlass : set.windlass, helm_taken_ ? set_.helm : set.helm};
}

void LeverSender::move(const std::function<void(LeverSet&)>& change) {
    const LeverSet before = get();
    LeverSet after = before;
    change(after);
    keep_in_range(after);
    const std::uint64_t run = run_heard();
    {
        const std::scoped_lock lock{mutex_};
        set_ = after;
        windlass_taken_ |= after.windlass != before.windlass;
        helm_taken_ |= after.helm != before.helm;
        if (after.windlass != before.windlass) windlass_run_ = run;
        if (after.helm != before.helm) helm_run_ = run;
        changed_ = true;
    }
    moved_.notify_all();
}

void LeverSender::take_windlass(const std::function<void(WindlassLevers&)>& change) {
    LeverSet set = get();
    change(set.windlass);
    keep_in_range(set);
    const std::uint64_t run = run_heard();
    {
        const std::scoped_lock lock{mutex_};
        set_.windlass = set.windlass;
        windlass_taken_ = changed_ = true;
        windlass_run_ = run;
    }
    moved_.notify_all();
}

/// Of the exercise's status as it was heard last; 0: it was not.
std::uint64_t LeverSender::run_heard() const {
    const auto status = client_.picture().status;
    return status ? status->run() : 0;
}

int LeverSender::matched() const {
    if (!windlass_) return helm_ ? helm_->matched() : 0;
    return helm_ ? std::min(windlass_->matched(), helm_->matched()) : windlass_->matched();
}

void LeverSender::send_until_stopped() {
    std::unique_lock lock{mutex_};
    while (!stop_ || changed_) { // the last move is sent before stopping
        const LeverSet set = set_;
        const bool windlass = windlass_taken_ && windlass_, helm = helm_taken_ && helm_;
        const std::uint64_t windlass_run = windlass_run_, helm_run = helm_run_;
        changed_ = false;
        lock.unlock(); // a write may wait; whoever moves a lever must not
        if (windlass) {
            wire::tell_moved_in_run(client_.participant(), windlass_->id(), windlass_run);
            windlass_->write(to_command(set.windlass, side_, client_.next_origin()));
        }
        if (helm) {
            wire::tell_moved_in_run(client_.participant(), helm_->id(), helm_run);
            helm_->write(to_command(set.helm, client_.next_origin()));
        }
        lock.lock();
        moved_.wait_for(lock, kResendPeriod, [this] { return stop_ || changed_; });
    }
}

} // namespace windlass::station
