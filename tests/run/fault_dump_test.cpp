// What is left behind of an exercise that had to be stopped: all of it.

#include "server/run/fault_dump.hpp"

#include "rigs/leaves.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <vector>

namespace windlass::run {
namespace {

using nlohmann::json;

/// Gives each value of a listed struct another one, and says which, as JSON has them, sorted.
template <class T>
std::vector<std::string> filled(T& object) {
    std::vector<std::string> values;
    int next = 1;
    rigs::each_leaf("", object, [&](const std::string&, auto& value) {
        using Leaf = std::remove_reference_t<decltype(value)>;
        if constexpr (std::is_same_v<Leaf, std::string>)
            values.push_back(json(value = "text " + std::to_string(next++)).dump());
        else if constexpr (std::is_enum_v<Leaf>)
            value = static_cast<Leaf>(next % 2), values.push_back(json(next++ % 2).dump());
        else
            values.push_back(json(value = static_cast<Leaf>(next++)).dump());
    });
    std::ranges::sort(values);
    return values;
}

/// Every number, flag and text that is anywhere in it, sorted.
std::vector<std::string> values_in(const json& object) {
    std::vector<std::string> values;
    const json flat = object.flatten();
    for (const json& value : flat)
        values.push_back(value.dump());
    std::ranges::sort(values);
    return values;
}

json dump_of(const exercise::Snapshot& last_good, const CommandHistory& history) {
    const auto folder =
        std::filesystem::path(testing::TempDir()) / ("windlass_fault_dump_test_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    const auto path = write_fault_dump(folder, "drill/1", last_good, history);
    EXPECT_EQ(path.filename(), "windlass-fault-drill_1-" + std::to_string(last_good.tick) + ".json");
    json dump = json::parse(std::ifstream(path));
    std::filesystem::remove_all(folder);
    return dump;
}

TEST(FaultDump, HasEveryFieldOfTheLastGoodPicture) {
    exercise::Snapshot picture;
    picture.tackle.resize(2);
    for (exercise::TackleView& tackle : picture.tackle) {
        tackle.chain.nodes.resize(3);
        tackle.chain.tension.resize(2);
        tackle.chain.marks.resize(1);
    }
    picture.environment.now.current_profile.resize(2);
    picture.environment.after.current_profile.resize(1);
    picture.sea.waves.resize(2);
    picture.faults.resize(1);
    picture.bridge_orders.resize(1);
    picture.events.resize(1);
    const auto values = filled(picture);
    EXPECT_GT(values.size(), 250U);
    EXPECT_EQ(values_in(dump_of(picture, {}).at("last_good")), values);
}

/// An order with values of its own in each field, and what they are.
template <class Order>
void give(CommandHistory& history, std::vector<std::vector<std::string>>& values) {
    Order order{};
    if constexpr (std::is_same_v<Order, exercise::EnvironmentOrder>) order.weather.current_profile.resize(1);
    values.push_back(filled(order));
    history.add(values.size(), order);
}
template <class... Orders>
void give_all(std::variant<Orders...>*, CommandHistory& history,
              std::vector<std::vector<std::string>>& values) {
    (give<Orders>(history, values), ...);
}

TEST(FaultDump, HasEveryFieldOfEveryOrder) {
    CommandHistory history;
    std::vector<std::vector<std::string>> values;
    give_all(static_cast<exercise::Order*>(nullptr), history, values);
    const json commands = dump_of({}, history).at("commands");
    ASSERT_EQ(commands.size(), values.size());
    for (std::size_t k = 0; k < values.size(); ++k) {
        json fields = commands[k];
        EXPECT_TRUE(fields["order"].is_string());
        EXPECT_EQ(fields["tick"], k + 1);
        fields.erase("order"), fields.erase("tick");
        EXPECT_EQ(values_in(fields), values[k]) << commands[k];
    }
}

} // namespace
} // namespace windlass::run
