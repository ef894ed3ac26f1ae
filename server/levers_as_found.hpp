#pragma once
// Levers that do not lurch when an exercise is taken up again at another moment.

#include "server/exercise/exercise.hpp"
#include "server/hands.hpp"

#include <array>
#include <optional>
#include <string>

namespace windlass::server {

/// After a restore the levers stand as they stood at that moment, while a station goes on sending where its
/// own stand. From hold() on, each lever of the hand that had it stays as it was found until that hand moves
/// it, but for the speed lever, which springs to zero where the hand does not hold it as found. A lever that
/// another hand takes follows that hand at once.
class LeversAsFound {
public:
    /// The exercise has been restored.
    void hold();

    /// The exercise is another: levers follow their hands.
    void clear() { stations_ = {}; }

    /// The order as it is to be applied to the exercise.
    exercise::Command taken_up(const exercise::Command& order, const std::string& source,
                               const exercise::Exercise& exercise);

private:
    struct Station {
        std::string source;
        exercise::Command last;                  ///< as the station sent it
        std::optional<exercise::Command> then{}; ///< at the restore; nothing: levers follow the hand
        unsigned moved = 0;                      ///< a bit for each lever that was moved since
    };
    std::array<std::optional<Station>, kAllLevers.size()> stations_;
};

} // namespace windlass::server
