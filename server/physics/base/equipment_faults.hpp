#pragma once
// What is wrong with a windlass, its cable and what the anchor finds, and with the ship that bears them:
// causes, never effects. What follows comes out of the model.

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

} // namespace windlass::physics
