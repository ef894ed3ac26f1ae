#pragma once
// The parts of a case file that say where the line begins and how its ends are held. For case.cpp.

#include "bench/problem/problem.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>

namespace windlass::lab {

/// Where a case comes from.
struct CaseSource {
    std::string name;             ///< in errors
    std::filesystem::path folder; ///< of the files it names

    /// Throws exercise::ConfigError: NAME: POINTER: VALUE is not allowed: ALLOWED.
    [[noreturn]] void refuse(const std::string& pointer, const nlohmann::json& value,
                             const std::string& allowed) const;
};

/// Kind, mass and weight of both ends.
void read_end_masses(const nlohmann::json& document, Problem& problem, const CaseSource& source);

/// The starting shape; line, medium and end masses are read before it.
std::function<Vec3(double arc)> read_start(const nlohmann::json& start, const Problem& problem,
                                           const CaseSource& source);

/// Motions of driven ends about their places in the starting shape, after settle (s).
void read_motions(const nlohmann::json& document, Problem& problem, double settle, const CaseSource& source);

/// Planes and meshes; corners of triangles are there, normals have a length, triangles an area.
std::vector<Obstacle> read_obstacles(const nlohmann::json& obstacles, const CaseSource& source);

} // namespace windlass::lab
