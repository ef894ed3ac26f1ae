#include "bench/lab/convergence/converge.hpp"

#include "bench/lab/case/processor_time.hpp"
#include "bench/lab/draw/chart.hpp"
#include "bench/methods/pbd_constraints.hpp"
#include "common/json_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace windlass::lab {
namespace {

const std::vector<std::string> kHeadings{"problem",    "method",         "limit_off_newtons",
                                         "iterations", "relative_error", "ms"};

constexpr int kNewtonIterations = 20; ///< drawn
constexpr int kEnough = 60;           ///< iterations of Newton to its limit
constexpr int kSweepsToLimit = 3000000;
constexpr int kTimings = 3; ///< the least counts

double distance(const Field& a, const Field& b) {
    double sum = 0;
    for (int i = 0; i < a.size(); ++i)
        sum += (a.at(i) - b.at(i)).squaredNorm();
    return std::sqrt(sum);
}

/// 1, 2 ... 10, 12, 15, 20 ...: about a dozen in each power of ten.
std::vector<int> stations(int max) {
    std::vector<int> all;
    for (double k = 1; k <= max; k = std::max(k + 1, std::round(k * 1.2)))
        all.push_back(static_cast<int>(k));
    return all;
}

/// What one run of a method left at each station.
struct Run {
    std::vector<Field> places;
    std::vector<double> seconds;
};

/// Runs anything that has iterate() and places(); looking at the places does not count.
template <class Iteration>
Run run(const std::vector<int>& at, Iteration iteration) {
    Run result;
    int done = 0;
    double spent = 0;
    for (const int station : at) {
        const double before = processor_seconds();
        for (; done < station; ++done)
            iteration.iterate();
        spent += processor_seconds() - before;
        result.places.push_back(iteration.places());
        result.seconds.push_back(spent);
    }
    return result;
}

/// The same several times: the shortest counts.
template <class Iteration>
Run shortest(const std::vector<int>& at, const Iteration& iteration, const std::function<void()>& told) {
    Run best;
    for (int k = 0; k < kTimings; ++k) {
        Run one = run(at, iteration);
        for (std::size_t i = 0; i < best.seconds.size(); ++i)
            one.seconds[i] = std::min(best.seconds[i], one.seconds[i]);
        best = std::move(one);
        told();
    }
    return best;
}

/// PBD's sweeps over the links.
class Sweeps {
public:
    Sweeps(const StepProblem& problem, double stiffness, Order order)
        : stretch_(problem.rest, stiffness, stiffness), places_(problem.predicted), order_(order) {
        stretch_.begin(problem.inverse_mass);
    }
    void begin(const Field& places) { places_ = places; }
    void iterate() { stretch_.sweep(places_, order_); }
    const Field& places() const { return places_; }

private:
    StretchConstraint stretch_;
    Field places_;
    Order order_;
};

/// Where Newton's method ends, from the places of the problem or from others; nothing where it does not.
std::optional<Field> newton_limit(NewtonProjection projection) {
    for (int k = 0; k < kEnough; ++k)
        projection.iterate();
    const Field last = projection.places();
    projection.iterate();
    const double moved = distance(projection.places(), last), size = distance(last, Field(last.size()));
    if (!(moved <= 1e-12 * size)) return std::nullopt;
    return last;
}

ConvergeCurve curve_of(const StepProblem& problem, const char* method, const std::vector<int>& at,
                       const Run& run, const Field& limit, const Field& reference) {
    ConvergeCurve curve{problem.title, method, {}, 0};
    const double whole = distance(problem.predicted, limit);
    for (std::size_t k = 0; k < at.size(); ++k)
        curve.points.push_back({at[k], distance(run.places[k], limit) / whole, run.seconds[k]});
    curve.limit_distance = distance(limit, reference) / distance(problem.predicted, reference);
    return curve;
}

} // namespace

std::vector<ConvergeCurve> converge(const StepProblem& problem, double stiffness, int max_sweeps,
                                    const std::function<void(double)>& progress) {
    using Along = NewtonProjection::Along;
    struct Newton {
        const char* name;
        Along along;
    };
    struct Pbd {
        const char* name;
        Order order;
    };
    constexpr std::array newtons{Newton{"Newton", Along::now}, Newton{"Newton, along start", Along::start}};
    constexpr std::array sweeps{Pbd{"PBD, up", Order::upwards}, Pbd{"PBD, down", Order::downwards},
                                Pbd{"PBD, coloured", Order::coloured}};
    const std::optional<Field> reference = newton_limit(NewtonProjection(problem, Along::now));
    if (!reference)
        throw std::invalid_argument(problem.title + ": Newton's method finds no solution of this step");

    std::vector<ConvergeCurve> curves;
    const std::vector<int> few = stations(kNewtonIterations);
    for (const Newton& newton : newtons) {
        const NewtonProjection projection(problem, newton.along);
        if (const std::optional<Field> limit = newton_limit(projection))
            curves.push_back(
                curve_of(problem, newton.name, few, shortest(few, projection, [] {}), *limit, *reference));
    }

    const std::vector<int> many = stations(max_sweeps);
    double done = 0;
    for (const Pbd& pbd : sweeps) {
        const Run run = shortest(many, Sweeps(problem, stiffness, pbd.order), [&] {
            if (progress) progress(++done / ((kTimings + 1) * sweeps.size()));
        });
        // On towards the limit, in the order that is quickest. Sweeps move along the links as they are: where
        // little is left over, Newton's method along these links ends where further sweeps would.
        Sweeps further(problem, stiffness, Order::coloured);
        further.begin(run.places.back());
        for (int k = 0; k < kSweepsToLimit; ++k)
            further.iterate();
        NewtonProjection rest(problem, Along::now);
        rest.begin(further.places());
        if (progress) progress(++done / ((kTimings + 1) * sweeps.size()));
        if (const std::optional<Field> limit = newton_limit(rest))
            curves.push_back(curve_of(problem, pbd.name, many, run, *limit, *reference));
    }
    return curves;
}

void write_converge(const std::filesystem::path& file, const std::vector<ConvergeCurve>& curves,
                    const Notes& notes) {
    TextRows lines;
    for (const ConvergeCurve& curve : curves) {
        std::string iterations, errors, ms;
        for (const ConvergePoint& point : curve.points) {
            const char* gap = iterations.empty() ? "" : " ";
            iterations += gap + std::to_string(point.iterations);
            errors += fmt::format("{}{:.4g}", gap, point.error);
            ms += fmt::format("{}{:.4g}", gap, 1e3 * point.seconds);
        }
        lines.push_back({curve.problem, curve.method, fmt::format("{:.3g}", curve.limit_distance), iterations,
                         errors, ms});
    }
    write_text_rows(file, kHeadings, lines, notes);
}

std::vector<ConvergeCurve> read_converge(const std::filesystem::path& file) {
    std::vector<ConvergeCurve> curves;
    std::size_t count = 0;
    for (const std::vector<std::string>& cells : read_text_rows(file, kHeadings)) {
        const std::string place = row_place(file, ++count);
        ConvergeCurve curve{cells[0], cells[1], {}, number_in(cells[2], place)};
        const std::vector<double> iterations = numbers_in(cells[3], place),
                                  errors = numbers_in(cells[4], place), ms = numbers_in(cells[5], place);
        if (errors.size() != iterations.size() || ms.size() != iterations.size())
            throw ConfigError(place + ": as many errors and times as iterations are allowed");
        for (std::size_t k = 0; k < iterations.size(); ++k)
            curve.points.push_back({static_cast<int>(iterations[k]), errors[k], 1e-3 * ms[k]});
        curves.push_back(std::move(curve));
    }
    return curves;
}

void draw_converge(const std::filesystem::path& file, const std::vector<ConvergeCurve>& curves) {
    constexpr double kWidth = 520, kHeight = 300, kHead = 38;
    constexpr double kMinError = 1e-14;
    std::vector<std::string> problems, methods;
    for (const ConvergeCurve& curve : curves) {
        if (std::ranges::find(problems, curve.problem) == problems.end()) problems.push_back(curve.problem);
        if (std::ranges::find(methods, curve.method) == methods.end()) methods.push_back(curve.method);
    }
    Svg svg(2 * kWidth, kHead + kHeight * static_cast<double>(problems.size()));
    svg.text({14, 22}, "Projection of one step: |x_i - x*| / |x_0 - x*|, x* each method's own limit",
             {.size = 16, .bold = true});
    for (std::size_t row = 0; row < problems.size(); ++row)
        for (const bool time : {false, true}) {
            Panel panel{.title = problems[row],
                        .x = {time ? "processor time, ms" : "iterations (PBD: sweeps)", true},
                        .y = {"relative error", true, kMinError, 10},
                        .curves = {},
                        .label_room = 140};
            for (const ConvergeCurve& curve : curves) {
                if (curve.problem != problems[row]) continue;
                const auto number = std::ranges::find(methods, curve.method) - methods.begin();
                Curve drawn{.name = curve.method,
                            .points = {},
                            .colour = colour_of(static_cast<int>(number)),
                            .marked = number == 0,
                            .width = number == 0 ? 2.4 : 1.2};
                for (const ConvergePoint& point : curve.points)
                    drawn.points.push_back(
                        {time ? 1e3 * point.seconds : point.iterations, std::max(kMinError, point.error)});
                panel.curves.push_back(std::move(drawn));
            }
            draw(svg, panel, {time ? kWidth : 0, kHead + kHeight * static_cast<double>(row)}, kWidth,
                 kHeight);
        }
    svg.save(file);
}

} // namespace windlass::lab
