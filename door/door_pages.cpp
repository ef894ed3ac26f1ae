// Which pages, files and WebSockets somebody gets.

#include "door/door_host.hpp"
#include "door/private_file.hpp"
#include "door/query.hpp"
#include "idl/wire.hpp"

#include <algorithm>

namespace windlass::door {

using gateway::Asset;
using gateway::refused;
using gateway::Verdict;
using namespace std::chrono_literals;

namespace {

constexpr const char* kSubprotocol = "windlass.v1";
constexpr const char* kClassIsOver = "the class is over: your instructor has your marks and the debriefing";
constexpr auto kSeenOut = 12s;  // for which a seat waits at most for its exercise to end
constexpr auto kMarksCome = 1s; // after which its marks are there

Verdict go_to(const std::string& place) {
    return {.kind = Verdict::Kind::answer,
            .status = 303,
            .type = "text/plain; charset=utf-8",
            .body = place + "\n",
            .headers = {{"Location", place}}};
}

Verdict give(std::shared_ptr<const Asset> file) {
    return {.kind = Verdict::Kind::file, .file = std::move(file)};
}

bool offers(const std::string& subprotocols) {
    return (',' + subprotocols + ',').find(kSubprotocol) != std::string::npos;
}

bool among(const std::vector<std::string>& pages, const std::string& page) {
    return std::ranges::find(pages, page) != pages.end();
}

} // namespace

/// Programs, styles and pictures are anybody's; a page is for those who have it. It knows nothing by itself.
Verdict DoorHost::file(const std::string& path, const Who& who) const {
    const auto mine = [&]() -> std::vector<std::string> {
        if (who.staff) {
            auto pages = gateway::role_of(seat_of(who.staff->rank), options_.exercise).pages;
            pages.insert(pages.begin(), {"class", "replay"});
            if (who.staff->rank == Rank::owner) pages.emplace_back("people");
            return pages;
        }
        if (who.trainee)
            return gateway::role_of(seat_at(who.trainee->trainee.place), who.trainee->trainee.exercise).pages;
        if (outbox_.of_browser(who.key) != nullptr) return {"cmi5"};
        return {who.kiosk ? "kiosk" : "join"};
    }();
    const bool launch = path == "/cmi5" || path.starts_with("/cmi5/"); // the page reads the rest
    if (launch && options_.learning_systems.empty())
        return refused(404, "no learning system may start lessons here: --learning-system lets one");
    if (launch) return give(assets_.find("/cmi5"));
    if (path == "/authority.crt" && !options_.certificate.authority.empty())
        return {.kind = Verdict::Kind::answer,
                .type = "application/x-x509-ca-cert",
                .body = read_file(options_.certificate.authority)};
    auto found = assets_.find(path == "/" ? '/' + mine.front() : path);
    if (found == nullptr) return refused(404, "there is no such page");
    if (path == "/") return mine.front() == "join" ? give(std::move(found)) : go_to('/' + mine.front());
    const bool page = found->type.starts_with("text/html");
    const std::string name = path.substr(1);
    const bool anybodys = !page || among({"join", "kiosk", "login", "setup", "trust"}, name);
    const bool debriefing = who.staff && name.starts_with("debrief-");
    if (anybodys || debriefing || among(mine, name)) return give(std::move(found));
    return go_to("/");
}

std::vector<DoorHost::Link>& DoorHost::links(const std::string& key) {
    auto& open = links_[key];
    std::erase_if(open, [](const Link& each) { return each.session.expired(); });
    return open;
}

void DoorHost::send_away(const std::string& key, const std::string& why, int code) {
    for (const Link& each : links(key))
        if (const auto session = each.session.lock()) session->end(code, why);
    links_.erase(key);
}

/// Its seats are nobody's any more. Who sits at a screen of their own hears the marks first; a device waits
/// for its next class at once, and a learner is led back to the course.
void DoorHost::part_with(const TrainingClass& its_class) {
    for (const Trainee& each : its_class.trainees)
        if (its_class.launch.empty() && kiosks_.with_key(each.key) == nullptr)
            leavers_.push_back(
                {.key = each.key, .exercise = each.exercise, .until = gateway::Clock::now() + kSeenOut});
        else
            send_away(each.key, kClassIsOver);
}

void DoorHost::see_out(gateway::Clock::time_point now) {
    for (Leaver& each : leavers_)
        if (runs_.has_ended(each.exercise)) each.until = std::min(each.until, now + kMarksCome);
    std::erase_if(leavers_, [&](const Leaver& each) {
        if (now < each.until) return false;
        send_away(each.key, kClassIsOver, kMayRead);
        return true;
    });
}

Verdict DoorHost::link(const gateway::Request& request, const Who& who) {
    if (!who.staff && !who.trainee) return refused(401, "nobody sits here: join a class, or log in");
    const std::string named = value_in(request.target, "exercise"), page = value_in(request.target, "page");
    const std::string exercise = who.trainee     ? who.trainee->trainee.exercise
                                 : named.empty() ? options_.exercise
                                                 : named;
    if (!wire::is_exercise_name(exercise))
        return refused(400, "an exercise has 1 to 64 letters, digits, dots, dashes and underscores");
    const station::Seat seat = who.trainee ? seat_at(who.trainee->trainee.place) : seat_of(who.staff->rank);
    if (who.trainee && !named.empty() && named != exercise)
        return refused(403, "this seat is in exercise " + exercise);
    if (who.trainee && !among(gateway::role_of(seat, exercise).pages, page))
        return refused(409, std::string("this seat is ") + name_of(who.trainee->trainee.place));
    const auto& open = links(who.key);
    const std::string name = who.trainee ? who.trainee->trainee.name : who.staff->name;
    if (std::ranges::any_of(open, [&](const Link& each) { return each.address != who.address; })) {
        // Once for each address: a page that came back with another one after its network was gone asks on.
        if (std::exchange(turned_away_[who.key], who.address) != who.address)
            audit_.write("seat.refused",
                         {{"name", name}, {"address", who.address}, {"at_work", open[0].address}});
        return refused(423, "this seat is open in a browser elsewhere");
    }
    if (who.trainee && open.size() >= kLinks)
        return refused(429, "this seat has as many pages open as it may");
    if (!request.upgrade || request.method != "GET" || !offers(request.subprotocols)) // a page asks why, too
        return refused(400, "a WebSocket with subprotocol windlass.v1 is expected");
    return {.kind = Verdict::Kind::page,
            .status = 101,
            .exercise = exercise,
            .subprotocol = kSubprotocol,
            .open = [this, seat, exercise, name, who](gateway::Transport& transport) {
                const auto now = book_.seated(who.key); // it may have been moved while the WebSocket was made
                if (who.trainee &&
                    (!now || now->trainee.exercise != exercise || seat_at(now->trainee.place) != seat))
                    throw std::runtime_error("the seat of " + name + " is another's");
                auto session = stations_.open(seat, exercise, name, transport);
                links(who.key).push_back({session, who.address});
                return session;
            }};
}

} // namespace windlass::door
