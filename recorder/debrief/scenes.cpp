#include "recorder/debrief/scenes.hpp"

#include "recorder/recording/typed.hpp"

#include "idl/topics.hpp"

#include <algorithm>

namespace windlass::debrief {

namespace topics = wire::topics;
using recording::Nanoseconds;

namespace {

constexpr std::size_t kMaxScenes = 12;
constexpr double kNear = 3;        // s of exercise; doubled until there are few enough
constexpr double kBefore = 2;      // s of the recording: the slowest stream comes five times a second
constexpr double kAfter = 0.6;     // a sample after it; the time of a status is known to a fifth of a second
constexpr double kRounding = 1e-6; // s

std::vector<PicturedMoments> grouped(const std::vector<Moment>& moments, double near) {
    std::vector<PicturedMoments> groups;
    for (std::size_t i = 0; i < moments.size(); ++i) {
        const Moment& moment = moments[i];
        if (groups.empty() || moment.time > groups.back().time + near)
            groups.push_back({.time = moment.time, .side = moment.side, .numbers = {}});
        PicturedMoments& group = groups.back();
        group.numbers.push_back(i);
        if (group.side < 0) group.side = moment.side;
    }
    return groups;
}

/// The sample takes the place of one from before the moment: what the moment tells is so from it on, as that
/// the anchor is on the bottom.
template <class T>
void keep(std::optional<T>& kept, T sample, double moment) {
    if (!kept || (kept->time() < moment - kRounding && sample.time() >= kept->time()))
        kept = std::move(sample);
}

void take(const recording::Message& message, SceneAt& scene) {
    const auto of = [](int side) { return static_cast<std::size_t>(side == SIDE_STARBOARD); };
    if (message.topic() == topics::ship_state.name)
        keep(scene.ship, recording::decode<ShipState>(message.payload), scene.time);
    if (message.topic() == topics::chain_state.name) {
        auto chain = recording::decode<ChainState>(message.payload);
        auto& kept = scene.chains[of(chain.side())];
        keep(kept, std::move(chain), scene.time);
    }
    if (message.topic() == topics::anchor_state.name) {
        auto anchor = recording::decode<AnchorState>(message.payload);
        auto& kept = scene.anchors[of(anchor.side())];
        keep(kept, std::move(anchor), scene.time);
    }
}

} // namespace

std::vector<PicturedMoments> pictured(const std::vector<Moment>& moments) {
    for (double near = kNear;; near *= 2)
        if (auto groups = grouped(moments, near); groups.size() <= kMaxScenes) return groups;
}

void read_scenes(recording::Recording& recording, Attempt& attempt) {
    attempt.scenes.clear();
    for (const PicturedMoments& each : pictured(moments_of(attempt))) {
        const auto at = recording.start() + static_cast<Nanoseconds>(attempt.position_of(each.time) * 1e9);
        SceneAt scene{.time = each.time, .ship = {}, .chains = {}, .anchors = {}};
        auto cursor = recording.messages(
            {.topics = {topics::ship_state.name, topics::chain_state.name, topics::anchor_state.name},
             .from = at - static_cast<Nanoseconds>(kBefore * 1e9),
             .until = at + static_cast<Nanoseconds>(kAfter * 1e9)});
        while (const auto message = cursor.next()) {
            try {
                take(*message, scene);
            } catch (const mcap::Damage&) {
                attempt.origin.complete = false;
            }
        }
        if (scene.ship) attempt.scenes.push_back(std::move(scene));
    }
}

} // namespace windlass::debrief
