// What one door carries: classes whose trainees sit at pages without a browser, over TLS as browsers do, and
// how long it takes from a lever's message to the gauge's change. README.md says how to read it.

#include <utility> // std::exchange, which Boost.Asio 1.74 uses without it

#include "bench/measured_server.hpp"
#include "bench/process_cpu.hpp"
#include "bench/program.hpp"
#include "idl/payload.hpp"
#include "rigs/server_process.hpp"

#include <CLI/CLI.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/ssl.hpp>
#include <boost/beast/websocket.hpp>
#include <boost/beast/websocket/ssl.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <deque>
#include <future>
#include <thread>

namespace {

using namespace windlass;
namespace net = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using Clock = std::chrono::steady_clock;
using nlohmann::json;
using tcp = net::ip::tcp;
using namespace std::chrono_literals;

constexpr int kOfAClass = 50; // exercises: a class has at most 64
constexpr const char* kPassword = "a long password";

struct Options {
    double seconds = 30; // of each row
    int pages = 5;       // of each exercise: forecastle, bridge, and the others look on
    std::string lesson = "L01_let_go_25m";
    bench::MeasuredServer server;
    bool unrecorded = false;
    std::filesystem::path security; // folder of identities; empty: DDS open to all
    std::vector<int> classes{4, 12, 48};
};

void add_identity(const Options& options, const char* role, std::vector<std::string>& arguments) {
    if (!options.security.empty())
        arguments.insert(arguments.end(), {"--security", (options.security / role).string()});
}

/// A folder that goes away with it.
struct Folder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / fmt::format("bench_door_{}", getpid());
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() { std::filesystem::remove_all(path); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
};

/// The door as a process of its own, with its owner logged in; asked by plain HTTP of this computer.
class Door : public rigs::ChildProcess {
public:
    Door(const Options& options, const Folder& folder) : ChildProcess(command(options, folder)) {
        rigs::eventually([&] { return ended() || text().find("certificate SHA-256") != std::string::npos; });
        const std::string told = text();
        const auto behind = [&told](const std::string& words) {
            const auto at = told.find(words);
            if (at == std::string::npos) throw std::runtime_error("no door: " + told);
            return told.substr(at + words.size(), 64);
        };
        tls = static_cast<unsigned short>(std::stoi(behind("https://localhost:")));
        loopback_ = static_cast<unsigned short>(std::stoi(behind("\nhttp://127.0.0.1:")));
        owner_ =
            post("", "/door/setup", {{"token", behind("#token=")}, {"name", "anna"}, {"password", kPassword}})
                .secret;
    }

    struct Answer {
        json body;
        std::string secret; ///< of the cookie that it sets
    };
    Answer post(const std::string& secret, const std::string& target, const json& body) const {
        return ask(http::verb::post, secret, target, body.dump());
    }
    void lead(const json& order) const { post(owner_, "/door/class", order); }
    json classes() const { return ask(http::verb::get, owner_, "/door/classes", "").body["classes"]; }
    /// The secret of somebody's cookie, who now sits.
    std::string join(const std::string& code, const std::string& name) const {
        return post("", "/door/join", {{"code", code}, {"name", name}}).secret;
    }

    unsigned short tls = 0;

private:
    static std::vector<std::string> command(const Options& options, const Folder& folder) {
        // Where no folder can be made nothing is recorded.
        const std::string recordings =
            options.unrecorded ? "/dev/null/none" : (folder.path / "recordings").string();
        std::vector<std::string> command{WINDLASS_DOOR,
                                         "--port",
                                         "0",
                                         "--loopback-port",
                                         "0",
                                         "--state",
                                         folder.path / "door",
                                         "--recordings",
                                         recordings,
                                         "--exercises",
                                         std::string(WINDLASS_CONFIG_DIR) + "/exercises",
                                         "--partition",
                                         "none",
                                         "--domain",
                                         std::to_string(options.server.domain),
                                         "--sessions",
                                         "10000"};
        add_identity(options, "door", command);
        return command;
    }
    Answer ask(http::verb verb, const std::string& secret, const std::string& target,
               const std::string& body) const {
        net::io_context io;
        beast::tcp_stream stream(io);
        stream.connect(tcp::endpoint(net::ip::make_address("127.0.0.1"), loopback_));
        const std::string host = fmt::format("127.0.0.1:{}", loopback_);
        http::request<http::string_body> request(verb, target, 11, body);
        request.set(http::field::host, host);
        request.set(http::field::origin, "http://" + host);
        if (!secret.empty()) request.set(http::field::cookie, "windlass=" + secret);
        request.keep_alive(false);
        request.prepare_payload();
        http::write(stream, request);
        beast::flat_buffer buffer;
        http::response<http::string_body> response;
        http::read(stream, buffer, response);
        if (response.result_int() != 200)
            throw std::runtime_error(
                fmt::format("{}: {} {}", target, response.result_int(), response.body()));
        const std::string cookie(response[http::field::set_cookie]);
        const auto from = cookie.find('=') + 1;
        return {json::parse(response.body(), nullptr, false),
                cookie.empty() ? std::string() : cookie.substr(from, cookie.find(';') - from)};
    }

    unsigned short loopback_ = 0;
    std::string owner_;
};

/// What all pages have seen, on the one thread that they are on.
struct Seen {
    std::uint64_t samples = 0, bytes = 0, moves = 0;
    std::vector<double> latencies; // s, from a lever's message to the first view that shows it
    int ended = 0;                 // pages that were sent away
};

/// One page of a seat. It hears what its seat is given, but ghosts and the camera, which pages ask for on
/// demand; at the forecastle it holds the port levers as a page does, 20 times a second, and moves one each
/// second.
class Page : public std::enable_shared_from_this<Page> {
public:
    Page(net::io_context& io, net::ssl::context& tls, Seen& seen, bool moves)
        : ws_(io, tls), timer_(io), seen_(seen), moves_(moves) {}

    /// On the caller's thread. Throws when it is not let in.
    void open(unsigned short port, const std::string& secret, const std::string& page) {
        const std::string host = fmt::format("127.0.0.1:{}", port);
        beast::get_lowest_layer(ws_).connect(tcp::endpoint(net::ip::make_address("127.0.0.1"), port));
        ws_.next_layer().handshake(net::ssl::stream_base::client);
        ws_.set_option(websocket::stream_base::decorator([&](websocket::request_type& request) {
            request.set(http::field::origin, "https://" + host);
            request.set(http::field::sec_websocket_protocol, "windlass.v1");
            request.set(http::field::cookie, "__Host-windlass=" + secret);
        }));
        ws_.handshake(host, "/ws?page=" + page);
    }
    /// From then on on the thread of its context. phase: of its moves, 0..1.
    void begin(double phase) {
        net::post(ws_.get_executor(), [self = shared_from_this(), phase] {
            self->read();
            if (!self->moves_) return;
            self->next_move_ = Clock::now() + std::chrono::microseconds(static_cast<int>(1e6 * (1 + phase)));
            self->timer_.expires_after(std::chrono::microseconds(static_cast<int>(5e4 * phase)));
            self->hold();
        });
    }

private:
    void read() {
        ws_.async_read(buffer_, [self = shared_from_this()](beast::error_code error, std::size_t bytes) {
            if (error) {
                ++self->seen_.ended;
                return;
            }
            self->take(static_cast<const char*>(self->buffer_.data().data()), bytes);
            self->buffer_.consume(bytes);
            self->read();
        });
    }
    void take(const char* data, std::size_t size) {
        seen_.bytes += size;
        if (ws_.got_text()) {
            const json told = json::parse(data, data + size, nullptr, false);
            if (told.is_object() && told.value("op", "") == "advertise") subscribe(told["channels"]);
            return;
        }
        ++seen_.samples;
        std::uint32_t number = 0;
        if (size < 17) return;
        std::memcpy(&number, data + 1, 4);
        if (number != view_ || waits_ == Clock::time_point()) return;
        const auto view =
            wire::decode<ForecastleView>({reinterpret_cast<const std::uint8_t*>(data) + 13, size - 13});
        if (std::abs(view.speed_lever() - lever_) > 1e-9) return;
        seen_.latencies.push_back(std::chrono::duration<double>(Clock::now() - waits_).count());
        waits_ = {};
    }
    void subscribe(const json& channels) {
        json wanted = json::array();
        for (const json& each : channels) {
            const std::string topic = each["topic"];
            const auto number = each["id"].get<std::uint32_t>();
            if (topic == "/ForecastleView") view_ = number;
            if (topic.ends_with("Ghost") || topic.ends_with("Camera")) continue;
            wanted.push_back({{"id", number}, {"channelId", number}});
        }
        say({{"op", "subscribe"}, {"subscriptions", wanted}});
    }
    void hold() {
        timer_.async_wait([self = shared_from_this()](beast::error_code error) {
            if (error) return;
            const auto now = Clock::now();
            if (now >= self->next_move_ && self->waits_ == Clock::time_point()) {
                self->lever_ = self->lever_ > 0.15 ? 0.01 : self->lever_ + 0.01;
                self->waits_ = now;
                self->next_move_ = now + 1s;
                ++self->seen_.moves;
            }
            self->say({{"op", "levers"},
                       {"side", 0},
                       {"brake", 1},
                       {"speed_lever", self->lever_},
                       {"clutch_in", false},
                       {"stopper_closed", false},
                       {"emergency_stop", false}});
            self->timer_.expires_at(self->timer_.expiry() + 50ms);
            self->hold();
        });
    }
    void say(const json& message) {
        waiting_.push_back(message.dump());
        if (waiting_.size() == 1) write();
    }
    void write() {
        ws_.text(true);
        ws_.async_write(net::buffer(waiting_.front()),
                        [self = shared_from_this()](beast::error_code error, std::size_t) {
                            if (error) return;
                            self->waiting_.pop_front();
                            if (!self->waiting_.empty()) self->write();
                        });
    }

    websocket::stream<beast::ssl_stream<beast::tcp_stream>> ws_;
    net::steady_timer timer_;
    Seen& seen_;
    const bool moves_;
    beast::flat_buffer buffer_;
    std::deque<std::string> waiting_;
    std::uint32_t view_ = 0; // channel of the forecastle's view
    double lever_ = 0;
    Clock::time_point waits_{}, next_move_{}; // waits_: since the move that is not seen yet was told
};

/// Pages, and the thread on which they are.
class Room {
public:
    Room() {
        tls_.set_verify_mode(net::ssl::verify_none);
        thread_ = std::thread([this] { io_.run(); });
    }
    ~Room() {
        io_.stop();
        thread_.join();
    }
    Room(const Room&) = delete;
    Room& operator=(const Room&) = delete;

    void open(unsigned short port, const std::string& secret, const std::string& page, bool moves) {
        auto made = std::make_shared<Page>(io_, tls_, seen_, moves);
        made->open(port, secret, page);
        made->begin(std::fmod(0.618 * ++opened_, 1.0));
    }
    /// What was seen since the last call.
    Seen seen() {
        std::promise<Seen> told;
        net::post(io_, [&] {
            told.set_value(seen_);
            const int ended = seen_.ended;
            seen_ = {};
            seen_.ended = ended;
        });
        return told.get_future().get();
    }

private:
    net::io_context io_{1};
    net::executor_work_guard<net::io_context::executor_type> work_{io_.get_executor()};
    net::ssl::context tls_{net::ssl::context::tls_client};
    Seen seen_;
    int opened_ = 0;
    std::thread thread_;
};

void wait(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

double since(Clock::time_point then) {
    return std::chrono::duration<double>(Clock::now() - then).count();
}

double cpu_of_family(pid_t pid) {
    double sum = 0;
    for (const pid_t each : bench::family_of(pid))
        sum += bench::cpu_of(each);
    return sum;
}

/// ms, of what is sorted.
double part(const std::vector<double>& sorted, double share) {
    return sorted.empty()
               ? NAN
               : 1e3 * sorted[static_cast<std::size_t>(share * (static_cast<double>(sorted.size()) - 1))];
}

std::vector<std::string> arguments_of(const Options& options) {
    std::vector<std::string> arguments = options.server.arguments();
    arguments.emplace_back("--classroom");
    add_identity(options, "server", arguments);
    return arguments;
}

/// Opens classes of so many exercises in all, and waits until a server has them.
void open_classes(const Options& options, const Door& door, int exercises) {
    for (int first = 0; first < exercises; first += kOfAClass)
        door.lead({{"do", "open"},
                   {"class", fmt::format("c{}", first / kOfAClass)},
                   {"lesson", options.lesson},
                   {"exercises", std::min(kOfAClass, exercises - first)},
                   {"crew", std::min(options.pages, 3)}});
    const auto began = Clock::now();
    for (int made = 0; made < exercises; wait(0.2)) {
        if (since(began) > 180) throw std::runtime_error("no class: " + door.text());
        made = 0;
        for (const json& each : door.classes())
            for (const json& exercise : each["exercises"])
                made += exercise["state"].is_null() ? 0 : 1;
    }
}

/// Everybody joins, and opens a page; returns how many.
int sit_down(const Options& options, const Door& door, Room& room) {
    int opened = 0;
    for (const json& each : door.classes())
        for (std::size_t k = 0; k < each["exercises"].size(); ++k) {
            std::string secret;
            for (int place = 0; place < options.pages; ++place, ++opened) {
                // A third is the last seat that an exercise has: the others are pages of the same browser.
                if (place < 3) secret = door.join(each["code"], fmt::format("t{}", opened));
                room.open(door.tls, secret, place == 1 ? "bridge" : "forecastle", place == 0);
            }
        }
    return opened;
}

/// Processor time so far, s.
struct Spent {
    Spent(const Door& of, const rigs::ServerProcess& server)
        : door(bench::cpu_of(of.pid())),
          recorders(cpu_of_family(of.pid()) - door),
          servers(cpu_of_family(server.pid())),
          pages(bench::cpu_of(getpid())) {}
    double door, recorders, servers, pages;
};

void row(const Options& options, int exercises) {
    const Folder folder;
    const rigs::ServerProcess server(arguments_of(options));
    const Door door(options, folder);
    const auto opening = Clock::now();
    open_classes(options, door, exercises);
    const double made = since(opening);
    Room room;
    const auto sitting = Clock::now();
    const int pages = sit_down(options, door, room);
    const double sat = since(sitting);
    for (const json& each : door.classes())
        door.lead({{"do", "start"}, {"class", each["id"]}});
    wait(10); // what is first met is slow
    room.seen();
    const Spent before(door, server);
    const auto from = Clock::now();
    wait(options.seconds);
    const double elapsed = since(from);
    Seen seen = room.seen();
    std::ranges::sort(seen.latencies);
    const Spent after(door, server);
    const auto share = [&](double Spent::*of) { return 100 * (after.*of - before.*of) / elapsed; };
    fmt::print("| {} | {} | {:.0f} | {:.0f} | {:.0f} | {:.0f} | {:.0f} | {} of {} | {:.0f} % | {:.0f} % | "
               "{:.0f} % | "
               "{:.0f} % | {:.0f} | {:.0f} | {:.1f} | {:.1f} | {} |\n",
               exercises, pages, static_cast<double>(seen.samples) / elapsed,
               1e-3 * static_cast<double>(seen.bytes) / elapsed, part(seen.latencies, 0.5),
               part(seen.latencies, 0.99), part(seen.latencies, 1), seen.latencies.size(), seen.moves,
               share(&Spent::door), share(&Spent::recorders), share(&Spent::servers), share(&Spent::pages),
               bench::memory_of(door.pid()), bench::memory_of(server.pid()), made, sat, seen.ended);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app("bench_door: classes at one door, at real time", "bench_door");
    app.footer("\nExit codes: 0 done, 1 no server or no door, 2 bad option. Prints a Markdown table.");
    app.add_option("--seconds", options.seconds, "measured for each row")
        ->check(CLI::Range(5.0, 3600.0))
        ->capture_default_str();
    app.add_option("--exercises", options.classes, "how many, one row each")
        ->check(CLI::Range(1, 448))
        ->capture_default_str();
    app.add_option("--pages", options.pages, "of each exercise: forecastle, bridge, the others look on")
        ->check(CLI::Range(1, 8))
        ->capture_default_str();
    app.add_option("--lesson", options.lesson, "an exercise file of config")->capture_default_str();
    app.add_flag("--unrecorded", options.unrecorded, "no exercise is recorded: a class always is");
    app.add_option("--security", options.security,
                   "DDS Security, with the identities that make_identities has put into that folder")
        ->type_name("FOLDER")
        ->check(CLI::ExistingDirectory);
    options.server.add_options(app);
    return bench::run_program(app, argc, argv, [&] {
        fmt::print(
            "| exercises | pages | samples/s | kB/s | half within, ms | 99 % | all | seen, of moves | door, "
            "of a core | recorders | server | these pages | door, MB | server, MB | made after, s | sent "
            "away |\n"
            "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
        for (const int count : options.classes)
            row(options, count);
    });
}
