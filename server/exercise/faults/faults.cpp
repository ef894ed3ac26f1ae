#include "server/exercise/faults/faults.hpp"

#include "server/physics/base/state_limits.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace windlass::exercise {

void FaultBook::raise(std::size_t place, double time, const EventLog& log) {
    FaultView& fault = faults_[place];
    fault.phase = FaultPhase::active;
    progress_[place].active_since = time;
    fault.severity_now = severity_at(place, time);
    log("fault.active", static_cast<int>(fault.order.side), fault.order.severity,
        std::string(words::row_of(fault.order.code).name) + " is active");
}

double FaultBook::severity_at(std::size_t place, double time) const {
    const FaultOrder& order = faults_[place].order;
    const Progress& progress = progress_[place];
    const double passed = time - progress.active_since;
    if (order.ramp == 0 || passed >= order.ramp) return order.severity;
    // A state from outside may have it begin later than now.
    return progress.from + (order.severity - progress.from) * (std::max(0.0, passed) / order.ramp);
}

bool FaultBook::due(std::size_t place, const TriggerInputs& inputs,
                    const std::vector<ExerciseEvent>& events) {
    const FaultOrder& order = faults_[place].order;
    Progress& progress = progress_[place];
    // A value that is below from the start says nothing: cable comes in, or a load comes off, only once it
    // has been above.
    const auto has_come_down = [&](double value) {
        progress.above = progress.above || value > order.trigger_value;
        return progress.above && value <= order.trigger_value;
    };
    switch (order.trigger) {
    case FaultTrigger::now:
        return true;
    case FaultTrigger::at_time:
        return inputs.time >= order.trigger_value;
    case FaultTrigger::at_cable_out:
        return inputs.cable_out >= order.trigger_value;
    case FaultTrigger::at_load:
        return inputs.gypsy_load >= order.trigger_value;
    case FaultTrigger::at_cable_out_at_most:
        return has_come_down(inputs.cable_out);
    case FaultTrigger::at_load_at_most:
        return has_come_down(inputs.gypsy_load);
    case FaultTrigger::at_event:
        // Of the ticks after it was armed, so that its own arming is none.
        return std::any_of(events.begin(), events.end(), [&](const ExerciseEvent& event) {
            const bool of_side = event.side < 0 || event.side == static_cast<int>(order.side);
            return of_side && event.time > progress.armed_at && event.code == order.trigger_event;
        });
    case FaultTrigger::at_order:
        return progress.heard;
    case FaultTrigger::at_chance:
        return progress.drawn && inputs.time >= progress.moment;
    }
    return false;
}

void FaultBook::order(const FaultOrder& order, double time, const EventLog& log) {
    assert(order.severity >= 0 && order.severity <= 1 && order.ramp >= 0 && "orders are checked before");
    const auto found = std::find_if(faults_.begin(), faults_.end(), [&](const FaultView& f) {
        return f.order.code == order.code && f.order.side == order.side;
    });
    auto place = static_cast<std::size_t>(found - faults_.begin());
    const int side = static_cast<int>(order.side);
    if (order.clear) {
        if (found == faults_.end() || found->phase == FaultPhase::cleared) return;
        clear(place, log);
        return;
    }
    if (found == faults_.end()) {
        place = faults_.size();
        faults_.emplace_back();
        progress_.emplace_back();
    }
    const double was = faults_[place].severity_now;
    faults_[place] = {order, FaultPhase::armed, 0};
    progress_[place] = {.armed_at = time, .arming = ++armings_};
    if (order.trigger == FaultTrigger::now) {
        progress_[place].from = was;
        raise(place, time, log);
    } else {
        log("fault.armed", side, order.trigger_value,
            std::string(words::row_of(order.code).name) + " is armed");
    }
}

void FaultBook::draw(const ChanceDrawn& drawn) {
    assert(drawn.chance >= 0 && drawn.chance <= 1 && "a draw is a share of the window");
    std::size_t newest = faults_.size();
    for (std::size_t k = 0; k < faults_.size(); ++k) {
        const bool waits = faults_[k].order.trigger == FaultTrigger::at_chance &&
                           faults_[k].phase == FaultPhase::armed && !progress_[k].drawn;
        if (waits && (newest == faults_.size() || progress_[k].arming > progress_[newest].arming)) newest = k;
    }
    if (newest == faults_.size()) return;
    const FaultOrder& order = faults_[newest].order;
    progress_[newest].drawn = true;
    progress_[newest].moment =
        order.trigger_value + drawn.chance * (order.trigger_until - order.trigger_value);
}

void FaultBook::hear(const BridgeOrderGiven& given) {
    for (std::size_t k = 0; k < faults_.size(); ++k) {
        const FaultOrder& order = faults_[k].order;
        const bool of_side = given.side < 0 || given.side == static_cast<int>(order.side);
        const bool waits = faults_[k].phase == FaultPhase::armed && order.trigger == FaultTrigger::at_order;
        if (waits && of_side && order.trigger_order == given.code) progress_[k].heard = true;
    }
}

void FaultBook::advance(double time, const EventLog& log) {
    for (std::size_t k = 0; k < faults_.size(); ++k) {
        if (faults_[k].phase != FaultPhase::active) continue;
        const double lasts = faults_[k].order.lasts;
        if (lasts > 0 && time >= progress_[k].active_since + lasts)
            clear(k, log);
        else
            faults_[k].severity_now = severity_at(k, time);
    }
}

void FaultBook::clear(std::size_t place, const EventLog& log) {
    FaultView& fault = faults_[place];
    fault.phase = FaultPhase::cleared;
    fault.severity_now = 0;
    log("fault.cleared", static_cast<int>(fault.order.side), 0,
        std::string(words::row_of(fault.order.code).name) + " is cleared");
}

void FaultBook::watch(Side side, const TriggerInputs& inputs, const std::vector<ExerciseEvent>& events,
                      const EventLog& log) {
    for (std::size_t k = 0; k < faults_.size(); ++k) {
        const bool waits = faults_[k].order.side == side && faults_[k].phase == FaultPhase::armed;
        if (waits && due(k, inputs, events)) raise(k, inputs.time, log);
    }
}

physics::EquipmentFaults FaultBook::causes(Side side) const {
    physics::EquipmentFaults causes;
    for (const FaultView& fault : faults_) {
        const bool both_sides = words::row_of(fault.order.code).both_sides;
        if ((fault.order.side != side && !both_sides) || fault.phase != FaultPhase::active) continue;
        const auto& [code, cause, target] =
            physics::kFaultCauses.at(static_cast<std::size_t>(fault.order.code));
        causes.*cause = std::max(causes.*cause, fault.severity_now);
        if (target != nullptr) causes.*target = fault.order.target;
    }
    if (causes.ship_blackout > 0) causes.power_lost = 1; // the windlasses' supply is the ship's
    return causes;
}

double FaultBook::seconds_of(FaultCode code, double time) const {
    double longest = -1;
    for (std::size_t k = 0; k < faults_.size(); ++k)
        if (faults_[k].order.code == code && faults_[k].phase == FaultPhase::active)
            longest = std::max(longest, time - progress_[k].active_since);
    return longest;
}

template <class Visitor, physics::StateOf<FaultOrder> State>
void visit_state(Visitor& v, State& order) {
    constexpr double kDay = 86400; // s, as orders may ask for
    auto& [code, side, severity, ramp, lasts, trigger, trigger_value, trigger_until, trigger_event,
           trigger_order, target, clear] = order;
    WINDLASS_STATE(v, code, side, severity, ramp, lasts, trigger, trigger_value, trigger_until, trigger_event,
                   trigger_order, target, clear);
    v.within({"severity"}, severity, 0, 1);
    v.within({"ramp"}, ramp, 0, kDay);
    v.within({"lasts"}, lasts, 0, kDay);
    v.within({"target"}, target, 0, 100);
    if constexpr (Visitor::kRestores)
        if (trigger == FaultTrigger::at_event && words::place_of(words::kEventsWaitedFor, trigger_event) < 0)
            throw physics::StateError("trigger_event = \"" + trigger_event +
                                      "\"; allowed: an event that the exercise calls");
}
WINDLASS_STATE_LISTED(FaultOrder);

template <class Visitor, physics::StateOf<FaultBook> Self>
void visit_state(Visitor& v, Self& self) {
    v.length({"count"}, self.faults_, 2 * kFaultCodes); // one for each code and side
    WINDLASS_STATE(v, self.armings_);
    if constexpr (Visitor::kRestores) self.progress_.resize(self.faults_.size());
    for (std::size_t k = 0; k < self.faults_.size(); ++k) {
        auto& [order, phase, severity_now] = self.faults_[k];
        WINDLASS_STATE(v, phase, severity_now, order);
        v.within({"severity_now"}, severity_now, 0, 1);
        auto& [armed_at, active_since, from, above, heard, drawn, moment, arming] = self.progress_[k];
        WINDLASS_STATE(v, armed_at, active_since, from, above, heard, drawn, moment, arming);
        WINDLASS_WITHIN(v, -physics::kLongest, physics::kLongest, armed_at, active_since);
        v.within({"from"}, from, 0, 1);
    }
}
WINDLASS_STATE_LISTED(FaultBook);

} // namespace windlass::exercise
