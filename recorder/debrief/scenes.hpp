#pragma once
// The scene at the key moments, as it was recorded: ship, bed, cables, anchors.

#include "recorder/debrief/moments.hpp"
#include "recorder/recording/recording.hpp"

namespace windlass::debrief {

/// Key moments that one picture shows: the first of them, and what came within a few seconds.
struct PicturedMoments {
    double time = 0;                  ///< s of exercise, of the first
    int side = -1;                    ///< that is spoken of; -1: neither, or both
    std::vector<std::size_t> numbers; ///< places in the page's list of moments
};

/// At most twelve, by time: moments that lie near each other share one.
std::vector<PicturedMoments> pictured(const std::vector<Moment>& moments);

/// Reads the scene at each of them into the attempt, which read_attempt() has made of the recording. A moment
/// of which nothing was recorded has none.
void read_scenes(recording::Recording& recording, Attempt& attempt);

} // namespace windlass::debrief
