#pragma once
// What people read and hear, and the names in files: the tables of words.json, and sentences made of them.
// So far only its tests use this header: server, stations, recorder and pages still have tables of their own.

#include "words/tables.hpp"

#include <cstddef>
#include <string>

namespace windlass::words {

/// Place of the row of that name; -1: there is none.
template <class Row, std::size_t N>
constexpr int place_of(const std::array<Row, N>& rows, std::string_view name) {
    for (std::size_t k = 0; k < N; ++k)
        if (rows[k].name == name) return static_cast<int>(k);
    return -1;
}

/// The row of a code; null: there is no such event.
constexpr const Event* find_event(std::string_view code) {
    for (const Event& event : kEventsWaitedFor)
        if (event.name == code) return &event;
    for (const Event& event : kEventsTold)
        if (event.name == code) return &event;
    return nullptr;
}

/// An event by its code. One that is not in words.json does not compile.
class EventCode {
public:
    // NOLINTNEXTLINE(google-explicit-constructor): a literal stands for the code that it is
    consteval EventCode(const char* code) : row_(find_event(code)) {
        if (row_ == nullptr) throw "words.json has no event of this code";
    }

    const Event& row() const { return *row_; }

private:
    const Event* row_;
};

constexpr const UnitWords& words_of(Unit unit) {
    return kUnits[static_cast<std::size_t>(unit)];
}

/// "3 shackles", "1 shackle", "20 m".
std::string figure_text(double value, Unit unit);

/// An order of the bridge as it is written: "pay out port cable to 3 shackles in the pipe". side: 0 port, 1
/// starboard, -1 both. Empty for an order in own words, and for a code that words.json does not have.
std::string order_text(std::size_t code, int side, double value);

/// What a report says; enumerators by their place.
struct ReportSaid {
    std::size_t code = 0;
    int side = -1; ///< 0 port, 1 starboard, -1 neither
    double value = 0;
    int lead = 0; ///< clock hour; 0: not given
    std::size_t stay = 0, growing = 0, weight = 0;
    std::size_t order_code = 0; ///< of a repeat
    std::string_view text = {}; ///< in own words, beside it
};

/// A report as it is written: "port cable is leading 11 o'clock, short stay"; "repeats: let go port anchor".
std::string report_text(const ReportSaid& report);

/// The usual text of an event, with its figure where the text has one.
std::string event_text(const Event& event, double value);

/// Place of the stay in kStay, by how far (deg) the cable points below the horizontal at the lip.
constexpr std::size_t stay_at(double top_angle_deg) {
    return top_angle_deg > limits::stay_up_and_down ? 0
           : top_angle_deg > limits::stay_short     ? 1
           : top_angle_deg > limits::stay_medium    ? 2
                                                    : 3;
}

} // namespace windlass::words
