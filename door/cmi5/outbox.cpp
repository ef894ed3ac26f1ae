#include "door/cmi5/outbox.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace windlass::cmi5 {

using nlohmann::json;
namespace fs = std::filesystem;

namespace {

template <class T>
json or_null(const std::optional<T>& value) {
    return value ? json(*value) : json();
}

std::optional<double> number_in(const json& kept, const char* name) {
    const json& value = kept.at(name);
    return value.is_null() ? std::nullopt : std::optional(value.get<double>());
}

json to_json(const Session& session) {
    const About& about = session.about;
    return {{"id", session.id},
            {"lesson", session.lesson},
            {"lesson_id", session.lesson_id},
            {"name", session.name},
            {"endpoint", session.endpoint},
            {"token", session.token},
            {"fetch", session.fetch},
            {"browser", session.browser},
            {"actor", about.actor},
            {"registration", about.registration},
            {"activity", about.activity},
            {"context_template", about.context_template},
            {"normal", about.normal},
            {"mastery_score", or_null(about.mastery_score)},
            {"has_passed", about.has_passed},
            {"has_completed", about.has_completed},
            {"return_url", session.return_url},
            {"began_unix_ms", session.began_unix_ms},
            {"started", session.started},
            {"closed", session.closed},
            {"verdict", session.verdict},
            {"points", or_null(session.points)},
            {"waiting", session.waiting},
            {"tries", session.tries},
            {"next_unix_s", session.next_unix_s},
            {"since_unix_s", session.since_unix_s},
            {"done_unix_s", session.done_unix_s}};
}

Session session_of(const json& kept) {
    return {.id = kept.at("id"),
            .lesson = kept.at("lesson"),
            .lesson_id = kept.at("lesson_id"),
            .name = kept.at("name"),
            .endpoint = kept.at("endpoint"),
            .token = kept.at("token"),
            .fetch = kept.at("fetch"),
            .browser = kept.at("browser"),
            .about = {.actor = kept.at("actor"),
                      .registration = kept.at("registration"),
                      .activity = kept.at("activity"),
                      .context_template = kept.at("context_template"),
                      .normal = kept.at("normal"),
                      .mastery_score = number_in(kept, "mastery_score"),
                      .has_passed = kept.at("has_passed"),
                      .has_completed = kept.at("has_completed")},
            .return_url = kept.at("return_url"),
            .began_unix_ms = kept.at("began_unix_ms"),
            .started = kept.at("started"),
            .closed = kept.at("closed"),
            .verdict = kept.at("verdict"),
            .points = number_in(kept, "points"),
            .waiting = kept.at("waiting"),
            .tries = kept.at("tries"),
            .next_unix_s = kept.at("next_unix_s"),
            .since_unix_s = kept.at("since_unix_s"),
            .done_unix_s = kept.at("done_unix_s")};
}

std::string text_in(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace

Outbox::Outbox(fs::path folder, Write write) : folder_{std::move(folder)}, write_{std::move(write)} {
    if (!fs::is_directory(folder_)) return;
    for (const auto& entry : fs::directory_iterator(folder_)) {
        if (entry.path().extension() != ".json") continue;
        try {
            Session session = session_of(json::parse(text_in(entry.path())));
            sessions_[session.id] = std::move(session);
        } catch (const std::exception& error) {
            throw std::runtime_error(entry.path().string() + ": " + error.what());
        }
    }
}

const Session* Outbox::find(const std::string& id) const {
    const auto found = sessions_.find(id);
    return found == sessions_.end() ? nullptr : &found->second;
}

const Session* Outbox::of_browser(const std::string& browser) const {
    const Session* newest = nullptr;
    for (const auto& [id, each] : sessions_)
        if (!browser.empty() && each.browser == browser &&
            (newest == nullptr || each.began_unix_ms > newest->began_unix_ms))
            newest = &each;
    return newest;
}

const Session* Outbox::of_fetch(const std::string& fetch) const {
    const auto found =
        std::ranges::find_if(sessions_, [&](const auto& each) { return each.second.fetch == fetch; });
    return found == sessions_.end() ? nullptr : &found->second;
}

void Outbox::keep(const Session& session) {
    write_(folder_ / (session.id + ".json"), to_json(session).dump(1) + '\n');
}

void Outbox::put(Session session) {
    keep(session);
    sessions_[session.id] = std::move(session);
}

void Outbox::add(const std::string& id, std::vector<json> statements, bool last) {
    Session session = sessions_.at(id);
    session.waiting.insert(session.waiting.end(), std::make_move_iterator(statements.begin()),
                           std::make_move_iterator(statements.end()));
    session.closed = session.closed || last;
    put(std::move(session));
}

std::vector<std::string> Outbox::due(std::int64_t now_unix_s) {
    std::vector<std::string> all;
    for (const auto& [id, each] : sessions_)
        if (!each.waiting.empty() && now_unix_s >= each.next_unix_s && !trying_.contains(id))
            all.push_back(id);
    return all;
}

void Outbox::begin(const std::string& id, std::int64_t now_unix_s) {
    Session& session = sessions_.at(id);
    if (session.since_unix_s == 0) session.since_unix_s = now_unix_s;
    trying_[id] = true;
}

std::string Outbox::posted(const std::string& id, std::int64_t now_unix_s) {
    trying_.erase(id);
    Session& session = sessions_.at(id);
    const std::string verb = session.waiting.front().at("verb").at("id");
    session.waiting.erase(session.waiting.begin());
    session.tries = 0;
    session.next_unix_s = session.since_unix_s = 0;
    done_if_empty(session, now_unix_s);
    keep(session);
    return verb.substr(verb.rfind('/') + 1);
}

bool Outbox::failed(const std::string& id, std::int64_t now_unix_s) {
    trying_.erase(id);
    Session& session = sessions_.at(id);
    const bool goes_on = now_unix_s - session.since_unix_s < kGivenUp;
    const auto pause = kFirstPause << std::min(session.tries, 10);
    session.tries += 1;
    session.next_unix_s = now_unix_s + std::min(pause, kLongestPause);
    if (!goes_on) session.waiting.clear();
    if (!goes_on) session.closed = true; // nothing may follow what is missing
    done_if_empty(session, now_unix_s);
    keep(session);
    return goes_on;
}

void Outbox::put_off(const std::string& id) {
    trying_.erase(id);
}

/// The token is of no use any more, and nobody's to find.
void Outbox::done_if_empty(Session& session, std::int64_t now_unix_s) {
    if (!session.closed || !session.waiting.empty()) return;
    session.done_unix_s = now_unix_s;
    session.token.clear();
}

void Outbox::forget_old(std::int64_t now_unix_s) {
    std::erase_if(sessions_, [&](const auto& each) {
        const bool old = each.second.done_unix_s != 0 && now_unix_s - each.second.done_unix_s > kKept;
        if (old) {
            std::error_code ignored;
            fs::remove(folder_ / (each.first + ".json"), ignored);
        }
        return old;
    });
}

} // namespace windlass::cmi5
