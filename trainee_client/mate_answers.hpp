#pragma once
// What a mate answers when the bridge asks, and what he calls by himself: from what stands before his eyes.

#include "trainee_client/script.hpp"

#include <deque>

namespace windlass::trainee {

class Answers {
public:
    /// What he sees at that moment, s.
    void look(const ForecastleView& view, double time);

    /// "how is the cable leading?": hour and stay; nothing leads: "does not lead" has no report, and he says
    /// it.
    ReportOrder lead() const;
    /// "how is it growing?": tight, growing or slack by how the load of the last 10 s compares with that of
    /// the 10 s before and with the least since the cable was held; without a load cell by how the cable
    /// stays.
    ReportOrder growing() const;
    /// "how much weight?": by the load cell, of what the brake holds.
    ReportOrder weight() const;
    /// "is she brought up?": brought up when the load has come and gone and stands, or else how it grows.
    ReportOrder brought_up() const;
    /// She is brought up now: told once, unasked, for each time that the cable has stood.
    bool comes_up();
    /// The anchor drags: the deck has trembled for some time, with cable that stands. Once, until it has been
    /// still.
    bool drags();

private:
    struct Seen {
        double time, load; // s, N
    };
    bool is_up() const;
    double mean(double from, double to) const; ///< N, of what was seen so many s ago; from the farther

    ForecastleView view_;
    double time_ = 0;
    std::deque<Seen> seen_;                        ///< a look a second, of two minutes
    double least_ = 0;                             ///< N, mean of 10 s, since the cable stands
    double most_ = 0;                              ///< the same
    double stands_since_ = 0;                      ///< s, the cable
    double trembles_since_ = -1, still_since_ = 0; ///< s, the deck; -1: it does not
    double trembled_ = -1e9;                       ///< s, when the deck last did, with cable that stood
    bool called_ = false, told_up_ = false;
};

} // namespace windlass::trainee
