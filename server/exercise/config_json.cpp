#include "server/exercise/config_json.hpp"

#include "server/exercise/config_fields.hpp"
#include "server/exercise/config_ground.hpp"
#include "server/exercise/field_json.hpp"

#include <nlohmann/json.hpp>

namespace windlass::exercise {
namespace {

using Json = nlohmann::json;

template <class Def>
void read(const Json& parent, const char* name, Def& def) {
    if (!parent.contains(name)) return;
    FieldReader reader(parent.at(name));
    visit_fields(reader, def);
}

/// By value: visit_fields serves readers too and so wants a def that may be written.
template <class Def>
Json written(Def def) {
    Json object = Json::object();
    FieldWriter writer(object);
    visit_fields(writer, def);
    return object;
}

/// Diameter and grade first, then the fields that are given on their own.
physics::ChainDef read_chain(const Json& tackle) {
    physics::ChainDef def;
    read(tackle, "chain", def);
    def = physics::stud_link_chain(def.diameter, def.grade, def.length);
    read(tackle, "chain", def);
    return def;
}

/// The soil first, then what is given of its bed on its own.
/// Type and mass first: they say what the rest is that is not given on its own.
physics::AnchorDef read_anchor(const Json& tackle) {
    physics::AnchorDef def;
    if (!tackle.contains("anchor")) return def;
    read(tackle, "anchor", def);
    const bool weighed = tackle.at("anchor").contains("mass");
    def = physics::typical_anchor(def.type, weighed ? def.mass : 0);
    read(tackle, "anchor", def);
    return def;
}

void read_environment(const Json& document, physics::EnvironmentDef& def) {
    read(document, "environment", def);
    lay_bed(def, def.soil);
    read(document, "environment", def);
    if (!document.contains("environment")) return;
    const Json& environment = document.at("environment");
    read_ground(environment, def);
    if (!environment.contains("current_profile")) return;
    def.current_profile.clear();
    for (const Json& entry : environment.at("current_profile")) {
        FieldReader reader(entry);
        visit_fields(reader, def.current_profile.emplace_back());
    }
}

} // namespace

Json to_json(const ExerciseDef& def) {
    Json document = written(def);
    document["model"] = written(def.model);
    document["environment"] = written(def.environment);
    Json& profile = document["environment"]["current_profile"] = Json::array();
    for (const physics::CurrentLayer& layer : def.environment.current_profile)
        profile.push_back(written(layer));
    document["environment"]["ground"] = ground_to_json(def.environment);
    document["ship"] = written(def.ship);
    document["ship_start"] = written(def.ship_start);
    document["tackle"] = Json::array();
    for (const GroundTackleDef& tackle : def.tackle) {
        Json& entry = document["tackle"].emplace_back(written(tackle));
        entry["windlass"] = written(tackle.windlass);
        entry["chain"] = written(tackle.chain);
        entry["anchor"] = written(tackle.anchor);
    }
    return document;
}

ExerciseDef exercise_from_json(const Json& document) {
    ExerciseDef def;
    FieldReader reader(document);
    visit_fields(reader, def);
    read(document, "model", def.model);
    read_environment(document, def.environment);
    read(document, "ship", def.ship);
    read(document, "ship_start", def.ship_start);
    if (!document.contains("tackle")) return def;
    def.tackle.clear();
    for (const Json& entry : document.at("tackle")) {
        GroundTackleDef& tackle = def.tackle.emplace_back();
        FieldReader tackle_reader(entry);
        visit_fields(tackle_reader, tackle);
        read(entry, "windlass", tackle.windlass);
        tackle.anchor = read_anchor(entry);
        tackle.chain = read_chain(entry);
    }
    return def;
}

} // namespace windlass::exercise
