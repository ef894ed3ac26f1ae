// What pages of the door ask and do, as JSON: POST /door/ACT and GET /door/QUESTION. docs/class.md has the
// list.

#include "door/asked.hpp"
#include "door/door_host.hpp"
#include "door/query.hpp"
#include "door/secrets.hpp"
#include "idl/wire.hpp"
#include "station/gateway/admission.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>

namespace windlass::door {

using gateway::refused;
using gateway::Verdict;
using nlohmann::json;

namespace {

/// The list of a class; none: whoever has its code may join.
std::vector<std::string> names_in(const json& asked) {
    std::vector<std::string> names;
    const auto given = asked.find("names");
    if (given == asked.end()) return names;
    if (!given->is_array()) throw Denied(400, "names: a list of texts is expected");
    for (const json& each : *given) {
        if (!each.is_string()) throw Denied(400, "names: a list of texts is expected");
        names.push_back(plain_name_of(each.get<std::string>()));
    }
    return names;
}

/// "places": {name: place}: whose seat is where; nothing: in the order in which they come. Throws Denied.
std::map<std::string, Place> places_in(const json& asked) {
    std::map<std::string, Place> places;
    const auto given = asked.find("places");
    if (given == asked.end()) return places;
    if (!given->is_object()) throw Denied(400, "places: names and their places are expected");
    for (const auto& [name, each] : given->items()) {
        const auto place = each.is_string() ? place_named(each.get<std::string>()) : std::nullopt;
        if (!place) throw Denied(400, "places: ship, forecastle, bridge or watch");
        places[plain_name_of(name)] = *place;
    }
    return places;
}

std::string password_in(const json& asked) {
    const std::string password = text_of(asked, "password");
    if (password.size() < People::kPasswordLeast || password.size() > People::kPasswordMost)
        throw Denied(400, fmt::format("password: {} to {} characters are allowed", People::kPasswordLeast,
                                      People::kPasswordMost));
    return password;
}

/// "from": {"recording": ..., "position": s}; nothing: the exercises begin anew. Throws Denied.
std::optional<Moment> moment_in(const json& asked) {
    const auto from = asked.find("from");
    if (from == asked.end() || from->is_null()) return std::nullopt;
    constexpr double kLongest = 24 * 3600; // s
    const json position = from->is_object() ? from->value("position", json()) : json();
    if (!position.is_number() || position < 0 || position > kLongest)
        throw Denied(400, "from.position: a number of s from 0 to 86400");
    return Moment{.recording = text_of(*from, "recording"), .position = position};
}

json words_told(const std::vector<AttemptJudged>& words) {
    json all = json::array();
    for (const AttemptJudged& each : words)
        all.push_back({{"recording", each.recording},
                       {"points", each.points ? json(*each.points) : json()},
                       {"outcome", each.outcome},
                       {"by", each.by},
                       {"note", each.note}});
    return all;
}

/// The recordings of a class's attempts.
std::vector<std::string> recordings_of(const TrainingClass& of) {
    std::vector<std::string> recordings;
    for (const auto& [exercise, result] : of.results)
        if (!result.recording.empty()) recordings.push_back(result.recording);
    return recordings;
}

} // namespace

void DoorHost::ask(const std::string& target, const Who& who, const Reply& reply) {
    const std::string path = target.substr(0, target.find('?'));
    if (path == "/door/me") return reply(answer(me(who)));
    if (!who.staff) return reply(refused(who.trainee ? 403 : 401, "this is for instructors: log in"));
    if (path == "/door/classes") return reply(answer(classes()));
    if (path == "/door/people" && who.staff->rank == Rank::owner) return reply(answer(people()));
    if (path == "/door/kiosks" && who.staff->rank == Rank::owner) return reply(answer(kiosks()));
    if (path == "/door/lessons" && options_.lessons)
        return slow_.add<json>(
            options_.lessons, [](const json& list) { return answer(list); }, reply);
    if (path == "/door/marks.csv") return marks(value_in(target, "class"), reply);
    if (path == "/door/side_by_side" && options_.side_by_side)
        return lay_side_by_side(value_in(target, "class"), reply);
    if (path == "/door/next" && options_.next) return next(value_in(target, "class"), reply);
    if (path == "/door/debriefing" || path == "/door/what_if")
        return debrief(value_in(target, "recording"), path == "/door/what_if", reply);
    reply(refused(404, "nobody answers that here"));
}

void DoorHost::marks(const std::string& id, const Reply& reply) {
    const auto* its_class = book_.find(id);
    if (its_class == nullptr) return reply(refused(404, "there is no such class"));
    slow_.add<std::string>(
        [of = *its_class, words = options_.words] {
            return marks_csv(of, words ? words(recordings_of(of)) : std::vector<AttemptJudged>());
        },
        [id](std::string table) {
            return Verdict{.kind = Verdict::Kind::answer,
                           .type = "text/csv; charset=utf-8",
                           .body = std::move(table),
                           .headers = {{"Content-Disposition", "attachment; filename=\"" + id + ".csv\""}}};
        },
        reply);
}

/// Of who sat in a class that is over, and what assessors have said of it. Waits, and says so, until all
/// their attempts are in the history.
void DoorHost::next(const std::string& id, const Reply& reply) {
    const auto* its_class = book_.find(id);
    if (its_class == nullptr || !its_class->over) return reply(refused(404, "no class of that name is over"));
    const bool waits = std::ranges::any_of(its_class->results, [](const auto& one) {
        return !one.second.recording.empty() && !one.second.in_history;
    });
    if (waits) return reply(answer({{"waits", true}, {"next", json::array()}, {"words", json::array()}}));
    std::set<std::string> all;
    for (const std::string& exercise : its_class->exercises)
        for (const Part& each : its_class->parts(exercise))
            all.insert(each.name);
    const std::vector<std::string> names(all.begin(), all.end());
    slow_.add<json>(
        [ask = options_.next, words = options_.words, names, recordings = recordings_of(*its_class)] {
            return json{{"next", ask(names)},
                        {"words", words ? words_told(words(recordings)) : json::array()}};
        },
        [](const json& found) {
            return answer({{"waits", false}, {"next", found["next"]}, {"words", found["words"]}});
        },
        reply);
}

/// An assessor's word on an attempt that the history has.
void DoorHost::take_word(const Who& who, const json& asked, const Reply& reply) {
    const auto points = asked.find("points");
    AttemptJudged judged{.recording = text_of(asked, "recording"),
                         .by = who.staff->name,
                         .outcome = text_of(asked, "outcome"),
                         .note = text_of(asked, "note")};
    if (points != asked.end() && !points->is_null()) {
        if (!points->is_number() || *points < 0 || *points > 100)
            throw Denied(400, "points: a number from 0 to 100, or null");
        judged.points = points->get<double>();
    }
    const std::set<std::string> outcomes{"achieved", "not_yet", "not_shown"};
    if (!outcomes.contains(judged.outcome)) throw Denied(400, "outcome: achieved, not_yet or not_shown");
    const auto its_class = std::ranges::find_if(book_.classes(), [&](const TrainingClass& each) {
        return std::ranges::any_of(each.results, [&](const auto& one) {
            return one.second.recording == judged.recording && one.second.in_history;
        });
    });
    if (its_class == book_.classes().end()) throw Denied(404, "no class has such an attempt in the history");
    slow_.add<json>(
        [judge = options_.judge, words = options_.words, judged] {
            const std::string why = judge(judged);
            return why.empty() ? json{{"words", words_told(words({judged.recording}))}} : json{{"why", why}};
        },
        [this, judged, id = its_class->id](const json& found) {
            if (const auto why = found.find("why"); why != found.end())
                return refused(409, why->get<std::string>());
            ++words_given_[id];
            audit_.write("attempt.judged", {{"by", judged.by},
                                            {"recording", judged.recording},
                                            {"outcome", judged.outcome},
                                            {"points", judged.points ? json(*judged.points) : json()},
                                            {"note", judged.note}});
            return answer(found);
        },
        reply);
}

namespace {

gateway::Verdict as_page(std::string page) {
    return {
        .kind = gateway::Verdict::Kind::answer, .type = "text/html; charset=utf-8", .body = std::move(page)};
}

/// Who sat in an exercise: "anna", "anna, forecastle; ben, bridge to 4:00"; its name where nobody did.
std::string who_sat(const TrainingClass& of, const std::string& exercise) {
    std::string who;
    for (const Part& each : of.parts(exercise)) {
        who += (who.empty() ? "" : "; ") + each.name;
        if (of.crew > 1) who += std::string(", ") + name_of(each.place);
        if (const std::string part = part_words(each); !part.empty()) who += ' ' + part;
    }
    return who.empty() ? exercise : who;
}

} // namespace

/// Who sat where a class made it; nothing: none did.
std::optional<std::string> DoorHost::who_made(const std::string& recording) const {
    for (const TrainingClass& each : book_.classes())
        for (const auto& [exercise, result] : each.results)
            if (!recording.empty() && result.recording == recording) return who_sat(each, exercise);
    return std::nullopt;
}

/// Of a class that is over: of the exercises that were recorded, and that somebody sat in.
void DoorHost::lay_side_by_side(const std::string& id, const Reply& reply) {
    const auto* its_class = book_.find(id);
    if (its_class == nullptr || !its_class->over) return reply(refused(404, "no class of that name is over"));
    std::vector<ExerciseMade> made;
    for (const std::string& exercise : its_class->exercises) {
        const auto result = its_class->results.find(exercise);
        const std::string recording =
            result == its_class->results.end() ? std::string() : result->second.recording;
        const std::string who = who_sat(*its_class, exercise);
        if (!recording.empty() || who != exercise) made.push_back({.who = who, .recording = recording});
    }
    slow_.add<std::string>(
        [make = options_.side_by_side, title = id + " side by side", made] { return make(title, made); },
        as_page, reply);
}

/// Of a recording that a class has made, and no other.
void DoorHost::debrief(const std::string& recording, bool what_if, const Reply& reply) {
    const auto who = who_made(recording);
    if (!who) return reply(refused(404, "no class has such a recording"));
    if (what_if) return reply(as_page(options_.what_if(recording)));
    slow_.add<std::string>([make = options_.debriefing, recording,
                            who = *who] { return make(recording, who, "what_if?recording=" + recording); },
                           as_page, reply);
}

void DoorHost::act(const std::string& path, const std::string& body, const Who& who, const Reply& reply) {
    try {
        const json asked = json::parse(body, nullptr, false);
        if (!asked.is_object()) throw Denied(400, "a JSON object is expected");
        if (path == "/door/join") return reply(join(who, asked));
        if (path == "/door/names") return reply(names(who, asked));
        if (path == "/door/login") return log_in(who, asked, reply);
        if (path == "/door/setup") return set_up(who, asked, reply);
        if (path == "/door/logout") return reply(log_out(who));
        if (path == "/door/device") return reply(open_kiosk(who, asked));
        if (path == "/door/sit") return reply(sit(who));
        if (path == "/door/launch") return launch(who, asked, reply);
        if (path == "/door/finish") return reply(finish(who));
        if (!who.staff) throw Denied(who.trainee ? 403 : 401, "this is for instructors: log in");
        if (path == "/door/class" && leads(who.staff->rank)) return reply(lead(who, asked));
        if (path == "/door/word" && judges(who.staff->rank) && options_.judge)
            return take_word(who, asked, reply);
        if (path == "/door/people" && who.staff->rank == Rank::owner) return let_in(who, asked, reply);
        if (path == "/door/kiosks" && who.staff->rank == Rank::owner) return reply(keep_kiosks(who, asked));
        if (path == "/door/class" || path == "/door/word" || path == "/door/people" || path == "/door/kiosks")
            throw Denied(403, std::string("not for ") + name_of(who.staff->rank));
        throw Denied(404, "nobody does that here");
    } catch (const Denied& denied) {
        reply(refused(denied.status, denied.what()));
    } catch (const std::exception& error) { // a disk that is full, say
        reply(refused(500, error.what()));
    }
}

Verdict DoorHost::with_cookie(const Who& who, const std::string& secret, json body) const {
    Verdict verdict = answer(body);
    verdict.headers = {
        {"Set-Cookie", cookie(who.way, cookie_name(who.way), secret, secret.empty() ? 0 : kDay)}};
    return verdict;
}

/// The class whose code somebody says; a wrong one counts. name: under which the audit log has that.
const TrainingClass& DoorHost::class_of(const Who& who, const json& asked, const std::string& name) {
    const std::string network = network_of(who.address);
    not_too_often(wrong_codes_, network);
    const auto* found = book_.with_code(plain_code(text_of(asked, "code")), unix_s());
    if (found != nullptr) return *found;
    wrong_codes_.wrong(network, Clock::now());
    audit_.write("join.failed", {{"name", name}, {"address", who.address}});
    throw Denied(403, "no class has this code today");
}

/// Its browser gets another seat.
void DoorHost::leave_seat(const Who& who) {
    if (!who.trainee) return;
    const std::string& id = who.trainee->class_id;
    if (const auto* its_class = book_.find(id); its_class != nullptr && !its_class->launch.empty())
        return end_launch(id);
    send_away(who.key, "this browser has another seat now");
    book_.remove(id, who.trainee->trainee.name);
}

/// Who may join by that code and has no seat yet; null: whoever has the code.
Verdict DoorHost::names(const Who& who, const json& asked) {
    const TrainingClass& its_class = class_of(who, asked, "");
    if (its_class.names.empty()) return answer({{"names", nullptr}});
    json free = json::array();
    for (const std::string& name : its_class.names)
        if (its_class.find(name) == nullptr) free.push_back(name);
    return answer({{"names", std::move(free)}});
}

Verdict DoorHost::join(const Who& who, const json& asked) {
    const std::string name = name_in(asked);
    const std::string id = class_of(who, asked, name).id;
    if (people_.find(name) != nullptr) throw Denied(409, "an instructor has that name: choose another");
    if (who.trainee && who.trainee->class_id == id) return answer(me(who)); // it sits there already
    const std::string secret = make_secret(), key = digest(secret);
    const Trainee seated = book_.join(id, name, key);
    leave_seat(who);
    keep_classes();
    audit_.write("join", {{"name", name},
                          {"class", id},
                          {"exercise", seated.exercise},
                          {"place", name_of(seated.place)},
                          {"address", who.address}});
    Who now = who;
    now.key = key;
    now.trainee = book_.seated(key);
    return with_cookie(who, secret, me(now));
}

/// A browser is that person's from now on; how: as the audit log has it.
Verdict DoorHost::logged_in(const Who& who, const std::string& name, const std::string& how) {
    const std::string secret = make_secret();
    Who now{.way = who.way, .address = who.address, .key = digest(secret), .staff = *people_.find(name)};
    staff_.begin(now.key, name, who.address, Clock::now());
    audit_.write(how, {{"name", name}, {"address", who.address}});
    return with_cookie(who, secret, me(now));
}

void DoorHost::log_in(const Who& who, const json& asked, const Reply& reply) {
    const std::string name = plain_name(text_of(asked, "name")), password = text_of(asked, "password");
    const std::string network = network_of(who.address), at = network + ' ' + name;
    not_too_often(wrong_passwords_, network);
    not_too_often(wrong_passwords_, at);
    if (password.size() > People::kPasswordMost) throw Denied(403, "name or password is wrong");
    // Counted before it is known to be wrong: many at once are tries, too.
    wrong_passwords_.wrong(at, Clock::now());
    wrong_passwords_.wrong(network, Clock::now());
    const Person* person = people_.find(name);
    slow_.add<bool>([hash = person == nullptr ? std::string() : person->hash,
                     password] { return is_password(hash, password); },
                    [this, who, name, at, network](bool right) {
                        if (!right || people_.find(name) == nullptr) {
                            audit_.write("login.failed", {{"name", name}, {"address", who.address}});
                            return refused(403, "name or password is wrong");
                        }
                        wrong_passwords_.right(at);
                        wrong_passwords_.right(network);
                        return logged_in(who, name, "login");
                    },
                    reply);
}

void DoorHost::set_up(const Who& who, const json& asked, const Reply& reply) {
    not_too_often(wrong_passwords_, network_of(who.address));
    if (setup_token_.empty() || !gateway::same_token(text_of(asked, "token"), setup_token_)) {
        wrong_passwords_.wrong(network_of(who.address), Clock::now());
        throw Denied(403, "this link is not good any more: log in, or start the door anew for another");
    }
    const std::string name = name_in(asked), password = password_in(asked);
    slow_.add<std::string>([password] { return password_hash(password); },
                           [this, who, name](const std::string& hash) {
                               if (!people_.empty()) return refused(403, "somebody was faster");
                               people_.put({.name = name, .rank = Rank::owner, .hash = hash});
                               setup_token_.clear();
                               return logged_in(who, name, "setup");
                           },
                           reply);
}

Verdict DoorHost::log_out(const Who& who) {
    if (who.trainee && !book_.find(who.trainee->class_id)->launch.empty())
        return finish(who); // the browser is told what came of it, by its cookie
    send_away(who.key, "logged out");
    if (who.staff) {
        staff_.end(who.key);
        audit_.write("logout", {{"name", who.staff->name}, {"address", who.address}});
    }
    if (who.trainee) {
        book_.remove(who.trainee->class_id, who.trainee->trainee.name);
        keep_classes();
        audit_.write("leave", {{"name", who.trainee->trainee.name}, {"class", who.trainee->class_id}});
    }
    return with_cookie(who, "", {{"who", "nobody"}});
}

/// What instructors do with classes.
Verdict DoorHost::lead(const Who& who, const json& asked) {
    const std::string what = text_of(asked, "do"), id = text_of(asked, "class");
    const auto under_way = [&]() -> const TrainingClass& {
        const auto* found = book_.find(id);
        if (found == nullptr || found->over) throw Denied(404, "there is no such class");
        return *found;
    };
    json done{{"by", who.staff->name}, {"class", id}};
    if (what == "open") {
        const std::string lesson = text_of(asked, "lesson");
        if (!wire::is_exercise_name(lesson)) throw Denied(400, "lesson: the name of an exercise file");
        std::string code = make_code();
        while (book_.with_code(code, unix_s()) != nullptr)
            code = make_code();
        const bool is_class = book_.find(id) != nullptr; // the book says which name is free
        for (int i = 1; i <= ClassBook::kExercises && !is_class; ++i)
            if (runs_.told(fmt::format("{}-{}", id, i)))
                throw Denied(409, "there are exercises of that name still: choose another, or wait");
        const json practice_asked = asked.value("practice", json(false));
        if (!practice_asked.is_boolean()) throw Denied(400, "practice: true or false");
        const bool practice = practice_asked;
        const auto from = moment_in(asked);
        if (from && !who_made(from->recording)) throw Denied(404, "from: no class has such a recording");
        auto names = names_in(asked);
        for (const std::string& name : names)
            if (people_.find(name) != nullptr) throw Denied(409, "names: an instructor is called " + name);
        book_.open(id,
                   {.lesson = lesson,
                    .exercises = number_of(asked, "exercises"),
                    .crew = number_of(asked, "crew"),
                    .names = std::move(names),
                    .practice = practice,
                    .from = from,
                    .bridge_judged = options_.bridge_is_judged && options_.bridge_is_judged(lesson),
                    .places = places_in(asked)},
                   code, unix_s());
        done["lesson"] = lesson;
        if (practice) done["practice"] = true;
        if (from) done["from"] = from->recording;
    } else if (what == "start" || what == "pause") {
        const TrainingClass& its_class = under_way();
        const bool start = what == "start";
        // Of an exercise in which nobody sits yet the time would run out on who comes late.
        auto exercises = start ? its_class.manned() : its_class.exercises;
        if (exercises.empty())
            throw Denied(409, "nobody sits in this class yet: an exercise is started once somebody does");
        // A start would pass over what a seat is being asked; it goes on by itself once that is answered.
        if (start) std::erase_if(exercises, [&](const auto& one) { return runs_.holds_for_a_question(one); });
        if (exercises.empty())
            throw Denied(409, "it holds for a question, and goes on once that is answered");
        if (start && !runs_.at_their_moment(its_class))
            throw Denied(409, "not all exercises stand at their moment yet: wait");
        runs_.give(exercises, wire::topics::exercise_command,
                   {{"action", start ? "EXERCISE_START" : "EXERCISE_PAUSE"}}, who.staff->name);
    } else if (what == "give") {
        const TrainingClass& its_class = under_way();
        const std::string topic = text_of(asked, "topic");
        const auto sample = asked.find("sample");
        const wire::TopicInfo* found =
            topic == wire::topics::fault_command.name          ? &wire::topics::fault_command
            : topic == wire::topics::bridge_order_command.name ? &wire::topics::bridge_order_command
                                                               : static_cast<const wire::TopicInfo*>(nullptr);
        if (found == nullptr) throw Denied(400, "topic: FaultCommand or BridgeOrderCommand");
        if (sample == asked.end() || !sample->is_object()) throw Denied(400, "sample: an object is expected");
        runs_.give(its_class.exercises, *found, *sample, who.staff->name);
        done.update({{"topic", topic}, {"sample", *sample}});
    } else if (what == "end") {
        const TrainingClass its_class = under_way(); // its keys are nobody's afterwards
        book_.end(id);
        runs_.remove(its_class.exercises, who.staff->name);
        part_with(its_class);
    } else if (what == "move") {
        const auto place = place_named(text_of(asked, "place"));
        if (!place) throw Denied(400, "place: ship, forecastle, bridge or watch");
        const std::string exercise = text_of(asked, "exercise");
        done.update({{"name", text_of(asked, "name")}, {"exercise", exercise}, {"place", name_of(*place)}});
        for (const std::string& name : book_.move(id, text_of(asked, "name"), exercise, *place))
            send_away(book_.find(id)->find(name)->key, "this seat was moved");
    } else if (what == "remove") {
        done["name"] = text_of(asked, "name");
        send_away(book_.remove(id, text_of(asked, "name")), "this seat was freed by the instructor");
    } else {
        throw Denied(400, "do: open, start, pause, give, end, move or remove");
    }
    keep_classes();
    audit_.write("class." + what, std::move(done));
    return answer(classes());
}

void DoorHost::let_in(const Who& who, const json& asked, const Reply& reply) {
    const std::string what = text_of(asked, "do"), name = name_in(asked);
    if (what == "remove") {
        people_.remove(name);
        log_out_all(name);
        audit_.write("people.remove", {{"by", who.staff->name}, {"name", name}});
        return reply(answer(people()));
    }
    const auto rank = rank_named(text_of(asked, "rank"));
    if (what != "put") throw Denied(400, "do: put or remove");
    if (!rank) throw Denied(400, "rank: owner, instructor, assessor or observer");
    const std::string password = password_in(asked);
    slow_.add<std::string>(
        [password] { return password_hash(password); },
        [this, by = who.staff->name, name, rank = *rank](const std::string& hash) {
            people_.put({.name = name, .rank = rank, .hash = hash});
            log_out_all(name); // who was logged in with another password or rank logs in anew
            audit_.write("people.put", {{"by", by}, {"name", name}, {"rank", name_of(rank)}});
            return answer(people());
        },
        reply);
}

void DoorHost::log_out_all(const std::string& name) {
    for (const std::string& key : staff_.end_of(name))
        send_away(key, "log in again");
}

json DoorHost::me(const Who& who) const {
    const Certificate& certificate = options_.certificate;
    json told{{"who", "nobody"},
              {"setup", !setup_token_.empty()},
              {"own_authority", !certificate.authority.empty()},
              {"fingerprint", certificate.fingerprint},
              {"authority_fingerprint", certificate.authority_fingerprint}};
    if (who.kiosk) // and whoever sits at it, below
        told.update({{"who", "kiosk"},
                     {"name", who.kiosk->name},
                     {"number", who.kiosk->exercise},
                     {"place", name_of(who.kiosk->place)}});
    if (who.staff)
        told.update({{"who", "staff"}, {"name", who.staff->name}, {"rank", name_of(who.staff->rank)}});
    if (who.trainee) {
        const Trainee& trainee = who.trainee->trainee;
        told.update({{"who", "trainee"},
                     {"name", trainee.name},
                     {"class", who.trainee->class_id},
                     {"exercise", trainee.exercise},
                     {"place", name_of(trainee.place)}});
    }
    if (json launch = launch_told(who.key); !launch.is_null()) told["launch"] = std::move(launch);
    return told;
}

json DoorHost::classes() {
    json list = json::array();
    for (const TrainingClass& each : book_.classes())
        list.push_back(class_told(each));
    return {{"classes", std::move(list)},
            {"servers", runs_.servers()},
            {"names", options_.names},
            {"port", port_}};
}

json DoorHost::class_told(const TrainingClass& told) {
    json exercises = json::array();
    for (const std::string& exercise : told.exercises) {
        json seats = json::array();
        for (const Place place : places_of(told.crew)) {
            json seat{{"place", name_of(place)},
                      {"name", nullptr},
                      {"here", false},
                      {"silent", nullptr},
                      {"acted", false}};
            for (const Trainee& one : told.trainees)
                if (one.exercise == exercise && one.place == place) {
                    seat["name"] = one.name;
                    seat["here"] = !links(one.key).empty();
                    if (const auto silent = silence_of(one.key)) // while it stands nobody has anything to do
                        seat["silent"] = std::floor(std::min(*silent, runs_.ran_for(exercise, Clock::now())));
                    seat["acted"] = std::ranges::any_of(links(one.key), [](const Link& each) {
                        const auto page = each.session.lock();
                        return page && page->has_acted();
                    });
                }
            seats.push_back(std::move(seat));
        }
        json parts = json::array();
        for (const Part& part : told.parts(exercise))
            parts.push_back({{"name", part.name},
                             {"place", name_of(part.place)},
                             {"since", part.since ? json(*part.since) : json()},
                             {"until", part.until ? json(*part.until) : json()},
                             {"judged", part.judged}});
        const auto known = told.results.find(exercise);
        const Result result = known == told.results.end() ? Result() : known->second;
        json each{{"exercise", exercise},
                  {"seats", std::move(seats)},
                  {"parts", std::move(parts)},
                  {"state", nullptr},
                  {"time", 0},
                  {"recording", result.recording},
                  {"abort", result.abort},
                  {"points", result.points ? json(*result.points) : json()},
                  {"lost", result.lost ? json(*result.lost) : json()},
                  {"pass", result.pass ? json(*result.pass) : json()},
                  {"outcome", result.outcome},
                  {"trouble", runs_.trouble(exercise)}};
        const auto asking = runs_.asking(exercise);
        each["asking"] =
            asking
                ? json{{"since", asking->since}, {"gives_up", asking->gives_up}, {"misled", asking->misled}}
                : json();
        each["asked"] = runs_.holds_for_a_question(exercise);
        const auto heard = runs_.told(exercise);
        each["heard"] = heard.has_value();
        if (const auto last = heard ? heard : runs_.lost(exercise)) {
            each["state"] = static_cast<int>(last->state());
            each["time"] = last->time();
        }
        exercises.push_back(std::move(each));
    }
    const auto words = words_given_.find(told.id);
    return {{"id", told.id},
            {"lesson", told.lesson},
            {"practice", told.practice},
            {"code", told.over || unix_s() >= told.until ? "" : told.code},
            {"crew", told.crew},
            {"bridge_judged", told.bridge_judged},
            {"until", told.until},
            {"over", told.over},
            {"words", words == words_given_.end() ? 0 : words->second},
            {"exercises", std::move(exercises)}};
}

std::optional<double> DoorHost::silence_of(const std::string& key) {
    std::optional<double> least;
    for (const Link& each : links(key))
        if (const auto page = each.session.lock()) {
            const double silent = std::chrono::duration<double>(Clock::now() - page->acted()).count();
            if (!least || silent < *least) least = silent;
        }
    return least;
}

json DoorHost::people() const {
    json list = json::array();
    for (const auto& [name, person] : people_.all())
        list.push_back({{"name", name}, {"rank", name_of(person.rank)}});
    return {{"people", std::move(list)}};
}

} // namespace windlass::door
