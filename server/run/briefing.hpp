#pragma once
// What the trainees of a lesson read before it begins, in pieces that events have room for.

#include "server/assess/lesson.hpp"

#include <string>
#include <vector>

namespace windlass::server {

/// The lesson's briefing and who gives the bridge's orders. Each piece is one line of at most 255 bytes; they
/// break at spaces, which are left out (a word that is longer than a piece is cut).
std::vector<std::string> briefing_pieces(const assess::Lesson& lesson);

} // namespace windlass::server
