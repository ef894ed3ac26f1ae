#pragma once
// The levers of one windlass and the helm, in the hand of this station.

#include "station/client.hpp"
#include "words/words.hpp"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace windlass::station {

/// Set points of a windlass. Units and signs are those of WindlassCommand.
struct WindlassLevers {
    double brake = 1;
    double speed_lever = 0;
    bool clutch_in = false;
    bool stopper_closed = false;
    bool emergency_stop = false;

    bool operator==(const WindlassLevers&) const = default;
};

/// Set points of the helm. Units and signs are those of HelmCommand.
struct HelmLevers {
    double engine = 0;
    double rudder = 0; ///< rad, starboard positive
    double bow_thruster = 0;
    double stern_thruster = 0;

    bool operator==(const HelmLevers&) const = default;
};

/// rad, of a rudder to either side that a station passes on; the server knows the ship's own.
inline constexpr double kRudderMax = 45 * words::units::degree;

struct LeverSet {
    WindlassLevers windlass;
    HelmLevers helm;
};

/// Whether the picture shows where the levers of that side stand.
bool levers_known(const Picture& picture, int side);

/// Sends the set points 20 times a second, and at once on a change. The windlass and the helm are each left
/// alone until one of their own levers is moved: a station that only looks on takes nothing over.
/// An instructor's go out on topics of their own, which the server prefers; on a forecastle there is no helm,
/// on a bridge no windlass: what is moved of them goes nowhere.
class LeverSender {
public:
    /// Ownership strength, the same for all people: it decides among equals only. Instructors have topics of
    /// their own.
    static constexpr int kStrength = 10;
    /// Of a script: it gives way to a person who takes the levers beside it, and has them again when he lets
    /// go.
    static constexpr int kScriptStrength = 5;

    /// Writes what the client's seat may; strength: of several on one topic, the highest is heard. Throws
    /// std::runtime_error when permissions forbid it.
    LeverSender(Client& client, int side, int strength = kStrength);
    ~LeverSender();
    LeverSender(const LeverSender&) = delete;
    LeverSender& operator=(const LeverSender&) = delete;

    /// Set points of this station. While it has moved none of a windlass or of the helm they are as found: of
    /// a windlass what was commanded last, otherwise what it shows, and its speed lever as it shows it; of
    /// the helm what the server has, whoever ordered it. So it takes over without moving anything.
    LeverSet get() const;

    /// Moves the levers: change gets the present set points. Values are kept within their range.
    void move(const std::function<void(LeverSet&)>& change);

    /// Takes the windlass over, also when change moves nothing; the helm is left alone.
    void take_windlass(const std::function<void(WindlassLevers&)>& change);

    /// Readers that windlass and helm orders reach now, whichever are fewer; this station's own is one.
    int matched() const;

private:
    void send_until_stopped();
    std::uint64_t run_heard() const;

    Client& client_;
    const int side_;
    std::optional<wire::Writer<WindlassCommand>> windlass_;
    std::optional<wire::Writer<HelmCommand>> helm_;
    mutable std::mutex mutex_;
    std::condition_variable moved_;
    LeverSet set_;
    bool windlass_taken_ = false;
    bool helm_taken_ = false;
    std::uint64_t windlass_run_ = 0, helm_run_ = 0; // in which they were taken or moved last
    bool changed_ = false;
    bool stop_ = false;
    std::thread sender_;
};

} // namespace windlass::station
