#pragma once
// A windlass as data: gypsy, band brake, dog clutch, chain stopper, prime mover, and the way of the chain on
// deck. Forces are at the gypsy's pitch line, so that they compare with the chain's pull.

namespace windlass::physics {

/// What drives a windlass.
enum class DriveKind { electric_vfd, electric_pole_changing, hydraulic };

/// How chain is stopped: a bar holds it both ways, a pawl only against running out.
enum class StopperKind { bar, pawl };

/// K, of the air on deck and of what is cold there.
inline constexpr double kAirTemperature = 293.15;

/// One cable lifter with its drive: what differs from one to another. What is alike in all of them is a
/// constant of the part that it belongs to. Defaults fit 78 mm K3 chain and a 9 900 kg anchor.
/// Sources: IACS UR A3 Rev.1 (2019) for pulls, speeds and brake; cultofsea.com ship table (brake 209 t,
/// lift 40 t, 12 m/min for 78 mm); values marked tuned have no published figure.
struct WindlassDef {
    // The way of the chain
    double hawse_pipe_height = 6;       ///< m, gypsy above the hawse pipe lip
    double hawse_pipe_length = 8;       ///< m of chain between gypsy and lip
    double locker_lift = 10;            ///< m, gypsy above the chain in the locker
    double bitter_end_strength = 9.0e5; ///< N, connection in the locker: 20 % of the breaking load; 15-30 %
                                        ///< is usual (cultofsea.com)

    // Gypsy (cable lifter)
    double gypsy_radius = 0.50; ///< m, pitch radius; 5 pockets: 40 d a revolution = 3.12 m, PCD 12.73 d
    double gypsy_inertia = 900; ///< kg m2, gypsy, drum and lifter shaft; tuned: 3.5 t of rim at 0.5 m

    double gypsy_grip = 9.0e6; ///< N, at which links leave sound pockets: twice the breaking load; tuned

    // Chain counter, a pick-up at the gypsy
    double counter_offset = 0; ///< m, by which it was set wrong: it shows so much more than is out

    // Band brake on the gypsy
    double brake_rating = 2.05e6; ///< N, full hand-wheel, cold lining: 209 t, 46 % of the breaking load
    /// Share of the hand-wheel's travel from open to where the lining touches the drum; tuned: 1 to 1.5 mm
    /// clear of it all round take 5 to 8 mm of a band that stretches by 5 mm from there to hard on.
    double brake_free_play = 0.4;
    /// Power with which the grip grows over the rest of the travel; tuned: pull and lined arc of a band that
    /// closes both grow with the travel, which by the capstan equation is a power of 2 at first and of 3.2 at
    /// the end.
    double brake_stiffening = 2.5;
    /// s, hand-wheel or cylinder from open to hard on: five turns at one a second; tuned (1 to 1.5 turns a
    /// second while it is slack, less in the last).
    double brake_travel_time = 5.0;
    double brake_track_area = 0.75;    ///< m2 of drum under the lining: 1.2 m across, 0.2 m wide; tuned
    double drum_heat_capacity = 6.9e5; ///< J/K, rim of 1.5 t of steel at 460 J/(kg K)
    double drum_cooling = 150;         ///< W/K, drum to air; tuned

    // Chain stopper
    StopperKind stopper = StopperKind::bar;
    double stopper_rating = 3.605e6; ///< N, 0.8 of the breaking load (UR A3 3.1.6), in whole kN above it

    // Prime mover, through gear and dog clutch
    DriveKind drive = DriveKind::electric_vfd;
    double rated_pull = 4.33e5;        ///< N, 1.5 Zcont = 1.5 x 47.5 d^2 N (UR A3 3.1.2, 3.1.3)
    double rated_speed = 0.15;         ///< m/s (UR A3 3.1.4)
    double stall_pull = 8.66e5;        ///< N, at standstill: twice rated; 2-2.5 is usual; electric
    double light_line_speed = 0.40;    ///< m/s with an empty gypsy: 2-3 times rated; electric
    double motor_inertia = 1.2;        ///< kg m2 at the motor shaft; tuned
    double shaft_brake_rating = 6.5e5; ///< N, fail-safe brake on the motor shaft: 1.5 rated pull
    double motor_current_rated = 180;  ///< A at rated pull (90 kW at 440 V)

    // Hydraulic prime mover: low-pressure vane motor. A windlass on record showed 50 bar with one pump and
    // 130 bar with two (MARS report, anchor handler).
    int hydraulic_pumps = 2;
    double hydraulic_pump_flow = 6.8e-3; ///< m3/s of each pump: 410 l/min
    double hydraulic_relief = 1.3e7;     ///< Pa, relief valve
    double hydraulic_counterbalance =
        1.7e7; ///< Pa, that the counterbalance valve holds: 1.3 x relief is usual
    double hydraulic_displacement = 1.78e-3; ///< m3 for each motor revolution: relief pressure is 1.5 x rated
    double hydraulic_leakage = 1.6e-10; ///< m3/s for each Pa past the motor: 10 % of the flow at rated pull

    // Dog clutch
    double clutch_rating = 2.0e6; ///< N, at which claws or shaft shear: 4.6 x rated pull; tuned
};

} // namespace windlass::physics
