#pragma once
// A scripted trainee at a seat: what he is given, and what he does.

#include "lesson/play.hpp"
#include "server/exercise/picture/snapshot.hpp"
#include "server/perceive/perceive.hpp"
#include "server/run/received_order.hpp"
#include "server/run/status.hpp"
#include "trainee_client/player.hpp"

namespace windlass::lesson {

class Seat {
public:
    /// Levers stand as the exercise has them at the start.
    Seat(Part part, const exercise::ExerciseDef& def, std::string name);

    /// Gives him what a seat is given of this picture. now: s, for what is old.
    void look(const exercise::Snapshot& seen, const run::RunStatus& run);
    void notice(const exercise::ExerciseEvent& event, const exercise::Snapshot& seen);
    /// He hears a report of the forecastle, as a bridge does. time: s.
    void hear(const Report& report, double time);
    void hear(const exercise::ReportMade& report, double time);
    /// His answer to what is asked at a freeze; nothing: he has none, or it is put to another. Throws
    /// std::runtime_error where his script answers what the question does not allow.
    std::optional<run::ReceivedOrder> answer(const run::QuestionView& question) const;
    /// What he does now; his windlass's levers every time, as a station sends them.
    std::vector<run::ReceivedOrder> act();

    /// What he reported since the last time.
    std::vector<Report> take_reports();
    /// What he said or did in words since the last time.
    std::vector<std::string> take_words();
    /// The step that he waits for; empty: all are done.
    std::string waiting_for() const;
    /// He gives the orders of the bridge.
    bool conns() const { return conns_; }
    /// He has done all of it, or has failed in it; a mate has when everybody else has.
    bool done() const { return mate_ || player_.finished() || player_.failure(); }
    const std::optional<std::string>& failure() const { return player_.failure(); }

private:
    void look_at_truth(const exercise::Snapshot& seen);
    double wheel_by_keys() const;
    void perform(const trainee::Step& step, std::vector<run::ReceivedOrder>& orders);

    int side_;
    bool voice_only_, conns_, mate_, keys_, coach_;
    std::string name_;
    perceive::SeatAids aids_;
    perceive::SeatShip ship_;
    trainee::QuestionAnswers answers_;
    trainee::Player player_;
    station::Picture picture_;
    station::LeverSet levers_;
    bool has_helm_ = false;
    std::uint64_t noticed_ = 0;
    std::vector<Report> reports_;
    std::vector<std::string> words_;
};

/// All of them look, act, and hear what the others report: what they do now. What they say aloud waits in
/// each.
std::vector<run::ReceivedOrder> look_and_act(std::vector<Seat>& seats, const exercise::Snapshot& seen,
                                             const run::RunStatus& status);

/// What the first of them that knows answers to what is asked at a freeze; nothing: none knows. Throws
/// std::runtime_error where a script answers what the question does not allow.
std::optional<run::ReceivedOrder> answer_to(const run::QuestionView& question,
                                            const std::vector<Seat>& seats);

/// These seats answer all that a lesson asks now, and what none knows is passed over. take: what an answer
/// does to the exercise.
void answer_questions(const assess::Assessor& assessor, const std::vector<Seat>& seats,
                      const std::function<void(const exercise::Order&)>& take);

} // namespace windlass::lesson
