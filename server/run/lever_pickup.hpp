#pragma once
// Levers that do not lurch when an exercise is taken up again at another moment.

#include "server/exercise/exercise.hpp"
#include "server/run/lever_ownership.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace windlass::run {

/// After a restore, and at the start of another run, the levers stand as they stood at that moment, while a
/// station goes on sending where its own stand. Each lever of a hand that lay there before stays as it was
/// found until that hand moves it, but for the speed lever, which springs to zero where the hand does not
/// hold it as found. Such a hand had the levers at hold(), or says itself that it moved them last in another
/// run: so a server that was started anew knows it too. A lever that another hand takes follows that hand at
/// once. A late word of a program that was killed, behind those of a later program of its hand, moves nothing
/// in a run that began in between.
class LeverPickup {
public:
    /// The exercise has been restored, reset or loaded.
    void hold();
    /// All that had come by then has been heard. Until now nothing was a move in the new run: it was sent
    /// before that began, by a server that stood still perhaps long before.
    void begun() { begins_ = false; }

    /// The order as it is to be applied to the exercise, which is in that run (RunStatus::run).
    exercise::Order taken_up(const exercise::Order& order, const ReceivedOrder& from, std::uint64_t run,
                             const exercise::Exercise& exercise);

private:
    struct Sender {
        std::string source;
        WriterKey writer{};                    ///< of its program
        std::vector<WriterKey> former{};       ///< those before it, kMaxFormer at most, the last one last
        exercise::Order last;                  ///< as the station sent it
        std::optional<exercise::Order> then{}; ///< as it lay when the run began; nothing: levers follow it
        unsigned moved = 0;                    ///< a bit for each lever that was moved since
    };
    std::array<std::optional<Sender>, kAllLeverGroups.size()> senders_;
    bool begins_ = false;
};

} // namespace windlass::run
