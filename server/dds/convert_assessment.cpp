// An assessment as its topic has it.

#include "server/dds/convert.hpp"

#include "common/text.hpp"
#include "server/assess/result.hpp"

#include <algorithm>

namespace windlass::server {

namespace {

constexpr std::size_t kMaxCriteria = 64; // of the IDL

void convert(const assess::CriterionResult& from, Criterion& to) {
    to.code() = std::string(clipped(from.code, 48));
    to.text() = std::string(clipped(from.text, 128));
    to.limit(from.limit);
    to.worst(from.worst);
    to.time_outside(from.time_outside);
    to.kind(static_cast<CriterionKind>(from.kind));
    to.state(static_cast<CriterionState>(from.state));
    to.weight(static_cast<std::uint32_t>(from.weight));
    to.milli(static_cast<std::uint32_t>(from.milli));
    to.must(from.must);
    to.objective() = std::string(clipped(from.objective, 32));
    to.reason() = std::string(clipped(from.reason, 256));
    to.tick(from.tick);
}

} // namespace

void convert(const assess::Result& from, Assessment& to) {
    to.tick(from.tick);
    to.time(from.time);
    to.score(0.1 * from.tenths);
    to.score_computed(0.1 * from.tenths_computed);
    to.finished(from.finished);
    to.outcome() = assess::outcome_name(from.outcome);
    to.abort() = std::string(clipped(from.abort, 128));
    to.lesson_hash(from.lesson_hash);
    to.assessment_hash(from.assessment_hash);
    to.criteria().resize(std::min(kMaxCriteria, from.criteria.size()));
    for (std::size_t k = 0; k < to.criteria().size(); ++k)
        convert(from.criteria[k], to.criteria()[k]);
}

} // namespace windlass::server
