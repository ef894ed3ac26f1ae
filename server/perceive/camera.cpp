// What the bridge's camera on the foremast shows of the forecastle.

#include "server/perceive/perceive.hpp"
#include "server/perceive/senses.hpp"
#include "words/words.hpp"

namespace windlass::perceive {

namespace {

/// As a hand-wheel and a lever are made out from the mast; tuned.
constexpr double kLeverStep = 0.1;

/// Smoke and flames are seen; warmth and smell are not.
LiningSeen lining_in_picture(double temperature) {
    const LiningSeen seen = lining_noticed(temperature);
    return seen >= LINING_SMOKES ? seen : LINING_COOL;
}

} // namespace

bool perceive_camera(const exercise::Snapshot& from, const exercise::TackleView& tackle, ForecastleView& to) {
    if (!working(from.faults).cctv) return false;
    const exercise::WindlassView& windlass = tackle.windlass;
    to.side(static_cast<int>(tackle.side));
    to.tick(from.tick);
    to.time(from.time);

    to.brake_position(in_steps(windlass.brake_position, kLeverStep));
    to.speed_lever(in_steps(windlass.speed_lever, kLeverStep));
    to.clutch(static_cast<ClutchState>(windlass.clutch));
    to.stopper_closed(windlass.stopper_closed);
    to.stopper_sprung(windlass.stopper_sprung);

    // Men who are at it; those who are done, or wait for something, stand by like others.
    const exercise::DeckWorkView& work = tackle.deck_work;
    const bool goes_on = work.waits == words::DeckHindrance::none && work.left > 0;
    to.deck_work(goes_on ? static_cast<DeckWork>(work.set) : DECK_WORK_NONE);

    to.cable_speed_seen(in_steps(windlass.cable_speed, kSpeedSeenStep));
    to.gypsy_turn(windlass.gypsy_turn);
    to.gypsy_jumping(windlass.gypsy_jumping);
    to.marks().clear();
    for (const exercise::MarkView& mark : tackle.chain.marks) {
        if (mark.outboard > 0 || mark.outboard <= -words::limits::seen_on_deck) continue;
        CableMark& seen = to.marks().emplace_back();
        seen.shackle(mark.shackle);
        seen.outboard(static_cast<float>(in_steps(mark.outboard, kMarkStep)));
        seen.white_links(mark.white_links);
        seen.last(mark.last);
    }
    to.anchor(ANCHOR_SEEN_UNDER_WATER); // over the bow the picture ends
    to.lining(lining_in_picture(windlass.lining_temperature));
    return true;
}

} // namespace windlass::perceive
