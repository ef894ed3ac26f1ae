#include "door/door_host.hpp"

#include "door/private_file.hpp"
#include "door/secrets.hpp"

#include <algorithm>
#include <sstream>

namespace windlass::door {

using gateway::Request;
using gateway::Verdict;
using namespace std::chrono_literals;

namespace {

constexpr std::size_t kLongestTarget = 2048;
constexpr std::size_t kLongestLaunch = 6000; // addresses within an address
constexpr auto kLook = 500ms;                // how often classes' exercises are looked after

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

/// Of "a=1; b=2"; empty: there is none of that name.
std::string cookie_in(const std::string& header, const std::string& name) {
    std::istringstream rest(header);
    for (std::string part; std::getline(rest, part, ';');) {
        part.erase(0, part.find_first_not_of(' '));
        if (part.starts_with(name + '=')) return part.substr(name.size() + 1);
    }
    return {};
}

/// Whom a name leads to on loopback is not for others to say.
bool is_loopback(const std::string& host) {
    const std::string name = host.substr(0, host.rfind(':'));
    return name == "localhost" || name == "127.0.0.1" || name == "[::1]";
}

ClassBook kept_classes(const std::filesystem::path& file) {
    if (!std::filesystem::exists(file)) return ClassBook();
    try {
        return ClassBook(nlohmann::json::parse(read_file(file)));
    } catch (const std::exception& error) {
        throw std::runtime_error(file.string() + ": " + error.what());
    }
}

} // namespace

const char* cookie_name(Way way) {
    return way == Way::tls ? "__Host-windlass" : "windlass";
}

const char* kiosk_cookie_name(Way way) {
    return way == Way::tls ? "__Host-windlass-kiosk" : "windlass-kiosk";
}

DoorHost::DoorHost(DoorOptions options, const gateway::Assets& assets, Stations& stations,
                   gateway::LineLog& log)
    : options_{std::move(options)},
      assets_{assets},
      stations_{stations},
      log_{log},
      audit_{options_.state / "audit.jsonl", [this](const std::string& line) { log_.tell(line); }},
      people_{options_.state / "people.json"},
      kiosks_{options_.state / "kiosks.json"},
      book_{kept_classes(options_.state / "classes.json")},
      runs_{stations.instructor(), stations.readers()},
      wrong_codes_{20, 3s},
      wrong_passwords_{10, 6s},
      setup_token_{people_.empty() ? make_secret() : std::string()},
      outbox_{options_.state / "launches", write_private} {
    if (!options_.learning_systems.empty()) private_folder(options_.state / "launches");
}

void DoorHost::judge(Way way, const Request& request, const Reply& reply) {
    const char* scheme = way == Way::tls ? "https://" : "http://";
    if (way == Way::loopback && !is_loopback(lower(request.host)))
        return reply(gateway::refused(421, "this host is not served here"));
    const bool ours = lower(request.origin) == scheme + lower(request.host);
    if (!request.origin.empty() && !ours)
        return reply(gateway::refused(403, "pages of this origin are not served here"));
    if (request.target.size() > (request.target.starts_with("/cmi5/") ? kLongestLaunch : kLongestTarget))
        return reply(gateway::refused(414, "the address is too long"));
    const std::string path = request.target.substr(0, request.target.find('?'));
    const bool post = request.method == "POST";
    if (!post && request.method != "GET" && request.method != "HEAD")
        return reply(gateway::refused(405, "GET, HEAD and POST only"));
    const Who asks = who(way, request);
    if (post) {
        if (!ours) return reply(gateway::refused(403, "only pages of this door may ask that"));
        return act(path, request.body, asks, reply);
    }
    if (path == "/ws") return reply(link(request, asks));
    if (path.starts_with("/door/")) return ask(request.target, asks, reply);
    reply(file(path, asks));
}

DoorHost::Who DoorHost::who(Way way, const Request& request) {
    Who found{.way = way, .address = request.address, .key = {}};
    if (const std::string secret = cookie_in(request.cookie, cookie_name(way)); !secret.empty()) {
        found.key = digest(secret);
        if (const auto* person = people_.find(staff_.find(found.key, request.address, gateway::Clock::now())))
            found.staff = *person;
        else
            found.trainee = book_.seated(found.key);
    }
    if (const std::string secret = cookie_in(request.cookie, kiosk_cookie_name(way)); !secret.empty())
        if (const auto* kiosk = kiosks_.with_key(digest(secret))) found.kiosk = *kiosk;
    if (found.kiosk && !found.staff && !found.trainee) {
        found.key = found.kiosk->key;
        found.trainee = book_.seated(found.key);
    }
    return found;
}

void DoorHost::tick(gateway::Clock::time_point now) {
    stations_.tick(now);
    slow_.tick();
    launches_.tick();
    posts_.tick();
    if (now < next_look_) return;
    next_look_ = now + kLook;
    turn_out_kiosks();
    runs_.tick(book_.classes(), now);
    note_results();
    see_out(now);
    keep_attempts();
    tend_launches(now);
}

/// Of exercises that are there; what came of others is known.
void DoorHost::note_results() {
    bool news = false;
    for (const auto& each : book_.classes())
        for (const std::string& exercise : each.exercises)
            if (const auto told = runs_.told(exercise)) {
                Result now = runs_.result(exercise);
                now.time = told->time();
                now.running = told->state() == RUN_RUNNING;
                news |= book_.note(each.id, exercise, now);
            }
    if (news) keep_classes();
}

/// Of classes that are over, each attempt into the history once its recording is whole; a door that was
/// killed before does it at its next start.
void DoorHost::keep_attempts() {
    for (const TrainingClass& each : book_.classes())
        for (const auto& [exercise, result] : each.results) {
            const bool whole = !runs_.told(exercise) && !stations_.instructor().recording_of(exercise);
            if (!each.over || result.recording.empty() || result.in_history || !whole) continue;
            const AttemptMade made{
                .recording = result.recording, .class_id = each.id, .parts = each.parts(exercise)};
            if (made.parts.empty() || !asked_for_history_.insert(made.recording).second) continue;
            slow_.add<bool>(
                [put = options_.put_in_history, made] {
                    put(made);
                    return true;
                },
                [this, name = made.recording](bool) {
                    book_.note_in_history(name);
                    keep_classes();
                    return gateway::Verdict{};
                },
                [this, name = made.recording](const gateway::Verdict& answer) {
                    if (answer.status == 503) asked_for_history_.erase(name); // others wait: at the next look
                    if (answer.status >= 400)
                        log_.tell("recording " + name + " is not in the history: " + answer.reason);
                });
        }
}

void DoorHost::keep_classes() const {
    try {
        write_private(options_.state / "classes.json", book_.to_json().dump(1) + '\n');
    } catch (const std::exception& error) {
        log_.tell(error.what()); // the class goes on; it will not outlive this program
    }
}

} // namespace windlass::door
