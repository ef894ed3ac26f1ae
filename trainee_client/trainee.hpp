#pragma once
// A trainee at the windlass as a script has him: levers, reports, and a view. Without a script he looks on.

#include "station/lever_sender.hpp"
#include "station/view.hpp"
#include "trainee_client/player.hpp"
#include "trainee_client/progress.hpp"

namespace windlass::trainee {

class Trainee {
public:
    /// Without a script nothing is moved and nothing said.
    Trainee(station::Client& client, int side, std::optional<Script> script, station::View& view);
    ~Trainee(); ///< returns when the last orders and reports have arrived, or after a second each
    Trainee(const Trainee&) = delete;
    Trainee& operator=(const Trainee&) = delete;

    enum class Outcome { goes_on, done, failed, server_lost };

    /// Does what is due now: call it about a hundred times a second.
    Outcome work();

    /// Why the outcome is failed or server_lost.
    const std::string& reason() const { return reason_; }

    /// What the script waits for now; empty without a script or after its end.
    std::string waiting_for() const;

    /// How the exercise gets on.
    const Progress& progress() const { return progress_; }

private:
    void perform(const Step& step, const station::Picture& picture);
    void show(const Shown& shown, const station::Picture& picture);
    void keep(const Circle& circle, const station::Picture& picture);
    void set_men(DeckWork work, const station::Picture& picture);
    void report(const ReportOrder& order, const station::Picture& picture);
    void order(const BridgesOrder& order, const station::Picture& picture);
    void answer_questions(const station::Picture& picture, station::Clock::time_point now);
    bool heard() const; ///< the server hears what this station says once

    /// The question that was answered last, and the one that he has no answer to, since when.
    struct Answered {
        std::string id;
        std::uint64_t tick = 0, run = 0;
        std::optional<station::Clock::time_point> at_a_loss_since;
    };

    station::Client& client_;
    const int side_;
    station::View& view_;
    station::LeverSender levers_;
    std::optional<wire::Writer<Report>> reports_;                           ///< of the forecastle
    std::optional<wire::Writer<DeckWorkCommand>> deck_works_;               ///< of the forecastle
    std::optional<wire::Writer<LightsAndShapesCommand>> lights_and_shapes_; ///< of the bridge
    std::optional<wire::Writer<WatchCircle>> circles_;                      ///< of the bridge
    std::optional<wire::Writer<BridgeOrderCommand>> orders_;                ///< of the bridge alone
    std::array<std::optional<wire::Writer<Answer>>, 2> answers_to_;         ///< of the forecastle, the bridge
    std::array<Answered, 2> answered_;                                      ///< the same
    QuestionAnswers answers_;
    std::optional<Player> player_;
    Progress progress_;
    double came_at_ = 0; ///< s of exercise time: what was refused before was another's of this name
    bool begun_ = false;
    std::string reason_;
};

} // namespace windlass::trainee
