#include "bench/lab/case/case_parts.hpp"

#include "bench/lab/case/motion.hpp"
#include "bench/lab/case/shapes.hpp"
#include "bench/lab/case/table.hpp"
#include "common/json_file.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace windlass::lab {
namespace {

using Json = nlohmann::json;

/// A field that goes with some kinds only. Returns whether it is there.
bool field_of(const Json& part, const char* field, bool wanted, bool needed, const std::string& at,
              const CaseSource& source) {
    const bool there = part.contains(field);
    const std::string pointer = at + "/" + field;
    if (there && !wanted) source.refuse(pointer, part.at(field), "this kind does not have it");
    if (!there && needed) source.refuse(pointer, Json(), "this kind needs it");
    return there;
}

End read_end(const Json& document, const char* name, const CaseSource& source) {
    End end;
    if (!document.contains(name)) return end;
    const Json& given = document.at(name);
    const auto kind = given.at("kind").get<std::string>();
    const std::string at = std::string("/") + name;
    end.kind = kind == "free"     ? EndKind::free
               : kind == "mass"   ? EndKind::mass
               : kind == "driven" ? EndKind::driven
                                  : EndKind::fixed;
    const bool mass = end.kind == EndKind::mass, driven = end.kind == EndKind::driven;
    if (field_of(given, "mass", mass, mass, at, source)) end.mass = given.at("mass").get<double>();
    end.weight = end.mass * physics::kGravity;
    if (field_of(given, "weight", mass, false, at, source)) end.weight = given.at("weight").get<double>();
    field_of(given, "motion", driven, driven, at, source);
    return end;
}

Vec3 vector(const Json& given) {
    return {given.at(0).get<double>(), given.at(1).get<double>(), given.at(2).get<double>()};
}

std::filesystem::path beside(const CaseSource& source, const Json& file) {
    return source.folder / file.get<std::string>(); // an absolute path stays as it is
}

Motion table(const std::filesystem::path& file, const Vec3& place) {
    Table table = read_table(file, 4, 2);
    std::vector<Vec3> offsets;
    for (std::size_t i = 0; i < table.rows(); ++i)
        offsets.emplace_back(table.columns[1][i], table.columns[2][i], table.columns[3][i]);
    const std::vector<double>& times = table.columns[0];
    if (times.front() != 0 || offsets.front() != Vec3::Zero())
        throw ConfigError(file.string() + ": the first row is not allowed: 0, 0, 0, 0");
    for (std::size_t i = 1; i < times.size(); ++i)
        if (times[i] <= times[i - 1])
            throw ConfigError(file.string() + ": row " + std::to_string(i + 1) +
                              ": its time is not allowed: later than in the row before");
    return table_motion(place, times, offsets);
}

Motion read_motion(const Json& given, const Vec3& place, const std::string& at, const CaseSource& source) {
    const auto kind = given.at("kind").get<std::string>();
    const bool circle = kind == "circle", harmonic = kind == "harmonic";
    for (const char* field : {"x", "y", "z"})
        field_of(given, field, harmonic, false, at, source);
    for (const char* field : {"radius", "period"})
        field_of(given, field, circle, circle, at, source);
    field_of(given, "clockwise", circle, false, at, source);
    field_of(given, "ramp", circle || harmonic, false, at, source);
    field_of(given, "file", kind == "table", kind == "table", at, source);
    const double ramp = given.value("ramp", 0.0);
    if (kind == "table") return table(beside(source, given.at("file")), place);
    if (circle) {
        if (ramp == 0)
            source.refuse(at + "/ramp", Json(ramp), "above 0: a circle does not begin at its centre");
        return circle_motion(place, given.at("radius"), given.at("period"), given.value("clockwise", true),
                             ramp);
    }
    std::array<Harmonic, 3> axes;
    for (int k = 0; k < 3; ++k) {
        const std::string axis(1, "xyz"[k]);
        if (!given.contains(axis)) continue;
        const Json& one = given.at(axis);
        axes[k] = {one.at("amplitude"), one.at("period"),
                   physics::radians_from_degrees(one.value("phase_deg", 0.0))};
        if (ramp == 0 && std::sin(axes[k].phase) != 0)
            source.refuse(at + "/" + axis + "/phase_deg", one.at("phase_deg"),
                          "0 without a ramp, for the end would jump");
    }
    return harmonic_motion(place, axes, ramp);
}

Shape points(const std::filesystem::path& file, double length) {
    const Table table = read_table(file, 3, 2);
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < table.rows(); ++i)
        points.emplace_back(table.columns[0][i], table.columns[1][i], table.columns[2][i]);
    return points_shape(std::move(points), length);
}

/// N/m, of line that is under water (or in air) as a whole.
double weight(const Problem& problem) {
    return physics::weight_in_water(problem.line, problem.environment.water_density);
}

} // namespace

void CaseSource::refuse(const std::string& pointer, const Json& value, const std::string& allowed) const {
    throw ConfigError(name + ": " + pointer + ": " + (value.is_null() ? "nothing" : value.dump()) +
                      " is not allowed: " + allowed);
}

void read_end_masses(const Json& document, Problem& problem, const CaseSource& source) {
    problem.lower = read_end(document, "lower", source);
    problem.upper = read_end(document, "upper", source);
}

std::function<Vec3(double arc)> read_start(const Json& start, const Problem& problem,
                                           const CaseSource& source) {
    const auto shape = start.at("shape").get<std::string>();
    const bool points_file = shape == "points", hanging = shape == "hanging", folded = shape == "folded";
    field_of(start, "lower", !points_file && !hanging, !points_file && !hanging, "/start", source);
    field_of(start, "upper", !points_file, !points_file, "/start", source);
    field_of(start, "direction", folded, false, "/start", source);
    field_of(start, "file", points_file, points_file, "/start", source);
    const double length = problem.length;
    if (points_file) return points(beside(source, start.at("file")), length);

    const Vec3 upper = vector(start.at("upper"));
    if (hanging)
        return hanging_shape(upper, length, weight(problem), problem.line.stiffness, problem.lower.weight);
    const Vec3 lower = vector(start.at("lower"));
    try {
        if (folded) {
            const Vec3 down = start.contains("direction") ? vector(start.at("direction")) : Vec3(0, 0, -1);
            if (down.norm() == 0) throw std::invalid_argument("a direction of some length");
            return folded_shape(lower, upper, length, down);
        }
        if (shape == "catenary") {
            const double depth = problem.environment.depth;
            const bool on_bed = std::abs(lower.z() + depth) < 1e-3 * std::max(1.0, std::abs(depth));
            return catenary_shape(lower, upper, {length, weight(problem), problem.line.stiffness}, on_bed);
        }
    } catch (const std::invalid_argument& error) {
        source.refuse("/start", start, error.what());
    }
    return straight_shape(lower, upper, length);
}

void read_motions(const Json& document, Problem& problem, double settle, const CaseSource& source) {
    for (const auto& [name, end, arc] :
         {std::tuple("lower", &problem.lower, 0.0), std::tuple("upper", &problem.upper, problem.length)}) {
        if (end->kind != EndKind::driven) continue;
        const std::string at = std::string("/") + name + "/motion";
        end->motion =
            delayed(read_motion(document.at(name).at("motion"), problem.start(arc), at, source), settle);
    }
}

} // namespace windlass::lab
