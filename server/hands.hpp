#pragma once
// Whose hand is on which levers, and when a hand is gone. DDS gives the levers to the strongest writer that
// still speaks; here is kept who that is, and what is to be done when nobody speaks any more.

#include "server/exercise/commands.hpp"

#include <array>
#include <optional>
#include <string>

namespace windlass::server {

/// Levers that one hand works: a windlass, or the helm.
enum class Levers { port_windlass, starboard_windlass, helm };
inline constexpr std::array kAllLevers{Levers::port_windlass, Levers::starboard_windlass, Levers::helm};

/// "port windlass", "starboard windlass", "helm".
const char* name(Levers levers);

/// s of wall time without a word after which the hand on a lever is taken to be gone. A weaker client that
/// still speaks has taken over by then: see kCommandDeadline in idl/topics.hpp.
inline constexpr double kHandGone = 0.3;

class Hands {
public:
    /// The levers that an order moves; nothing for any other order.
    static std::optional<Levers> levers_of(const exercise::Command& command);

    /// source gave an order to these levers at wall time now (s). Returns who had them when they change hands
    /// ("" when nobody had), else nothing.
    std::optional<std::string> take(Levers levers, const std::string& source, double now);

    /// Who had these levers and has now been silent for too long; from here on nobody has them.
    std::optional<std::string> gone(Levers levers, double now);

    /// Nobody has these levers.
    bool free(Levers levers) const { return hands_[static_cast<std::size_t>(levers)].source.empty(); }

    /// Nobody has any levers.
    void clear() { hands_ = {}; }

private:
    struct Hand {
        std::string source; // empty: nobody
        double heard = 0;
    };
    Hand& hand(Levers levers) { return hands_[static_cast<std::size_t>(levers)]; }

    std::array<Hand, kAllLevers.size()> hands_;
};

} // namespace windlass::server
