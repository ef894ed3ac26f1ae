#pragma once
// Whose hand is on which levers, and when a hand is gone. DDS gives the levers to the strongest writer that
// still speaks; here is kept who that is, and what is to be done when nobody speaks any more.

#include "server/exercise/orders.hpp"

#include <array>
#include <optional>
#include <string>

namespace windlass::server {

/// Levers that one hand works: a windlass, or the helm.
enum class LeverGroup { port_windlass, starboard_windlass, helm };
inline constexpr std::array kAllLeverGroups{LeverGroup::port_windlass, LeverGroup::starboard_windlass,
                                            LeverGroup::helm};

/// "port windlass", "starboard windlass", "helm".
const char* name(LeverGroup levers);

/// s of wall time without a word after which the hand on a lever is taken to be gone. A weaker client that
/// still speaks has taken over by then: see kCommandDeadline in idl/topics.hpp.
inline constexpr double kOwnerGone = 0.3;

class LeverOwnership {
public:
    /// The levers that an order moves; nothing for any other order.
    static std::optional<LeverGroup> levers_of(const exercise::Order& command);

    /// source gave an order to these levers at wall time now (s). Returns who had them when they change hands
    /// ("" when nobody had), else nothing.
    std::optional<std::string> take(LeverGroup levers, const std::string& source, double now);

    /// Who had these levers and has now been silent for too long; from here on nobody has them.
    std::optional<std::string> gone(LeverGroup levers, double now);

    /// Nobody has these levers.
    bool free(LeverGroup levers) const {
        return lever_ownership_[static_cast<std::size_t>(levers)].source.empty();
    }

    /// Nobody has any levers.
    void clear() { lever_ownership_ = {}; }

private:
    struct Owner {
        std::string source; // empty: nobody
        double heard = 0;
    };
    Owner& hand(LeverGroup levers) { return lever_ownership_[static_cast<std::size_t>(levers)]; }

    std::array<Owner, kAllLeverGroups.size()> lever_ownership_;
};

} // namespace windlass::server
