// How a suite is run: which of its runs, in what order, against which converged run.

#include "bench/lab/accuracy/suite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace windlass::lab {
namespace {

constexpr const char* kTooLong = "too long";

/// ms of processor time below which a run is timed again, and below which many times.
constexpr double kShortRun = 100, kTinyRun = 5;

template <typename T>
bool chosen(const std::vector<T>& choice, const T& one) {
    return choice.empty() || std::find(choice.begin(), choice.end(), one) != choice.end();
}

/// The ladder of a line: what is asked for, and the rates just above c/l; among them the first at which
/// leapfrog, which keeps 3 % off its bound, takes one step and not two.
std::vector<int> ladder(const SuiteCase& one, int links) {
    std::set<int> rates(one.rates.begin(), one.rates.end());
    const physics::ChainDef& line = one.given.problem.line;
    const double wave = std::sqrt(line.stiffness / line.mass_per_metre) * links / one.given.problem.length;
    for (const double margin : {1.0, 1 / 0.97, 1.15})
        if (const int rate = kSampleRate * int(std::ceil(margin * wave / kSampleRate));
            rate <= *rates.rbegin())
            rates.insert(rate);
    return {rates.begin(), rates.end()};
}

SuiteRow measure(const SuiteCase& one, const MethodEntry& method, int links, int rate, double max_seconds,
                 const Trace& converged) {
    SuiteRow row{one.name, links, method.name, rate, 0, {}, ""};
    try {
        const TraceLimits limits{one.until, max_seconds};
        Trace run = trace(one.given, method, links, rate, limits);
        row.cost = run.cost;
        // A short run is timed again: the least has the least of the machine's other work in it. Not looked
        // at: that empties the caches and, 15 times in a second, costs the cheapest methods a tenth of their
        // time.
        const double took = run.cost * one.given.problem.duration; // ms
        if (run.end == Trace::End::whole && took < kShortRun) {
            const int again = took < kTinyRun ? 30 : 2;
            for (int k = 0; k < again; ++k)
                row.cost = std::min(row.cost, stepping_cost(one.given, method, links, rate));
        }
        row.errors = errors_of(run, converged, one.until);
        if (run.end == Trace::End::blew_up) row.end = "blew up";
        if (run.end == Trace::End::too_long) row.end = kTooLong;
        if (run.end == Trace::End::unsolved) row.end = "unsolved";
    } catch (const std::invalid_argument& error) {
        row.end = error.what();
    }
    return row;
}

/// All runs of one case with one number of links.
class LineRuns {
public:
    LineRuns(const Suite& suite, const SuiteCase& one, int links, std::vector<SuiteRow>& rows)
        : suite_(suite), one_(one), links_(links), rows_(rows) {}

    /// Those of one method. progress: told of each.
    void run(const MethodEntry& method, bool missing,
             const std::function<void(const std::string&)>& progress) {
        if (!missing) remove(method.name);
        bool too_long = false; // more steps take no less time
        for (const int rate : ladder(one_, links_)) {
            const std::string what =
                fmt::format("{}, {} links: {} at {}/s", one_.name, links_, method.name, rate);
            if (const SuiteRow* there = find(method.name, rate)) {
                progress(what);
                too_long = there->end == kTooLong;
                continue;
            }
            if (!too_long) {
                converge(progress);
                progress(what);
                rows_.push_back(measure(one_, method, links_, rate, suite_.max_seconds, *converged_));
            } else {
                progress(what);
                rows_.push_back({one_.name, links_, method.name, rate, 0, {}, kTooLong});
            }
            too_long = rows_.back().end == kTooLong;
        }
    }

private:
    const SuiteRow* find(const std::string& method, int rate) const {
        const auto at = std::find_if(rows_.begin(), rows_.end(), [&](const SuiteRow& row) {
            return row.case_name == one_.name && row.nodes == links_ && row.method == method &&
                   row.rate == rate;
        });
        return at == rows_.end() ? nullptr : &*at;
    }

    void remove(const std::string& method) {
        std::erase_if(rows_, [&](const SuiteRow& row) {
            return row.case_name == one_.name && row.nodes == links_ && row.method == method;
        });
    }

    /// The converged run, when it is wanted first, and what checks it.
    void converge(const std::function<void(const std::string&)>& progress) {
        if (converged_) return;
        progress(fmt::format("{}, {} links: converged run", one_.name, links_));
        converged_ =
            trace(one_.given, *find_method("production"), links_, one_.reference_rate, {one_.until, 1e9});
        const int half = std::max(1, one_.reference_rate / 2 / kSampleRate) * kSampleRate;
        for (const auto& [name, rate] :
             {std::pair("production", half), std::pair("leapfrog", one_.reference_rate)}) {
            const std::string check = kReferenceCheck + std::string(": ") + name;
            remove(check);
            rows_.push_back(measure(one_, *find_method(name), links_, rate, 1e9, *converged_));
            rows_.back().method = check;
        }
    }

    const Suite& suite_;
    const SuiteCase& one_;
    int links_;
    std::vector<SuiteRow>& rows_;
    std::optional<Trace> converged_;
};

} // namespace

void run_suite(const Suite& suite, const Selection& selection, std::vector<SuiteRow>& rows,
               const std::function<void(double share, const std::string& what)>& progress,
               const std::function<void()>& keep) {
    double total = 0, done = 0;
    const auto each_line = [&](const auto& work) {
        for (const SuiteCase& one : suite.cases)
            for (const int links : one.nodes)
                if (chosen(selection.cases, one.name) && chosen(selection.nodes, links)) work(one, links);
    };
    const auto each_method = [&](const auto& work) {
        for (const MethodEntry* method : suite.methods)
            if (chosen(selection.methods, method->name)) work(*method);
    };
    each_line([&](const SuiteCase& one, int links) {
        each_method([&](const MethodEntry&) { total += double(ladder(one, links).size()); });
    });
    each_line([&](const SuiteCase& one, int links) {
        LineRuns runs(suite, one, links, rows);
        const double before = done;
        int methods_done = 0;
        each_method([&](const MethodEntry& method) {
            runs.run(method, selection.missing, [&](const std::string& what) {
                progress(std::min(1.0, done / total), what);
                done += 1;
            });
            done = before + double(++methods_done) * double(ladder(one, links).size());
            keep();
        });
    });
}

} // namespace windlass::lab
