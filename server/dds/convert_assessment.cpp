// An assessment as its topic has it.

#include "server/dds/convert.hpp"

#include "common/text.hpp"
#include "server/assess/result.hpp"

#include <algorithm>

namespace windlass::server {

namespace {

// Enumerators go by their places.
static_assert(static_cast<int>(assess::last_of(assess::Ending{})) == LESSON_ENDED_EARLY);

void convert(const assess::CriterionResult& from, Criterion& to) {
    to.code() = std::string(clipped(from.code, 48));
    to.text() = std::string(clipped(from.text, 128));
    to.limit(from.limit);
    to.worst(from.worst);
    to.unit() = std::string(clipped(from.unit, 16));
    to.time_outside(from.time_outside);
    to.kind(static_cast<CriterionKind>(from.kind));
    to.state(static_cast<CriterionState>(from.state));
    to.weight(static_cast<std::uint32_t>(from.weight));
    to.milli(static_cast<std::uint32_t>(from.milli));
    to.counted(static_cast<std::uint32_t>(from.counted));
    to.counts(from.counts);
    to.met(from.met);
    to.must(from.must);
    to.objective() = std::string(clipped(from.objective, 32));
    to.reason() = std::string(clipped(from.reason, 256));
    to.tick(from.tick);
    to.lost_tick(from.lost_tick);
}

void convert(const assess::ObjectiveResult& from, ObjectiveMark& to) {
    to.id() = std::string(clipped(from.id, 32));
    to.text() = std::string(clipped(from.text, 256));
    to.stcw() = std::string(clipped(from.stcw, 64));
    to.outcome() = assess::outcome_name(from.outcome);
    to.score(0.1 * from.tenths);
    to.pass(static_cast<std::uint32_t>(from.pass));
}

void convert(const assess::OrderDoneResult& from, OrderDone& to) {
    to.number(from.number);
    to.tick(from.tick);
}

void convert(const assess::ReportResult& from, JudgedReport& to) {
    to.tick(from.tick);
    to.code(static_cast<ReportCode>(from.code));
    to.side(from.side);
    to.criterion() = std::string(clipped(from.criterion, 48));
    to.milli(static_cast<std::uint32_t>(from.milli));
    to.timed(from.delay.has_value());
    to.delay(from.delay.value_or(0));
    to.figure(from.truth.has_value());
    to.truth(from.truth.value_or(0));
    to.text() = std::string(clipped(from.text, 128));
}

/// As many as the type bears.
template <class From, class To>
void convert_list(const std::vector<From>& from, To& to, std::size_t most) {
    to.resize(std::min(most, from.size()));
    for (std::size_t k = 0; k < to.size(); ++k)
        convert(from[k], to[k]);
}

} // namespace

void convert(const assess::Result& from, Assessment& to) {
    to.tick(from.tick);
    to.time(from.time);
    to.score(0.1 * from.tenths);
    to.score_computed(0.1 * from.tenths_computed);
    to.pass(static_cast<std::uint32_t>(from.pass));
    to.finished(from.finished);
    to.ending(static_cast<LessonEnding>(from.ending));
    to.outcome() = assess::outcome_name(from.outcome);
    to.abort() = std::string(clipped(from.abort, 128));
    to.lesson_hash(from.lesson_hash);
    to.assessment_hash(from.assessment_hash);
    convert_list(from.criteria, to.criteria(), 64); // bounds of the IDL
    convert_list(from.objectives, to.objectives(), 16);
    convert_list(from.orders, to.orders(), 64);
    convert_list(from.reports, to.reports(), assess::kMostJudged);
}

} // namespace windlass::server
