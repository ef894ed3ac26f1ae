#include "recorder/blind/agreement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace windlass::blind {

namespace {

/// Student's t that 2.5 % lie above; to four digits from 9 degrees of freedom on (Abramowitz and
/// Stegun, 26.7.5).
double students_t(std::size_t degrees) {
    constexpr double z = 1.959963985, z2 = z * z;
    const double d = static_cast<double>(degrees);
    return z * (1 + (z2 + 1) / (4 * d) + ((5 * z2 + 16) * z2 + 3) / (96 * d * d) +
                (((3 * z2 + 19) * z2 + 17) * z2 - 15) / (384 * d * d * d));
}

/// The mean kappa of those couples, without one recording. Nothing where that of any is not determined.
std::optional<double> mean_kappa(const std::vector<const Beside*>& couples, const std::string& without) {
    double sum = 0;
    for (const Beside* couple : couples) {
        Pairs all;
        for (const auto& [recording, pairs] : *couple)
            if (recording != without) all.insert(all.end(), pairs.begin(), pairs.end());
        const auto kappa = weighted_kappa(all);
        if (!kappa) return std::nullopt;
        sum += *kappa;
    }
    return couples.empty() ? std::nullopt : std::optional(sum / static_cast<double>(couples.size()));
}

} // namespace

Beside beside(const Rater& one, const Rater& other, const std::string& item) {
    Beside all;
    for (const auto& [sheet, marks] : one.marks) {
        const auto theirs = other.marks.find(sheet);
        if (theirs == other.marks.end()) continue;
        for (const auto& [name, mark] : marks) {
            if (item.empty() ? name.find('/') == std::string::npos : name != item) continue;
            const auto its = theirs->second.find(name);
            if (its != theirs->second.end()) all[sheet].push_back({mark, its->second});
        }
    }
    return all;
}

// With squared differences as weights of disagreement, the sums over the table of both come down to means and
// variances: 1 - E(x - y)^2 / E(x - y')^2, where y' is drawn apart from x.
std::optional<double> weighted_kappa(const Pairs& pairs) {
    if (pairs.empty()) return std::nullopt;
    std::int64_t n = 0, apart = 0;
    std::array<std::int64_t, 2> sum{}, squares{};
    for (const Pair& pair : pairs) {
        ++n;
        apart += std::int64_t{pair[0] - pair[1]} * (pair[0] - pair[1]);
        for (std::size_t k = 0; k < 2; ++k) {
            sum[k] += pair[k];
            squares[k] += std::int64_t{pair[k]} * pair[k];
        }
    }
    for (std::size_t k = 0; k < 2; ++k)
        if (n * squares[k] == sum[k] * sum[k]) return std::nullopt; // no variance: all the same
    const std::int64_t by_chance = n * (squares[0] + squares[1]) - 2 * sum[0] * sum[1];
    return 1 - static_cast<double>(n * apart) / static_cast<double>(by_chance);
}

Agreement agreement(const std::vector<Beside>& couples) {
    Agreement found;
    std::set<std::string> recordings;
    std::vector<const Beside*> determined;
    for (const Beside& couple : couples) {
        Pairs all;
        for (const auto& [recording, pairs] : couple) {
            recordings.insert(recording);
            all.insert(all.end(), pairs.begin(), pairs.end());
        }
        for (const Pair& pair : all) {
            ++found.pairs;
            found.same += pair[0] == pair[1] ? 1 : 0;
            found.difference += pair[0] - pair[1];
        }
        if (weighted_kappa(all)) determined.push_back(&couple);
    }
    found.recordings = recordings.size();
    if (found.pairs > 0) {
        found.same /= static_cast<double>(found.pairs);
        found.difference /= static_cast<double>(found.pairs);
    }
    if (found.recordings < kFewestRecordings) {
        found.undetermined = fmt::format("fewer than {} recordings", kFewestRecordings);
        return found;
    }
    found.kappa = mean_kappa(determined, "");
    if (!found.kappa) {
        found.undetermined = "all marks of one are equal";
        return found;
    }
    const double kappa = *found.kappa, n = static_cast<double>(found.recordings);
    std::vector<double> without;
    for (const std::string& recording : recordings) {
        const auto one = mean_kappa(determined, recording);
        if (!one) {
            found.undetermined = "interval: without one recording, all marks of one are equal";
            return found;
        }
        without.push_back(*one);
    }
    double mean = 0, squares = 0;
    for (const double each : without)
        mean += each / n;
    for (const double each : without)
        squares += (each - mean) * (each - mean);
    const double error = std::sqrt(squares * (n - 1) / n);
    if (error < 1e-12 || 1 - kappa * kappa < 1e-12) {
        found.undetermined = "interval: nothing varies between recordings";
        return found;
    }
    const double half = students_t(found.recordings - 1) * error / (1 - kappa * kappa);
    found.interval = {std::tanh(std::atanh(kappa) - half), std::tanh(std::atanh(kappa) + half)};
    return found;
}

} // namespace windlass::blind
