#pragma once
// How a learning system starts a lesson here: what the address says, and what is fetched with it. By the
// cmi5 specification, Quartz edition (github.com/AICC/CMI-5_Spec_Current), over xAPI 1.0.3.

#include "door/cmi5/http_client.hpp"

#include <nlohmann/json.hpp>

#include <stdexcept>

namespace windlass::cmi5 {

/// What is wrong with a launch, for whoever came by it: field, value and what is allowed.
struct WrongLaunch : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The five parameters of a launch, each good.
struct Launch {
    std::string endpoint; ///< ends with a slash
    std::string fetch;
    nlohmann::json actor; ///< an Agent with an account
    std::string registration;
    std::string activity;
};

/// asked: the parameters as texts, escapes resolved. Throws WrongLaunch.
Launch launch_of(const nlohmann::json& asked, const LearningSystems& allowed);

/// The name under which an actor sits here: its own, else its account's.
std::string name_of(const nlohmann::json& actor);

/// What LMS.LaunchData says.
struct LaunchData {
    nlohmann::json context_template;
    bool normal = true;                       ///< what comes of it is kept; false: browse or review
    std::optional<double> mastery_score = {}; ///< 0..1
    std::string return_url = {};              ///< http or https; empty: none
};

/// Throws WrongLaunch when the document is none.
LaunchData launch_data_of(const nlohmann::json& document);

/// The record store of one launch. What is asked waits; throws std::runtime_error, whose text never has the
/// token.
class RecordStore {
public:
    RecordStore(const WebClient& client, std::string endpoint, std::string token)
        : client_{client}, endpoint_{std::move(endpoint)}, token_{std::move(token)} {}

    /// The token, which the address gives once: a second time is the learning system's refusal.
    static std::string fetch_token(const WebClient& client, const std::string& fetch);

    LaunchData launch_data(const Launch& launch) const;

    struct Preferences {
        std::string languages = {}; ///< "de-DE,en": by preference; empty: none is told
        std::string audio = {};     ///< "on", "off", or empty
    };
    /// Of the learner; none where the store has none.
    Preferences preferences(const Launch& launch) const;

    /// Whether the activity has a statement of that verb (the last part of its IRI) in this registration: of
    /// some there may be one only. False, too, where the store lets nobody ask.
    bool has(const Launch& launch, const std::string& verb) const;

    /// The status with which it answered; what it said of a refusal is put into why.
    int post(const nlohmann::json& statement, std::string& why) const;

private:
    WebAnswer ask(const std::string& method, const std::string& what, const std::string& body = {}) const;

    const WebClient& client_;
    const std::string endpoint_, token_;
};

} // namespace windlass::cmi5
