// States that no exercise ever had, as a checkpoint from outside may bring: refused, or run on without harm.

#include "server/exercise/checkpoint.hpp"

#include "rigs/drill.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

namespace windlass::exercise {
namespace {

using physics::FieldName;

/// Puts a value into one number of the state, counted in its order; -1: into none.
class PutIn final : public physics::StateVisitor {
public:
    PutIn(int which, double value) : which_(which), value_(value) {}
    void number(const FieldName&, double& value) override { put(value, value_); }
    void numbers(const FieldName&, double* first, std::size_t count) override {
        put(*first, value_); // one of the many stands for all
        if (count > 1) put(first[count - 1], value_);
    }
    void text(const FieldName&, std::string&) override {}
    void integer(const FieldName&, std::int64_t& value) override { put(value, whole()); }
    int seen() const { return seen_; }

private:
    template <class T>
    void put(T& value, T put_in) {
        if (seen_++ == which_) value = put_in;
    }
    std::int64_t whole() const {
        using Limits = std::numeric_limits<std::int64_t>;
        return !(value_ > -1e18) ? Limits::min() : value_ > 1e18 ? Limits::max() : std::int64_t(value_);
    }

    int which_, seen_ = 0;
    double value_;
};

/// Brought up to where the chain lies, some of it asleep: every list of the state is in use.
std::unique_ptr<Drill> lying() {
    auto drill = std::make_unique<Drill>(steady_breeze_def());
    drill->fault(FaultCode::brake_lining_faded, 0.2, FaultTrigger::at_cable_out, 1000);
    EXPECT_TRUE(lie_quietly(*drill));
    return drill;
}

TEST(HostileState, IsRefusedOrRunsOnWithoutHarm) {
    const auto drill = lying();
    auto& source = const_cast<Exercise&>(drill->exercise());
    const auto bytes = write_checkpoint(source);
    PutIn count(-1, 0);
    source.visit_state(count);
    ASSERT_GT(count.seen(), 50);
    int refused = 0, run_on = 0;
    for (const double value : {-1.0, 2147483647.0, 1e300, std::nan("")}) {
        for (int which = 0; which < count.seen(); ++which) {
            Exercise exercise = read_checkpoint(bytes);
            PutIn hostile(which, value);
            SCOPED_TRACE(std::to_string(which) + " = " + std::to_string(value));
            try {
                exercise.visit_state(hostile); // as when it is read
                Snapshot seen;
                for (int tick = 0; tick < 12 && exercise.step(1.0 / exercise.def().tick_rate_hz); ++tick)
                    exercise.view(seen);
                ++run_on;
            } catch (const std::exception&) {
                ++refused; // at once, or by the server's alarm when it comes to that
            }
        }
    }
    EXPECT_GT(refused, 0);
    EXPECT_GT(run_on, 0);
}

} // namespace
} // namespace windlass::exercise
