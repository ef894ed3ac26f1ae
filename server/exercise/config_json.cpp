#include "server/exercise/config_json.hpp"

#include "server/exercise/config_fields.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace windlass::exercise {
namespace {

using Json = nlohmann::json;
using physics::degrees_from_radians;
using physics::radians_from_degrees;

/// Lays what an object gives over the members; what it does not give stays.
class FieldReader {
public:
    explicit FieldReader(const Json& object) : object_(object) {}

    void number(const char* name, double& member) const { read(name, member); }
    void integer(const char* name, int& member) const { read(name, member); }
    void flag(const char* name, bool& member) const { read(name, member); }
    void text(const char* name, std::string& member) const { read(name, member); }
    void degrees(const char* name, double& member) const {
        if (object_.contains(name)) member = radians_from_degrees(object_.at(name).get<double>());
    }
    template <class Enum, class Names>
    void choice(const char* name, Enum& member, const Names& names) const {
        if (object_.contains(name))
            member = Enum(std::find(names.begin(), names.end(), object_.at(name).get<std::string>()) -
                          names.begin());
    }

private:
    template <class T>
    void read(const char* name, T& member) const {
        if (object_.contains(name)) object_.at(name).get_to(member);
    }
    const Json& object_;
};

class FieldWriter {
public:
    explicit FieldWriter(Json& object) : object_(object) {}

    void number(const char* name, double member) { object_[name] = member; }
    void integer(const char* name, int member) { object_[name] = member; }
    void flag(const char* name, bool member) { object_[name] = member; }
    void text(const char* name, const std::string& member) { object_[name] = member; }
    void degrees(const char* name, double member) { object_[name] = degrees_from_radians(member); }
    template <class Enum, class Names>
    void choice(const char* name, Enum member, const Names& names) {
        object_[name] = names.at(std::size_t(member));
    }

private:
    Json& object_;
};

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
    const Json::json_pointer profile("/environment/current_profile");
    if (!document.contains(profile)) return;
    def.current_profile.clear();
    for (const Json& entry : document.at(profile)) {
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
