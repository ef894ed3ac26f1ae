// Which events a seat notices, and what of them: by the rows of words.json.

#include "server/perceive/perceive.hpp"
#include "server/perceive/senses.hpp"

#include "common/text.hpp"
#include "words/words.hpp"

namespace windlass::perceive {

namespace {

/// "FaultCommand" of "(3 refusals not listed) FaultCommand from instructor: ...".
std::string_view refused_topic(std::string_view text) {
    if (text.starts_with('(')) text.remove_prefix(std::min(text.size(), text.find(')') + 2));
    return text.substr(0, text.find(' '));
}

struct Orders {
    std::string_view topic;
    bool forecastle, bridge;
};
/// Topics that a seat writes. Other refusals are the instructor's: they tell what he is about to do.
constexpr Orders kOwnOrders[]{
    {"WindlassCommand", true, false},
    {"Report", true, false},
    {"HelmCommand", false, true},
    {"BridgeOrderCommand", false, true},
    {"WatchCircle", false, true},
    {"AlertCommand", true, true},
    {"LightsAndShapesCommand", false, true},
    {"DeckWorkCommand", true, false},
    {"ForecastleAnswer", true, false},
    {"BridgeAnswer", false, true},
};

template <class FixedString>
void copy(std::string_view from, FixedString& to) {
    to = std::string(clipped(from, FixedString::max_size));
}

const exercise::AnchorView* anchor_of(const exercise::ExerciseEvent& event,
                                      const exercise::Snapshot& snapshot) {
    for (const exercise::TackleView& tackle : snapshot.tackle)
        if (static_cast<int>(tackle.side) == event.side) return &tackle.anchor;
    return nullptr;
}

bool noticed(words::Notice when, bool Orders::*seat, const exercise::ExerciseEvent& event,
             const exercise::Snapshot& snapshot) {
    switch (when) {
    case words::Notice::never:
        return false;
    case words::Notice::anchor_above: {
        const exercise::AnchorView* anchor = anchor_of(event, snapshot);
        return anchor != nullptr && above_water(*anchor);
    }
    case words::Notice::own_orders:
        return std::ranges::any_of(kOwnOrders, [&](const Orders& own) {
            return own.*seat && own.topic == refused_topic(event.text);
        });
    case words::Notice::always:
    case words::Notice::alone:
        return true;
    }
    return false;
}

} // namespace

bool is_instruction(const exercise::ExerciseEvent& event) {
    const words::Event* row = words::find_event(event.code);
    return row != nullptr && (row->forecastle == words::Notice::alone || row->bridge == words::Notice::alone);
}

std::optional<SeatEvent> perceive_event(const exercise::ExerciseEvent& event,
                                        const exercise::Snapshot& snapshot) {
    const words::Event* row = words::find_event(event.code);
    if (row == nullptr) return std::nullopt;
    const bool forecastle = noticed(row->forecastle, &Orders::forecastle, event, snapshot);
    const bool bridge = noticed(row->bridge, &Orders::bridge, event, snapshot);
    if (!forecastle && !bridge) return std::nullopt;
    SeatEvent to;
    to.tick(event.tick);
    to.time(event.time);
    to.severity(static_cast<EventSeverity>(event.severity));
    copy(row->seat_code.empty() ? std::string_view(event.code) : row->seat_code, to.code());
    to.side(event.side);
    to.forecastle(forecastle);
    to.bridge(bridge);
    to.value(row->value ? event.value : 0);
    copy(row->seat_said.empty() ? std::string_view(event.text) : row->seat_said, to.text());
    return to;
}

} // namespace windlass::perceive
