#include "station/seen.hpp"

#include "station/format.hpp"
#include "station/names.hpp"
#include "words/words.hpp"

namespace windlass::station {

namespace {

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

} // namespace windlass::station
