#pragma once
// What is wrong with a windlass, its cable and what the anchor finds, and with the ship that bears them:
// causes, never effects. What follows comes out of the model.

#include "words/codes.hpp"

#include <array>
#include <cstddef>

namespace windlass::physics {

/// Each from 0 (sound) to 1 (gone); set from outside, by the instructor.
struct EquipmentFaults {
    // Band brake
    double lining_faded = 0;  ///< share of the lining's friction that is lost
    double lining_wet = 0;    ///< water film that spray and wash water keep up
    double lining_glazed = 0; ///< glaze that is there already, of what heat can make
    double lining_worn = 0;   ///< share of the lining that is gone already
    double brake_seized = 0;  ///< share of the hand-wheel's way in a time that spindle and band do not give
    // Prime mover
    double power_lost = 0;            ///< share of the motor's pull that is lost
    double overspeed_unprotected = 0; ///< above 0: nothing cuts in when the cable drives the motor too fast
    double pumps_lost = 0;            ///< share of the hydraulic flow that is lost: 0.5 is one of two pumps
    double relief_low = 0;            ///< share of the relief valve's pressure that is lost
    double counterbalance_open = 0;   ///< share of the counterbalance valve's pressure that is lost
    double hose_burst = 0;            ///< share of the hydraulic pressure that is lost
    double drive_trip = 0;            ///< above 0: trips the drive, once
    double relay_misset = 0; ///< share by which an electric drive's overload relay sees too much of the pull
    double phase_lost = 0;   ///< of a phase of an electric drive's supply, the share that is missing
    // Clutch, gypsy, stopper, load cell
    double clutch_worn = 0;     ///< dog clutch jumps out above (1 - this) x rated pull; 0: never
    double shaft_damaged = 0;   ///< share of the clutch's and shaft's strength that is lost
    double pockets_worn = 0;    ///< share of the gypsy's grip on the links that is lost
    double clutch_seized = 0;   ///< above 0: the dog clutch stays as it is
    double stopper_jammed = 0;  ///< above 0: the stopper's bar stays as it is
    double stopper_pin_out = 0; ///< the stopper's bar springs open above (1 - this) x its rating; 0: never
    double pipe_jammed = 0;     ///< share of the breaking load that a jam in the spurling pipe holds
    double bitter_end_weak = 0; ///< share of the strength of the bitter end's connection that is lost
    double link_weak = 0;       ///< share of the breaking load that one link has lost
    int weak_length = 0; ///< of the cable, from 1 at the anchor, whose middle link it is; 0: the link at the
                         ///< lip when it comes up
    double shackle_open = 0; ///< share of its strength that a joining shackle has lost whose pin works out
    int open_shackle = 0;    ///< which, from 1 nearest the anchor; 0: the last one over the lip, or the first
                             ///< when none is
    double cable_twisted = 0;  ///< above 0: puts turns in when it comes up, takes all out when it goes
    double counter_drift = 0;  ///< share of its pulses that the chain counter misses
    double load_cell_dead = 0; ///< share of the load that the cell does not show
    double load_cell_bias = 0; ///< share of the load by which it shows too much
    double cable_slipped = 0;  ///< above 0: broken on deck, and nothing holds it; men do that, and no fault
    // Under the anchor
    double anchor_fouled = 0; ///< something heavy (1: an old 78 mm cable) lies where the flukes dig in
    double soil_poor = 0;     ///< share of what flukes hold beyond sliding that this ground does not give
    double flukes_seized = 0; ///< above 0: the flukes do not turn on their pin
    // The ship; on both sides alike
    double ship_blackout =
        0; ///< above 0: no main supply: no engine, thrusters, windlasses; no steering at first
    double telegraph_failed = 0;        ///< above 0: engine orders do not get through
    double vhf_lost = 0, cctv_lost = 0; ///< above 0.5: no talk with the forecastle, no picture of it
};

/// What a fault of words.json is in the model.
struct FaultCause {
    words::FaultCode code;
    double EquipmentFaults::*cause;
    int EquipmentFaults::*target = nullptr; ///< where the model has several of the part: which it is, from 1
};

/// In the order of the codes.
inline constexpr std::array kFaultCauses = std::to_array<FaultCause>({
    {words::FaultCode::brake_lining_faded, &EquipmentFaults::lining_faded},
    {words::FaultCode::motor_power_lost, &EquipmentFaults::power_lost},
    {words::FaultCode::clutch_jumps_out, &EquipmentFaults::clutch_worn},
    {words::FaultCode::load_cell_dead, &EquipmentFaults::load_cell_dead},
    {words::FaultCode::brake_lining_worn, &EquipmentFaults::lining_worn},
    {words::FaultCode::brake_wet, &EquipmentFaults::lining_wet},
    {words::FaultCode::stopper_pin_out, &EquipmentFaults::stopper_pin_out},
    {words::FaultCode::hydraulic_pump_lost, &EquipmentFaults::pumps_lost},
    {words::FaultCode::hydraulic_hose_burst, &EquipmentFaults::hose_burst},
    {words::FaultCode::drive_trip, &EquipmentFaults::drive_trip},
    {words::FaultCode::blackout, &EquipmentFaults::power_lost},
    {words::FaultCode::clutch_shaft_damaged, &EquipmentFaults::shaft_damaged},
    {words::FaultCode::gypsy_pockets_worn, &EquipmentFaults::pockets_worn},
    {words::FaultCode::spurling_pipe_jammed, &EquipmentFaults::pipe_jammed},
    {words::FaultCode::chain_link_weak, &EquipmentFaults::link_weak, &EquipmentFaults::weak_length},
    {words::FaultCode::joining_shackle_open, &EquipmentFaults::shackle_open, &EquipmentFaults::open_shackle},
    {words::FaultCode::bitter_end_weak, &EquipmentFaults::bitter_end_weak},
    {words::FaultCode::chain_counter_drift, &EquipmentFaults::counter_drift},
    {words::FaultCode::anchor_fouled, &EquipmentFaults::anchor_fouled},
    {words::FaultCode::soil_poor, &EquipmentFaults::soil_poor},
    {words::FaultCode::cctv_lost, &EquipmentFaults::cctv_lost},
    {words::FaultCode::vhf_lost, &EquipmentFaults::vhf_lost},
    {words::FaultCode::brake_lining_glazed, &EquipmentFaults::lining_glazed},
    {words::FaultCode::overspeed_protection_lost, &EquipmentFaults::overspeed_unprotected},
    {words::FaultCode::counterbalance_stuck_open, &EquipmentFaults::counterbalance_open},
    {words::FaultCode::relief_valve_low, &EquipmentFaults::relief_low},
    {words::FaultCode::cable_twisted, &EquipmentFaults::cable_twisted},
    {words::FaultCode::brake_seized, &EquipmentFaults::brake_seized},
    {words::FaultCode::clutch_seized, &EquipmentFaults::clutch_seized},
    {words::FaultCode::stopper_jammed, &EquipmentFaults::stopper_jammed},
    {words::FaultCode::overload_relay_misset, &EquipmentFaults::relay_misset},
    {words::FaultCode::phase_lost, &EquipmentFaults::phase_lost},
    {words::FaultCode::flukes_seized, &EquipmentFaults::flukes_seized},
    {words::FaultCode::load_cell_bias, &EquipmentFaults::load_cell_bias},
    {words::FaultCode::telegraph_failed, &EquipmentFaults::telegraph_failed},
    {words::FaultCode::ship_blackout, &EquipmentFaults::ship_blackout},
});
static_assert(
    [] {
        for (std::size_t k = 0; k < kFaultCauses.size(); ++k)
            if (kFaultCauses[k].code != static_cast<words::FaultCode>(k)) return false;
        return kFaultCauses.size() == static_cast<std::size_t>(last_of(words::FaultCode{})) + 1;
    }(),
    "each fault of words.json has its cause here, in the order of the codes");

} // namespace windlass::physics
