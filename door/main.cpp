// The door: every page of every exercise of this machine's servers, by TLS, for whoever is let in.

#include "door/class_history.hpp"
#include "door/cmi5/course.hpp"
#include "door/kiosks.hpp"
#include "door/private_file.hpp"
#include "door/secrets.hpp"
#include "door/tls_server.hpp"
#include "instructor_console/debrief_page.hpp"
#include "instructor_console/lesson_files.hpp"
#include "instructor_console/pages.hpp"
#include "recorder/debrief/judgement.hpp"
#include "recorder/debrief/read_attempt.hpp"
#include "station/gateway/roles.hpp"
#include "station/options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <thread>

using namespace windlass;
namespace fs = std::filesystem;

namespace {

/// Topics of orders that an instructor gives and no trainee's seat: of these each is written down.
std::set<std::string> staffs_orders() {
    std::set<std::string> topics;
    const gateway::Role instructor = gateway::role_of(station::Seat::instructor, "any");
    for (const auto& written : {instructor.writes, instructor.classroom_writes})
        for (const wire::TopicInfo* topic : written)
            topics.insert(topic->name);
    for (const auto seat : {station::Seat::forecastle, station::Seat::conning, station::Seat::trainee})
        for (const wire::TopicInfo* topic : gateway::role_of(seat, "any").writes)
            topics.erase(topic->name);
    return topics;
}

struct Options {
    station::SessionOptions session{.name = "door"};
    door::PortOptions ports;
    fs::path state;
    fs::path certificate, key;
    std::vector<std::string> names;
    fs::path recordings = "recordings", exercises = "config/exercises", history;
    std::string log_level = "info";
    std::vector<std::string> learning_systems;
    fs::path learning_authority;

    // Of the command kiosk.
    CLI::App *kiosk = nullptr, *kiosk_add = nullptr, *kiosk_remove = nullptr;
    door::Kiosk seat;
    std::string place;

    CLI::App* course = nullptr;
    std::string url; // of the course
};

/// $XDG_DATA_HOME/windlass/door, or ~/.local/share/windlass/door.
fs::path state_folder() {
    const char* data = std::getenv("XDG_DATA_HOME");
    const char* home = std::getenv("HOME");
    if (data != nullptr && *data != '\0') return fs::path(data) / "windlass/door";
    return fs::path(home == nullptr ? "." : home) / ".local/share/windlass/door";
}

void add_options(CLI::App& app, Options& options) {
    options.session.add_to(app);
    app.add_option("--address", options.ports.address, "to listen at; 127.0.0.1: for this computer alone")
        ->check(CLI::ValidIPV4)
        ->capture_default_str();
    app.add_option("--port", options.ports.port, "of HTTPS; 0: any that is free")
        ->check(CLI::Range(0, 65535))
        ->capture_default_str();
    app.add_option("--redirect-port", options.ports.redirect,
                   "of HTTP that leads to HTTPS and does nothing else")
        ->check(CLI::Range(0, 65535));
    app.add_option("--loopback-port", options.ports.loopback,
                   "of plain HTTP at 127.0.0.1, for browsers of this computer")
        ->check(CLI::Range(0, 65535));
    app.add_option("--sessions", options.ports.sessions, "pages that are open at a time, at most")
        ->check(CLI::Range(1, 10000))
        ->capture_default_str();
    auto* certificate =
        app.add_option(
               "--certificate", options.certificate,
               "the house's certificate and those between it and its authority, in PEM; without it the "
               "door has an authority of its own")
            ->type_name("FILE")
            ->check(CLI::ExistingFile);
    auto* key = app.add_option("--key", options.key, "its private key, in PEM, without a passphrase")
                    ->type_name("FILE")
                    ->check(CLI::ExistingFile);
    certificate->needs(key);
    key->needs(certificate);
    app.add_option("--host-name", options.names,
                   "one more name or address under which people reach this machine")
        ->type_name("NAME");
    app.add_option("--state", options.state, "folder of what the door keeps, mode 0700")
        ->type_name("DIR")
        ->default_str(state_folder().string());
    app.add_option("--recordings", options.recordings, "folder of recordings")
        ->type_name("DIR")
        ->capture_default_str();
    app.add_option(
           "--history", options.history,
           "file in which the attempts of classes are kept; by default history.sqlite in the folder of "
           "recordings")
        ->type_name("FILE");
    app.add_option("--exercises", options.exercises, "folder of exercise files")
        ->type_name("DIR")
        ->check(CLI::ExistingDirectory)
        ->capture_default_str();
    app.add_option("--learning-system", options.learning_systems,
                   "origin of a learning system that may start lessons here (cmi5) and is told what came of "
                   "them: https://HOST[:PORT]; its record store's, too, where that is another; without one "
                   "nothing goes out")
        ->type_name("ORIGIN");
    app.add_option("--learning-authority", options.learning_authority,
                   "certificates in PEM by which such a system is trusted, beside those of this machine")
        ->type_name("FILE")
        ->check(CLI::ExistingFile);
    app.add_option("--log-level", options.log_level, "how much is told on stderr")
        ->check(CLI::IsMember({"trace", "debug", "info", "warn", "error", "off"}))
        ->capture_default_str();
    options.kiosk = app.add_subcommand("kiosk", "devices that stand at one seat; the running door heeds it");
    options.kiosk->require_subcommand(1)->fallthrough();
    options.kiosk_add = options.kiosk->add_subcommand(
        "add", "prints an address that is opened once on the device; one of that name is none any more");
    options.kiosk_add->fallthrough()->add_option("name", options.seat.name, "of the device")->required();
    options.kiosk_add->add_option("--seat", options.seat.exercise, "which exercise of a class, from 1")
        ->check(CLI::Range(1, door::ClassBook::kExercises))
        ->required();
    options.kiosk_add->add_option("--place", options.place, "there")
        ->check(CLI::IsMember(std::vector<std::string>(door::kPlaceNames.begin(), door::kPlaceNames.end())))
        ->required();
    options.kiosk_remove = options.kiosk->add_subcommand("remove", "its device is sent away");
    options.kiosk_remove->fallthrough()->add_option("name", options.seat.name, "of the device")->required();
    options.kiosk->add_subcommand("list", "each with its seat, and whether a device has opened its address")
        ->fallthrough();
    options.course = app.add_subcommand(
        "course", "prints the course for a learning system (cmi5.xml): a unit to each lesson of --exercises");
    options.course->fallthrough()
        ->add_option("--url", options.url,
                     "of the door, as learners reach it: https://HOST or https://HOST:PORT")
        ->required();
    app.footer(
        "Prints its addresses and the fingerprint of its certificate; at the first start a link with which\n"
        "the first owner is set up. docs/class.md has the rest.\n"
        "Exit codes: 0 stopped by a signal, 1 it cannot serve, and the text says why, 2 bad option.");
}

/// What its recording says of an attempt, for a learning system.
cmi5::Marks marks_of(const fs::path& folder) {
    recording::Recording recording({folder});
    const debrief::Attempt attempt = debrief::read_attempt(recording);
    cmi5::Marks marks{.outcome = {},
                      .duration = attempt.duration(),
                      .objectives = {},
                      .recording = folder.filename(),
                      .recording_sha256 = attempt.origin.sha256};
    if (!attempt.assessment) return marks;
    const Assessment& its = *attempt.assessment;
    marks.ended_by_itself = its.finished() && its.ending() != LESSON_ENDED_EARLY;
    marks.practice = its.practice();
    marks.outcome = its.outcome().to_string();
    marks.score = its.score();
    for (const debrief::Achievement& each : debrief::achievements_of(attempt))
        marks.objectives.push_back({.id = each.id,
                                    .text = each.text,
                                    .stcw = each.stcw,
                                    .outcome = each.outcome,
                                    .score = each.score});
    return marks;
}

void set_up_log(const std::string& level) {
    spdlog::set_default_logger(spdlog::stderr_color_mt("windlass_door"));
    spdlog::set_level(spdlog::level::from_str(level));
    spdlog::set_pattern("%H:%M:%S.%e %^%-5l%$ %v");
}

door::Certificate certificate_of(const Options& options, const std::vector<std::string>& names) {
    if (!options.certificate.empty()) return door::given_certificate(options.certificate, options.key);
    auto own = door::own_certificate(options.state, names);
    if (!own.left_out.empty())
        spdlog::warn("not in the certificate: {}; the door's authority was made before they were known "
                     "(remove authority.crt in {} for another one)",
                     fmt::join(own.left_out, ", "), options.state.string());
    return own;
}

void print_addresses(const Options& options, const door::TlsServer& server,
                     const std::vector<std::string>& names, const door::Certificate& certificate,
                     const std::string& setup_token) {
    std::string addresses;
    for (const std::string& name : names)
        if (name.find(':') == std::string::npos)
            addresses += fmt::format("https://{}:{}/\n", name, server.port());
    std::cout << addresses;
    if (server.redirect_port() != 0)
        std::cout << fmt::format("http://{}:{}/ leads there\n", options.ports.address,
                                 server.redirect_port());
    if (server.loopback_port() != 0)
        std::cout << fmt::format("http://127.0.0.1:{}/\n", server.loopback_port());
    std::cout << fmt::format("certificate SHA-256 {}\n", certificate.fingerprint);
    if (!certificate.authority.empty())
        std::cout << fmt::format("authority SHA-256 {}\n", certificate.authority_fingerprint);
    if (!setup_token.empty())
        std::cout << fmt::format("set up the first owner, once: https://localhost:{}/setup#token={}\n",
                                 server.port(), setup_token);
    std::cout << std::flush;
}

/// The command kiosk.
int kiosks(Options options) {
    door::begin_secrets();
    if (options.state.empty()) options.state = state_folder();
    door::private_folder(options.state);
    door::Kiosks kept(options.state / "kiosks.json");
    const door::Audit audit(options.state / "audit.jsonl",
                            [](const std::string& line) { std::cerr << line << '\n'; });
    options.seat.name = door::plain_name(options.seat.name);
    if (*options.kiosk_add) {
        if (options.seat.name.empty()) throw std::runtime_error("name: 1 to 32 bytes of text are allowed");
        options.seat.place = door::place_named(options.place).value();
        const std::string key = door::make_key();
        options.seat.invitation = door::digest(key);
        kept.put(options.seat);
        audit.write("kiosk.put", {{"by", "command line"},
                                  {"name", options.seat.name},
                                  {"exercise", options.seat.exercise},
                                  {"place", options.place}});
        auto names = door::own_names();
        names.insert(names.begin(), options.names.begin(), options.names.end());
        for (const std::string& name : names)
            if (name.find(':') == std::string::npos)
                std::cout << door::kiosk_address(name, options.ports.port, key) << '\n';
    } else if (*options.kiosk_remove) {
        kept.remove(options.seat.name);
        audit.write("kiosk.remove", {{"by", "command line"}, {"name", options.seat.name}});
    } else {
        for (const auto& [name, each] : kept.all())
            std::cout << fmt::format("{}: {} of exercise {}, {}\n", name, door::name_of(each.place),
                                     each.exercise, each.invitation.empty() ? "opened" : "not opened yet");
    }
    return station::kOk;
}

/// The command course.
int course(const Options& options) {
    const auto url = cmi5::url_of(options.url);
    if (!url || url->target != "/")
        throw std::runtime_error("--url: " + options.url + ": https://HOST or https://HOST:PORT is allowed");
    std::vector<cmi5::CourseLesson> lessons;
    for (const fs::path& file : console::lesson_files(options.exercises)) {
        const console::LessonFile read = console::read_lesson_file(file);
        const std::string& title = read.def.title_trainee.empty() ? read.def.title : read.def.title_trainee;
        const std::string& id = read.lesson.id;
        if (std::ranges::find(lessons, id, &cmi5::CourseLesson::id) != lessons.end())
            throw std::runtime_error(file.string() + ": /lesson/id: " + id + " is another lesson's, too");
        lessons.push_back({.id = id,
                           .title = title.starts_with(id) ? title : id + ' ' + title,
                           .description = read.lesson.briefing.empty() ? title : read.lesson.briefing,
                           .pass = read.lesson.pass});
    }
    if (lessons.empty()) throw std::runtime_error(options.exercises.string() + ": there is no lesson in it");
    std::cout << cmi5::course_xml(url->origin(), lessons);
    return station::kOk;
}

int run(Options options) {
    station::catch_stop_signals();
    set_up_log(options.log_level);
    door::begin_secrets();
    if (options.state.empty()) options.state = state_folder();
    if (options.history.empty()) options.history = options.recordings / "history.sqlite";
    door::private_folder(options.state);
    auto names = door::own_names();
    names.insert(names.begin(), options.names.begin(), options.names.end());
    const auto certificate = certificate_of(options, names);

    gateway::LineLog log([](const std::string& line) { spdlog::info("{}", line); });
    const door::Audit audit(options.state / "audit.jsonl",
                            [&log](const std::string& line) { log.tell(line); });
    gateway::Assets assets(gateway::folder_of_pages(), "join");
    auto instructor = console::instructor_pages(options.session, options.recordings, options.exercises);
    instructor.publish = [&assets](const std::string& path, std::function<std::string()> page) {
        assets.add_page(path, std::move(page));
    };
    instructor.log = [&log](const std::string& line) { log.tell(line); };
    instructor.given = [&audit, staffs = staffs_orders()](const std::string& by, const std::string& exercise,
                                                          const std::string& topic) {
        if (staffs.contains(topic))
            audit.write("order", {{"by", by}, {"exercise", exercise}, {"topic", topic}});
    };
    const auto exercise_files = instructor.exercise_files;
    const auto config = instructor.config_root;
    const auto what_if_of = instructor.what_if_of;
    const auto lessons = [exercise_files] {
        return exercise_files({{"what", "list"}, {"name", ""}, {"text", ""}, {"over", ""}});
    };
    const door::ClassHistory history(options.history, options.recordings, options.exercises);
    door::Stations stations(std::move(instructor));
    door::DoorHost host(
        {.state = options.state,
         .exercise = options.session.partition,
         .names = names,
         .certificate = certificate,
         .lessons = lessons,
         .bridge_is_judged =
             [exercises = options.exercises](const std::string& lesson) {
                 std::ifstream file(exercises / (lesson + ".json"));
                 const auto exercise = nlohmann::json::parse(file, nullptr, false);
                 const nlohmann::json of =
                     exercise.is_object() ? exercise.value("lesson", nlohmann::json()) : nlohmann::json();
                 return of.is_object() && of.value("bridge", nlohmann::json()) == "manned";
             },
         .debriefing =
             [history, recordings = options.recordings,
              config](const std::string& recording, const std::string& who, const std::string& what_if) {
                 return console::debrief_page(recordings / recording, config, what_if, who,
                                              history.word_on(recording));
             },
         .side_by_side =
             [history, recordings = options.recordings](const std::string& title,
                                                        const std::vector<door::ExerciseMade>& exercises) {
                 std::vector<console::RecordedExercise> recorded;
                 for (const auto& [who, recording] : exercises)
                     recorded.push_back({.who = who,
                                         .link = "debriefing?recording=" + recording,
                                         .recording = recording.empty() ? fs::path() : recordings / recording,
                                         .word = history.word_on(recording)});
                 return console::side_by_side_page(title, recorded);
             },
         .what_if = [what_if_of, recordings = options.recordings](
                        const std::string& recording) { return what_if_of(recordings / recording); },
         .put_in_history = [history](const door::AttemptMade& made) { history.put(made); },
         .next = [history,
                  lessons](const std::vector<std::string>& names) { return history.next(names, lessons()); },
         .judge = [history](const door::AttemptJudged& judged) { return history.judge(judged); },
         .words = [history](const std::vector<std::string>& recordings) { return history.words(recordings); },
         .learning_systems = cmi5::LearningSystems(options.learning_systems),
         .web = cmi5::WebClient(options.learning_authority),
         .marks_of = [recordings = options.recordings](
                         const std::string& recording) { return marks_of(recordings / recording); }},
        assets, stations, log);
    const door::TlsServer server(options.ports, certificate, host);
    print_addresses(options, server, names, certificate, host.setup_token());
    while (!station::stop_asked())
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    return station::kOk;
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app{"The door: every page of every exercise, by TLS, for whoever is let in.", "windlass_door"};
    Options options;
    add_options(app, options);
    if (const auto code = station::parse(app, argc, argv)) return *code;
    try {
        if (*options.course) return station::leave(course(options));
        const bool kiosk = static_cast<bool>(*options.kiosk);
        return station::leave(kiosk ? kiosks(std::move(options)) : run(std::move(options)));
    } catch (const std::exception& error) {
        std::cerr << "windlass_door: " << error.what() << std::endl;
        return station::kFailed;
    }
}
