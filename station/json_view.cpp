#include "station/json_view.hpp"

#include "station/names.hpp"

#include "idl/idl_text.hpp"
#include "idl/json_text.hpp"
#include "idl/payload.hpp"
#include "idl/topic_types.hpp"

#include <nlohmann/json.hpp>

namespace windlass::station {

using nlohmann::json;

template <class Sample>
json to_json(const Sample& sample) {
    std::string text;
    idl::append_json(idl::own_type<Sample>(), wire::encode(sample), text);
    json object = json::parse(text);
    for (const char* hash : {"state_hash", "definition_hash", "lesson_hash", "assessment_hash"})
        if (const auto found = object.find(hash); found != object.end()) *found = found->dump();
    return object;
}
#define WINDLASS_JSON_OF_TYPE(T) template json to_json(const T&);
WINDLASS_TOPIC_TYPES(WINDLASS_JSON_OF_TYPE)
#undef WINDLASS_JSON_OF_TYPE

namespace {

template <class T>
void put(json& object, const char* name, const Latest<T>& latest) {
    if (latest) object[name] = to_json(*latest);
}

} // namespace

json to_json(const Picture& picture, Clock::time_point now) {
    json object = json::object();
    put(object, "status", picture.status);
    if (const auto silent = picture.silence(now)) object["silence"] = *silent;
    put(object, "truth", picture.truth);
    put(object, "environment", picture.environment);
    put(object, "ship", picture.ship);
    put(object, "bridge", picture.bridge);
    put(object, "helm", picture.helm_in_force());
    for (const Alert& alert : picture.alerts)
        object["alerts"].push_back(to_json(alert));
    for (const BridgeOrder& order : picture.orders)
        object["orders"].push_back(to_json(order));
    for (const int side : {SIDE_PORT, SIDE_STARBOARD}) {
        const TacklePicture& tackle = picture.tackle[static_cast<std::size_t>(side)];
        json of_side = json::object();
        put(of_side, "forecastle", tackle.view);
        put(of_side, "anchor", tackle.anchor);
        put(of_side, "chain", tackle.chain);
        put(of_side, "windlass", tackle.load);
        put(of_side, "levers", tackle.levers_in_force());
        if (!of_side.empty()) object[std::string{side_name(side)}] = std::move(of_side);
    }
    return object;
}

} // namespace windlass::station
