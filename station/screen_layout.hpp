#pragma once
// The full-screen view as pieces of text with a place and a style: no terminal needed to make or test it.

#include "station/seen.hpp"

#include <optional>
#include <string>
#include <vector>

namespace windlass::station {

enum class Style { plain, title, label, good, caution, alarm, stale };

/// Text at a row and column, both counted from 0. Never runs past the width it was made for.
struct Piece {
    int row = 0;
    int column = 0;
    std::string text;
    Style style = Style::plain;
};

/// What the one who looks has chosen.
struct ScreenRequest {
    int width = 80;
    int height = 24;
    Onlooker who = Onlooker::instructor;
    int side = 0;                 ///< windlass shown: SIDE_PORT, SIDE_STARBOARD
    std::string heading;          ///< who looks, e.g. "trainee-1"
    std::vector<std::string> log; ///< lines of this station itself, newest last
    std::string keys;             ///< bottom line: which keys do what
};

inline constexpr int kMinWidth = 80;
inline constexpr int kMinHeight = 24;

/// The whole screen. Everything is styled stale, with its age in the title, when the data have stopped. A
/// window under the least size gets one line that says so.
std::vector<Piece> layout(const Picture& picture, const ScreenRequest& request, Clock::time_point now);

} // namespace windlass::station
