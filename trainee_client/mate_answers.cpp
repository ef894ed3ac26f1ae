#include "trainee_client/mate_answers.hpp"

#include "words/words.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace windlass::trainee {

namespace {

constexpr double kKept = 120;    // s of load that he remembers
constexpr double kStands = 0.1;  // m/s of cable
constexpr double kRise = 1.1;    // of the mean of the 10 s before: it grows
constexpr double kPulls = 1.4;   // times the least: she lies on it, and it does not only hang
constexpr double kTight = 2;     // times the least since the cable stands, as the marks have it
constexpr double kStrain = 60e3; // N, beyond the least: the cable has come to strain, and does not only hang
constexpr double kQuiet = 90;    // s in which the load of a ship that is brought up changes little
constexpr double kRides =
    120; // s that the cable has stood before he listens for it: a young anchor works its way in
constexpr double kTrembles =
    60; // s, of an anchor that drags: what works its way in or jerks is still again by then
constexpr double kStill = 60; // s after which another dragging is called anew
// Of what the brake holds, 0.45 of the breaking load: 0.3, 1 and 1.5 of the pull that a motor bears for half
// an hour, 47.5 d^2 N of grade K3 (UR A3), which is 0.14 of it
constexpr double kNone = 0.04, kModerate = 0.14, kMuch = 0.21;
constexpr int kDragging = 1; // of the deck's vibration, through a cable that stands

double angle_deg(const ForecastleView& view) {
    return view.top_angle() / words::units::degree;
}

StayGiven stay_of(double angle_deg) {
    if (angle_deg > words::limits::stay_up_and_down) return STAY_GIVEN_UP_AND_DOWN;
    if (angle_deg > words::limits::stay_short) return STAY_GIVEN_SHORT;
    return angle_deg > words::limits::stay_medium ? STAY_GIVEN_MEDIUM : STAY_GIVEN_LONG;
}

} // namespace

void Answers::look(const ForecastleView& view, double time) {
    if (time < time_) *this = {}; // the exercise went back
    view_ = view;
    time_ = time;
    if (std::abs(view.cable_speed_seen()) > kStands)
        stands_since_ = time, least_ = most_ = 0, told_up_ = false;
    if (seen_.empty() || time >= seen_.back().time + 1) {
        seen_.push_back({time, view.gypsy_load_indicated()});
        while (seen_.front().time < time - kKept)
            seen_.pop_front();
        if (time > stands_since_ + 10) {
            const double now = mean(10, 0);
            least_ = least_ > 0 ? std::min(least_, now) : now;
            most_ = std::max(most_, now);
        }
    }
    if (view.vibration() >= kDragging && time > stands_since_ + 1) trembled_ = time;
    const bool trembles = view.vibration() >= kDragging && time > stands_since_ + kRides;
    if (!trembles) {
        if (trembles_since_ >= 0) still_since_ = time;
        trembles_since_ = -1;
        if (time > still_since_ + kStill) called_ = false;
    } else if (trembles_since_ < 0) {
        trembles_since_ = time;
    }
}

double Answers::mean(double from, double to) const {
    double sum = 0;
    int count = 0;
    for (const Seen& seen : seen_)
        if (seen.time > time_ - from && seen.time <= time_ - to) sum += seen.load, ++count;
    return count > 0 ? sum / count : 0;
}

ReportOrder Answers::lead() const {
    ReportOrder report{.code = REPORT_LEAD, .side = {}, .order = {}, .text = {}};
    if (!view_.leads()) {
        report.code = REPORT_TEXT;
        report.text = "no cable outboard to lead";
        return report;
    }
    const int hour = static_cast<int>(std::lround(view_.lead_clock()));
    report.lead = hour == 0 ? 12 : hour;
    report.stay = stay_of(angle_deg(view_));
    return report;
}

ReportOrder Answers::growing() const {
    ReportOrder report{.code = REPORT_GROWING, .side = {}, .order = {}, .text = {}};
    if (!view_.load_cell_fitted()) {
        const double angle = angle_deg(view_);
        report.growing = angle < words::limits::stay_medium  ? GROWING_TIGHT
                         : angle < words::limits::stay_short ? GROWING_GROWING
                                                             : GROWING_SLACK;
        return report;
    }
    const double now = mean(10, 0), before = mean(20, 10);
    report.growing = now > kRise * before                  ? GROWING_GROWING
                     : least_ > 0 && now > kTight * least_ ? GROWING_TIGHT
                                                           : GROWING_SLACK;
    return report;
}

ReportOrder Answers::weight() const {
    ReportOrder report{.code = REPORT_WEIGHT, .side = {}, .order = {}, .text = {}};
    const double share = view_.brake_rating() > 0 ? view_.gypsy_load_indicated() / view_.brake_rating() : 0;
    report.weight = share < kNone       ? WEIGHT_NONE
                    : share < kModerate ? WEIGHT_MODERATE
                    : share < kMuch     ? WEIGHT_MUCH
                                        : WEIGHT_TOO_MUCH;
    return report;
}

/// The load has come, has gone back from its most, and has stood since; the deck has been still; and the
/// cable leads forward and away from the bow: over a heap it is up and down, and after a kick ahead it leads
/// aft.
bool Answers::is_up() const {
    const bool forward = view_.lead_clock() <= 3 || view_.lead_clock() >= 9;
    const bool away = view_.leads() && forward && angle_deg(view_) < words::limits::stay_short;
    const double now = mean(kQuiet / 2, 0), before = mean(kQuiet, kQuiet / 2);
    const bool came = least_ > 0 && most_ > kTight * least_ && most_ > least_ + kStrain;
    const bool quiet = time_ > std::max(stands_since_, trembled_) + kQuiet;
    return away && came && quiet && now > kPulls * least_ && now < kRise * before && now * kRise > before &&
           now < most_;
}

ReportOrder Answers::brought_up() const {
    if (!is_up()) return growing();
    return {.code = REPORT_BROUGHT_UP, .side = {}, .order = {}, .text = {}};
}

bool Answers::comes_up() {
    if (told_up_ || !is_up()) return false;
    return told_up_ = true;
}

bool Answers::drags() {
    if (called_ || trembles_since_ < 0 || time_ < trembles_since_ + kTrembles) return false;
    return called_ = true;
}

} // namespace windlass::trainee
