#pragma once
// What people read and hear, and the names in files: the tables of words.json, and sentences made of them.
// Server, stations, recorder and schemas have their words from here; the pages import words.json itself.

#include "words/tables.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace windlass::words {

/// words.json itself, for schemas that refer to it.
std::string_view json_text();

/// The names of rows, in their order.
template <class Row, std::size_t N>
constexpr std::array<std::string_view, N> names_of(const std::array<Row, N>& rows) {
    std::array<std::string_view, N> names;
    for (std::size_t k = 0; k < N; ++k)
        names[k] = rows[k].name;
    return names;
}

/// Place of the row of that name; -1: there is none.
template <class Row, std::size_t N>
constexpr int place_of(const std::array<Row, N>& rows, std::string_view name) {
    for (std::size_t k = 0; k < N; ++k)
        if (rows[k].name == name) return static_cast<int>(k);
    return -1;
}

inline constexpr auto kBridgeOrderNames = names_of(kBridgeOrderCode);
inline constexpr auto kReportNames = names_of(kReportCode);
inline constexpr auto kFaultNames = names_of(kFaultCode);
inline constexpr auto kCriterionKindNames = names_of(kCriterionKind);
inline constexpr auto kAnchorPhaseNames = names_of(kAnchorPhase);
inline constexpr auto kSoilNames = names_of(kSoil);
inline constexpr auto kLandmarkNames = names_of(kLandmarkKind);
inline constexpr auto kLightNames = names_of(kLightColour);
/// Events that a lesson or a fault may wait for.
inline constexpr auto kEventNames = names_of(kEventsWaitedFor);

/// The row of a code; null: there is no such event.
constexpr const Event* find_event(std::string_view code) {
    for (const Event& event : kEventsWaitedFor)
        if (event.name == code) return &event;
    for (const Event& event : kEventsTold)
        if (event.name == code) return &event;
    return nullptr;
}

/// The row of a code; null: there is no such alert.
constexpr const Alert* find_alert(std::string_view code) {
    const int place = place_of(kAlerts, code);
    return place < 0 ? nullptr : &kAlerts[static_cast<std::size_t>(place)];
}

/// A code that is written where it is used. One that is not in words.json does not compile.
template <class Row, const Row* (*Find)(std::string_view)>
class Code {
public:
    // NOLINTNEXTLINE(google-explicit-constructor): a literal stands for the code that it is
    consteval Code(const char* code) : row_(Find(code)) {
        if (row_ == nullptr) throw "words.json has no such code";
    }

    constexpr const Row& row() const { return *row_; }

private:
    const Row* row_;
};
using EventCode = Code<Event, find_event>;
using AlertCode = Code<Alert, find_alert>;

constexpr const Order& row_of(BridgeOrderCode code) {
    return kBridgeOrderCode.at(static_cast<std::size_t>(code));
}
constexpr const Report& row_of(ReportCode code) {
    return kReportCode.at(static_cast<std::size_t>(code));
}
/// Throws std::out_of_range beyond the last, as those above.
constexpr const Fault& row_of(FaultCode code) {
    return kFaultCode.at(static_cast<std::size_t>(code));
}

constexpr const Named& row_of(DeckWork work) {
    return kDeckWork.at(static_cast<std::size_t>(work));
}
constexpr const Named& row_of(DeckHindrance why) {
    return kDeckHindrance.at(static_cast<std::size_t>(why));
}

/// "symptom; reason; way out", for a list of faults.
std::string fault_text(const Fault& fault);

constexpr const UnitWords& words_of(Unit unit) {
    return kUnits[static_cast<std::size_t>(unit)];
}

/// "3 shackles", "1 shackle", "20 m".
std::string figure_text(double value, Unit unit);

/// An order of the bridge as it is written: "pay out port cable to 3 shackles in the pipe". side: 0 port, 1
/// starboard, -1 both. Empty for an order in own words, and for a code that words.json does not have.
std::string order_text(std::size_t code, int side, double value);

/// An order with what the bridge has added to it, which after a question is a sentence of its own: "how much
/// port cable is out? This is my last call".
std::string order_with(std::string order, std::string_view added);

/// What a report says; enumerators by their place.
struct ReportSaid {
    std::size_t code = 0;
    int side = -1; ///< 0 port, 1 starboard, -1 neither
    double value = 0;
    int lead = 0; ///< clock hour; 0: not given
    std::size_t stay = 0, growing = 0, weight = 0;
    std::size_t order_code = 0; ///< of a repeat: what was understood; of what is unsafe: what is proposed
    std::string_view text = {}; ///< in own words, beside it
};

/// A report as it is written: "port cable is leading 11 o'clock, short stay"; "repeats: let go port anchor".
std::string report_text(const ReportSaid& report);

/// A sentence with its {0}, {1} ... filled in.
std::string filled(std::string_view sentence, const std::vector<std::string>& parts);

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
