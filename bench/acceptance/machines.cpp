#include "bench/acceptance/machines.hpp"

#include "server/config/config.hpp"
#include "server/config/config_json.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace windlass::lab {

namespace fs = std::filesystem;
using config::ConfigKind;

namespace {

struct Size {
    const char *ending, *chain, *anchor;
};

/// IACS UR A1 and the cultofsea.com ship table: which anchor goes with which chain.
constexpr Size kSizes[]{
    {"_46mm", "stud_link_46mm_k3", "stockless_3540"},    {"_52mm", "stud_link_52mm_k3", "stockless_4650"},
    {"_78mm", "stud_link_78mm_k3", "stockless_9900"},    {"_95mm", "stud_link_95mm_k3", "stockless_14700"},
    {"_100mm", "stud_link_100mm_k3", "stockless_16900"}, {"_117mm", "stud_link_117mm_k3", "stockless_23000"}};

nlohmann::json document(ConfigKind kind, const std::string& name, const fs::path& root) {
    return config::load_document(kind, root / config::config_folder(kind) / (name + ".json"), root);
}

} // namespace

std::vector<Machine> shipped_machines(const fs::path& config_root) {
    std::vector<Machine> machines;
    for (const auto& entry :
         fs::directory_iterator(config_root / config::config_folder(ConfigKind::windlass))) {
        const std::string name = entry.path().stem().string();
        const auto size = std::find_if(std::begin(kSizes), std::end(kSizes),
                                       [&](const Size& s) { return name.ends_with(s.ending); });
        if (size == std::end(kSizes)) continue;
        const exercise::ExerciseDef def = config::exercise_from_json(
            {{"tackle",
              {{{"windlass", document(ConfigKind::windlass, name, config_root)},
                {"chain", document(ConfigKind::chain, size->chain, config_root)},
                {"anchor", document(ConfigKind::anchor, size->anchor, config_root)}}}}});
        const exercise::GroundTackleDef& tackle = def.tackle.front();
        physics::TackleSetup setup;
        setup.windlass = tackle.windlass, setup.chain = tackle.chain, setup.anchor = tackle.anchor;
        machines.push_back({name, setup});
    }
    std::sort(machines.begin(), machines.end(), [](const Machine& a, const Machine& b) {
        const double smaller = a.setup.chain.diameter - b.setup.chain.diameter;
        return smaller != 0 ? smaller < 0 : a.name < b.name;
    });
    return machines;
}

} // namespace windlass::lab
