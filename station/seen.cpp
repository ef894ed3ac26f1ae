#include "station/seen.hpp"

#include "station/format.hpp"
#include "station/names.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <utility>

namespace windlass::station {

namespace {

/// A view has only such marks; the truth has those of the whole cable.
bool in_sight(const CableMark& mark) {
    return mark.outboard() > -words::limits::seen_on_deck;
}

/// As the server classes it in ChainState.stay; a view's angle comes in steps of 10 degrees.
Stay stay_of(double top_angle) {
    return static_cast<Stay>(words::stay_at(top_angle / words::units::degree));
}

std::string lead_and_stay(double lead_clock, Stay stay) {
    return stay == STAY_UP_AND_DOWN ? words(stay) : lead(lead_clock) + ", " + words(stay);
}

} // namespace

const char* words(LiningSeen lining) {
    switch (lining) {
    case LINING_COOL:
        return "cool";
    case LINING_WARM:
        return "warm";
    case LINING_SMELLS:
        return "hot, smells";
    case LINING_SMOKES:
        return "SMOKING";
    case LINING_BURNS:
        return "FLAMES";
    }
    return "unknown";
}

double cable_speed_told(const ForecastleView& view) {
    return view.counter_fitted() ? view.cable_speed_indicated() : view.cable_speed_seen();
}

double load_used(const ForecastleView& view) {
    return view.breaking_load() > 0 ? view.gypsy_load_indicated() / view.breaking_load() : 0;
}

double load_used(const WindlassLoad& load) {
    return load.breaking_load() > 0 ? load.hawse_tension() / load.breaking_load() : 0;
}

std::string lead_and_stay(const ChainState& chain) {
    return lead_and_stay(chain.lead_clock(), chain.stay());
}

std::string lead_and_stay(const ForecastleView& view) {
    return lead_and_stay(view.lead_clock(), stay_of(view.top_angle()));
}

bool leads(const TacklePicture& tackle) {
    if (!tackle.anchor) return true;
    const AnchorPhase phase = tackle.anchor->phase();
    return phase != ANCHOR_HOUSED && phase != ANCHOR_ACOCKBILL;
}

std::string marks_in_sight(const std::vector<CableMark>& marks) {
    int in_water = 0;
    std::string above;
    bool first = true;
    for (const CableMark& mark : marks) { // nearest the anchor first
        if (!in_sight(mark)) break;
        // What is nearer the anchor than the first mark in sight is under water.
        if (std::exchange(first, false)) in_water = mark.shackle() - 1;
        const bool on_deck = mark.outboard() <= 0;
        if (!on_deck && mark.position().z() < 0) {
            in_water = mark.shackle();
            continue;
        }
        above += fmt::format(", {} ", mark.shackle()) +
                 (on_deck ? fmt::format("on deck (white {0}+{0})", mark.white_links()) : "below the hawse");
    }
    if (in_water == 0) return above.empty() ? "no mark in sight" : "shackle" + above.substr(1);
    return fmt::format("{} shackle{} in the water", in_water, in_water == 1 ? "" : "s") + above;
}

bool last_lengths_in_sight(const std::vector<CableMark>& marks) {
    bool last = false;
    for (const CableMark& mark : marks)
        if (in_sight(mark)) last = mark.last();
    return last;
}

std::string in_the_ground(const AnchorState& anchor) {
    std::string text =
        fmt::format("flukes {} deg, {} in, {}", number(anchor.fluke_angle() / words::units::degree, 0),
                    percent(anchor.embedment()), name(anchor.soil()));
    if (anchor.breakout() > 0) text += fmt::format("; breaks out with {}", tonnes(anchor.breakout()));
    if (anchor.carried() > 0) text += fmt::format("; carries {}", tonnes(anchor.carried()));
    if (anchor.bent() > 0) text += fmt::format("; BENT {}", percent(anchor.bent()));
    if (anchor.fouled() > 0) text += "; FOUL";
    return text;
}

} // namespace windlass::station
