#include "door/cmi5/launch.hpp"

#include "common/text.hpp"

#include <fmt/format.h>

#include <array>
#include <regex>

namespace windlass::cmi5 {

using nlohmann::json;

namespace {

constexpr std::size_t kShown = 80; // bytes of a value that is wrong

std::string value_shown(const std::string& value) {
    return value.empty() ? "nothing" : printable(clipped(value, kShown));
}

[[noreturn]] void wrong(const std::string& field, const std::string& value, const std::string& allowed) {
    throw WrongLaunch(fmt::format("{}: {}: {}", field, value_shown(value), allowed));
}

std::string text_of(const json& asked, const char* name) {
    const auto found = asked.find(name);
    if (found == asked.end() || !found->is_string()) return {};
    return found->get<std::string>();
}

Url allowed_url(const std::string& field, const std::string& value, const LearningSystems& allowed) {
    const auto url = url_of(value);
    if (!url) wrong(field, value, "an absolute address by https is expected");
    if (!allowed.allow(*url)) wrong(field, value, "of this door's learning systems only: " + allowed.told());
    return *url;
}

json actor_of(const std::string& text) {
    constexpr const char* kExpected =
        "an Agent as JSON is expected, with account.homePage, an address, and account.name";
    json actor = json::parse(text, nullptr, false);
    if (!actor.is_object() || actor.value("objectType", json("Agent")) != "Agent")
        wrong("actor", text, kExpected);
    const json account = actor.value("account", json());
    if (!account.is_object() || text_of(account, "name").empty() ||
        text_of(account, "homePage").find(':') == std::string::npos)
        wrong("actor", text, kExpected);
    if (actor.contains("name") && !actor["name"].is_string()) wrong("actor", text, kExpected);
    actor["objectType"] = "Agent";
    return actor;
}

/// An answer's body, where it is JSON; else null.
json body_of(const WebAnswer& answer) {
    json body = json::parse(answer.body, nullptr, false);
    return body.is_discarded() ? json() : body;
}

} // namespace

Launch launch_of(const json& asked, const LearningSystems& allowed) {
    Launch launch{.endpoint = text_of(asked, "endpoint"),
                  .fetch = text_of(asked, "fetch"),
                  .actor = {},
                  .registration = text_of(asked, "registration"),
                  .activity = text_of(asked, "activityId")};
    const Url endpoint = allowed_url("endpoint", launch.endpoint, allowed);
    if (endpoint.target.find('?') != std::string::npos)
        wrong("endpoint", launch.endpoint, "an address without a query is expected");
    if (!launch.endpoint.ends_with('/')) launch.endpoint += '/';
    allowed_url("fetch", launch.fetch, allowed);
    launch.actor = actor_of(text_of(asked, "actor"));
    static const std::regex kUuid("[0-9a-fA-F]{8}(-[0-9a-fA-F]{4}){3}-[0-9a-fA-F]{12}");
    if (!std::regex_match(launch.registration, kUuid))
        wrong("registration", launch.registration, "a UUID is expected");
    static const std::regex kIri("[A-Za-z][A-Za-z0-9+.-]*:[^\\s<>\"{}|\\\\^`]+");
    if (launch.activity.size() > 1000 || !std::regex_match(launch.activity, kIri))
        wrong("activityId", launch.activity, "an IRI is expected");
    return launch;
}

std::string name_of(const json& actor) {
    const std::string own = text_of(actor, "name");
    return own.empty() ? text_of(actor.at("account"), "name") : own;
}

LaunchData launch_data_of(const json& document) {
    const auto wrong_here = [](const std::string& field, const json& value, const std::string& allowed) {
        wrong("LMS.LaunchData." + field,
              value.is_null() ? "" : value.dump(-1, ' ', false, json::error_handler_t::replace), allowed);
    };
    if (!document.is_object()) wrong("LMS.LaunchData", "", "a JSON object is expected");
    LaunchData data;
    data.context_template = document.value("contextTemplate", json());
    if (!data.context_template.is_object())
        wrong_here("contextTemplate", data.context_template, "an object is expected");
    for (const char* part : {"contextActivities", "extensions"})
        if (data.context_template.contains(part) && !data.context_template[part].is_object())
            wrong_here("contextTemplate", data.context_template, std::string(part) + " is no object");
    const json mode = document.value("launchMode", json());
    if (mode != "Normal" && mode != "Browse" && mode != "Review")
        wrong_here("launchMode", mode, "Normal, Browse or Review is allowed");
    data.normal = mode == "Normal";
    if (const json score = document.value("masteryScore", json()); !score.is_null()) {
        if (!score.is_number() || score.get<double>() < 0 || score.get<double>() > 1)
            wrong_here("masteryScore", score, "0 to 1 is allowed");
        data.mastery_score = score.get<double>();
    }
    if (const json back = document.value("returnURL", json()); !back.is_null() && back != "") {
        // Followed by the learner's browser, never by the door: any site, but no script.
        if (!back.is_string() ||
            !url_of(back.get<std::string>().substr(0, back.get<std::string>().find('#'))))
            wrong_here("returnURL", back, "an address by http or https is allowed");
        data.return_url = back;
    }
    return data;
}

std::string RecordStore::fetch_token(const WebClient& client, const std::string& fetch) {
    const Url url = url_of(fetch).value();
    const WebAnswer answer = client.ask({.method = "POST", .url = url});
    const json body = body_of(answer);
    const std::string token = body.is_object() ? text_of(body, "auth-token") : std::string();
    const std::string said = body.is_object() ? text_of(body, "error-text") : std::string();
    if (answer.status != 200 || token.empty())
        throw std::runtime_error(
            fmt::format("{} gave no token for this launch ({}{}): start the lesson there again", url.origin(),
                        answer.status, said.empty() ? "" : ", " + value_shown(said)));
    static const std::regex kToken("[\\x21-\\x7E]{1,4000}"); // it becomes part of a header
    if (!std::regex_match(token, kToken))
        throw std::runtime_error(url.origin() + " gave a token that is none");
    return token;
}

WebAnswer RecordStore::ask(const std::string& method, const std::string& what,
                           const std::string& body) const {
    WebRequest request{.method = method,
                       .url = url_of(endpoint_ + what).value(),
                       .headers = {{"Authorization", "Basic " + token_},
                                   {"X-Experience-API-Version", "1.0.3"},
                                   {"Accept", "application/json"}},
                       .body = body};
    if (!body.empty()) request.headers.emplace_back("Content-Type", "application/json");
    return client_.ask(request);
}

LaunchData RecordStore::launch_data(const Launch& launch) const {
    const WebAnswer answer = ask(
        "GET", fmt::format("activities/state?stateId=LMS.LaunchData&activityId={}&agent={}&registration={}",
                           escaped(launch.activity), escaped(launch.actor.dump()), launch.registration));
    if (answer.status != 200)
        throw std::runtime_error(
            fmt::format("{} gave no LMS.LaunchData ({})", url_of(endpoint_).value().origin(), answer.status));
    return launch_data_of(body_of(answer));
}

RecordStore::Preferences RecordStore::preferences(const Launch& launch) const {
    const WebAnswer answer =
        ask("GET", "agents/profile?profileId=cmi5LearnerPreferences&agent=" + escaped(launch.actor.dump()));
    const json body = body_of(answer);
    if (answer.status != 200 || !body.is_object()) return {};
    return {.languages = text_of(body, "languagePreference"), .audio = text_of(body, "audioPreference")};
}

bool RecordStore::has(const Launch& launch, const std::string& verb) const {
    const WebAnswer answer =
        ask("GET", fmt::format("statements?limit=1&activity={}&agent={}&registration={}&verb={}",
                               escaped(launch.activity), escaped(launch.actor.dump()), launch.registration,
                               escaped("http://adlnet.gov/expapi/verbs/" + verb)));
    const json body = body_of(answer);
    if (answer.status != 200 || !body.is_object()) return false;
    const auto found = body.find("statements");
    return found != body.end() && found->is_array() && !found->empty();
}

int RecordStore::post(const json& statement, std::string& why) const {
    const WebAnswer answer = ask("POST", "statements", statement.dump());
    why = value_shown(answer.body);
    return answer.status;
}

} // namespace windlass::cmi5
