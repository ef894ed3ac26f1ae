#pragma once
// Where things stand on the screen, and what keeps them inside the window.

#include "station/screen_layout.hpp"

#include <algorithm>
#include <utility>

namespace windlass::station {

inline constexpr int kLeverRows = 10; // row of the headings; the levers follow below
inline constexpr int kRight = 42;     // column where the windlass's own figures start
inline constexpr int kLoads = 12;     // column of the loads, which need room

inline Style by_share(double fraction, double caution, double alarm) {
    if (fraction >= alarm) return Style::alarm;
    return fraction >= caution ? Style::caution : Style::plain;
}

/// Collects pieces and keeps them inside the window.
class Page {
public:
    Page(int width, int height, bool stale) : width_{width}, height_{height}, stale_{stale} {}

    void put(int row, int column, std::string text, Style style = Style::plain) {
        if (row >= height_ || column >= width_) return;
        text.resize(std::min(text.size(), static_cast<std::size_t>(width_ - column)));
        const bool figure = style != Style::title && style != Style::label;
        pieces_.push_back({row, column, std::move(text), stale_ && figure ? Style::stale : style});
    }

    /// A line over the whole width, with one text at each end.
    void band(int row, const std::string& left, const std::string& right, Style style) {
        const auto width = static_cast<std::size_t>(width_);
        std::string text = left.substr(0, width);
        text.resize(width, ' ');
        const auto tail = std::min(right.size(), width);
        text.replace(width - tail, tail, right, 0, tail);
        pieces_.push_back({row, 0, std::move(text), style});
    }

    /// Label, set point and present value of one lever; coloured while it is still on its way.
    void lever(int row, const std::string& label, const std::string& set, const std::string& now) {
        put(row, 1, label, Style::label);
        put(row, 17, set);
        put(row, 27, now, set != "-" && set != now ? Style::caution : Style::plain);
    }

    void figure(int row, const std::string& label, const std::string& value, Style style = Style::plain) {
        put(row, kRight, label, Style::label);
        put(row, kRight + 10, value, style);
    }

    int width() const { return width_; }
    std::vector<Piece> take() { return std::move(pieces_); }

private:
    int width_, height_;
    bool stale_;
    std::vector<Piece> pieces_;
};

/// What one at a seat has in rows 1 to 18, of its views; and what the instructor has there, of the truth.
/// Nothing of a topic that has not been heard.
void seat_figures(Page& page, const Picture& picture, int side);
void truth_figures(Page& page, const Picture& picture, int side);

/// Set points and where the levers are. WindlassLoad and ForecastleView name them alike.
template <class Sample>
void windlass_levers(Page& page, const Latest<WindlassCommand>& levers, const Sample& now);
/// The same of the helm; ShipState and BridgeView name it alike.
template <class Sample>
void helm_levers(Page& page, const Latest<HelmCommand>& helm, const Sample& now);

/// "NO POWER", "EMERGENCY STOP", ..., "ready".
template <class Sample>
void drive_lamps(Page& page, int row, const Sample& now);

} // namespace windlass::station
