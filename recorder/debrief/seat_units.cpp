#include "recorder/debrief/seat_units.hpp"

#include "common/figure_text.hpp"
#include "station/format.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <regex>

namespace windlass::debrief {

namespace {

/// Of small figures a tenth: what was 7.3 m/min, and 7.2 at most, is not "7, at most 7".
std::string to_tenths_if_small(double value) {
    return station::number(value, std::abs(value) < 9.95 ? 1 : 0);
}

enum class Whose { nobody, cable, ship };

Whose named_last(const std::string& text) {
    static const std::regex words(
        R"(\b(?:(cables?|chains?|gypsy)|winds?|streams?|currents?|ship|she|ahead|astern|ground|water)\b)",
        std::regex::icase);
    Whose found = Whose::nobody;
    for (std::sregex_iterator at(text.begin(), text.end(), words), end; at != end; ++at)
        found = (*at)[1].matched ? Whose::cable : Whose::ship;
    return found;
}

Whose named_first(const std::string& text) {
    for (std::size_t end = text.find(' ');; end = text.find(' ', end + 1)) {
        const Whose found = named_last(text.substr(0, end));
        if (found != Whose::nobody || end == std::string::npos) return found;
    }
}

bool ends_a_sentence(const std::string& text, std::size_t at) {
    const bool last = at + 1 >= text.size() || text[at + 1] == ' ';
    return last && std::string_view(".;!?").find(text[at]) != std::string_view::npos;
}

/// Whose speed stands at that place: nearest before it in its sentence, else after it.
Whose whose(const std::string& text, std::size_t from, std::size_t to) {
    std::size_t begin = from, end = to;
    while (begin > 0 && !ends_a_sentence(text, begin - 1))
        --begin;
    while (end < text.size() && !ends_a_sentence(text, end))
        ++end;
    const Whose before = named_last(text.substr(begin, from - begin));
    return before != Whose::nobody ? before : named_first(text.substr(to, end - to));
}

std::string without_unit(const std::string& text) {
    return text.substr(0, text.find(' '));
}

} // namespace

std::string in_seat_units(const std::string& text) {
    static const std::regex figures(
        R"((^|[^\d.])(\d+(?:\.\d+)?)(?:( and | to )(\d+(?:\.\d+)?))? (m/s|kN)(?![\w/]))");
    std::string told;
    auto copied = text.begin();
    for (std::sregex_iterator at(text.begin(), text.end(), figures), end; at != end; ++at) {
        const std::smatch& found = *at;
        const auto from = static_cast<std::size_t>(found.position(2));
        const auto to = static_cast<std::size_t>(found.position(0) + found.length(0));
        const bool load = found[5] == "kN";
        const Whose of = load ? Whose::nobody : whose(text, from, to);
        if (!load && of == Whose::nobody) continue;
        const auto shown = [&](const std::string& figure) {
            const double value = std::strtod(figure.c_str(), nullptr);
            return load                 ? station::tonnes(value * words::units::kilonewton)
                   : of == Whose::cable ? cable_speed_text(value)
                                        : to_tenths_if_small(value / words::units::knot) + " kn";
        };
        told.append(copied, found[2].first);
        if (found[3].matched)
            told += without_unit(shown(found[2])) + found[3].str() + shown(found[4]);
        else
            told += shown(found[2]);
        copied = found[0].second;
    }
    return told.append(copied, text.end());
}

std::string cable_speed_text(double speed) {
    return to_tenths_if_small(speed / words::units::metre_a_minute) + " m/min";
}

std::string shackles_text(double metres) {
    return figure_text(metres / words::units::shackle, "shackles");
}

SeatUnit seat_unit(const std::string& unit, const std::string& of) {
    if (unit == "N") return {"t", 1 / words::units::tonne};
    if (unit == "N/s") return {"t/s", 1 / words::units::tonne};
    if (unit == "K") return {"\u00b0C", 1, -words::limits::ice_point};
    if (unit == "m/s" && of == "cable_speed") return {"m/min", 1 / words::units::metre_a_minute};
    if (unit == "m/s" && !of.empty()) return {"kn", 1 / words::units::knot};
    return {unit};
}

std::string limited_figure(double value, const std::string& unit, const std::string& of) {
    const SeatUnit shown = seat_unit(unit, of);
    return to_tenths_if_small(value * shown.factor + shown.offset);
}

std::string limited_text(double value, const std::string& unit, const std::string& of) {
    const SeatUnit shown = seat_unit(unit, of);
    if (shown.name == unit || unit == "K") return figure_text(value, unit);
    return limited_figure(value, unit, of) + ' ' + shown.name;
}

} // namespace windlass::debrief
