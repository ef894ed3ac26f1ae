#pragma once
// How a station shows the exercise: line by line, as JSON lines, full screen, or not at all.

#include "station/seen.hpp"

#include <memory>
#include <optional>
#include <string>

namespace windlass::station {

enum class ViewKind { none, line, json, screen };

struct ViewOptions {
    ViewKind kind = ViewKind::line;
    Onlooker who = Onlooker::seat;
    int side = 0;        ///< SIDE_PORT or SIDE_STARBOARD; Tab changes it on the screen
    std::string heading; ///< who looks
    std::string keys;    ///< bottom line of the screen
};

class View {
public:
    virtual ~View() = default;

    /// A line of this station's own: what it does, what it was told.
    virtual void note(const Picture& picture, const std::string& text) = 0;

    /// Shows what is due: call it often. Returns a key that was pressed, see Screen::key.
    virtual std::optional<int> update(const Picture& picture, Clock::time_point now) = 0;

    /// Text in place of the bottom line, e.g. what is being typed; empty for the keys.
    virtual void prompt(const std::string&) {}
};

/// Throws std::runtime_error when a screen is asked for and the terminal cannot be used.
std::unique_ptr<View> make_view(const ViewOptions& options);

} // namespace windlass::station
