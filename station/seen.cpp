#include "station/seen.hpp"

#include "station/format.hpp"
#include "station/names.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace windlass::station {

namespace {

/// m inboard of the lip that can be seen before the cable goes down the spurling pipe: as from lip to gypsy
/// on a common ship.
constexpr double kSeenOnDeck = 8;

bool in_sight(const CableMark& mark) {
    return mark.outboard() > -kSeenOnDeck;
}

} // namespace

std::optional<double> cable_out(const TacklePicture& tackle, Onlooker who) {
    if (who == Onlooker::instructor)
        return tackle.chain ? std::optional(tackle.chain->cable_out()) : std::nullopt;
    return tackle.load ? std::optional(tackle.load->cable_out_indicated()) : std::nullopt;
}

double cable_load(const WindlassLoad& load, Onlooker who) {
    return who == Onlooker::instructor ? load.hawse_tension() : load.gypsy_load_indicated();
}

double load_used(const WindlassLoad& load, Onlooker who) {
    return load.breaking_load() > 0 ? cable_load(load, who) / load.breaking_load() : 0;
}

const char* lining_seen(const WindlassLoad& load) {
    constexpr double kWarm = 333.15, kSmells = 423.15, kBurns = 673.15; // K; tuned
    const double now = load.lining_temperature();
    if (now < kWarm) return "cool";
    if (now < kSmells) return "warm";
    if (now < kSmoking) return "hot, smells";
    return now < kBurns ? "SMOKING" : "FLAMES";
}

std::string marks_in_sight(const ChainState& chain) {
    int in_water = 0;
    std::string above;
    for (const CableMark& mark : chain.marks()) { // nearest the anchor first
        if (!in_sight(mark)) break;
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

bool last_lengths_in_sight(const ChainState& chain) {
    bool last = false;
    for (const CableMark& mark : chain.marks())
        if (in_sight(mark)) last = mark.last();
    return last;
}

std::string anchor_seen(const AnchorState& anchor, Onlooker who) {
    const AnchorPhase phase = anchor.phase();
    if (who == Onlooker::instructor || phase == ANCHOR_HOUSED || phase == ANCHOR_ACOCKBILL)
        return words(phase);
    if (phase == ANCHOR_LOST || anchor.position().z() < 0) return "under water";
    return anchor.fouled() > 0 ? "in sight, foul" : "in sight, clear";
}

bool leads(const TacklePicture& tackle) {
    if (!tackle.anchor) return true;
    const AnchorPhase phase = tackle.anchor->phase();
    return phase != ANCHOR_HOUSED && phase != ANCHOR_ACOCKBILL;
}

bool noticed(const Event& event, const Picture& picture, Onlooker who) {
    if (who == Onlooker::instructor) return true;
    const std::string_view code = event.code().c_str();
    if (code.starts_with("fault.") || code == "environment.changed" || code == "cable.overstrained" ||
        code == "brake.glazed")
        return false;
    if (code != "anchor.digging_in" && code != "anchor.holding" && code != "anchor.dragging" &&
        code != "anchor.fouled")
        return true;
    if (event.side() != SIDE_PORT && event.side() != SIDE_STARBOARD) return true;
    const auto& anchor = picture.tackle.at(static_cast<std::size_t>(event.side())).anchor;
    return anchor && anchor->position().z() >= 0;
}

std::string in_the_ground(const AnchorState& anchor) {
    std::string text =
        fmt::format("flukes {} deg, {} in, {}", number(anchor.fluke_angle() * 180 / std::numbers::pi, 0),
                    percent(anchor.embedment()), name(anchor.soil()));
    if (anchor.breakout() > 0) text += fmt::format("; breaks out with {}", tonnes(anchor.breakout()));
    if (anchor.carried() > 0) text += fmt::format("; carries {}", tonnes(anchor.carried()));
    if (anchor.bent() > 0) text += fmt::format("; BENT {}", percent(anchor.bent()));
    if (anchor.fouled() > 0) text += "; FOUL";
    return text;
}

} // namespace windlass::station
