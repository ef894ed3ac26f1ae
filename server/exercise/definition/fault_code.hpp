#pragma once
// The faults that the wire knows. What each is, and which are causes in the model: fault_table.hpp.

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
    cable_twisted,
    brake_seized,
    clutch_seized,
    stopper_jammed,
    overload_relay_misset,
    phase_lost,
    flukes_seized,
    load_cell_bias,
    telegraph_failed,
    ship_blackout
};
constexpr FaultCode last_of(FaultCode) {
    return FaultCode::ship_blackout;
}

inline constexpr int kFaultCodes = static_cast<int>(FaultCode::ship_blackout) + 1;

} // namespace windlass::exercise
