// An assessment as its topic has it.

#include "server/dds/convert.hpp"

#include "server/assess/result.hpp"
#include "server/dds/wire_fields.hpp"

#include <algorithm>

namespace windlass::dds {

namespace {

// Enumerators go by their places.
static_assert(static_cast<int>(assess::last_of(assess::Ending{})) == LESSON_ENDED_EARLY);

void convert(const assess::ObjectiveResult& from, ObjectiveMark& to) {
    to_wire(from.id, to.id());
    to_wire(from.text, to.text());
    to_wire(from.stcw, to.stcw());
    to.outcome() = assess::outcome_name(from.outcome);
    to.score(0.1 * from.tenths);
    to_wire(from.pass, to.pass());
}

} // namespace

void convert(const assess::Result& from, Assessment& to) {
    to.tick(from.tick);
    to.time(from.time);
    to.score(0.1 * from.tenths);
    to.score_computed(0.1 * from.tenths_computed);
    to_wire(from.pass, to.pass());
    to.finished(from.finished);
    to_wire(from.ending, to.ending());
    to.outcome() = assess::outcome_name(from.outcome);
    to_wire(from.abort, to.abort());
    to.lesson_hash(from.lesson_hash);
    to.assessment_hash(from.assessment_hash);
    to_wire(from.criteria, to.criteria());
    to_wire(from.orders, to.orders());
    to_wire(from.reports, to.reports());
    to.practice(from.practice);
    to_wire(from.hints, to.hints());
    for (std::size_t k = 0; k < to.reports().size(); ++k) {
        to.reports()[k].timed(from.reports[k].delay.has_value());
        to.reports()[k].figure(from.reports[k].truth.has_value());
    }
    to.objectives().resize(std::min(from.objectives.size(), kMostOnWire<ObjectiveMark>));
    for (std::size_t k = 0; k < to.objectives().size(); ++k)
        convert(from.objectives[k], to.objectives()[k]);
}

} // namespace windlass::dds
