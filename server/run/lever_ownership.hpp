#pragma once
// Who has which levers, and until when. Instructors' levers come over topics of their own, which no trainee
// may write: while they speak, nobody else is heard. Among equals DDS gives the levers to the strongest
// writer that still speaks; here is kept who that is.

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

/// s of wall time without a word after which an instructor's levers are a trainee's again: as long as DDS
/// waits before it hears a weaker equal (kCommandDeadline in idl/topics.hpp).
inline constexpr double kInstructorSilent = 0.2;

class LeverOwnership {
public:
    /// The levers that an order moves; nothing for any other order.
    static std::optional<LeverGroup> levers_of(const exercise::Order& command);

    /// source gives an order to these levers at wall time now (s), and has them from here on. Returns who had
    /// them ("": nobody; source itself, where they do not change hands). Nothing when the order is not heard:
    /// an instructor's always is, another's only when no instructor has had them for the last
    /// kInstructorSilent.
    std::optional<std::string> take(LeverGroup levers, const std::string& source, bool instructor,
                                    double now);

    /// Who had these levers and has now been silent for too long; from here on nobody has them.
    std::optional<std::string> gone(LeverGroup levers, double now);

    /// Nobody has these levers.
    bool free(LeverGroup levers) const { return owners_[static_cast<std::size_t>(levers)].source.empty(); }

    /// Nobody has any levers.
    void clear() { owners_ = {}; }

private:
    struct Owner {
        std::string source; // empty: nobody
        double heard = 0;
        bool instructor = false;
    };
    Owner& owner(LeverGroup levers) { return owners_[static_cast<std::size_t>(levers)]; }

    std::array<Owner, kAllLeverGroups.size()> owners_;
};

} // namespace windlass::server
