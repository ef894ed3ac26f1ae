// Tests side by side never share a domain, whatever becomes of them.

#include "rigs/child_process.hpp"

#include <gtest/gtest.h>

namespace windlass::test {
using namespace rigs;

namespace {

TEST(OwnDomain, IsHeldForThisProcess) {
    EXPECT_EQ(own_domain(), own_domain());
    EXPECT_FALSE(HeldDomain::hold(own_domain()));
}

TEST(OwnDomain, OfTwoHeldAtATimeEachIsAnother) {
    const HeldDomain one = hold_any_domain(), two = hold_any_domain();
    EXPECT_NE(one.number(), two.number());
}

TEST(OwnDomain, IsFreeAgainWhenTheLastProgramThatHasItIsKilled) {
    std::optional<HeldDomain> held = hold_any_domain();
    const int number = held->number();
    ChildProcess orphan({"/bin/sleep", "600"});
    held.reset();
    EXPECT_FALSE(HeldDomain::hold(number));
    orphan.signal(SIGKILL);
    orphan.exit_code();
    EXPECT_TRUE(HeldDomain::hold(number));
}

TEST(OwnDomain, IsNoneInWhichAProgramListensAlready) {
    const HeldDomain held = hold_any_domain();
    ASSERT_TRUE(is_quiet(held.number()));
    const int listener = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    sockaddr_in port{};
    port.sin_family = AF_INET;
    port.sin_port = htons(static_cast<std::uint16_t>(7400 + 250 * held.number() + 10));
    ASSERT_EQ(bind(listener, reinterpret_cast<const sockaddr*>(&port), sizeof port), 0);
    EXPECT_FALSE(is_quiet(held.number()));
    close(listener);
}

} // namespace
} // namespace windlass::test
