#include "station/format.hpp"
#include "station/names.hpp"
#include "station/screen_page.hpp"

namespace windlass::station {

namespace {

std::string yes(bool value, const char* if_true, const char* if_false) {
    return value ? if_true : if_false;
}

} // namespace

template <class Sample>
void windlass_levers(Page& page, const Latest<WindlassCommand>& levers, const Sample& now) {
    const auto set = [&levers](const std::string& text) { return levers ? text : std::string{"-"}; };
    int row = kLeverRows;
    page.put(row, 1, "LEVER           SET       NOW", Style::label);
    page.lever(++row, "brake", set(percent(levers->brake())), percent(now.brake_position()));
    page.lever(++row, "speed lever", set(lever(levers->speed_lever())), lever(now.speed_lever()));
    page.lever(++row, "clutch", set(yes(levers->clutch_in(), "in", "out")), std::string{name(now.clutch())});
    page.lever(++row, "stopper", set(yes(levers->stopper_closed(), "on", "off")),
               yes(now.stopper_closed(), "on", "off"));
    page.lever(++row, "emergency stop", set(yes(levers->emergency_stop(), "ON", "off")),
               yes(now.emergency_stop(), "ON", "off"));
}

template <class Sample>
void helm_levers(Page& page, const Latest<HelmCommand>& helm, const Sample& now) {
    const auto set = [&helm](const std::string& text) { return helm ? text : std::string{"-"}; };
    page.lever(16, "engine", set(percent(helm->engine())), percent(now.engine()));
    page.lever(17, "rudder", set(rudder(helm->rudder())), rudder(now.rudder()));
    page.lever(18, "bow thruster", set(percent(helm->bow_thruster())), percent(now.bow_thruster()));
}

template <class Sample>
void drive_lamps(Page& page, int row, const Sample& now) {
    const bool bad = !now.power() || now.tripped() || now.emergency_stop();
    page.figure(row, "drive",
                !now.power()           ? "NO POWER"
                : now.emergency_stop() ? "EMERGENCY STOP"
                : now.tripped()        ? "TRIPPED: speed lever to zero resets it, once cool"
                                       : "ready",
                bad ? Style::alarm : Style::good);
}

template void windlass_levers(Page&, const Latest<WindlassCommand>&, const WindlassLoad&);
template void windlass_levers(Page&, const Latest<WindlassCommand>&, const ForecastleView&);
template void helm_levers(Page&, const Latest<HelmCommand>&, const ShipState&);
template void helm_levers(Page&, const Latest<HelmCommand>&, const BridgeView&);
template void drive_lamps(Page&, int, const WindlassLoad&);
template void drive_lamps(Page&, int, const ForecastleView&);

} // namespace windlass::station
