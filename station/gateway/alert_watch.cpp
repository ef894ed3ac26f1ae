#include "station/gateway/alert_watch.hpp"

#include "idl/payload.hpp"

#include <algorithm>
#include <tuple>

namespace windlass::gateway {

using nlohmann::json;

namespace {

/// By the panels that alerts are of.
const Topics& alert_topics() {
    static const Topics all{&wire::topics::alert, &wire::topics::forecastle_alert,
                            &wire::topics::server_alert};
    return all;
}

bool waits(const Alert& alert) {
    return alert.condition() == ALERT_ACTIVE_UNACKNOWLEDGED || alert.condition() == ALERT_ACTIVE_SILENCED ||
           alert.condition() == ALERT_RECTIFIED_UNACKNOWLEDGED;
}

} // namespace

json alert_to_tell(const std::vector<FramePtr>& frames) {
    std::vector<Alert> waiting;
    for (const FramePtr& frame : frames) {
        try {
            if (auto alert = wire::decode<Alert>(frame->payload); waits(alert))
                waiting.push_back(std::move(alert));
        } catch (const std::exception&) {
            continue; // of a writer that means harm
        }
    }
    if (waiting.empty()) return nullptr;
    const auto first = std::ranges::max_element(
        waiting, {}, [](const Alert& alert) { return std::tuple(alert.priority(), alert.raised_time()); });
    return {{"code", first->code().to_string()},
            {"side", first->side()},
            {"priority", static_cast<int>(first->priority())},
            {"text", first->text().to_string()},
            {"raised_time", first->raised_time()},
            {"waiting", waiting.size()}};
}

void AlertWatch::follow(const SharedReaders& readers, const std::vector<std::string>& exercises) {
    std::erase_if(feeds_, [&](const auto& each) {
        return std::ranges::find(exercises, each.first) == exercises.end();
    });
    for (const std::string& exercise : exercises) {
        if (feeds_.contains(exercise)) continue;
        try {
            feeds_[exercise] = std::make_unique<Feed>(readers, wire::exercise_partition(exercise),
                                                      Feed::Kind::exercise, alert_topics());
        } catch (const std::exception&) {
            feeds_.erase(exercise); // tried again with the next news
        }
    }
}

json AlertWatch::told() const {
    json all = json::object();
    for (const auto& [exercise, feed] : feeds_) {
        std::vector<FramePtr> frames;
        for (const wire::TopicInfo* topic : alert_topics())
            for (FramePtr& frame : feed->kept(*topic))
                if (std::ranges::find(frames, frame->instance, &SharedFrame::instance) == frames.end())
                    frames.push_back(std::move(frame)); // one that is of two panels once
        if (json first = alert_to_tell(frames); !first.is_null()) all[exercise] = std::move(first);
    }
    return all;
}

} // namespace windlass::gateway
