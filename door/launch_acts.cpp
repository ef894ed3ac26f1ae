// Lessons that a learning system starts, from the launch to the last statement: cmi5.

#include "common/text.hpp"
#include "door/asked.hpp"
#include "door/door_host.hpp"
#include "door/secrets.hpp"
#include "idl/wire.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace windlass::door {

using gateway::refused;
using gateway::Verdict;
using nlohmann::json;
using namespace std::chrono_literals;

namespace {

constexpr auto kHears = 2s;       // until a recorder that was started hears the exercise
constexpr auto kLeft = 15s;       // without a page, after the lesson's end
constexpr auto kReads = 20min;    // of the marks, at most
constexpr auto kDeserted = 30min; // without a page, in a lesson

std::int64_t unix_ms() {
    return std::chrono::duration_cast<std::chrono::milliseconds>(
               std::chrono::system_clock::now().time_since_epoch())
        .count();
}

/// A UUID of version 4.
std::string make_uuid() {
    std::string hex = make_key();
    hex[12] = '4';
    hex[16] = "89ab"[hex[16] & 3];
    return fmt::format("{}-{}-{}-{}-{}", hex.substr(0, 8), hex.substr(8, 4), hex.substr(12, 4),
                       hex.substr(16, 4), hex.substr(20));
}

cmi5::Stamp stamp() {
    return {.id = make_uuid(), .at_unix_ms = unix_ms()};
}

/// File and id of a lesson that is asked for by either.
std::pair<std::string, std::string> lesson_of(const json& list, const std::string& lesson) {
    for (const json& each : list.at("files"))
        if (!each.at("lesson").is_null() && (each.at("name") == lesson || each.at("lesson") == lesson)) {
            if (each.at("bridge_judged"))
                throw Denied(409, "lesson: " + lesson +
                                      " is for two, and a learning system starts one learner alone");
            return {each.at("name"), each.at("lesson")};
        }
    throw Denied(404, "lesson: " + lesson + ": there is no such lesson here");
}

} // namespace

/// What a launch has brought, or why it has not.
struct DoorHost::Arrived {
    cmi5::Launch launch;
    std::string lesson, lesson_id = {}, token = {};
    cmi5::LaunchData data = {};
    cmi5::RecordStore::Preferences preferences = {};
    bool has_passed = false, has_completed = false;
    int status = 0; // of a refusal
    std::string why = {};
};

/// The token is asked for once, whatever comes of it; so nothing is asked while there is no room.
void DoorHost::launch(const Who& who, const json& asked, const Reply& reply) {
    if (options_.learning_systems.empty()) throw Denied(404, "no learning system may start lessons here");
    const std::string network = network_of(who.address);
    not_too_often(wrong_codes_, network);
    Arrived arrived;
    arrived.lesson = text_of(asked, "lesson");
    if (!wire::is_exercise_name(arrived.lesson))
        throw Denied(400, "lesson: the name of a lesson is expected");
    try {
        arrived.launch = cmi5::launch_of(asked, options_.learning_systems);
    } catch (const cmi5::WrongLaunch& wrong) {
        throw Denied(400, wrong.what());
    }
    const std::string fetch = digest(arrived.launch.fetch);
    if (const auto* known = outbox_.of_fetch(fetch)) {
        if (known->browser == who.key) return reply(answer(me(who))); // the page was loaded again
        throw Denied(403, "this launch was used before: start the lesson in the learning system again");
    }
    if (!book_.can_launch()) throw Denied(503, "as many lessons are under way as may be: try again later");
    if (!launching_.insert(fetch).second) throw Denied(409, "this launch is under way already");
    launches_.add<Arrived>(
        [arrived, client = options_.web, lessons = options_.lessons]() mutable {
            try {
                std::tie(arrived.lesson, arrived.lesson_id) = lesson_of(lessons(), arrived.lesson);
                arrived.token = cmi5::RecordStore::fetch_token(client, arrived.launch.fetch);
                const cmi5::RecordStore store(client, arrived.launch.endpoint, arrived.token);
                arrived.data = store.launch_data(arrived.launch);
                arrived.preferences = store.preferences(arrived.launch);
                arrived.has_passed = store.has(arrived.launch, "passed");
                arrived.has_completed = store.has(arrived.launch, "completed");
            } catch (const Denied& denied) {
                arrived.status = denied.status;
                arrived.why = denied.what();
            } catch (const std::exception& error) {
                arrived.status = 502; // the learning system's, not the browser's
                arrived.why = error.what();
            }
            return arrived;
        },
        [this, who, network](const Arrived& come) {
            if (come.status == 0) return arrive(who, come);
            wrong_codes_.wrong(network, Clock::now());
            audit_.write("launch.failed",
                         {{"lesson", come.lesson}, {"address", who.address}, {"why", come.why}});
            return refused(come.status, come.why);
        },
        [this, fetch, reply](const Verdict& verdict) {
            launching_.erase(fetch);
            reply(verdict);
        });
}

/// A name that nobody else here goes by: an instructor's would be taken for his.
std::string DoorHost::learner_name(const json& actor) const {
    std::string name = plain_name(std::string(clipped(printable(cmi5::name_of(actor)), 32)));
    if (name.empty() || name == "server" || name == "door" || people_.find(name) != nullptr)
        name = "learner " + digest(actor.dump()).substr(0, 8);
    return name;
}

Verdict DoorHost::arrive(const Who& who, const Arrived& come) {
    const std::string secret = make_secret(), key = digest(secret), id = make_uuid(),
                      class_id = "cmi5-" + make_key().substr(0, 8);
    const auto& [actor, registration, activity] =
        std::tie(come.launch.actor, come.launch.registration, come.launch.activity);
    const std::string name = learner_name(actor);
    cmi5::Session session;
    session.id = id;
    session.lesson = come.lesson;
    session.lesson_id = come.lesson_id;
    session.name = name;
    session.endpoint = come.launch.endpoint;
    session.token = come.token;
    session.fetch = digest(come.launch.fetch);
    session.browser = key;
    session.about = {.actor = actor,
                     .registration = registration,
                     .activity = activity,
                     .context_template = come.data.context_template,
                     .normal = come.data.normal,
                     .mastery_score = come.data.mastery_score,
                     .has_passed = come.has_passed,
                     .has_completed = come.has_completed};
    session.return_url = come.data.return_url;
    session.began_unix_ms = unix_ms();
    session.waiting = {cmi5::initialized(session.about, stamp())};
    leave_seat(who);
    book_.launch(class_id, id, come.lesson, !come.data.normal, name, key, unix_s());
    outbox_.put(std::move(session));
    keep_classes();
    audit_.write("launch", {{"name", name},
                            {"class", class_id},
                            {"lesson", come.lesson},
                            {"learning_system", cmi5::url_of(come.launch.endpoint).value().origin()},
                            {"registration", registration},
                            {"activity", activity},
                            {"address", who.address}});
    Who now{.way = who.way, .address = who.address, .key = key};
    now.trainee = book_.seated(key);
    json told = me(now);
    told["launch"]["languages"] = come.preferences.languages;
    told["launch"]["audio"] = come.preferences.audio;
    return with_cookie(who, secret, std::move(told));
}

/// The learner has read what came of it, or has had enough.
Verdict DoorHost::finish(const Who& who) {
    const auto* its_class = who.trainee ? book_.find(who.trainee->class_id) : nullptr;
    if (its_class != nullptr && !its_class->launch.empty()) end_launch(std::string(its_class->id));
    Who now = who;
    now.trainee = book_.seated(who.key);
    return answer(me(now));
}

/// What a browser may know of the session that it came by; null: it came by none.
json DoorHost::launch_told(const std::string& browser) const {
    const auto* session = outbox_.of_browser(browser);
    if (session == nullptr) return {};
    const auto* its_class = book_.launched(session->id);
    const bool under_way = its_class != nullptr && !its_class->over;
    return {{"state", under_way         ? "under_way"
                      : session->closed ? "done"
                                        : "marking"},
            {"lesson", session->lesson_id}, // a file's name may say what is to come
            {"name", session->name},
            {"counts", session->about.normal},
            {"verdict", session->verdict},
            {"points", session->points ? json(*session->points) : json()},
            {"waits", !session->waiting.empty()},
            {"back", session->return_url}};
}

void DoorHost::end_launch(const std::string& class_id) {
    const TrainingClass its_class = *book_.find(class_id); // its keys are nobody's afterwards
    book_.end(class_id);
    runs_.remove(its_class.exercises, "door");
    for (const Trainee& each : its_class.trainees)
        send_away(each.key, "the lesson is over");
    keep_classes();
    audit_.write("launch.end", {{"class", class_id}});
}

void DoorHost::tend_launches(gateway::Clock::time_point now) {
    const auto classes = book_.classes(); // which end and go meanwhile
    for (const TrainingClass& each : classes) {
        if (each.launch.empty()) continue;
        if (each.over)
            settle_launch(each);
        else
            tend_launch(each, now);
    }
    std::vector<std::string> lost; // whose class is not in the book any more
    for (const auto& [id, session] : outbox_.sessions())
        if (!session.closed && book_.launched(id) == nullptr) lost.push_back(id);
    for (const std::string& id : lost)
        close_session(id, std::nullopt);
    std::erase_if(watched_, [&](const auto& each) { return book_.find(each.first) == nullptr; });
    post_statements();
    outbox_.forget_old(unix_s());
}

/// Nobody leads it: it is started once it is recorded and the learner's page is open, and ends when the
/// learner has left.
void DoorHost::tend_launch(const TrainingClass& its_class, gateway::Clock::time_point now) {
    Watched& watched = watched_.try_emplace(its_class.id, Watched{.seen = now}).first->second;
    const bool open = std::ranges::any_of(its_class.trainees,
                                          [&](const Trainee& each) { return !links(each.key).empty(); });
    if (open) watched.seen = now;
    const auto result = its_class.results.find(its_class.exercises.front());
    const bool known = result != its_class.results.end();
    if (known && !result->second.recording.empty() && !watched.recorded) watched.recorded = now;
    if (known && !result->second.outcome.empty() && !watched.finished) watched.finished = now;
    const auto* session = outbox_.find(its_class.launch);
    if (session != nullptr && !session->started && open && watched.recorded &&
        now - *watched.recorded >= kHears) {
        runs_.give(its_class.exercises, wire::topics::exercise_command, {{"action", "EXERCISE_START"}},
                   "door");
        cmi5::Session begun = *session;
        begun.started = true;
        outbox_.put(std::move(begun));
    }
    const auto away = now - watched.seen;
    const bool left = its_class.trainees.empty() || away > kDeserted || unix_s() >= its_class.until;
    const bool over = watched.finished && (away > kLeft || now - *watched.finished > kReads);
    if (left || over || session == nullptr) end_launch(its_class.id);
}

/// What came of it is read from its recording, once that is whole.
void DoorHost::settle_launch(const TrainingClass& its_class) {
    const std::string& exercise = its_class.exercises.front();
    if (runs_.told(exercise) || stations_.instructor().recording_of(exercise)) return;
    const auto found = its_class.results.find(exercise);
    const Result result = found == its_class.results.end() ? Result() : found->second;
    const auto* session = outbox_.find(its_class.launch);
    if (session == nullptr || session->closed) {
        if (result.in_history || result.recording.empty() || its_class.trainees.empty()) {
            book_.forget(its_class.id);
            keep_classes();
        }
        return;
    }
    if (result.recording.empty()) return close_session(session->id, std::nullopt);
    if (std::exchange(watched_[its_class.id].asked_for_marks, true)) return;
    slow_.add<cmi5::Marks>([marks_of = options_.marks_of, name = result.recording] { return marks_of(name); },
                           [this, id = session->id](const cmi5::Marks& marks) {
                               close_session(id, marks);
                               return Verdict{};
                           },
                           [this, id = session->id, class_id = its_class.id](const Verdict& verdict) {
                               if (verdict.status == 503) watched_[class_id].asked_for_marks = false;
                               if (verdict.status != 500) return;
                               log_.tell("a launched lesson has no result: " + verdict.reason);
                               close_session(id, std::nullopt);
                           });
}

void DoorHost::close_session(const std::string& id, const std::optional<cmi5::Marks>& marks) {
    const auto* known = outbox_.find(id);
    if (known == nullptr || known->closed) return;
    cmi5::Session session = *known;
    const auto verdict = marks ? cmi5::verdict_of(session.about, *marks) : cmi5::Verdict::none;
    session.verdict = verdict == cmi5::Verdict::passed   ? "passed"
                      : verdict == cmi5::Verdict::failed ? "failed"
                                                         : "";
    if (marks) session.points = marks->score;
    const double duration = static_cast<double>(unix_ms() - session.began_unix_ms) / 1000;
    for (json& each : cmi5::last_statements(session.about, marks, duration, stamp))
        session.waiting.push_back(std::move(each));
    session.closed = true;
    audit_.write("launch.result", {{"name", session.name},
                                   {"lesson", session.lesson},
                                   {"verdict", session.verdict},
                                   {"points", session.points ? json(*session.points) : json()},
                                   {"recording", marks ? marks->recording : ""},
                                   {"recording_sha256", marks ? marks->recording_sha256 : ""}});
    outbox_.put(std::move(session));
}

/// In their order, one of a session at a time; a record store that does not take one is asked again later.
void DoorHost::post_statements() {
    struct Said {
        int status = 0;
        std::string why;
    };
    for (const std::string& id : outbox_.due(unix_s())) {
        const cmi5::Session& session = *outbox_.find(id);
        outbox_.begin(id, unix_s());
        const auto not_taken = [this, id](const std::string& why) {
            const cmi5::Session before = *outbox_.find(id);
            const bool goes_on = outbox_.failed(id, unix_s());
            const std::string store = cmi5::url_of(before.endpoint).value().origin();
            if (goes_on && before.tries == 0)
                log_.tell(store + " has not taken a statement, tried again: " + why);
            if (goes_on) return;
            audit_.write(
                "launch.given_up",
                {{"name", before.name}, {"learning_system", store}, {"statements", before.waiting.size()}});
            log_.tell(store + " was given up: " + why);
        };
        posts_.add<Said>(
            [client = options_.web, endpoint = session.endpoint, token = session.token,
             statement = session.waiting.front()] {
                Said said;
                said.status = cmi5::RecordStore(client, endpoint, token).post(statement, said.why);
                return said;
            },
            [this, id, not_taken](const Said& said) {
                const bool there = said.status == 409; // that very statement: an answer was lost
                if (there || (said.status >= 200 && said.status < 300)) {
                    const std::string verb = outbox_.posted(id, unix_s());
                    const auto* its_session = outbox_.find(id);
                    audit_.write("launch.posted", {{"name", its_session->name},
                                                   {"lesson", its_session->lesson},
                                                   {"verb", verb},
                                                   {"status", said.status}});
                } else {
                    not_taken(fmt::format("{} {}", said.status, said.why));
                }
                return Verdict{};
            },
            [this, id, not_taken](const Verdict& verdict) {
                if (verdict.status == 503) outbox_.put_off(id);
                if (verdict.status == 500) not_taken(verdict.reason);
            });
    }
}

} // namespace windlass::door
