// One who floods the classroom with orders and garbage: exercises run on to the bit.

#include "tests/wire/hostile_rig.hpp"

#include <atomic>
#include <random>

namespace windlass::test {
using namespace rigs;

namespace {

/// One who means harm in the classroom, and hears what server "hostile" says to it.
class ClassroomEnemy {
public:
    bool matched() const { return orders_.matched() > 0; }
    std::size_t events() const {
        const std::lock_guard lock(mutex_);
        return events_.size();
    }
    bool has_refused(const std::string& field) const {
        const std::lock_guard lock(mutex_);
        return std::any_of(events_.begin(), events_.end(), [&](const Event& e) {
            return e.text().to_string().find(field) != std::string::npos;
        });
    }
    /// The next of: garbage, a definition longer than there may be, one that is there and of no use.
    void order(std::uint64_t serial) {
        if (serial % 3 == 0) {
            Payload garbage(4 + random_() % 300);
            std::generate(garbage.begin(), garbage.end(),
                          [&] { return static_cast<std::uint8_t>(random_()); });
            orders_.write(garbage);
            return;
        }
        auto create = signed_by<ClassroomCommand>("enemy", serial);
        create.server("hostile");
        create.id("x");
        create.definition().assign(serial % 300 == 1 ? 262144 : 8, '[');
        auto bytes = cdr(create);
        if (serial % 3 == 2) bytes = with(bytes, places(bytes, 8).back(), 262145);
        orders_.write(bytes);
    }

private:
    std::mt19937 random_{5};
    mutable std::mutex mutex_;
    std::vector<Event> events_;
    wire::Participant participant_{{own_domain(), wire::kClassroomPartition, "enemy"}};
    wire::RawWriter orders_{participant_, topics::classroom_command};
    wire::Reader<Event> log_{participant_, topics::event, [this](const Event& e) {
                                 const std::lock_guard lock(mutex_);
                                 events_.push_back(e);
                             }};
};

TEST_F(Hostile, FloodOfClassroomOrdersChangesNotABitAndIsToldAsRefused) {
    ClassroomEnemy enemy;
    ASSERT_TRUE(eventually([&] { return enemy.matched(); }));
    flood([&](std::uint64_t serial) { enemy.order(serial); });
    for (const char* field : {"rate = ", "payload = ", "definition = 8 bytes"})
        EXPECT_TRUE(eventually([&] { return enemy.has_refused(field); })) << field;
    // 10 refusals a second and a burst of 20, whatever came.
    EXPECT_LT(static_cast<double>(enemy.events()), 20 + 10 * (seconds() + 1));
    expect_unharmed();
}

/// How 3 s of exercise ended that an instructor started: tick and bits.
std::pair<std::uint64_t, std::uint64_t> run_with(ClassroomEnemy* enemy) {
    ServerProcess server({"--domain", std::to_string(own_domain()), "--name", "hostile", "--partition",
                          "hostile", "--wait", "--duration", "3"});
    std::atomic<std::uint64_t> tick = 0, hash = 0;
    wire::Participant instructor(member("instructor"));
    const wire::Reader<ExerciseTruth> statuses(instructor, topics::exercise_truth,
                                               [&](const ExerciseTruth& s) {
                                                   hash = s.state_hash();
                                                   tick = s.tick();
                                               });
    wire::Writer<ExerciseCommand> orders(instructor, topics::exercise_command);
    EXPECT_TRUE(eventually([&] { return orders.matched() > 0 && hash != 0; })) << server.text();
    EXPECT_TRUE(!enemy || eventually([&] { return enemy->matched(); }));
    auto start = signed_by<ExerciseCommand>("instructor", 1);
    start.action(EXERCISE_START);
    std::uint64_t serial = 0;
    if (enemy) enemy->order(++serial);
    orders.write(start);
    EXPECT_TRUE(eventually([&] {
        for (int i = 0; enemy && i < 30; ++i) // thousands a second
            enemy->order(++serial);
        return server.ended();
    })) << server.text();
    EXPECT_EQ(server.exit_code(), 0) << server.text();
    return {tick, hash};
}

TEST(Exercise, RunsTheSameBitsUnderAFloodOfClassroomOrders) {
    const auto alone = run_with(nullptr);
    ClassroomEnemy enemy;
    const auto flooded = run_with(&enemy);
    EXPECT_TRUE(enemy.has_refused("rate = "));
    EXPECT_EQ(alone.first, 900U); // 3 s of 300 Hz
    EXPECT_EQ(flooded, alone);
}

} // namespace
} // namespace windlass::test
