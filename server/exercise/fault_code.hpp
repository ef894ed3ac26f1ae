#pragma once
// The faults that the wire knows, and which of them are causes in the model.

namespace windlass::exercise {

/// In the order of idl FaultCode.
enum class FaultCode {
    brake_lining_faded,
    motor_power_lost,
    clutch_jumps_out,
    load_cell_dead,
    brake_lining_worn,
    brake_wet,
    stopper_pin_out,
    hydraulic_pump_lost,
    hydraulic_hose_burst,
    drive_trip,
    blackout,
    clutch_shaft_damaged,
    gypsy_pockets_worn,
    spurling_pipe_jammed,
    chain_link_weak,
    joining_shackle_open,
    bitter_end_weak,
    chain_counter_drift,
    anchor_fouled,
    soil_poor,
    cctv_lost,
    vhf_lost,
    brake_lining_glazed,
    overspeed_protection_lost,
    counterbalance_stuck_open,
    relief_valve_low,
    cable_twisted
};
constexpr FaultCode last_of(FaultCode) {
    return FaultCode::cable_twisted;
}

/// Whether the fault is a cause in the model; others are refused. False for a code beyond the last.
constexpr bool modelled(FaultCode code) {
    switch (code) {
    case FaultCode::brake_lining_faded:
    case FaultCode::motor_power_lost:
    case FaultCode::clutch_jumps_out:
    case FaultCode::load_cell_dead:
    case FaultCode::brake_lining_worn:
    case FaultCode::brake_wet:
    case FaultCode::stopper_pin_out:
    case FaultCode::hydraulic_pump_lost:
    case FaultCode::hydraulic_hose_burst:
    case FaultCode::drive_trip:
    case FaultCode::blackout:
    case FaultCode::clutch_shaft_damaged:
    case FaultCode::gypsy_pockets_worn:
    case FaultCode::spurling_pipe_jammed:
    case FaultCode::chain_link_weak:
    case FaultCode::joining_shackle_open:
    case FaultCode::bitter_end_weak:
    case FaultCode::brake_lining_glazed:
    case FaultCode::overspeed_protection_lost:
    case FaultCode::counterbalance_stuck_open:
    case FaultCode::relief_valve_low:
    case FaultCode::chain_counter_drift:
    case FaultCode::cable_twisted:
    case FaultCode::anchor_fouled:
    case FaultCode::soil_poor:
        return true;
    case FaultCode::cctv_lost:
    case FaultCode::vhf_lost:
        return false;
    }
    return false;
}

/// Name of a fault as people type it, e.g. "brake-lining-faded".
const char* fault_name(FaultCode code);

} // namespace windlass::exercise
