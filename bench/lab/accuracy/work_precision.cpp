#include "bench/lab/accuracy/work_precision.hpp"

#include "bench/lab/case/processor_time.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace windlass::lab {
namespace {

bool astray(const Vec3& p, double length) {
    return !p.allFinite() || p.norm() > 100 * length;
}

/// Writes down where a method is; false when it blew up.
bool sample(const Method& method, const Case& given, bool keep, Trace& trace) {
    trace.top_tension.push_back(method.tension(method.links() - 1));
    if (!std::isfinite(trace.top_tension.back())) return false;
    std::vector<Vec3> nodes(method.links() + 1);
    for (int i = 0; i <= method.links(); ++i) {
        nodes[i] = method.position(i);
        if (astray(nodes[i], given.problem.length)) return false;
    }
    if (keep) trace.positions.push_back(std::move(nodes));
    return true;
}

} // namespace

Trace trace(const Case& given, const MethodEntry& entry, int links, int rate, const TraceLimits& limits) {
    if (rate % kSampleRate != 0) throw std::invalid_argument("rate: a multiple of 15 steps in a second");
    Trace result{.links = links, .rest = given.problem.length / links, .top_tension = {}, .positions = {}};
    const auto method = make_method(entry, given.problem, links, 1.0 / rate, given.settings);
    const int top = method->links() - 1;
    const long stride = rate / kSampleRate;
    const long settling = std::lround(given.settle * kSampleRate);
    const long samples = std::lround(given.problem.duration * kSampleRate);
    double spent = 0, counted = 0;
    long seen = 0; // of the samples' intervals
    for (long k = 0; k <= samples; ++k) {
        const bool recording = k >= settling;
        const double time = double(k - settling) / kSampleRate;
        // Before any step no method has a tension of its own.
        if (recording && k > 0 && !sample(*method, given, time <= limits.until, result)) {
            result.end = Trace::End::blew_up;
            break;
        }
        if (k == samples) break;
        const double before = processor_seconds();
        for (long step = 0; step < stride; ++step) {
            method->step();
            if (recording) result.peak = std::max(result.peak, method->tension(top));
        }
        const double took = processor_seconds() - before;
        spent += took;
        if (recording) counted += took, ++seen;
        // The first samples tell whether the whole will take too long.
        if (k >= 5 && spent / double(k + 1) * double(samples) > limits.max_seconds) {
            result.end = Trace::End::too_long;
            break;
        }
    }
    if (result.end == Trace::End::whole && method->unsolved() > 0) result.end = Trace::End::unsolved;
    result.cost = 1000 * counted * kSampleRate / double(std::max(1L, seen));
    return result;
}

double stepping_cost(const Case& given, const MethodEntry& entry, int links, int rate) {
    const auto method = make_method(entry, given.problem, links, 1.0 / rate, given.settings);
    const auto run = [&](double seconds) {
        const double before = processor_seconds();
        for (long left = std::lround(seconds * rate); left > 0; --left)
            method->step();
        return processor_seconds() - before;
    };
    run(given.settle);
    const double counted = given.problem.duration - given.settle;
    return 1000 * run(counted) / counted;
}

Errors errors_of(const Trace& run, const Trace& converged, double until) {
    const std::size_t wanted = std::size_t(std::max(0.0, until * kSampleRate)) + 1;
    const std::size_t samples = std::min({wanted, run.positions.size(), converged.positions.size()});
    double tension = 0, scale = 0, position = 0, link = 0;
    for (std::size_t k = 0; k < samples; ++k) {
        const std::vector<Vec3>&ours = run.positions[k], &theirs = converged.positions[k];
        tension += std::pow(run.top_tension[k] - converged.top_tension[k], 2);
        scale += std::pow(converged.top_tension[k], 2);
        for (int i = 0; i <= run.links; ++i)
            position += (ours[i] - theirs[i]).squaredNorm();
        for (int i = 0; i < run.links; ++i)
            link += std::pow((ours[i + 1] - ours[i]).norm() - (theirs[i + 1] - theirs[i]).norm(), 2);
    }
    const double length = run.rest * run.links, n = double(std::max<std::size_t>(1, samples));
    return {.tension = std::sqrt(tension / scale),
            .position = std::sqrt(position / (n * (run.links + 1))) / length,
            .link = std::sqrt(link / (n * run.links)) / run.rest,
            .peak = run.peak / converged.peak - 1};
}

} // namespace windlass::lab
