#include "instructor_console/hold.hpp"

#include "station/lever_sender.hpp"
#include "station/options.hpp"

#include <fmt/format.h>

#include <thread>

namespace windlass::console {

using station::Picture;
using namespace std::chrono_literals;

namespace {

constexpr int kStrength = 20; // above a trainee's 10

void fulfil(const LeverWish& wish, station::WindlassLevers& levers) {
    levers.brake = wish.brake.value_or(levers.brake);
    levers.speed_lever = wish.speed_lever.value_or(levers.speed_lever);
    levers.clutch_in = wish.clutch_in.value_or(levers.clutch_in);
    levers.stopper_closed = wish.stopper_closed.value_or(levers.stopper_closed);
    levers.emergency_stop = wish.emergency_stop.value_or(levers.emergency_stop);
}

} // namespace

bool hold_levers(station::Client& client, int side, const LeverWish& wish, double duration, double timeout,
                 const std::function<void(const std::string&)>& told) {
    const auto known = [side](const Picture& now) {
        return bool(now.tackle.at(static_cast<std::size_t>(side)).load);
    };
    if (!client.wait(std::chrono::duration<double>{timeout}, known)) return false; // no such windlass
    const char* name = side == SIDE_PORT ? "port" : "starboard";
    {
        station::LeverSender levers{client, side, kStrength};
        levers.take_windlass([&wish](station::WindlassLevers& set) { fulfil(wish, set); });
        const double speed_lever = levers.get().windlass.speed_lever;
        // Heard as the strongest here, and obeyed there.
        const bool mine = client.wait(std::chrono::duration<double>{timeout}, [&](const Picture& now) {
            const auto& tackle = now.tackle[static_cast<std::size_t>(side)];
            return tackle.levers && tackle.levers->origin().source().to_string() == client.name() &&
                   tackle.load->speed_lever() == speed_lever;
        });
        if (!mine) return false;
        told(fmt::format("{} has the {} windlass", client.name(), name));
        const auto until = station::Clock::now() + std::chrono::duration<double>{duration};
        while (!station::stop_asked() && (duration <= 0 || station::Clock::now() < until))
            std::this_thread::sleep_for(20ms);
    } // the writer goes, and with it the claim
    told(fmt::format("{} windlass handed back", name));
    return true;
}

} // namespace windlass::console
