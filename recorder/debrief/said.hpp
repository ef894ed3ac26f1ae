#pragma once
// Orders, repeat-backs and reports of an attempt, each with what was so when it was said.

#include "recorder/debrief/attempt.hpp"

namespace windlass::debrief {

/// An order of the bridge and what came back.
struct OrderSaid {
    int number = 0;
    double given = 0; ///< s of exercise
    std::string words, by;
    bool question = false;          ///< it asks: answered, and not repeated
    std::optional<double> repeated; ///< time of the first repeat-back
    std::string state; ///< "repeated", "repeated wrongly", "not repeated, said again", "answered" ...; of a
                       ///< question of before an attempt that goes on from a moment, that it is, where no
                       ///< more is known
    std::optional<double> answered; ///< time of the first report that answers it, other than its repeat-back
    std::string answer;             ///< its words
    std::optional<double> repeat_by, do_by; ///< times, where there was a deadline
    bool judged = false;                    ///< it is known whether it was carried out
    std::optional<double> done;             ///< judged: time from which on it was; nothing: it was not
    std::optional<double> done_before;      ///< said again: the same, carried out before that
};

/// A report that is no repeat-back.
struct ReportSaid {
    double time = 0;
    std::string words, by;
    std::string_view code; ///< as wire names have it
    double value = 0;      ///< as given
    int side = -1;
    std::string truth;                ///< what was so, in words: as judged, else as the tackle was then
    std::optional<double> true_value; ///< as judged, in the unit of value
    std::optional<double> delay; ///< as judged: s since what it tells came to be so; negative: told before
    std::optional<std::uint32_t> milli; ///< that it has earned, 0..1000, the least where several judge it;
                                        ///< nothing: no criterion judges it
};

std::vector<OrderSaid> orders_said(const Attempt& attempt);
std::vector<ReportSaid> reports_said(const Attempt& attempt);

} // namespace windlass::debrief
