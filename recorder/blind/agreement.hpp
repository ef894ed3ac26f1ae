#pragma once
// How far raters agree who have marked the same recordings: Cohen's kappa with quadratic weights (Cohen
// 1968), which counts a mark that is off by two as four that are off by one.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace windlass::blind {

/// Below so many recordings, an interval spans the half of what kappa can be, and kappa is not told.
inline constexpr std::size_t kFewestRecordings = 10;

/// One rater's marks, whole numbers on an ordinal scale: of each sheet, of each item on it. What he has left
/// out is not there.
struct Rater {
    std::string name;
    std::map<std::string, std::map<std::string, int>> marks;
};

/// Two marks of the same thing, and those of a recording.
using Pair = std::array<int, 2>;
using Pairs = std::vector<Pair>;

/// Two raters beside each other: the marks that both have given, of each recording.
using Beside = std::map<std::string, Pairs>;

/// What two raters have both marked of an item; of every item whose name has a stroke where `item` is empty,
/// which are all criteria.
Beside beside(const Rater& one, const Rater& other, const std::string& item);

/// 1: they agree in all; 0: as chance would have it; negative: less than that. Nothing where one of them has
/// given everything the same mark, or there is nothing.
std::optional<double> weighted_kappa(const Pairs& pairs);

struct Agreement {
    std::size_t recordings = 0, pairs = 0; ///< with a mark of both raters
    double same = 0;                       ///< share of pairs in which both marks are equal
    double difference = 0;                 ///< mean, first less second
    std::optional<double> kappa;
    std::optional<std::array<double, 2>> interval; ///< of 95 %
    std::string undetermined;                      ///< why kappa or its interval is; empty: neither is
};

/// Of two raters, or the mean of several such pairs. The interval leaves out one recording after the other
/// (jackknife), on Fisher's scale atanh(kappa), with Student's t: docs/validity.md says why, and how often it
/// holds the true kappa.
Agreement agreement(const std::vector<Beside>& couples);

} // namespace windlass::blind
