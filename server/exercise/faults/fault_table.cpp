#include "server/exercise/faults/fault_table.hpp"

#include "server/physics/base/equipment_faults.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace windlass::exercise {

namespace {

using Causes = physics::EquipmentFaults;

constexpr bool kForecastle = true, kBridge = true, kNot = false;

constexpr std::array kRows{
    FaultRow{FaultCode::brake_lining_faded, "brake-lining-faded", "brake hard on and the cable renders",
             "the lining has lost friction", "brake hard on at once, stopper on, tell the bridge",
             "no friction left", kForecastle, kNot, &Causes::lining_faded},
    FaultRow{FaultCode::motor_power_lost, "motor-power-lost",
             "power lamp out, the windlass neither heaves nor lowers", "the motor has lost its supply",
             "brake on, lever to zero, gear out, wait for power", "no pull left", kForecastle, kNot,
             &Causes::power_lost},
    FaultRow{FaultCode::clutch_jumps_out, "clutch-jumps-out",
             "claws spring out of gear under load and the cable runs", "the dog clutch's claws are worn",
             "brake on; gear in again only when the cable stands", "it jumps out under any load", kForecastle,
             kNot, &Causes::clutch_worn},
    FaultRow{FaultCode::load_cell_dead, "load-cell-dead", "the load gauge shows too little, or nothing",
             "the load cell has failed", "judge the load by the cable's lead and by ear", "it shows nothing",
             kForecastle, kNot, &Causes::load_cell_dead},
    FaultRow{FaultCode::brake_lining_worn, "brake-lining-worn",
             "the hand-wheel goes further and the brake holds less", "the lining is worn thin",
             "stopper on early, do not rely on the brake alone", "no lining left", kForecastle, kNot,
             &Causes::lining_worn},
    FaultRow{FaultCode::brake_wet, "brake-wet",
             "the brake holds less than it did, and bites again as it dries",
             "spray and wash water on the lining", "dry it by braking gently, stopper on", "wet through",
             kForecastle, kNot, &Causes::lining_wet},
    FaultRow{FaultCode::stopper_pin_out, "stopper-pin-out", "the stopper's bar springs open under load",
             "its pin has worked out", "brake hard on, lash the bar, look at it on every round",
             "it holds nothing", kForecastle, kNot, &Causes::stopper_pin_out},
    FaultRow{FaultCode::hydraulic_pump_lost, "hydraulic-pump-lost",
             "the windlass turns slowly and pulls less", "hydraulic pumps have failed",
             "go on at the speed that is left, tell the bridge", "no pump left; 0.5: one of two", kForecastle,
             kNot, &Causes::pumps_lost},
    FaultRow{FaultCode::hydraulic_hose_burst, "hydraulic-hose-burst",
             "pressure falls, heaving stops, oil on deck", "a hose has burst",
             "brake on, lever to zero, gear out, clear of the oil", "no pressure left", kForecastle, kNot,
             &Causes::hose_burst},
    FaultRow{FaultCode::drive_trip, "drive-trip", "trip lamp on, the motor stops", "the drive has tripped",
             "brake on, lever to zero to reset it", "any but 0 trips it, once", kForecastle, kNot,
             &Causes::drive_trip},
    FaultRow{.code = FaultCode::blackout,
             .name = "blackout",
             .symptom = "both windlasses are without power",
             .reason = "the deck's supply has failed",
             .way_out = "brakes on, levers to zero, gear out; let go on order",
             .severity = "no pull left",
             .forecastle = kForecastle,
             .bridge = kBridge,
             .cause = &Causes::power_lost,
             .both_sides = true},
    FaultRow{FaultCode::clutch_shaft_damaged, "clutch-shaft-damaged",
             "the shaft shears under load and the motor turns alone", "shaft or claws have cracked",
             "brake on before the load comes, stopper on, do not heave", "no strength left", kForecastle,
             kNot, &Causes::shaft_damaged},
    FaultRow{FaultCode::gypsy_pockets_worn, "gypsy-pockets-worn",
             "links jump over the gypsy and the cable runs", "the pockets are worn",
             "ease the load by the engine; the stopper when it stands", "no grip left", kForecastle, kNot,
             &Causes::pockets_worn},
    FaultRow{FaultCode::spurling_pipe_jammed, "spurling-pipe-jammed",
             "brake off and nothing runs; hove in, the cable heaps up below the gypsy",
             "the cable is fast in the spurling pipe", "work her back and forth with the motor",
             "it holds the cable's breaking load", kForecastle, kNot, &Causes::pipe_jammed},
    FaultRow{FaultCode::chain_link_weak, "chain-link-weak", "the cable parts below its strength",
             "a link is cracked", "keep the load down by the engine, second anchor ready", "no strength left",
             kForecastle, kBridge, &Causes::link_weak, &Causes::weak_length,
             "length of the cable, counted from the anchor"},
    FaultRow{FaultCode::joining_shackle_open, "joining-shackle-open", "the cable parts at a joining shackle",
             "its pin works out", "keep the load down by the engine, heave it in to look at it",
             "no strength left", kForecastle, kBridge, &Causes::shackle_open, &Causes::open_shackle,
             "joining shackle, counted from the anchor"},
    FaultRow{FaultCode::bitter_end_weak, "bitter-end-weak", "all cable out, the end comes out of the locker",
             "its connection in the locker is weak", "stop the cable before it comes to the end, keep clear",
             "no strength left", kForecastle, kNot, &Causes::bitter_end_weak},
    FaultRow{FaultCode::chain_counter_drift, "chain-counter-drift", "counter and painted marks differ",
             "the counter misses pulses", "go by the marks", "it counts nothing", kForecastle, kNot,
             &Causes::counter_drift},
    FaultRow{FaultCode::anchor_fouled, "anchor-fouled",
             "load high at the waterline, something hangs on the flukes",
             "an old cable lies where they dig in",
             "stop, report, hang it off and slip it before heaving home", "1: an old cable of 78 mm",
             kForecastle, kBridge, &Causes::anchor_fouled},
    FaultRow{FaultCode::soil_poor, "soil-poor", "the anchor does not bring her up, or drags early",
             "the ground holds less than the chart says", "more cable, engine ahead, another berth",
             "it holds no more than sliding does", kForecastle, kBridge, &Causes::soil_poor},
    FaultRow{FaultCode::cctv_lost, "cctv-lost", "no picture of the forecastle on the bridge",
             "camera or cable has failed", "ask by word for what was seen",
             "no picture; below 0.5 it is there", kNot, kBridge, &Causes::cctv_lost},
    FaultRow{FaultCode::vhf_lost, "vhf-lost", "no talk between bridge and forecastle", "the radio has failed",
             "second radio, telephone, bell and signs", "no word gets through; below 0.5 all do", kForecastle,
             kBridge, &Causes::vhf_lost},
    FaultRow{FaultCode::brake_lining_glazed, "brake-lining-glazed",
             "the brake holds less for good, also when it has cooled", "the lining was burnt and is glazed",
             "stopper on, do not let go on this brake", "glazed all over", kForecastle, kNot,
             &Causes::lining_glazed},
    FaultRow{FaultCode::overspeed_protection_lost, "overspeed-protection-lost",
             "the cable drives the motor ever faster", "nothing cuts in when it is driven too fast",
             "brake on at the first sign, lever to zero, clear the forecastle", "any but 0: it is off",
             kForecastle, kNot, &Causes::overspeed_unprotected},
    FaultRow{FaultCode::counterbalance_stuck_open, "counterbalance-stuck-open",
             "the motor turns backwards with the lever at zero or up", "the counterbalance valve lets oil by",
             "brake on at once, lever to zero", "it holds no pressure", kForecastle, kNot,
             &Causes::counterbalance_open},
    FaultRow{FaultCode::relief_valve_low, "relief-valve-low",
             "the motor stalls, or is turned back, at a load that it used to heave",
             "the relief valve opens too early", "ease the cable by the engine, brake on",
             "it holds no pressure", kForecastle, kNot, &Causes::relief_low},
    FaultRow{FaultCode::cable_twisted, "cable-twisted", "links do not lie fair at the lip and wedge there",
             "there are turns in the cable", "stop heaving, report, walk back and take the turns out",
             "any but 0 puts the turns in", kForecastle, kBridge, &Causes::cable_twisted},
    FaultRow{FaultCode::brake_seized, "brake-seized", "the hand-wheel does not turn",
             "spindle or band has seized", "stopper on, free it with no load on it",
             "it cannot be moved; less: slowly", kForecastle, kNot, &Causes::brake_seized},
    FaultRow{FaultCode::clutch_seized, "clutch-seized", "the clutch goes neither in nor out",
             "its claws have seized on the shaft", "work the motor back and forth, brake on",
             "any but 0: it cannot be moved", kForecastle, kNot, &Causes::clutch_seized},
    FaultRow{FaultCode::stopper_jammed, "stopper-jammed", "the stopper's bar cannot be moved",
             "its hinge has seized", "take the weight by the windlass, then lift it",
             "any but 0: it cannot be moved", kForecastle, kNot, &Causes::stopper_jammed},
    FaultRow{FaultCode::overload_relay_misset, "overload-relay-misset",
             "the drive trips at a load that it used to heave", "the overload relay is set too low",
             "heave with less load, have it set", "it sees twice the pull", kForecastle, kNot,
             &Causes::relay_misset},
    FaultRow{FaultCode::phase_lost, "phase-lost", "the motor hums, pulls little and grows hot",
             "one phase of the supply is missing", "lever to zero, brake on, have the fuses looked at",
             "one phase gone", kForecastle, kNot, &Causes::phase_lost},
    FaultRow{FaultCode::flukes_seized, "flukes-seized", "the anchor does not dig in",
             "the flukes do not turn at the crown", "weigh it, free them, let go again",
             "any but 0: they do not turn", kForecastle, kBridge, &Causes::flukes_seized},
    FaultRow{FaultCode::load_cell_bias, "load-cell-bias",
             "the load gauge shows more than the cable's lead and the motor tell",
             "the load cell's amplifier is out of adjustment", "judge the load by lead and by ear, report it",
             "it shows twice the load", kForecastle, kNot, &Causes::load_cell_bias},
    FaultRow{.code = FaultCode::telegraph_failed,
             .name = "telegraph-failed",
             .symptom = "the engine does not follow its orders",
             .reason = "the telegraph has failed",
             .way_out = "order by telephone, local control",
             .severity = "any but 0: no order gets through",
             .forecastle = kNot,
             .bridge = kBridge,
             .cause = &Causes::telegraph_failed,
             .both_sides = true},
    FaultRow{.code = FaultCode::ship_blackout,
             .name = "ship-blackout",
             .symptom = "engine, thrusters, steering, windlasses and instruments fail",
             .reason = "the ship's main supply has failed",
             .way_out = "brakes on, let go on order; the emergency supply steers her after 45 s",
             .severity = "any but 0: all of it",
             .forecastle = kForecastle,
             .bridge = kBridge,
             .cause = &Causes::ship_blackout,
             .both_sides = true},
};

static_assert(kRows.size() == kFaultCodes);
static_assert(
    [] {
        for (std::size_t k = 0; k < kRows.size(); ++k)
            if (kRows[k].code != static_cast<FaultCode>(k) || kRows[k].cause == nullptr) return false;
        return true;
    }(),
    "the rows stand in the order of the codes, and each has a cause in the model");

} // namespace

std::span<const FaultRow> fault_table() {
    return kRows;
}

const FaultRow& fault_row(FaultCode code) {
    return kRows.at(static_cast<std::size_t>(code));
}

const char* fault_name(FaultCode code) {
    return fault_row(code).name;
}

std::string fault_wire_name(FaultCode code) {
    std::string name = std::string("FAULT_") + fault_name(code);
    for (char& letter : name)
        letter = letter == '-'                    ? '_'
                 : letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A')
                                                  : letter;
    return name;
}

const FaultRow* find_fault(const std::string& name) {
    const auto found =
        std::find_if(kRows.begin(), kRows.end(), [&](const FaultRow& row) { return name == row.name; });
    return found == kRows.end() ? nullptr : &*found;
}

std::string fault_text(const FaultRow& row) {
    return std::string(row.symptom) + "; " + row.reason + "; " + row.way_out;
}

} // namespace windlass::exercise
