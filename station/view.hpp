#pragma once
// How a station shows the exercise: line by line, as JSON lines, or not at all.

#include "station/seen.hpp"

#include <memory>
#include <string>

namespace windlass::station {

enum class ViewKind { none, line, json };

struct ViewOptions {
    ViewKind kind = ViewKind::line;
    Onlooker who = Onlooker::seat;
    int side = 0; ///< SIDE_PORT or SIDE_STARBOARD
};

class View {
public:
    virtual ~View() = default;

    /// A line of this station's own: what it does, what it was told.
    virtual void note(const Picture& picture, const std::string& text) = 0;

    /// Shows what is due: call it often.
    virtual void update(const Picture& picture, Clock::time_point now) = 0;
};

std::unique_ptr<View> make_view(const ViewOptions& options);

} // namespace windlass::station
