#pragma once
// How much one writer may say.

#include "idl/wire.hpp"

#include <vector>

namespace windlass::dds {

/// Lets so many samples a second of each writer pass. Bounded memory: of very many writers, the one not heard
/// for longest is forgotten. One thread at a time.
class FloodGate {
public:
    struct Rate {
        double per_second = 0;
        double burst = 0; ///< samples that may come at once after a pause
    };
    explicit FloodGate(Rate rate) : rate_(rate) {}

    /// May this sample pass, at wall time now (s, never going back)?
    bool pass(const wire::WriterId& writer, double now);

private:
    struct Entry {
        wire::WriterId writer{};
        double allowance = 0, heard = 0;
    };

    Rate rate_;
    std::vector<Entry> entries_;
};

} // namespace windlass::dds
