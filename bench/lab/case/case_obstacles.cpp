// The obstacles of a case file.

#include "bench/lab/case/case_parts.hpp"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

namespace windlass::lab {
namespace {

using Json = nlohmann::json;

Vec3 vector(const Json& given) {
    return {given.at(0).get<double>(), given.at(1).get<double>(), given.at(2).get<double>()};
}

void read_plane(const Json& given, Obstacle& obstacle, const std::string& at, const CaseSource& source) {
    obstacle.point = vector(given.at("point"));
    obstacle.normal = vector(given.at("normal"));
    if (obstacle.normal.norm() == 0)
        source.refuse(at + "/normal", given.at("normal"), "a direction of some length");
    obstacle.normal.normalize();
}

void read_mesh(const Json& given, Obstacle& obstacle, const std::string& at, const CaseSource& source) {
    for (const Json& corner : given.at("corners"))
        obstacle.corners.push_back(vector(corner));
    const Json& triangles = given.at("triangles");
    for (std::size_t k = 0; k < triangles.size(); ++k) {
        const std::string place = at + "/triangles/" + std::to_string(k);
        std::array<Vec3, 3> corners;
        for (int c = 0; c < 3; ++c) {
            const auto number = triangles[k][c].get<std::size_t>();
            if (number >= obstacle.corners.size())
                source.refuse(place, triangles[k],
                              "numbers of corners, 0 to " + std::to_string(obstacle.corners.size() - 1));
            corners[c] = obstacle.corners[number];
        }
        const Vec3 one = corners[1] - corners[0], other = corners[2] - corners[0];
        if (one.cross(other).norm() <= 1e-12 * (one.squaredNorm() + other.squaredNorm()))
            source.refuse(place, triangles[k], "three corners that do not lie on one line");
        obstacle.triangles.push_back(triangles[k].get<std::array<int, 3>>());
    }
}

} // namespace

std::vector<Obstacle> read_obstacles(const Json& given, const CaseSource& source) {
    std::vector<Obstacle> obstacles;
    for (std::size_t i = 0; i < given.size(); ++i) {
        const std::string at = "/obstacles/" + std::to_string(i);
        const Json& one = given[i];
        const bool plane = one.at("kind") == "plane";
        for (const auto& [field, wanted] : {std::pair("point", plane), std::pair("normal", plane),
                                            std::pair("corners", !plane), std::pair("triangles", !plane)}) {
            if (one.contains(field) != wanted)
                source.refuse(at + "/" + field, one.value(field, Json()),
                              wanted ? "this kind needs it" : "this kind does not have it");
        }
        Obstacle obstacle;
        obstacle.material = {.thickness = one.value("thickness", 0.0),
                             .friction = one.value("friction", 0.0),
                             .stickiness = one.value("stickiness", 0.0)};
        if (plane) {
            read_plane(one, obstacle, at, source);
        } else {
            read_mesh(one, obstacle, at, source);
        }
        obstacles.push_back(std::move(obstacle));
    }
    return obstacles;
}

} // namespace windlass::lab
