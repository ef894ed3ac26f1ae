#pragma once
// Case files: one line between two ends, and what is to be written down of it. The format is
// bench/schema/case.schema.json.

#include "bench/lab/case/probes.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <limits>

namespace windlass::lab {

/// How a measured series lies beside the result.
struct ReferenceDef {
    std::string probe;  ///< "": the first
    double shift = 0;   ///< s, added to its times
    double from = -1e6; ///< s of the result
    double to = 1e6;    ///< s of the result
    double low = 2;     ///< unit of the probe
};

/// A case as it is run.
struct Case {
    std::string title;
    Problem problem;   ///< its time begins settle before the result's time 0; duration includes that
    double settle = 0; ///< s
    double sample = 0; ///< s between rows, 0: every step
    int links = 50;
    double dt = 0.005; ///< s
    std::vector<Probe> probes;
    MethodSettings settings;
    ReferenceDef reference;
};

/// Changes one field of a case before it is read: "line.length=150", "probes.0.arc=10". The value is JSON, or
/// text when it is not. Throws exercise::ConfigError when there is no = in it or the place cannot be.
void set_field(nlohmann::json& document, const std::string& assignment);

/// Reads a case from its document; source names it in errors and folder is where its other files are. Throws
/// exercise::ConfigError: file, JSON pointer, value, what is allowed.
Case case_from_json(const nlohmann::json& document, const std::string& source,
                    const std::filesystem::path& folder);

/// Reads a case file, with assignments as for set_field() laid over it.
Case load_case(const std::filesystem::path& file, const std::vector<std::string>& assignments = {});

} // namespace windlass::lab
