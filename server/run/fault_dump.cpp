#include "server/run/fault_dump.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <cctype>
#include <fstream>
#include <stdexcept>
#include <type_traits>
#include <variant>

namespace windlass::run {

namespace {

using nlohmann::json;

constexpr std::size_t kCommandsKept = 256; // over ten seconds of two clients at 10 Hz

/// A number, text or flag; an enumerator by its number; a vector or quaternion (w, x, y, z) as a list; a
/// struct as an object of all the fields of its list.
template <class T>
json as_json(const T& value) {
    if constexpr (Listed<T>) {
        json object;
        for_each_field<T>([&](auto field) { object[field.name] = as_json(field.of(value)); });
        return object;
    } else if constexpr (std::is_enum_v<T>) {
        return static_cast<int>(value);
    } else if constexpr (std::is_same_v<T, Eigen::Quaterniond>) {
        return {value.w(), value.x(), value.y(), value.z()};
    } else if constexpr (requires { value.begin(); } && !std::is_same_v<T, std::string>) {
        json list = json::array();
        for (const auto& each : value)
            list.push_back(as_json(each));
        return list;
    } else {
        return value;
    }
}

/// What an order is called in the dump, in the order of exercise::Order.
constexpr std::array kOrderNames{
    "windlass",          "helm",      "fault",  "environment", "report",          "bridge", "watch_circle",
    "lights_and_shapes", "deck_work", "chance", "own_ship",    "assessor's word", "answer"};
static_assert(kOrderNames.size() == std::variant_size_v<exercise::Order>);

/// A file name from a name that people chose.
std::string file_safe(std::string name) {
    for (char& c : name) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '_') c = '_';
    }
    return name;
}

} // namespace

void CommandHistory::add(std::uint64_t tick, const exercise::Order& command) {
    if (entries_.size() == kCommandsKept) entries_.pop_front();
    entries_.push_back({tick, command});
}

std::filesystem::path write_fault_dump(const std::filesystem::path& folder, const std::string& exercise,
                                       const exercise::Snapshot& last_good, const CommandHistory& history) {
    json commands = json::array();
    for (const auto& [tick, command] : history.entries()) {
        json entry = std::visit([](const auto& order) { return as_json(order); }, command);
        entry["order"] = kOrderNames.at(command.index());
        entry["tick"] = tick;
        commands.push_back(std::move(entry));
    }
    const json dump{
        {"exercise", exercise}, {"last_good", as_json(last_good)}, {"commands", std::move(commands)}};
    auto path =
        folder / ("windlass-fault-" + file_safe(exercise) + "-" + std::to_string(last_good.tick) + ".json");
    std::ofstream file(path);
    file << dump.dump(1) << '\n';
    file.close();
    if (!file) throw std::runtime_error("cannot write " + path.string());
    return path;
}

} // namespace windlass::run
