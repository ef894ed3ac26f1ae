#pragma once
// The terminal as a full-screen view, through ncurses.

#include "station/screen_layout.hpp"

#include <optional>

namespace windlass::station {

/// Keys that are no character.
enum class Key : int { up = 0x110000, down, left, right, page_up, page_down, home, end, f2, f3 };

/// Has the terminal while it lives, and gives it back as it was. One at a time.
class Screen {
public:
    /// Throws std::runtime_error when the terminal cannot be used (no terminal, TERM unknown).
    Screen();
    ~Screen();
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    int width() const;  ///< columns, as of now: follows the window
    int height() const; ///< rows

    void draw(const std::vector<Piece>& pieces);

    /// Waits up to that many milliseconds for a key: its character, or one of Key. Nothing on a time-out and
    /// when the window has changed its size.
    std::optional<int> key(int milliseconds);
};

} // namespace windlass::station
