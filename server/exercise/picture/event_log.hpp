#pragma once
// How the parts of an exercise call out what happens.

#include "words/words.hpp"

#include <functional>
#include <string>
#include <utility>

namespace windlass::exercise {

/// Takes each event that is called, with its row of words.json.
class EventLog {
public:
    using Call =
        std::function<void(const words::Event& event, int side, double value, const std::string& text)>;

    explicit EventLog(Call call) : call_(std::move(call)) {}

    /// side: 0 port, 1 starboard, -1 neither; value: the figure that the text speaks of, SI. The usual text.
    void operator()(words::EventCode code, int side, double value) const {
        call_(code.row(), side, value, words::event_text(code.row(), value));
    }
    /// A text of its own, made of more than that figure.
    void operator()(words::EventCode code, int side, double value, const std::string& text) const {
        call_(code.row(), side, value, text);
    }

private:
    Call call_;
};

} // namespace windlass::exercise
