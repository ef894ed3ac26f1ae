#include "server/exercise/definition/exercise_def.hpp"

#include "server/physics/sea/ground.hpp"
#include "server/physics/tackle/hawse_pipe_fit.hpp"

#include <algorithm>

namespace windlass::exercise {

using namespace physics;

const std::string& title_for_trainees(const ExerciseDef& def) {
    return def.title_trainee.empty() ? def.title : def.title_trainee;
}

double lip_clearance(const ExerciseDef& def) {
    double width = 0;
    for (const GroundTackleDef& tackle : def.tackle)
        width = std::max(width, tackle.chain.contact_diameter);
    return width;
}

double outboard(Side side) {
    return side == Side::port ? -1 : 1;
}

HawsePipe hawse_pipe(const ExerciseDef& def, const GroundTackleDef& tackle, const ObstacleMesh& hull) {
    return physics::fit_hawse_pipe(def.ship, tackle.windlass, tackle.chain, tackle.anchor, hull,
                                   outboard(tackle.side));
}

double water_depth(const ExerciseDef& def) {
    return def.environment.depth + def.weather.tide_height;
}

double depth_at_bow(const ExerciseDef& def) {
    const Vec3 bow = Vec3(def.ship_start.x, def.ship_start.y, 0) +
                     def.ship.hawse_forward * compass(def.ship_start.heading);
    return def.weather.tide_height - bed_height(def.environment, bow.x(), bow.y());
}

void lay_out(ExerciseDef& def) {
    physics::lay_bed(def.environment, def.environment.soil);
    for (GroundTackleDef& tackle : def.tackle) {
        const ChainDef chain = tackle.chain;
        tackle.chain = physics::stud_link_chain(chain.diameter, chain.grade, chain.length);
        tackle.chain.node_spacing = chain.node_spacing;
        const physics::AnchorDef anchor = tackle.anchor;
        tackle.anchor = physics::typical_anchor(anchor.type, anchor.mass);
        tackle.anchor.mass = anchor.mass;
        tackle.anchor.shank_length = anchor.shank_length;
        tackle.anchor.fluke_length = anchor.fluke_length;
        tackle.anchor.crown_width = anchor.crown_width;
        tackle.anchor.drag_area = anchor.drag_area;
    }
}

ChainDef modelled_chain(const ExerciseDef& def, const GroundTackleDef& tackle) {
    ChainDef chain = tackle.chain;
    if (def.model.adaptive) {
        chain.node_spacing =
            spacing_within(spacing_share(kModelBudget), depth_at_bow(def) + def.ship.hawse_height, chain,
                           tackle.anchor_home ? 0 : tackle.cable_out);
    }
    return chain;
}

} // namespace windlass::exercise
