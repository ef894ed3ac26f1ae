#pragma once
// The exercise in three dimensions as a foxglove.SceneUpdate in JSON: hull, cables, anchors, water and
// seabed, in the topics' own frame "world" (x east, y north, z up, m). Pure.

#include "station/gateway/roles.hpp"

#include <array>
#include <optional>
#include <span>

namespace windlass::gateway {

/// The newest sample of each topic that a scene is made of; nothing: none was heard.
struct SceneHeard {
    std::optional<SceneDescription> plan;
    std::optional<SeabedDescription> bed;
    std::optional<SeaState> sea;
    std::optional<ShipState> ship;
    std::array<std::optional<ChainState>, 2> chains;   // by side
    std::array<std::optional<AnchorState>, 2> anchors; // by side

    /// Takes a sample; one that is no payload of its topic, or of no such side, is left out.
    void hear(const wire::TopicInfo& topic, std::span<const std::uint8_t> payload);
};

/// The topics that SceneHeard hears: all of them are the truth's or everybody's.
const Topics& scene_topics();

/// Every entity of which enough was heard, with time (s of exercise time) as its timestamp. Their ids are the
/// same in every update: "water", "seabed", "ship", "port_cable", "port_anchor", "starboard_cable",
/// "starboard_anchor". delete_until: all that stands with an older timestamp, s, is deleted first.
std::string scene_update(const SceneHeard& heard, double time, std::optional<double> delete_until = {});

/// JSON Schema of foxglove.SceneUpdate: fields, types and titles as Foxglove publishes them.
const std::string& scene_schema();

} // namespace windlass::gateway
