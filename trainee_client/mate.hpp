#pragma once
// A mate on the forecastle who works one windlass as the bridge orders, for a bridge that practises alone. He
// goes by what a seat is given: counter or eye for the cable, gauge, lead, feet. Knows no clock and no
// network: time is exercise time.

#include "trainee_client/mate_answers.hpp"
#include "trainee_client/script.hpp"

#include <vector>

namespace windlass::trainee {

class Mate {
public:
    explicit Mate(int side) : side_{side} {}

    /// What he does and says now, as steps of a script without conditions; nothing until his windlass and the
    /// exercise have been heard. He carries out the newest order of the bridge and drops the one before; a
    /// question is answered beside it. Call it ten times a second of exercise time or oftener.
    std::vector<Step> advance(const station::Picture& picture);

    /// Why he can do nothing about an order, his own or of a side where nobody is; nothing where he can. He
    /// says so and does not repeat it back.
    std::optional<std::string> cannot(const BridgeOrder& order, const station::Picture& picture) const;

private:
    /// The order that he carries out.
    struct Deed {
        BridgeOrderCode code = BRIDGE_ORDER_TEXT; ///< text: none
        double value = 0;
        long number = 0;
        double begin = 0;    ///< s, when he begins
        double repeated = 0; ///< s, when he has repeated it back
        int stage = 0;       ///< of its work; 0: not begun
        double since = 0;    ///< s, when that stage began
    };
    struct Question {
        BridgeOrderCode code;
        double at; ///< s, when he answers
    };
    struct Word {
        ReportOrder report;
        double at; ///< s, when he says it: an order is repeated back first
    };

    void look(const station::Picture& picture);
    void hear(const station::Picture& picture);
    void work();
    void answer(BridgeOrderCode question);
    bool on_the_brake(); ///< out of gear, stopper off: makes it so, and whether it is
    void let_go();
    void pay_out();
    void hold_on();
    void by_gear(double direction);
    void secure();
    void gear(bool in);
    void men(DeckWork work, ReportCode done);
    bool held_for(DeckWork work); ///< makes the cable safe for men to work at it, and whether it is
    void set_men(DeckWork work);
    void call_men_back();      ///< where they are at it
    bool last_on_deck() const; ///< the last joining shackle
    ReportOrder unable(std::string why) const;
    void finish(std::optional<ReportOrder> report = {});

    void stage(int next);
    double since() const;      ///< s in this stage
    void render(double speed); ///< lets the cable run at that speed, m/s, by the wheel
    void turn(double rate);    ///< of the wheel, a second; screwed up positive
    bool in_gear_and_free();
    ReportOrder shackles() const;
    void say(ReportOrder report);

    const int side_;
    long heard_ = 0; ///< number of the newest order that he has heard
    std::uint64_t run_ = 0;
    Deed deed_;
    std::vector<Question> questions_;
    std::vector<Word> words_; ///< of what is done, which he has not said yet
    Answers answers_;

    // As he sees them now
    const ForecastleView* view_ = nullptr; ///< while he works
    double time_ = 0, step_ = 0;           ///< s, now, and since he looked last
    double out_ = 0, speed_ = 0;           ///< m and m/s of cable
    double let_go_at_ = 0, fastest_ = 0;   ///< m of cable and m/s, of the anchor that he lets go
    double tightened_ = 0;                 ///< s, when he last screwed the brake up while it ran
    double looked_ = -1;                   ///< s, when he looked last
    bool plain_seen_ = false;              ///< a mark that is not of the warning colour
    int warning_ = 0; ///< the mark at which the warning colour begins; 0: not seen to begin

    station::WindlassLevers levers_; ///< where he has them
    std::vector<Step> done_;         ///< what advance() returns
};

} // namespace windlass::trainee
