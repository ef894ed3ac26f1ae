#include "recorder/resimulate/reassessment.hpp"

#include "idl/topics.hpp"
#include "recorder/recording/typed.hpp"

#include <fmt/format.h>

#include <limits>
#include <map>

namespace windlass::recorder {

namespace {

/// An assessment of the recording.
struct Recorded {
    std::uint64_t hash = 0;
    double score = 0;
    bool found = false;
};

std::multimap<std::uint64_t, Recorded> recorded_in(recording::Recording& recording) {
    std::multimap<std::uint64_t, Recorded> all;
    auto cursor = recording.messages({.topics = {wire::topics::assessment.name}});
    while (const auto message = cursor.next()) {
        const auto sample = recording::decode<Assessment>(message->payload);
        all.emplace(sample.tick(), Recorded{sample.assessment_hash(), sample.score()});
    }
    return all;
}

} // namespace

Reassessment reassess(recording::Recording& recording) {
    auto recorded = recorded_in(recording);
    Reassessment all;
    const auto runs = runs_of(recording);
    for (std::size_t k = 0; k < runs.size(); ++k) {
        const Mark* first = runs[k].first_checkpoint();
        if (first == nullptr) continue;
        Resimulation again(recording, runs[k], *first);
        if (!again.assessor().assesses()) continue;
        const auto look = [&](const assess::Assessor& assessor) {
            const auto [begin, end] = recorded.equal_range(static_cast<std::uint64_t>(assessor.state().tick));
            if (begin == end) return;
            const std::uint64_t hash = assess::assessment_hash(*assessor.lesson(), assessor.state());
            for (auto it = begin; it != end; ++it)
                it->second.found = it->second.found || it->second.hash == hash;
        };
        look(again.assessor());
        again.watch(look);
        again.go_through();
        all.runs.push_back({k + 1, again.assessor().lesson()->id, again.assessor().result(),
                            again.assessor().computed(), *again.assessor().lesson()});
    }
    all.recorded = recorded.size();
    for (const auto& [tick, one] : recorded) {
        if (one.found) {
            ++all.equal;
        } else if (all.first_that_differs.empty()) {
            all.first_that_differs =
                fmt::format("the assessment at tick {} ({:.1f} points, hash {:016x}) does "
                            "not come of what was recorded",
                            tick, one.score, one.hash);
        }
    }
    return all;
}

} // namespace windlass::recorder
