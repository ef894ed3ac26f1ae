#pragma once
// The one table of faults: a new fault is a row in fault_table.cpp, and its cause where the model acts on it.
// Here nothing of the model is needed: a station may read it.

#include "server/exercise/definition/fault_code.hpp"

#include <span>
#include <string>

namespace windlass::physics {
struct EquipmentFaults;
}

namespace windlass::exercise {

/// One fault. Texts are one line for people, without a full stop.
struct FaultRow {
    FaultCode code;
    const char* name;     ///< as people type it, e.g. "brake-lining-faded"
    const char* symptom;  ///< what is noticed
    const char* reason;   ///< what is wrong
    const char* way_out;  ///< what a good hand does
    const char* severity; ///< what 1 means
    bool forecastle;      ///< whether it can be noticed there
    bool bridge;          ///< ... there; the instructor has the list
    /// The cause that it is in the model.
    double physics::EquipmentFaults::*cause = nullptr;
    /// Where the model has several of the part: which it is, from 1, and what is counted.
    int physics::EquipmentFaults::*target = nullptr;
    const char* targets = "";
    bool both_sides = false; ///< whichever side it is given for
};

/// Every fault, in the order of FaultCode.
std::span<const FaultRow> fault_table();

/// Throws std::out_of_range for a code beyond the last.
const FaultRow& fault_row(FaultCode code);

/// Name of a fault as people type it, e.g. "brake-lining-faded".
const char* fault_name(FaultCode code);

/// Its enumerator on the wire, e.g. "FAULT_BRAKE_LINING_FADED".
std::string fault_wire_name(FaultCode code);

/// The fault of a name as people type it; null for none.
const FaultRow* find_fault(const std::string& name);

/// "symptom; reason; way out", for a list of faults.
std::string fault_text(const FaultRow& row);

} // namespace windlass::exercise
