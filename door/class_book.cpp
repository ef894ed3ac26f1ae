#include "door/class_book.hpp"

#include "common/figure_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <regex>

namespace windlass::door {

using nlohmann::json;

namespace {

constexpr double kLookApart = 1; // s: an exercise is looked at twice a second

} // namespace

std::optional<Place> place_named(const std::string& name) {
    const auto found = std::ranges::find(kPlaceNames, name);
    if (found == kPlaceNames.end()) return std::nullopt;
    return static_cast<Place>(found - kPlaceNames.begin());
}

std::vector<Place> places_of(int crew) {
    if (crew == 1) return {Place::ship};
    if (crew == 2) return {Place::forecastle, Place::bridge};
    return {Place::forecastle, Place::bridge, Place::watch};
}

const Trainee* TrainingClass::find(const std::string& name) const {
    const auto found = std::ranges::find(trainees, name, &Trainee::name);
    return found == trainees.end() ? nullptr : &*found;
}

std::vector<std::string> TrainingClass::manned() const {
    std::vector<std::string> found;
    std::ranges::copy_if(exercises, std::back_inserter(found), [&](const std::string& exercise) {
        return std::ranges::find(trainees, exercise, &Trainee::exercise) != trainees.end();
    });
    return found;
}

std::vector<Part> TrainingClass::parts(const std::string& exercise) const {
    const auto found = results.find(exercise);
    const Result its = found == results.end() ? Result() : found->second;
    const double began = its.began.value_or(its.time) + kLookApart,
                 marked = its.marked.value_or(std::numeric_limits<double>::infinity());
    std::vector<Relieved> all;
    std::ranges::copy_if(relieved, std::back_inserter(all),
                         [&](const Relieved& each) { return each.exercise == exercise; });
    for (const Trainee& each : trainees)
        if (each.exercise == exercise) {
            const double end = std::numeric_limits<double>::infinity();
            all.push_back({each.name, exercise, each.place, each.since, end});
        }
    std::erase_if(all, [&](const Relieved& each) {
        return each.until <= began || (each.since > began && each.since >= marked);
    });
    std::ranges::stable_sort(all, {}, [](const Relieved& each) { return std::pair(each.place, each.since); });
    std::vector<Relieved> merged;
    for (Relieved& each : all)
        if (!merged.empty() && merged.back().name == each.name && merged.back().place == each.place)
            merged.back().until = each.until;
        else
            merged.push_back(std::move(each));
    std::vector<Part> found_parts;
    for (const Relieved& each : merged)
        found_parts.push_back(
            {.name = each.name,
             .place = each.place,
             .since = each.since <= began ? std::nullopt : std::optional(each.since),
             .until = each.until >= marked ? std::nullopt : std::optional(each.until),
             .judged = each.place != Place::watch && !(bridge_judged && each.place == Place::forecastle)});
    return found_parts;
}

std::string part_words(const Part& of) {
    const auto clock = [](double time) {
        const auto s = static_cast<long>(time);
        return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60)
                        : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
    };
    std::string words = of.since ? "from " + clock(*of.since) : "";
    if (of.until) words += (words.empty() ? "to " : " to ") + clock(*of.until);
    return words;
}

namespace {

std::optional<double> number_or_none(const json& kept) {
    return kept.is_null() ? std::nullopt : std::optional(kept.get<double>());
}

json or_null(std::optional<double> number) {
    return number ? json(*number) : json();
}

} // namespace

ClassBook::ClassBook(const json& kept) {
    if (kept.is_null()) return;
    for (const json& each : kept.at("classes")) {
        TrainingClass made{.id = each.at("id"),
                           .lesson = each.at("lesson"),
                           .code = each.at("code"),
                           .until = each.at("until"),
                           .practice = each.value("practice", false),
                           .crew = each.at("crew"),
                           .exercises = each.at("exercises"),
                           .names = each.value("names", std::vector<std::string>()),
                           .trainees = {},
                           .relieved = {},
                           .results = {},
                           .over = each.at("over"),
                           .launch = each.value("launch", std::string())};
        made.bridge_judged = each.value("bridge_judged", false);
        const json places = each.value("places", json::object());
        for (const auto& [name, place] : places.items())
            made.places[name] = place_named(place).value();
        if (const auto from = each.find("from"); from != each.end())
            made.from = Moment{.recording = from->at("recording"), .position = from->at("position")};
        for (const auto& [exercise, result] : each.at("results").items())
            made.results[exercise] = {.recording = result.at("recording"),
                                      .points = number_or_none(result.at("points")),
                                      .outcome = result.at("outcome"),
                                      .lost = number_or_none(result.value("lost", json())),
                                      .pass = number_or_none(result.value("pass", json())),
                                      .abort = result.value("abort", std::string()),
                                      .in_history = result.value("in_history", false),
                                      .time = result.value("time", 0.0),
                                      .began = number_or_none(result.value("began", json())),
                                      .marked = number_or_none(result.value("marked", json()))};
        for (const json& one : each.at("trainees"))
            made.trainees.push_back({.name = one.at("name"),
                                     .key = one.at("key"),
                                     .exercise = one.at("exercise"),
                                     .place = place_named(one.at("place")).value(),
                                     .since = one.value("since", 0.0)});
        for (const json& one : each.value("relieved", json::array()))
            made.relieved.push_back({.name = one.at("name"),
                                     .exercise = one.at("exercise"),
                                     .place = place_named(one.at("place")).value(),
                                     .since = one.at("since"),
                                     .until = one.at("until")});
        classes_.push_back(std::move(made));
    }
}

json ClassBook::to_json() const {
    json list = json::array();
    for (const TrainingClass& each : classes_) {
        json trainees = json::array();
        for (const Trainee& one : each.trainees)
            trainees.push_back({{"name", one.name},
                                {"key", one.key},
                                {"exercise", one.exercise},
                                {"place", name_of(one.place)},
                                {"since", one.since}});
        json relieved = json::array();
        for (const Relieved& one : each.relieved)
            relieved.push_back({{"name", one.name},
                                {"exercise", one.exercise},
                                {"place", name_of(one.place)},
                                {"since", one.since},
                                {"until", one.until}});
        json places = json::object();
        for (const auto& [name, place] : each.places)
            places[name] = name_of(place);
        json results = json::object();
        for (const auto& [exercise, result] : each.results)
            results[exercise] = {{"recording", result.recording},   {"points", or_null(result.points)},
                                 {"lost", or_null(result.lost)},    {"pass", or_null(result.pass)},
                                 {"outcome", result.outcome},       {"abort", result.abort},
                                 {"in_history", result.in_history}, {"time", result.time},
                                 {"began", or_null(result.began)},  {"marked", or_null(result.marked)}};
        list.push_back({{"id", each.id},
                        {"lesson", each.lesson},
                        {"practice", each.practice},
                        {"code", each.code},
                        {"until", each.until},
                        {"crew", each.crew},
                        {"exercises", each.exercises},
                        {"names", each.names},
                        {"over", each.over},
                        {"launch", each.launch},
                        {"results", std::move(results)},
                        {"relieved", std::move(relieved)},
                        {"bridge_judged", each.bridge_judged},
                        {"places", std::move(places)},
                        {"trainees", std::move(trainees)}});
        if (each.from)
            list.back()["from"] = {{"recording", each.from->recording}, {"position", each.from->position}};
    }
    return {{"classes", std::move(list)}};
}

const TrainingClass* ClassBook::find(const std::string& id) const {
    const auto found = std::ranges::find(classes_, id, &TrainingClass::id);
    return found == classes_.end() ? nullptr : &*found;
}

TrainingClass& ClassBook::mine(const std::string& id) {
    const auto found = std::ranges::find(classes_, id, &TrainingClass::id);
    if (found == classes_.end() || found->over) throw Denied(404, "there is no such class");
    return *found;
}

std::string ClassBook::free_name(const std::string& wanted) const {
    std::string name = wanted, behind = "-a";
    while (find(name) != nullptr) {
        if (behind.back() == 'z')
            behind += 'a';
        else
            ++behind.back();
        name = wanted.substr(0, kLongestName - behind.size()) + behind;
    }
    return name;
}

const TrainingClass& ClassBook::open(const std::string& id, Wanted wanted, const std::string& code,
                                     std::int64_t now) {
    const auto& [lesson, exercises, crew, names, practice, from, bridge_judged, places] = wanted;
    static const std::regex kName("[A-Za-z0-9][A-Za-z0-9-]{0,23}");
    if (!std::regex_match(id, kName))
        throw Denied(400, "name: 1 to 24 letters, digits and dashes are allowed");
    if (id.starts_with("replay")) throw Denied(400, "name: none that begins with replay");
    if (exercises < 1 || exercises > kExercises)
        throw Denied(400, fmt::format("exercises: 1 to {} are allowed", kExercises));
    if (crew < 1 || crew > kCrew) throw Denied(400, fmt::format("crew: 1 to {} are allowed", kCrew));
    if (bridge_judged && crew == 1)
        throw Denied(400, "crew: in this lesson the bridge orders and the forecastle obeys: 2 or 3");
    const std::size_t seats = static_cast<std::size_t>(exercises) * places_of(crew).size();
    if (names.size() > seats)
        throw Denied(400, fmt::format("names: {} are more than the {} seats", names.size(), seats));
    for (const std::string& name : names)
        if (std::ranges::count(names, name) > 1)
            throw Denied(400, fmt::format("names: {} stands there twice", name));
    if (const auto* there = find(id))
        throw Denied(409, fmt::format("{} is a class {}: {} is free", id,
                                      there->over ? "that is over, whose results are kept" : "already",
                                      free_name(id)));
    if (count(false, false) >= kClasses)
        throw Denied(409, fmt::format("{} classes at a time: end one", kClasses));
    TrainingClass made{.id = id,
                       .lesson = std::move(wanted.lesson),
                       .code = code,
                       .until = now + kGood,
                       .practice = practice || from,
                       .crew = crew,
                       .exercises = {},
                       .names = std::move(wanted.names),
                       .trainees = {},
                       .relieved = {},
                       .results = {}};
    made.from = std::move(wanted.from);
    made.bridge_judged = bridge_judged;
    made.places = std::move(wanted.places);
    for (int i = 1; i <= exercises; ++i)
        made.exercises.push_back(fmt::format("{}-{}", id, i));
    return classes_.emplace_back(std::move(made));
}

void ClassBook::end(const std::string& id) {
    TrainingClass& ended = mine(id);
    ended.over = true;
    for (Trainee& each : ended.trainees)
        each.key.clear();
    const bool launched = !ended.launch.empty();
    if (count(launched, true) > (launched ? kLaunched : kClasses))
        classes_.erase(std::ranges::find_if(classes_, [&](const TrainingClass& each) {
            return each.over && each.launch.empty() != launched;
        }));
}

std::size_t ClassBook::count(bool launched, bool over) const {
    return static_cast<std::size_t>(std::ranges::count_if(classes_, [&](const TrainingClass& each) {
        return each.over == over && each.launch.empty() != launched;
    }));
}

bool ClassBook::can_launch() const {
    return count(true, false) < kLaunched;
}

Trainee ClassBook::launch(const std::string& id, const std::string& session, const std::string& lesson,
                          bool practice, const std::string& name, const std::string& key, std::int64_t now) {
    if (!can_launch())
        throw Denied(503, fmt::format("{} lessons that learning systems have started are under way: try "
                                      "again later",
                                      kLaunched));
    if (find(id) != nullptr) throw Denied(409, "there is a class of that name");
    const std::string exercise = id + "-1";
    const Trainee seated{.name = name, .key = key, .exercise = exercise, .place = Place::ship};
    classes_.push_back({.id = id,
                        .lesson = lesson,
                        .code = "",
                        .until = now + kGood,
                        .practice = practice,
                        .exercises = {exercise},
                        .names = {name},
                        .trainees = {seated},
                        .relieved = {},
                        .results = {},
                        .launch = session});
    return seated;
}

const TrainingClass* ClassBook::launched(const std::string& session) const {
    const auto found = std::ranges::find(classes_, session, &TrainingClass::launch);
    return session.empty() || found == classes_.end() ? nullptr : &*found;
}

void ClassBook::forget(const std::string& id) {
    std::erase_if(classes_, [&](const TrainingClass& each) {
        return each.id == id && each.over && !each.launch.empty();
    });
}

namespace {

/// s of exercise, as it was heard last.
double time_in(const TrainingClass& of, const std::string& exercise) {
    const auto found = of.results.find(exercise);
    return found == of.results.end() ? 0 : found->second.time;
}

/// He leaves his seat, of an exercise that has begun.
void relieve(TrainingClass& of, const Trainee& who) {
    const auto found = of.results.find(who.exercise);
    if (found == of.results.end() || !found->second.began) return;
    const double now = found->second.time;
    if (who.since < now) of.relieved.push_back({who.name, who.exercise, who.place, who.since, now});
}

/// An exercise stands at that time again.
void go_back(TrainingClass& its_class, const std::string& exercise, double time) {
    std::erase_if(its_class.relieved, [&](Relieved& each) {
        if (each.exercise != exercise) return false;
        each.until = std::min(each.until, time);
        return each.since >= each.until;
    });
    for (Trainee& each : its_class.trainees)
        if (each.exercise == exercise) each.since = std::min(each.since, time);
}

} // namespace

bool ClassBook::note(const std::string& id, const std::string& exercise, const Result& result) {
    const auto its_class = std::ranges::find(classes_, id, &TrainingClass::id);
    if (its_class == classes_.end()) return false;
    Result& known = its_class->results[exercise];
    const Result before = known;
    known = result;
    if (known.recording.empty()) known.recording = before.recording; // of a door before this one
    known.in_history = before.in_history && known.recording == before.recording;
    if (result.time < before.time) go_back(*its_class, exercise, result.time);
    known.began = before.began     ? std::min(*before.began, result.time)
                  : result.running ? std::optional(result.time)
                                   : std::nullopt;
    if (!result.outcome.empty()) known.marked = std::min(before.marked.value_or(result.time), result.time);
    return known.recording != before.recording || known.outcome != before.outcome ||
           known.began != before.began;
}

void ClassBook::note_in_history(const std::string& recording) {
    for (TrainingClass& each : classes_)
        for (auto& [exercise, result] : each.results)
            if (result.recording == recording) result.in_history = true;
}

std::string marks_csv(const TrainingClass& of, const std::vector<AttemptJudged>& words) {
    const auto field = [](const std::string& text) {
        // What a table program would take for a formula is a text.
        std::string quoted = text.find_first_of("=+-@\t") == 0 ? "\"'" : "\"";
        for (const char c : text)
            quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
        return quoted + '"';
    };
    std::string csv = "class,lesson,exercise,seat,trainee,points,outcome,recording,part,confirmed_by,"
                      "confirmed_points,confirmed_outcome,note\r\n";
    for (const std::string& exercise : of.exercises)
        for (const Part& each : of.parts(exercise)) {
            const auto found = of.results.find(exercise);
            const Result result = found == of.results.end() ? Result() : found->second;
            const bool marked = each.judged && result.points;
            csv += fmt::format(
                "{},{},{},{},{},{},{},{},{}", field(of.id), field(of.lesson), field(exercise),
                name_of(each.place), field(each.name), marked ? points_text(*result.points) : "",
                each.judged ? result.outcome : "not judged", field(result.recording), part_words(each));
            const auto word = std::ranges::find(words, result.recording, &AttemptJudged::recording);
            if (each.judged && word != words.end())
                csv += fmt::format(",{},{},{},{}\r\n", field(word->by),
                                   word->points ? points_text(*word->points) : "", word->outcome,
                                   field(word->note));
            else
                csv += ",,,,\r\n";
        }
    return csv;
}

const TrainingClass* ClassBook::with_code(const std::string& code, std::int64_t now) const {
    const auto found = std::ranges::find_if(classes_, [&](const TrainingClass& each) {
        return !each.over && each.launch.empty() && each.code == code && now < each.until;
    });
    return found == classes_.end() ? nullptr : &*found;
}

Trainee ClassBook::join(const std::string& id, const std::string& name, const std::string& key) {
    TrainingClass& joined = mine(id);
    if (!joined.names.empty() && std::ranges::find(joined.names, name) == joined.names.end())
        throw Denied(403, name + " is not on the list of this class: ask the instructor");
    if (joined.find(name) != nullptr)
        throw Denied(409,
                     name + " has a seat in another browser; if that was you, ask the instructor to free it");
    const auto his = joined.places.find(name);
    const auto is_free = [&](const std::string& exercise, Place place) {
        return std::ranges::none_of(joined.trainees, [&](const Trainee& each) {
            return each.exercise == exercise && each.place == place;
        });
    };
    const bool has_his =
        his != joined.places.end() && std::ranges::any_of(joined.exercises, [&](const std::string& exercise) {
            return is_free(exercise, his->second);
        });
    for (const std::string& exercise : joined.exercises)
        for (const Place place : places_of(joined.crew))
            if (is_free(exercise, place) && (!has_his || place == his->second))
                return joined.trainees.emplace_back(Trainee{.name = name,
                                                            .key = key,
                                                            .exercise = exercise,
                                                            .place = place,
                                                            .since = time_in(joined, exercise)});
    throw Denied(409, "every seat of this class is taken");
}

namespace {

/// Where a device may sit in a class.
struct DeviceSeat {
    std::string exercise;
    Place place = Place::ship;
};

/// That of its number. One whose name is on the list takes another that is free where it has to: a class that
/// goes on from a moment has exercise 1 alone, whichever it was. Nothing: the class has none for it.
std::optional<DeviceSeat> device_seat(const TrainingClass& of, const std::string& name, int exercise,
                                      Place place) {
    if (const auto his = of.places.find(name); his != of.places.end()) place = his->second;
    const auto places = places_of(of.crew);
    if (std::ranges::find(places, place) == places.end()) return std::nullopt;
    std::vector<std::string> fit; // the best first
    if (exercise >= 1 && static_cast<std::size_t>(exercise) <= of.exercises.size())
        fit.push_back(of.exercises[static_cast<std::size_t>(exercise - 1)]);
    if (std::ranges::find(of.names, name) != of.names.end())
        fit.insert(fit.end(), of.exercises.begin(), of.exercises.end());
    if (fit.empty()) return std::nullopt;
    const auto found = std::ranges::find_if(fit, [&](const std::string& there) {
        return std::ranges::none_of(
            of.trainees, [&](const Trainee& each) { return each.exercise == there && each.place == place; });
    });
    return DeviceSeat{.exercise = found == fit.end() ? fit.front() : *found, .place = place};
}

} // namespace

const TrainingClass* ClassBook::with_seat(const std::string& name, int exercise, Place place) const {
    const auto has = [&](const TrainingClass& each) {
        return !each.over && each.launch.empty() && device_seat(each, name, exercise, place);
    };
    const auto found = std::find_if(classes_.rbegin(), classes_.rend(), has);
    return found == classes_.rend() ? nullptr : &*found;
}

Trainee ClassBook::sit(const std::string& id, const std::string& name, const std::string& key, int exercise,
                       Place place) {
    TrainingClass& its_class = mine(id);
    if (!its_class.names.empty() && std::ranges::find(its_class.names, name) == its_class.names.end())
        throw Denied(403, "this class has a list of names: take a seat by its code");
    const auto seat = device_seat(its_class, name, exercise, place);
    if (!seat) throw Denied(404, "this class has no such seat");
    const auto& [there, at] = *seat;
    for (const Trainee& each : its_class.trainees) {
        if (each.name == name) throw Denied(409, name + " has a seat in this class already");
        if (each.exercise == there && each.place == at) throw Denied(409, each.name + " sits here");
    }
    return its_class.trainees.emplace_back(Trainee{
        .name = name, .key = key, .exercise = there, .place = at, .since = time_in(its_class, there)});
}

std::optional<ClassBook::Seated> ClassBook::seated(const std::string& key) const {
    for (const TrainingClass& each : classes_)
        for (const Trainee& one : each.trainees)
            if (!each.over && one.key == key) return Seated{each.id, one};
    return std::nullopt;
}

std::vector<std::string> ClassBook::move(const std::string& id, const std::string& name,
                                         const std::string& exercise, Place place) {
    TrainingClass& its_class = mine(id);
    const auto mover = std::ranges::find(its_class.trainees, name, &Trainee::name);
    if (mover == its_class.trainees.end()) throw Denied(404, "nobody of that name is in this class");
    const auto places = places_of(its_class.crew);
    if (std::ranges::find(its_class.exercises, exercise) == its_class.exercises.end() ||
        std::ranges::find(places, place) == places.end())
        throw Denied(400, "this class has no such seat");
    if (mover->exercise == exercise && mover->place == place) return {};
    const auto take = [&](Trainee& who, const std::string& there, Place at) {
        relieve(its_class, who);
        who.exercise = there;
        who.place = at;
        who.since = time_in(its_class, there);
    };
    const Trainee before = *mover;
    std::vector<std::string> moved{name};
    for (Trainee& other : its_class.trainees)
        if (&other != &*mover && other.exercise == exercise && other.place == place) {
            take(other, before.exercise, before.place);
            moved.push_back(other.name);
        }
    take(*mover, exercise, place);
    return moved;
}

std::string ClassBook::remove(const std::string& id, const std::string& name) {
    TrainingClass& its_class = mine(id);
    const auto found = std::ranges::find(its_class.trainees, name, &Trainee::name);
    if (found == its_class.trainees.end()) throw Denied(404, "nobody of that name is in this class");
    relieve(its_class, *found);
    std::string key = found->key;
    its_class.trainees.erase(found);
    return key;
}

} // namespace windlass::door
