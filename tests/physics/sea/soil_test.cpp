// What the soil does to chain that lies on it: how deep it sinks in, what holds it back.

#include "server/physics/chain/chain_forces.hpp"
#include "tests/physics/solver/chain_rig.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace windlass::physics {
namespace {

class EverySoil : public testing::TestWithParam<Soil> {};

TEST_P(EverySoil, ChainSinksInUntilItsBedBearsIt) {
    EnvironmentDef sea = still_water(20);
    lay_bed(sea, GetParam());
    const ChainDef def = stud_link_chain(0.078, Grade::k3, 330);
    const double weight = weight_in_water(def, sea.water_density);
    const double deep = weight / (chain_bed(GetParam()).stiffness * def.contact_diameter);
    const Vec3 end(0, 0, -sea.depth - deep);
    ChainRig rig(def, sea, end + Vec3(40, 0, 0.3), end, 40, Foot::hanging);
    rig.run(20, 1.0 / 300);
    for (int i = 5; i < rig.state.links - 5; ++i) // clear of the ends, one held, one cut to half a link
        EXPECT_NEAR((-sea.depth - rig.state.position.z[i]) / deep, 1, 0.01) << "node " << i;
}

TEST_P(EverySoil, HoldsBackWithNoMoreThanItsSuction) {
    EnvironmentDef sea = still_water(20);
    lay_bed(sea, GetParam());
    const ChainDef def = stud_link_chain(0.078, Grade::k3, 330);
    const double deep = 0.1, max = sea.bed_suction * sea.bed_stiffness * def.contact_diameter * deep;
    const Vec3 at(0, 0, -sea.depth - deep), along(1, 0, 0);
    const NodeMedium m = node_medium(def, sea, at - along, at, at + along, 1);
    double min = 0;
    for (double rise = 0; rise < 20; rise += 0.01) {
        const Vec3 v(0, 0, rise);
        const NodeDamping damping = node_damping(def, sea, level_bed(sea), m, v, Vec3::Zero());
        min = std::min(min, bed_push(m, damping, rise, 0) - bed_hold(damping, 0) * rise);
    }
    EXPECT_GE(min, -max * (1 + 1e-12));
    EXPECT_NEAR(min, -max, bed_damper(m) * 0.01); // found to a centimetre a second
}

std::string name_of(const testing::TestParamInfo<Soil>& soil) {
    constexpr std::array kNames{"mud", "sand", "clay", "gravel", "rock", "coral", "mixed"};
    return kNames.at(static_cast<std::size_t>(soil.param));
}

INSTANTIATE_TEST_SUITE_P(Soil, EverySoil,
                         testing::Values(Soil::mud, Soil::sand, Soil::clay, Soil::gravel, Soil::rock,
                                         Soil::coral, Soil::mixed),
                         name_of);

} // namespace
} // namespace windlass::physics
