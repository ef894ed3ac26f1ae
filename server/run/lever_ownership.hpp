#pragma once
// Who has which levers, and until when. Instructors' levers come over topics of their own, which no trainee
// may write: while they speak, nobody else is heard. Among equals DDS gives the levers to the strongest
// writer that still speaks; here is kept who that is.

#include "common/hand_silence.hpp"
#include "server/exercise/definition/orders.hpp"
#include "server/run/received_order.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace windlass::run {

/// Levers that one hand works: a windlass, or the helm.
enum class LeverGroup { port_windlass, starboard_windlass, helm };
inline constexpr std::array kAllLeverGroups{LeverGroup::port_windlass, LeverGroup::starboard_windlass,
                                            LeverGroup::helm};

/// "port windlass", "starboard windlass", "helm".
const char* name(LeverGroup levers);

class LeverOwnership {
public:
    /// Whose hand was on some levers.
    struct Hand {
        std::string source;  ///< empty: nobody's
        bool let_go = false; ///< its writer was gone while it spoke; else it is not heard, or still speaks
        bool instructor = false;
        bool found_free = false; ///< nobody had the levers when it took them
    };

    /// The levers that an order moves; nothing for any other order.
    static std::optional<LeverGroup> levers_of(const exercise::Order& command);

    /// It is wall time now (s). To be called with each look at what came, before what came is taken: what
    /// goes by between two looks is not heard by us, and counts as nobody's silence (ListeningTime).
    void listen(double now) { now_ = listening_.at(now); }

    /// A hand gives an order to these levers, and has them from here on. Returns who had them (the same
    /// source, where they do not change hands); let go only where an instructor has and this hand was waiting
    /// for it, for the station that the levers are taken from may let go before the order that takes them
    /// comes. Nothing when the order is not heard: an instructor's always is, another's only when no
    /// instructor has them, or he is given up.
    std::optional<Hand> take(LeverGroup levers, const ReceivedOrder& from);

    /// That writer is there no more: a hand that lets go says so.
    void leave(const WriterKey& writer);
    /// That writer is there (again): it was missed while its program was held up.
    void come(const WriterKey& writer);

    /// Who had these levers and has let go, or has been silent for kHandSilent, and nobody has taken them
    /// since; from here on nobody has them.
    std::optional<Hand> gone(LeverGroup levers);

    /// Whether that source is at the other place, and has levers there: of a windlass the helm, of the helm a
    /// windlass.
    bool is_elsewhere(LeverGroup levers, const std::string& source) const;

    /// s since the hand was heard last that has been silent for longest; 0: nobody has any levers.
    double longest_silence() const;

    /// Nobody has these levers.
    bool free(LeverGroup levers) const { return owners_[static_cast<std::size_t>(levers)].source.empty(); }

    /// Nobody has any levers.
    void clear() { owners_ = {}; }

private:
    struct Owner {
        std::string source; // empty: nobody
        double heard = 0;   // s of ListeningTime, when he spoke last
        WriterKey writer{};
        bool instructor = false;
        bool found_free = false;
        std::optional<double> left; // s of ListeningTime, when his writer was gone

        double given_up_at() const {
            return std::min(left.value_or(heard + kHandSilent), heard + kHandSilent);
        }
        /// A writer that goes after a silence is one whose page hung, or whose program was killed and is now
        /// missed by DDS: that hand has not let go.
        bool let_go() const { return left && *left - heard < 1; }
    };
    Owner& owner(LeverGroup levers) { return owners_[static_cast<std::size_t>(levers)]; }

    ListeningTime listening_;
    double now_ = 0; // of it
    std::array<Owner, kAllLeverGroups.size()> owners_;
};

} // namespace windlass::run
