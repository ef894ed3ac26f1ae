#pragma once
// The rows of words.json as C++ has them; words.schema.json says what each column means.

#include "words/codes.hpp"

#include <array>
#include <string_view>

namespace windlass::words {

/// In the order of idl EventSeverity.
enum class Severity { info, caution, warning, alarm };
constexpr Severity last_of(Severity) {
    return Severity::alarm;
}

/// In the order of idl AlertPriority.
enum class Priority { caution, warning, alarm, emergency };

/// When a seat notices an event. alone: it is told to this seat and to no other.
enum class Notice { never, anchor_above, own_orders, always, alone };

/// Where the mark is that a report of shackles counts.
enum class MarkAt { none, deck, pipe, water };

/// An enumerator that has no more than this.
struct Named {
    std::string_view name, said, unjudged = {};
};

struct Order {
    std::string_view name, said, said_bare = {};
    Unit unit = Unit::none;
    double repeat = 0, execute = 0; ///< s
};

struct Report {
    std::string_view name, said, label = {}; ///< label: of its button
    Unit unit = Unit::none;
    MarkAt mark_at = MarkAt::none;
    std::string_view event = {};
    double early = 0, full = 0, half = 0; ///< s
    double full_off = 0, half_off = 0;    ///< in the unit of its figure
};

struct Fault {
    std::string_view name, said, symptom, reason, way_out, severity, targets = {};
    bool forecastle = false, bridge = false, both_sides = false;
};

struct Event {
    std::string_view name;
    Severity severity = Severity::info;
    std::string_view said = {};
    Notice forecastle = Notice::never, bridge = Notice::never;
    bool value = false;
    std::string_view seat_said = {}, seat_code = {};
    bool moment = false;
};

struct Alert {
    std::string_view name;
    Priority priority = Priority::caution;
    std::string_view said, explanation;
    bool deck = false, bridge = false;
};

struct UnitWords {
    std::string_view one, many, written;
    double si = 1; ///< of one, in the SI unit
};

} // namespace windlass::words
