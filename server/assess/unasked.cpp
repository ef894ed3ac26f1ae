#include "server/assess/unasked.hpp"

#include "server/assess/growth.hpp"
#include "server/assess/order_done.hpp"
#include "server/assess/quantities.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace windlass::assess {

namespace {

using exercise::AnchorPhase;
using exercise::ReportCode;

constexpr unsigned phases(std::initializer_list<AnchorPhase> all) {
    unsigned bits = 0;
    for (const AnchorPhase one : all)
        bits |= 1U << static_cast<unsigned>(one);
    return bits;
}

constexpr unsigned kOnTheGround = phases({AnchorPhase::on_bottom, AnchorPhase::digging_in,
                                          AnchorPhase::holding, AnchorPhase::dragging, AnchorPhase::fouled});

/// How an anchor may be for a report to be so without the event that makes it so: she may have been at anchor
/// before the lesson began, and an anchor that is walked out is never called let go.
unsigned phases_of(ReportCode code) {
    switch (code) {
    case ReportCode::let_go:
        return kOnTheGround | phases({AnchorPhase::aweigh, AnchorPhase::lost});
    case ReportCode::on_the_bottom:
    case ReportCode::brought_up:
        return kOnTheGround;
    case ReportCode::anchor_aweigh:
        return phases({AnchorPhase::housed, AnchorPhase::acockbill, AnchorPhase::hanging, AnchorPhase::aweigh,
                       AnchorPhase::fouled});
    case ReportCode::anchor_home:
        return phases({AnchorPhase::housed});
    case ReportCode::dragging:
        return phases({AnchorPhase::dragging, AnchorPhase::fouled});
    default:
        return 0;
    }
}

/// What is to hold for a report of something that happens: that it has, or that it is so anyhow.
Condition truth_of_moment(Lesson& lesson, const Criterion& criterion, Condition when) {
    if (criterion.report != ReportCode::heaving) // at short stay she is also once the windlass stands
        std::erase_if(when.bounds,
                      [](const Bounds& bounds) { return bounds.quantity != quantity_of("top_angle_deg"); });
    const unsigned anyhow_in = phases_of(criterion.report);
    if (anyhow_in == 0) return when;
    Condition anyhow{.side = criterion.side, .phases = anyhow_in};
    if (criterion.report == ReportCode::brought_up) { // since before the lesson
        Condition landed{.side = criterion.side};
        landed.signs.push_back({SignKind::event, watch(lesson, {"anchor.on_bottom", criterion.side})});
        anyhow.neither.push_back(std::move(landed));
    }
    Condition truth{.side = criterion.side};
    truth.either = {std::move(when), std::move(anyhow)};
    return truth;
}

/// What standing by is hangs on what he stands by for.
bool can_be_told(ReportCode code) {
    return code != ReportCode::standing_by && code != ReportCode::anchor_ready;
}

bool is_asked_for(const Lesson& lesson, ReportCode code, int side) {
    return std::ranges::any_of(lesson.criteria, [&](const Criterion& one) {
        return one.kind == CriterionKind::report && one.side == side && is_report(one, code);
    });
}

/// Whether what a report says is held against one instant, whoever takes it.
bool is_looked_at_once(ReportCode code) {
    return code == ReportCode::growing || words::row_of(code).half_off > 0;
}

/// Whether a criterion takes a report at this tick, so that it is told there.
bool is_taken(const Heard& report, const Look& look) {
    for (std::size_t k = 0; k < look.lesson.criteria.size(); ++k) {
        const Criterion& one = look.lesson.criteria[k];
        const Mark& mark = look.state.marks[k];
        const bool his = report.side < 0 || report.side == one.side;
        if (one.kind != CriterionKind::report || !his || !is_report(one, report.code)) continue;
        const bool in_time = !one.orders.empty() || !one.from || mark.began >= 0;
        if (in_time && (mark.decided < 0 || mark.decided == look.tick())) return true;
    }
    return false;
}

bool is_so(const Criterion& criterion, const JudgedReport& report, const Look& look) {
    if (criterion.truth != ReportTruth::growth) return look.holds(criterion.that);
    return look.state.growth.at(static_cast<std::size_t>(criterion.side)).nearly(report.growing);
}

void keep(const JudgedReport& report, State& state) {
    if (state.unasked.size() < kMostUnasked) state.unasked.push_back(report);
}

} // namespace

void lay_unasked(Lesson& lesson, const std::vector<int>& sides) {
    for (const int side : sides)
        for (std::size_t place = 0; place < words::kReportNames.size(); ++place) {
            const auto code = static_cast<ReportCode>(place);
            // A figure may be asked for at one time, and said at another.
            const bool may_be_taken = is_asked_for(lesson, code, side) && !is_looked_at_once(code);
            if (!can_be_told(code) || may_be_taken) continue;
            Criterion to{.id = {}, .text = {}, .kind = CriterionKind::report, .side = side, .report = code};
            if (!lay_usual_truth(lesson, to)) continue;
            if (to.truth == ReportTruth::moment) {
                // Looked at once somebody says so, and not at every tick.
                Condition when = std::move(lesson.moments.back().when);
                lesson.moments.pop_back();
                to.truth_moment = -1;
                to.that = truth_of_moment(lesson, to, std::move(when));
            }
            if (to.truth == ReportTruth::growth) to.early = kGrowthAround;
            lesson.unasked.push_back(std::move(to));
        }
}

void take_unasked(const Heard& report, const Look& look) {
    if (report.side < 0 && look.lesson.two_sides) return; // of which of the two he speaks nobody knows
    if (is_taken(report, look)) return;
    for (std::size_t k = 0; k < look.lesson.unasked.size(); ++k) {
        const Criterion& criterion = look.lesson.unasked[k];
        const exercise::TackleView* tackle = tackle_of(look.seen, criterion.side);
        const bool his = report.side < 0 || report.side == criterion.side;
        if (criterion.report != report.code || !his || tackle == nullptr) continue;
        JudgedReport said = as_judged(criterion, report, *tackle, look.lesson);
        said.criterion = static_cast<int>(k);
        if (criterion.truth != ReportTruth::figure) {
            if (look.state.waiting.size() < kMostUnasked) look.state.waiting.push_back(said);
        } else if (said.milli == 0) {
            keep(said, look.state);
        }
    }
}

void watch_unasked(const Look& look) {
    std::erase_if(look.state.waiting, [&](const JudgedReport& waits) {
        const Criterion& criterion = look.lesson.unasked[static_cast<std::size_t>(waits.criterion)];
        if (is_so(criterion, waits, look)) return true;
        if (look.tick() - waits.tick < std::llround(criterion.early * look.tick_rate)) return false;
        JudgedReport wrong = waits;
        if (criterion.truth == ReportTruth::state) {
            const MissingPart missing = look.missing(criterion.that);
            wrong.missing = missing.place, wrong.truth = missing.value;
        }
        keep(wrong, look.state);
        return true;
    });
}

} // namespace windlass::assess
