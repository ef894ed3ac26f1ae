#include "bench/lab/case/case.hpp"

#include "bench/lab/case/case_parts.hpp"
#include "common/json_schema.hpp"
#include "embedded/case_schema.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace windlass::lab {
namespace {

using Json = nlohmann::json;

const JsonSchema& schema() {
    static const JsonSchema one(embedded::case_schema);
    return one;
}

physics::ChainDef read_line(const Json& line) {
    physics::ChainDef def = physics::stud_link_chain(line.value("diameter", 0.078), physics::Grade::k3,
                                                     line.at("length").get<double>());
    def.mass_per_metre = line.value("mass_per_metre", def.mass_per_metre);
    def.stiffness = line.value("stiffness", def.stiffness);
    def.damping_time = line.value("damping_time", 0.0);
    def.displacement = line.value("displacement", def.displacement);
    def.drag_normal = line.value("drag_normal", def.drag_normal);
    def.drag_axial = line.value("drag_axial", def.drag_axial);
    def.added_mass_normal = line.value("added_mass_normal", def.added_mass_normal);
    def.added_mass_axial = line.value("added_mass_axial", def.added_mass_axial);
    def.contact_diameter = line.value("contact_diameter", def.contact_diameter);
    return def;
}

physics::EnvironmentDef read_medium(const Json& medium) {
    physics::EnvironmentDef def;
    def.water_density = medium.value("water_density", 0.0);
    def.depth = medium.value("depth", 1e6);
    def.current_speed = medium.value("current_speed", 0.0);
    def.current_towards = physics::radians_from_degrees(medium.value("current_towards_deg", 90.0));
    def.bed_stiffness = medium.value("bed_stiffness", def.bed_stiffness);
    def.bed_friction = medium.value("bed_friction", def.bed_friction);
    def.wind_speed = 0;
    return def;
}

MethodSettings read_settings(const Json& given) {
    MethodSettings settings;
    settings.iterations = given.value("iterations", settings.iterations);
    settings.k_stretch = given.value("k_stretch", settings.k_stretch);
    settings.k_bend = given.value("k_bend", settings.k_bend);
    settings.bend_by_angle = given.value("bend_by", "centroid") == "angle";
    settings.rest_angle = physics::radians_from_degrees(given.value("rest_angle_deg", 0.0));
    settings.k_lra = given.value("k_lra", settings.k_lra);
    settings.k_pin = given.value("k_pin", settings.k_pin);
    settings.k_slack = given.value("k_slack", settings.k_slack);
    settings.bend_iterations = given.value("bend_iterations", settings.bend_iterations);
    settings.lra_iterations = given.value("lra_iterations", settings.lra_iterations);
    settings.pin_iterations = given.value("pin_iterations", settings.pin_iterations);
    settings.pin_damping = given.value("pin_damping", settings.pin_damping);
    settings.self_collision = given.value("self_collision", settings.self_collision);
    settings.radius = given.value("radius", settings.radius);
    settings.resolution = given.value("resolution", settings.resolution);
    settings.rest_distance = given.value("rest_distance", settings.rest_distance);
    settings.coloured = given.value("coloured", settings.coloured);
    return settings;
}

Probe read_probe(const Json& given, double length, const CaseSource& source, const std::string& at) {
    Probe probe;
    probe.name = given.at("name").get<std::string>();
    const auto name = given.at("quantity").get<std::string>();
    probe.quantity =
        Quantity(std::find(kQuantityNames.begin(), kQuantityNames.end(), name) - kQuantityNames.begin());
    const int places = int(given.count("end")) + int(given.count("arc")) + int(given.count("node"));
    const bool whole = probe.quantity >= Quantity::kinetic_energy;
    if (places != (whole ? 0 : 1))
        source.refuse(at, given,
                      whole ? "an energy is of the whole line: no end, arc or node"
                            : "exactly one of end, arc and node");
    if (given.contains("end")) probe.arc = given.at("end") == "upper" ? length : 0;
    if (given.contains("arc")) probe.arc = given.at("arc").get<double>();
    if (probe.arc.value_or(0) > length)
        source.refuse(at + "/arc", given.at("arc"), "at most the line's length");
    if (given.contains("node")) probe.node = given.at("node").get<int>();
    return probe;
}

ReferenceDef read_reference(const Json& given, const std::vector<Probe>& probes, const CaseSource& source) {
    ReferenceDef def;
    def.probe = given.value("probe", probes.front().name);
    def.shift = given.value("shift", def.shift);
    def.from = given.value("from", def.from);
    def.to = given.value("to", def.to);
    def.low = given.value("low", def.low);
    if (std::none_of(probes.begin(), probes.end(), [&](const Probe& p) { return p.name == def.probe; }))
        source.refuse("/reference/probe", Json(def.probe), "the name of one of the probes");
    return def;
}

} // namespace

void set_field(Json& document, const std::string& assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0)
        throw ConfigError("--set " + assignment + ": is not allowed: FIELD=VALUE, e.g. line.length=150");
    std::string path = "/" + assignment.substr(0, equals);
    std::replace(path.begin(), path.end(), '.', '/');
    const std::string text = assignment.substr(equals + 1);
    Json value = Json::parse(text, nullptr, false);
    if (value.is_discarded()) value = text;
    try {
        document[Json::json_pointer(path)] = value;
    } catch (const Json::exception&) {
        throw ConfigError("--set " + assignment + ": " + path + " is no place in the case");
    }
}

Case case_from_json(const Json& document, const std::string& name, const std::filesystem::path& folder) {
    schema().check(document, name);
    const CaseSource source{name, folder};
    const auto part = [&](const char* field) { return document.value(field, Json::object()); };
    Case result;
    result.title = document.value("title", "");
    result.settle = document.value("settle", result.settle);
    result.sample = document.value("sample", result.sample);
    result.links = document.value("nodes", result.links);
    result.dt = document.value("dt", result.dt);
    result.settings = read_settings(part("settings"));

    Problem& problem = result.problem;
    problem.line = read_line(document.at("line"));
    problem.length = problem.line.length;
    problem.environment = read_medium(part("medium"));
    problem.duration = result.settle + document.at("duration").get<double>();
    read_end_masses(document, problem, source);
    problem.start = read_start(document.at("start"), problem, source);
    const auto shape = document.at("start").at("shape").get<std::string>();
    if (shape == "hanging" || shape == "catenary") { // at rest: a line that does not stretch rests elsewhere
        constexpr double kRigid = 1e6;               // times as stiff
        Problem unstretched = problem;
        unstretched.line.stiffness *= kRigid;
        problem.rigid_start = read_start(document.at("start"), unstretched, source);
    }
    read_motions(document, problem, result.settle, source);
    problem.obstacles = read_obstacles(document.value("obstacles", Json::array()), source);

    const Json probes =
        document.value("probes", Json::array({{{"name", "top"}, {"quantity", "tension"}, {"end", "upper"}}}));
    for (std::size_t i = 0; i < probes.size(); ++i)
        result.probes.push_back(
            read_probe(probes[i], problem.length, source, "/probes/" + std::to_string(i)));
    result.reference = read_reference(part("reference"), result.probes, source);
    return result;
}

Case load_case(const std::filesystem::path& file, const std::vector<std::string>& assignments) {
    Json document = read_json(file);
    for (const std::string& assignment : assignments)
        set_field(document, assignment);
    return case_from_json(document, file.string(), file.parent_path());
}

} // namespace windlass::lab
