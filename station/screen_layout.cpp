#include "station/screen_layout.hpp"

#include "station/format.hpp"
#include "station/line_view.hpp"
#include "station/names.hpp"
#include "station/screen_page.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace windlass::station {

namespace {

constexpr int kLogRow = 19;

std::string scale_text(double scale) {
    return scale > 0 ? fmt::format("x{:.3g}", scale) : std::string{"x max"};
}

void title(Page& page, const Picture& picture, const ScreenRequest& request, double silent) {
    const ExerciseStatus& status = *picture.status;
    const std::string right = fmt::format(" {}  {} {} ", clock(picture.time(request.side)),
                                          name(status.state()), scale_text(status.time_scale()));
    const bool truth = request.who == Onlooker::instructor && picture.truth;
    page.band(0,
              fmt::format(" {}  {}", request.heading,
                          truth ? picture.truth->title().c_str() : status.title().c_str()),
              right, Style::title);
    if (silent > kStaleAfter)
        page.band(1, fmt::format(" NO DATA FOR {:.0f} s: the figures below are old", silent), "",
                  Style::alarm);
}

Style by_severity(EventSeverity severity) {
    if (severity >= EVENT_WARNING) return Style::alarm;
    return severity == EVENT_CAUTION ? Style::caution : Style::plain;
}

/// An order that is not yet repeated back stands out; one that was cancelled is history.
Style by_state(BridgeOrderState state) {
    return state == ORDER_REPEATED || state == ORDER_CANCELLED ? Style::plain : Style::caution;
}

void log(Page& page, const Picture& picture, const ScreenRequest& request, const TacklePicture& tackle) {
    const auto& levers = tackle.levers_in_force();
    const std::string holder = levers ? levers->origin().source().to_string() : "nobody";
    page.put(kLogRow - 1, kRight,
             picture.replayed() ? "a replay: levers move nothing" : "levers in the hand of " + holder,
             Style::label);

    struct Line {
        std::string text;
        Style style;
    };
    std::vector<Line> lines;
    for (const Alert& alert : picture.alerts)
        lines.push_back({line(alert), alert.priority() >= ALERT_ALARM ? Style::alarm : Style::caution});
    // Of the orders, the newest, and one that still waits to be repeated back.
    const BridgeOrder* waits = picture.order_to_repeat();
    const BridgeOrder* newest_order = picture.orders.empty() ? nullptr : &picture.orders.back();
    for (const BridgeOrder* order : {waits, newest_order == waits ? nullptr : newest_order})
        if (order) lines.push_back({line(*order), by_state(order->state())});
    const auto rows = static_cast<std::size_t>(std::max(request.height - kLogRow - 1, 1));
    std::vector<Line> newest;
    for (auto text = request.log.rbegin(); text != request.log.rend() && newest.size() < 2; ++text)
        newest.push_back({*text, Style::label});
    const auto tell = [&](const auto& events) {
        for (auto event = events.rbegin(); event != events.rend() && newest.size() < rows; ++event)
            newest.push_back({line(*event), by_severity(event->severity())});
    };
    if (request.who == Onlooker::instructor)
        tell(picture.events.kept);
    else
        tell(picture.seat_events.kept);
    // Alerts and orders stand first and stay; what is left of the window is for the newest events.
    lines.resize(std::min(lines.size(), rows > 1 ? rows - 1 : 1));
    const auto room = rows - lines.size();
    if (newest.size() > room) newest.resize(room);
    lines.insert(lines.end(), newest.rbegin(), newest.rend());
    for (std::size_t i = 0; i < lines.size(); ++i)
        page.put(kLogRow + static_cast<int>(i), 1, lines[i].text, lines[i].style);
}

} // namespace

std::vector<Piece> layout(const Picture& picture, const ScreenRequest& request, Clock::time_point now) {
    const double silent = picture.silence(now).value_or(0.0);
    Page page{request.width, request.height, silent > kStaleAfter};
    if (request.width < kMinWidth || request.height < kMinHeight) {
        page.put(0, 0,
                 fmt::format("window {}x{}: at least {}x{} is needed", request.width, request.height,
                             kMinWidth, kMinHeight));
        return page.take();
    }
    page.band(request.height - 1, request.keys, "", Style::title);
    if (!picture.status) {
        page.band(0, fmt::format(" {}", request.heading), "no server heard yet ", Style::title);
        return page.take();
    }
    const auto& tackle = picture.tackle.at(static_cast<std::size_t>(request.side));
    if (request.who == Onlooker::instructor)
        truth_figures(page, picture, request.side);
    else
        seat_figures(page, picture, request.side);
    title(page, picture, request, silent);
    log(page, picture, request, tackle);
    return page.take();
}

} // namespace windlass::station
