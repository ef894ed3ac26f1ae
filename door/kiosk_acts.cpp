// What devices that stand at one seat ask, and what the owner does with them: kiosks.

#include "door/asked.hpp"
#include "door/door_host.hpp"
#include "door/secrets.hpp"

namespace windlass::door {

using gateway::Verdict;
using nlohmann::json;

namespace {

constexpr int kKioskGood = 400 * kDay; // s: as long as browsers keep a cookie at all

} // namespace

/// A device is that kiosk's from now on.
Verdict DoorHost::open_kiosk(const Who& who, const json& asked) {
    const std::string network = network_of(who.address);
    not_too_often(wrong_codes_, network);
    const std::string invitation = digest(text_of(asked, "key")), secret = make_secret();
    Who now = who;
    try {
        now.kiosk = kiosks_.open(invitation, digest(secret));
    } catch (const Denied&) {
        wrong_codes_.wrong(network, Clock::now());
        audit_.write("kiosk.failed", {{"address", who.address}});
        throw;
    }
    audit_.write("kiosk.open", {{"name", now.kiosk->name}, {"address", who.address}});
    Verdict verdict = answer(me(now));
    verdict.headers = {{"Set-Cookie", cookie(who.way, kiosk_cookie_name(who.way), secret, kKioskGood)}};
    return verdict;
}

/// The device's seat of whatever class is under way; else why it has none, until it asks again.
Verdict DoorHost::sit(const Who& who) {
    if (!who.kiosk) throw Denied(401, "this device is no kiosk any more: ask the owner for an address");
    if (who.trainee || who.staff) return answer(me(who));
    const auto& [name, exercise, place, invitation, key] = *who.kiosk;
    json told = me(who);
    try {
        if (people_.find(name) != nullptr) throw Denied(409, "an instructor has that name");
        const auto* its_class = book_.with_seat(name, exercise, place);
        if (its_class == nullptr) return answer(told);
        const std::string id = its_class->id;
        const Trainee seated = book_.sit(id, name, key, exercise, place);
        keep_classes();
        audit_.write("kiosk.sit", {{"name", name},
                                   {"class", id},
                                   {"exercise", seated.exercise},
                                   {"place", name_of(seated.place)},
                                   {"address", who.address}});
        Who now = who;
        now.trainee = book_.seated(key);
        return answer(me(now));
    } catch (const Denied& denied) {
        told["why"] = denied.what();
        return answer(told);
    }
}

/// What the owner does with kiosks. The key is told here and nowhere else.
Verdict DoorHost::keep_kiosks(const Who& who, const json& asked) {
    const std::string what = text_of(asked, "do"), name = name_in(asked);
    json done{{"by", who.staff->name}, {"name", name}}, told;
    if (what == "put") {
        const auto place = place_named(text_of(asked, "place"));
        if (!place) throw Denied(400, "place: ship, forecastle, bridge or watch");
        if (people_.find(name) != nullptr) throw Denied(409, "an instructor has that name: choose another");
        const std::string key = make_key();
        const int exercise = number_of(asked, "exercise");
        kiosks_.put({.name = name, .exercise = exercise, .place = *place, .invitation = digest(key)});
        done.update({{"exercise", exercise}, {"place", name_of(*place)}});
        told = {{"key", key}};
    } else if (what == "remove") {
        kiosks_.remove(name);
    } else {
        throw Denied(400, "do: put or remove");
    }
    audit_.write("kiosk." + what, std::move(done));
    turn_out_kiosks();
    told.update(kiosks());
    return answer(told);
}

json DoorHost::kiosks() const {
    json list = json::array();
    for (const auto& [name, each] : kiosks_.all())
        list.push_back({{"name", name},
                        {"exercise", each.exercise},
                        {"place", name_of(each.place)},
                        {"opened", each.invitation.empty()}});
    return {{"kiosks", std::move(list)}};
}

/// Those that the owner or the command line has taken back.
void DoorHost::turn_out_kiosks() {
    try {
        kiosks_.refresh();
    } catch (const std::exception& error) {
        log_.tell(error.what());
    }
    for (const std::string& key : kiosks_.take_revoked()) {
        if (const auto seated = book_.seated(key)) {
            book_.remove(seated->class_id, seated->trainee.name);
            keep_classes();
        }
        send_away(key, "this device is no kiosk any more");
    }
}

} // namespace windlass::door
