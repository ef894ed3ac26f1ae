#include "instructor_console/hold.hpp"

#include "station/lever_sender.hpp"
#include "station/options.hpp"

#include <fmt/format.h>

#include <thread>

namespace windlass::console {

using station::Picture;
using namespace std::chrono_literals;

namespace {

/// Without the levers for so long, somebody else has them: a hand that is late is passed over for a moment.
constexpr auto kLost = 2s;

void fulfil(const LeverWish& wish, station::WindlassLevers& levers) {
    levers.brake = wish.brake.value_or(levers.brake);
    levers.speed_lever = wish.speed_lever.value_or(levers.speed_lever);
    levers.clutch_in = wish.clutch_in.value_or(levers.clutch_in);
    levers.stopper_closed = wish.stopper_closed.value_or(levers.stopper_closed);
    levers.emergency_stop = wish.emergency_stop.value_or(levers.emergency_stop);
}

/// Who has the levers, as the server told last; empty: nobody, or nothing was told.
std::string owner(const Picture& picture, int side) {
    for (auto event = picture.events.kept.rbegin(); event != picture.events.kept.rend(); ++event) {
        if (event->side() != side) continue;
        const std::string text = event->text().to_string();
        if (event->code() == "levers.lost") return "";
        if (event->code() == "levers.taken") return text.substr(0, text.find(" has the "));
    }
    return "";
}

/// Serials of what this hand has sent: another of the same name, and there may be one, has others.
class OwnSerials {
public:
    explicit OwnSerials(station::Client& client) : client_(client), first_(client.next_origin().serial()) {}
    bool include(const WindlassCommand& levers) const {
        const auto serial = levers.origin().serial();
        return levers.origin().source().to_string() == client_.name() && serial > first_ &&
               serial < client_.next_origin().serial();
    }

private:
    station::Client& client_;
    std::uint64_t first_;
};

/// Whoever is heard, or has the levers, in place of this hand.
std::string other(const Picture& picture, int side, const station::Client& client, bool own_heard) {
    if (const auto told = owner(picture, side); !told.empty() && told != client.name()) return told;
    const auto& levers = picture.tackle[static_cast<std::size_t>(side)].instructor_levers;
    if (levers && !own_heard) {
        const auto heard = levers->origin().source().to_string();
        return heard == client.name() ? "another station named " + heard : heard;
    }
    return "";
}

} // namespace

std::optional<std::string> hold_levers(station::Client& client, int side, const LeverWish& wish,
                                       double duration, double timeout,
                                       const std::function<void(const std::string&)>& told) {
    const char* name = side == SIDE_PORT ? "port" : "starboard";
    const auto known = [side](const Picture& now) {
        return bool(now.tackle.at(static_cast<std::size_t>(side)).load);
    };
    if (!client.wait(std::chrono::duration<double>{timeout}, known))
        return fmt::format("the exercise has no {} windlass: nothing heard of one in {:g} s", name, timeout);
    const OwnSerials own(client);
    {
        station::LeverSender levers{client, side};
        levers.take_windlass([&wish](station::WindlassLevers& set) { fulfil(wish, set); });
        const double speed_lever = levers.get().windlass.speed_lever;
        const auto heard = [&](const Picture& now) {
            const auto& at = now.tackle[static_cast<std::size_t>(side)].instructor_levers;
            return at && own.include(*at);
        };
        // Heard as the strongest of the instructors here, told so by the server, and obeyed there.
        const auto mine = [&](const Picture& now) { return heard(now) && owner(now, side) == client.name(); };
        const bool given = client.wait(std::chrono::duration<double>{timeout}, [&](const Picture& now) {
            return mine(now) && now.tackle[static_cast<std::size_t>(side)].load->speed_lever() == speed_lever;
        });
        if (!given) {
            const Picture now = client.picture();
            const std::string who = other(now, side, client, heard(now));
            return who.empty()
                       ? fmt::format("the server did not give the {} windlass in {:g} s", name, timeout)
                       : fmt::format("{} has the {} windlass, and kept it for {:g} s", who, name, timeout);
        }
        told(fmt::format("{} has the {} windlass", client.name(), name));
        const auto until = station::Clock::now() + std::chrono::duration<double>{duration};
        auto last_mine = station::Clock::now(), last_look = last_mine;
        while (!station::stop_asked() && (duration <= 0 || station::Clock::now() < until)) {
            std::this_thread::sleep_for(20ms);
            const Picture now = client.picture();
            const auto look = station::Clock::now();
            // A hand that hung itself finds the levers with the next, and has to be heard again first.
            if (mine(now) || look - last_look > kLost / 2) last_mine = look;
            last_look = look;
            if (look - last_mine < kLost) continue;
            const std::string who = other(now, side, client, heard(now));
            if (!who.empty()) return fmt::format("{} has taken the {} windlass", who, name);
        }
    } // the writer goes, and with it the claim
    told(fmt::format("{} windlass handed back", name));
    return std::nullopt;
}

} // namespace windlass::console
