#include "sim/pages.hpp"

#include "common/hand_silence.hpp"
#include "idl/payload.hpp"
#include "server/dds/convert.hpp"
#include "server/perceive/perceive.hpp"
#include "sim/station_program.hpp"
#include "sim/told_topics.hpp"

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <set>

namespace windlass::sim {

using nlohmann::json;

namespace {

constexpr double kPagesTick = 0.05;   // s, as a station's program
constexpr double kStatusEvery = 0.2;  // s, as dds::Publisher
constexpr double kShipEvery = 0.1;    // s
constexpr int kFloodOfPage = 500;     // messages at once, more than any session takes
constexpr double kSaysWhere = 0.25;   // s behind a page's word in which its program repeats it
constexpr double kSaysFor = 0.3;      // s behind a page's word up to which it does, at the longest
constexpr double kSabotagedFrom = 10; // s
constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kLost = std::chrono::duration<double>(gateway::LeverDesk::kLost).count(); // s
constexpr std::size_t kWaitAtMost = gateway::Outbox::kMost + 8;

using Values = std::array<double, 5>; // as on WindlassCommand

} // namespace

struct Pages::Impl {
    struct Program;
    struct Page;
    struct Connection;

    Impl(World& its_world, Network& its_network, std::uint64_t seed, Sabotage what);
    ~Impl();

    void add(station::Seat seat, const char* name, std::vector<std::string> may_hear, bool hand);
    void start(Program& program);
    void kill(Program& program);
    void tick(Program& program);
    void tell(const wire::TopicInfo& topic, std::vector<std::uint8_t> payload, std::string key, double time);
    void send_on(Program& program, const ToldPtr& sample);
    void arrive(Program& program, const ToldPtr& sample);
    void overhear(const Sent& sent);
    void written(Program& program, gateway::LeverDesk::Page by, WindlassCommand& levers);
    void open(Page& page);
    void work(Page& page);
    void misbehave(Page& page, double drawn);
    void move(Page& page);
    void add_to_digest(const std::vector<std::uint8_t>& bytes);
    bool sabotages(Sabotage what) const { return sabotage == what && world.now() > kSabotagedFrom; }

    World& world;
    Network& network;
    Chance chance;
    const Sabotage sabotage;
    bool sabotaged = false;
    std::vector<std::unique_ptr<Program>> programs;
    HeardBook told; // of the present server: what DDS keeps for a program that starts
    std::uint64_t server = 0, samples = 0, seat_events = 0, started = 0;
    std::uint64_t status_run = 0;
    exercise::RunState status_state{};
    double next_status = 0, next_ship = 0; // s
    std::uint64_t opened = 0, sent_away = 0, killed = 0, taken = 0, digest = 0;
};

/// A page, with its connection if it has one.
struct Pages::Impl::Page {
    Program& of;
    const bool hand;
    Chance chance; // of its own: the gateway tells several pages in no order
    std::shared_ptr<Connection> connection{};
    double stays_away_until = 0, reads_again = 0, hangs_until = 0; // s
    bool chatters = false;                                         // while it does not read
    Values at{1, 0, 0, 0, 0};
};

struct Pages::Impl::Program {
    StationProgram::Options options;
    std::vector<std::string> may_hear;
    std::unique_ptr<StationProgram> runs{};
    std::uint64_t generation = 0;
    double last_arrival = 0; // s
    HeardBook book{};
    std::vector<std::unique_ptr<Page>> pages{};
    // Of its port levers, by what is heard of them:
    gateway::LeverDesk::Page holder = nullptr; // whose words went out last; nobody's any more
    double held_since = 0, own = -10;          // s: that page's first word; when a word of its own counted
    double overruled = kNever;                 // s: from when on another station's has taken them
    std::set<std::string> others{};            // that were heard on them
};

/// A WebSocket, as gateway::Socket is one.
struct Pages::Impl::Connection final : gateway::Transport, std::enable_shared_from_this<Connection> {
    Connection(Impl& its_impl, Page& its_page)
        : impl(its_impl), page(its_page), checks(its_page.of.may_hear) {}

    void wake() override {
        if (waits || ended) return;
        waits = true;
        const bool slow = page.chance.in(0.02);
        later(slow ? page.chance.spread(0.05, 3) : page.chance.spread(1e-4, 0.02), [this] { read(); });
    }

    void close(int code, const std::string& reason) override {
        if (ended || std::exchange(closing, true)) return;
        impl.world.tell(fmt::format("a page of {} is sent away: {}", page.of.options.name, reason));
        const bool deserved = (code == gateway::kFlood && floods) ||
                              (code == gateway::kBinaryRefused && sends_binary) ||
                              (code == gateway::kTooSlow && reads_not);
        if (!deserved) throw Failure{"page sessions", "a page that does nothing wrong stays", reason};
        ++impl.sent_away;
        later(0, [this] { go(); });
    }

    /// Something happens in so many seconds, if there is still a connection.
    template <class What>
    void later(double seconds, What what) {
        impl.world.at(impl.world.now() + seconds, [weak = this->weak_from_this(), what] {
            if (const auto self = weak.lock()) what();
        });
    }

    /// The page reads all that waits.
    void read() {
        waits = false;
        if (ended || closing || impl.world.now() < page.reads_again) return;
        std::size_t count = 0;
        while (auto item = session->next()) {
            ++count;
            take(*item);
        }
        checks.has_all(page.of.book, count, kWaitAtMost);
        const auto holder = page.of.runs->holder(0);
        const std::string has = holder == nullptr ? "nobody" : holder == session.get() ? "this" : "another";
        if (told_has != has) throw Failure{"page takings", "told who has the levers: " + has, told_has};
        reads_not = false;
    }

    void take(const gateway::Outbox::Item& item) {
        if (item.frame) {
            const wire::TopicInfo* topic = page.of.runs->topic_of(item.frame->channel);
            checks.gets(item.subscription, topic == nullptr ? "a channel that there is not" : topic->name,
                        item.frame->payload);
            impl.add_to_digest(item.frame->payload);
            const bool alert = topic->name == std::string_view(wire::topics::forecastle_alert.name);
            if (alert && page.hand && page.chance.in(0.3)) acknowledge(item.frame->payload);
            return;
        }
        const json message = json::parse(item.text);
        if (message.at("op") == "levers") return take_levers(message);
        if (message.at("op") != "advertise") return;
        for (const json& channel : message.at("channels"))
            channels.push_back(channel.at("id").get<std::uint32_t>());
        subscribe(channels);
    }

    /// It is told who has them. Where another station does, its hand comes off them for a while.
    void take_levers(const json& message) {
        told_has = message.at("by").get<std::string>();
        if (!message.contains("taken_by")) return;
        const auto by = message.at("taken_by").get<std::string>();
        ++impl.taken;
        if (!page.of.others.contains(by))
            throw Failure{"page takings", "told of a station that is heard on its levers", by};
        if (!page.hand || !std::exchange(works, false)) return;
        page.hangs_until = impl.world.now() + page.chance.spread(0.5, 20);
        let_go_levers();
    }

    void let_go_levers() {
        send(json{{"op", "let_go_levers"}, {"side", 0}}.dump(), [this] {
            if (page.of.holder == session.get()) page.of.holder = nullptr;
        });
    }

    void acknowledge(const std::vector<std::uint8_t>& payload) {
        const auto alert = wire::decode<Alert>(payload);
        send({{"op", "order"},
              {"id", 1},
              {"topic", wire::topics::alert_command.name},
              {"sample",
               {{"code", alert.code().to_string()},
                {"side", alert.side()},
                {"action", "ALERT_ACKNOWLEDGE"}}}});
    }

    /// A message comes to the gateway behind those before it.
    template <class Before>
    void send(std::string text, Before before) {
        const double now = impl.world.now();
        last_sent = std::max(last_sent, now + page.chance.spread(0.0005, 0.02));
        later(last_sent - now, [this, text = std::move(text), before] {
            if (page.of.runs == nullptr || of_generation != page.of.generation) return;
            if (!ended) before();
            session->take_text(text, impl.world.time());
        });
    }
    void send(const json& message) {
        send(message.dump(), [] {});
    }

    void subscribe(const std::vector<std::uint32_t>& wanted) {
        json list = json::array();
        std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs; // subscription, channel
        for (const std::uint32_t channel : wanted) {
            pairs.emplace_back(++subscriptions, channel);
            list.push_back({{"id", subscriptions}, {"channelId", channel}});
        }
        send(json{{"op", "subscribe"}, {"subscriptions", list}}.dump(), [this, pairs] {
            for (const auto& [subscription, channel] : pairs) {
                const StationProgram& program = *page.of.runs;
                checks.subscribes(subscription, *program.topic_of(channel), page.of.book,
                                  program.kept(channel));
                subscribed[channel] = subscription;
            }
        });
    }

    /// One of its subscriptions again, by which it is told anew what stands.
    void subscribe_again() {
        if (subscribed.empty() || channels.empty()) return;
        const std::uint32_t channel = channels.at(page.chance.below(channels.size()));
        const auto known = subscribed.find(channel);
        if (known == subscribed.end()) return;
        const std::uint32_t subscription = known->second;
        subscribed.erase(known);
        send(json{{"op", "unsubscribe"}, {"subscriptionIds", json::array({subscription})}}.dump(),
             [this, subscription] { checks.unsubscribes(subscription); });
        subscribe({channel});
    }

    void say_levers() {
        const Values at = page.at;
        works = true;
        const json message{{"op", "levers"},
                           {"side", 0},
                           {"brake", at[0]},
                           {"speed_lever", at[1]},
                           {"clutch_in", at[2] > 0},
                           {"stopper_closed", at[3] > 0},
                           {"emergency_stop", at[4] > 0}};
        send(message.dump(), [this, at] {
            levers = at;
            spoke = impl.world.now();
        });
    }

    void flood() {
        const double now = impl.world.now();
        last_sent = std::max(last_sent, now + 0.001);
        later(last_sent - now, [this] {
            if (page.of.runs == nullptr || of_generation != page.of.generation || ended || closing) return;
            floods = true;
            for (int k = 0; k < kFloodOfPage; ++k)
                session->take_text(R"({"op":"wind_sea"})", impl.world.time());
            if (!closing)
                throw Failure{"page sessions", fmt::format("{} messages at once end it", kFloodOfPage),
                              "the session goes on"};
        });
    }

    void send_binary() {
        later(0.001, [this] {
            if (page.of.runs == nullptr || of_generation != page.of.generation || ended || closing) return;
            sends_binary = true;
            session->take_binary();
        });
    }

    /// It is at its end. What the page has sent may still come.
    void go() {
        if (std::exchange(ended, true)) return;
        if (!impl.sabotages(Sabotage::page_works_on)) session->close();
    }

    Impl& impl;
    Page& page;
    PageChecks checks;
    std::shared_ptr<gateway::PageSession> session{};
    std::uint64_t of_generation = 0;
    bool waits = false, closing = false, ended = false;
    bool floods = false, sends_binary = false, reads_not = false;
    bool works = false; // on levers
    std::string told_has = "nobody";
    double last_sent = 0; // s
    std::uint32_t subscriptions = 0;
    std::vector<std::uint32_t> channels{};
    std::map<std::uint32_t, std::uint32_t> subscribed{}; // subscription, by channel
    Values levers{};                                     // as its program has heard them last
    double spoke = -10, repeated = -10;                  // s: when that was, and when they went out
};

Pages::Impl::Impl(World& its_world, Network& its_network, std::uint64_t seed, Sabotage what)
    : world(its_world), network(its_network), chance(seed * 0x9E3779B97F4A7C15ULL + 1), sabotage(what) {
    const bool all = what >= Sabotage::page_event_lost;
    const bool takes_part = chance.in(0.5) || all, works = chance.in(0.4) || all;
    if (!takes_part) return;
    digest = 14695981039346656037ULL;
    const std::vector<std::string> deck{"ExerciseStatus", "ForecastleEvent", "ForecastleAlert"};
    std::vector<std::string> both = deck;
    both.insert(both.end(), {"BridgeEvent", "Alert"});
    std::vector<std::string> truth = both;
    truth.insert(truth.end(), {"Event", "ShipState", "ServerAlert"});
    add(station::Seat::watcher, "watch", both, false);
    add(station::Seat::observer, "observer", truth, false);
    if (!works) return;
    add(station::Seat::forecastle, "deck", deck, true);
    network.overhear([this](const Sent& sent) { overhear(sent); });
}

Pages::Impl::~Impl() {
    for (const auto& program : programs)
        kill(*program);
}

void Pages::Impl::add(station::Seat seat, const char* name, std::vector<std::string> may_hear, bool hand) {
    programs.push_back(std::make_unique<Program>(
        Program{.options = {.seat = seat,
                            .name = name,
                            .hears_truth = sabotage == Sabotage::page_sees_truth && !station::has_truth(seat),
                            .tells_no_takings = sabotage == Sabotage::page_taking_untold,
                            .looks_at_no_takings = sabotage == Sabotage::page_hand_stays},
                .may_hear = std::move(may_hear)}));
    Program& program = *programs.back();
    if (hand)
        program.options.written = [this, &program](gateway::LeverDesk::Page by, WindlassCommand& levers) {
            written(program, by, levers);
        };
    for (int k = 0; k < 2; ++k) {
        program.pages.push_back(
            std::make_unique<Page>(Page{.of = program, .hand = hand, .chance = Chance(chance.bits())}));
        world.at(chance.spread(0.2, 5), [this, page = program.pages.back().get()] { work(*page); });
    }
    world.at(chance.spread(0.05, 2), [this, &program] { start(program); });
}

// ---- a station's program

void Pages::Impl::start(Program& program) {
    ++program.generation;
    program.options.number = ++started;
    program.book = {};
    program.runs = std::make_unique<StationProgram>(world, network, program.options);
    program.holder = nullptr, program.own = -10, program.overruled = kNever;
    program.others.clear();
    // What the server's writers have for who comes late.
    for (const wire::TopicInfo* topic : std::initializer_list<const wire::TopicInfo*>{
             &wire::topics::event, &wire::topics::forecastle_event, &wire::topics::bridge_event,
             &wire::topics::alert, &wire::topics::forecastle_alert, &wire::topics::server_alert})
        for (const ToldPtr& sample : told.stands(topic->name))
            send_on(program, sample);
    if (const ToldPtr status = told.newest(wire::topics::exercise_status.name)) send_on(program, status);
    tick(program);
    world.at(world.now() + chance.spread(5, 300), [this, &program] {
        ++killed;
        world.tell("the program of " + program.options.name + " is killed");
        kill(program);
        world.at(world.now() + chance.spread(0.2, 5), [this, &program] { start(program); });
    });
}

/// Nobody is told but by the network, later.
void Pages::Impl::kill(Program& program) {
    if (!program.runs) return;
    if (const auto writer = program.runs->speaks_as(0))
        world.at(world.now() + chance.spread(0.5, 20), [this, gone = *writer] { network.leave(gone); });
    for (const auto& page : program.pages) {
        if (page->connection) page->connection->ended = true;
        page->stays_away_until = 0;
    }
    program.runs.reset();
    for (const auto& page : program.pages)
        page->connection.reset();
}

void Pages::Impl::tick(Program& program) {
    if (!program.runs) return;
    program.runs->tick();
    if (program.holder != program.runs->holder(0)) program.holder = nullptr;
    for (const auto& page : program.pages) {
        const Connection* const one = page->connection.get();
        if (one == nullptr || one->ended || one->closing) continue;
        if (program.runs->holder(0) == one->session.get() && world.now() - one->spoke < kSaysWhere &&
            one->repeated != world.now())
            throw Failure{"page levers", "levers go out as long as their page speaks", "they do not"};
    }
    world.at(world.now() + kPagesTick, [this, &program, generation = program.generation] {
        if (generation == program.generation) tick(program);
    });
}

/// Over the network: one behind the other.
void Pages::Impl::send_on(Program& program, const ToldPtr& sample) {
    if (!program.runs || !program.runs->reads(*sample->topic)) return;
    const double delay = chance.in(0.002) ? chance.spread(0.2, 3) : chance.spread(0.0002, 0.02);
    program.last_arrival = std::max(program.last_arrival, world.now() + delay);
    world.at(program.last_arrival, [this, &program, generation = program.generation, sample] {
        if (program.runs && generation == program.generation) arrive(program, sample);
    });
}

void Pages::Impl::arrive(Program& program, const ToldPtr& sample) {
    program.book.hear(sample);
    for (const auto& page : program.pages)
        if (page->connection) page->connection->checks.is_told(sample);
    const std::string_view name = sample->topic->name;
    if (sabotages(Sabotage::page_state_lost) && name == wire::topics::exercise_status.name) return;
    const bool told_once = name == wire::topics::event.name || name == wire::topics::forecastle_event.name;
    if (sabotages(Sabotage::page_event_lost) && told_once && !std::exchange(sabotaged, true)) return;
    program.runs->hear(*sample);
}

/// A word on levers counts: every station hears whose it is.
void Pages::Impl::overhear(const Sent& sent) {
    const auto* const levers = std::get_if<WindlassCommand>(&sent.sample);
    if (levers == nullptr || levers->side() != 0 || sent.instructor) return;
    for (const auto& program : programs) {
        if (!program->runs || !program->options.written) continue;
        program->runs->overhear(sent);
        if (program->runs->speaks_as(0) == sent.writer) {
            program->own = world.now(), program->overruled = kNever;
        } else {
            if (world.now() - std::max(program->own, program->held_since) > kLost)
                program->overruled = std::min(program->overruled, world.now());
            program->others.insert(levers->origin().source().to_string());
        }
    }
}

/// A word goes out: of a page that is there, as its hand has moved the levers last, and as long as no other
/// station has them.
void Pages::Impl::written(Program& program, gateway::LeverDesk::Page by, WindlassCommand& levers) {
    const auto page = std::ranges::find_if(program.pages, [&](const auto& one) {
        return one->connection && !one->connection->ended && one->connection->session.get() == by;
    });
    if (page == program.pages.end())
        throw Failure{"page levers", "nothing of a page that is gone", "a word on its levers"};
    if (sabotages(Sabotage::page_lever_altered)) levers.brake(0.123);
    Connection& one = *(*page)->connection;
    const Values at{levers.brake(), levers.speed_lever(), levers.clutch_in() ? 1.0 : 0.0,
                    levers.stopper_closed() ? 1.0 : 0.0, levers.emergency_stop() ? 1.0 : 0.0};
    if (at != one.levers)
        throw Failure{"page levers",
                      fmt::format("brake {:g}, speed lever {:g}", one.levers[0], one.levers[1]),
                      fmt::format("brake {:g}, speed lever {:g}", at[0], at[1])};
    // A hand that was silent for too long and goes on has no word of another's against it from before that.
    const bool goes_on = world.now() - one.repeated > kHandSilent - kSaysFor - kPagesTick;
    one.repeated = world.now();
    if (program.holder != by || goes_on)
        program.holder = by, program.held_since = world.now(), program.overruled = kNever;
    if (world.now() - program.overruled > 2 * kPagesTick)
        throw Failure{
            "page levers", "its hand is off levers that another station has",
            fmt::format("a word, {:.2f} s behind the one that took them", world.now() - program.overruled)};
}

// ---- its pages

void Pages::Impl::open(Page& page) {
    page.connection = std::make_shared<Connection>(*this, page);
    Connection& one = *page.connection;
    one.of_generation = page.of.generation;
    one.session = page.of.runs->open_page(one);
    one.session->open();
    ++opened;
}

void Pages::Impl::work(Page& page) {
    const double now = world.now();
    double next = page.hand ? chance.between(0.05, 0.1) : chance.spread(0.1, 1);
    if (page.connection && page.connection->ended) {
        page.connection.reset(); // what it has sent since is lost
        page.stays_away_until = now + chance.spread(0.01, 10);
    }
    if (!page.connection) {
        if (page.of.runs && now >= page.stays_away_until) {
            page.reads_again = 0;
            open(page);
        }
    } else {
        Connection& one = *page.connection;
        // One that has read that another page has them tries all the same now and then, and is refused.
        if (page.hand && now >= page.hangs_until && (one.told_has != "another" || chance.in(0.05))) {
            if (chance.in(0.08)) move(page);
            one.say_levers();
        }
        if (now < page.reads_again && page.chatters)
            for (int k = 0; k < static_cast<int>(60 * next); ++k)
                one.send(std::string(R"({"op":"what"})"), [] {});
        else if (now >= page.reads_again)
            one.wake();
        misbehave(page, chance.unit());
    }
    world.at(now + next, [this, &page] { work(page); });
}

/// Now and then, of each kind a little.
void Pages::Impl::misbehave(Page& page, double drawn) {
    static constexpr std::array<const char*, 9> kNoMessages{
        "",
        "{",
        "[1]",
        "{\"op\":7}",
        R"({"op":"levers","side":7})",
        R"({"op":"levers","side":0,"brake":9,"speed_lever":0})",
        R"({"op":"order","id":1,"topic":"FaultCommand","sample":{}})",
        R"({"op":"subscribe","subscriptions":[{"id":100000,"channelId":99},{"id":"a"},7]})",
        "{\"op\":\"\xff\xfe\"}"};
    Connection& one = *page.connection;
    const double now = world.now();
    if (drawn < 0.004) {
        one.flood();
    } else if (drawn < 0.007) {
        one.send_binary();
    } else if (drawn < 0.03) {
        one.send(std::string(kNoMessages.at(chance.below(kNoMessages.size()))), [] {});
    } else if (drawn < 0.035) { // is loaded anew, or closed for a while
        one.go();
        page.connection.reset();
        page.stays_away_until = now + chance.spread(0.01, 10);
    } else if (drawn < 0.045) { // stops reading
        page.reads_again = now + chance.spread(0.2, 40);
        page.chatters = chance.in(0.5);
        one.reads_not = true;
    } else if (drawn < 0.07) {
        one.subscribe_again();
    } else if (drawn < 0.08 && page.hand) { // says nothing for a while, or lets go
        page.hangs_until = now + chance.spread(0.1, 15);
        if (chance.in(0.5)) one.let_go_levers();
    }
}

void Pages::Impl::move(Page& page) {
    const std::size_t lever = chance.below(5);
    double& at = page.at.at(lever);
    if (lever == 0)
        at = chance.in(0.3) ? 1 : chance.between(0.2, 0.8);
    else if (lever == 1)
        at = chance.in(0.4) ? 0 : chance.between(-1, 1);
    else
        at = chance.in(lever == 4 ? 0.05 : 0.3) ? 1 : 0;
}

void Pages::Impl::add_to_digest(const std::vector<std::uint8_t>& bytes) {
    for (const std::uint8_t byte : bytes)
        digest = (digest ^ byte) * 1099511628211ULL;
}

// ---- the server

void Pages::Impl::tell(const wire::TopicInfo& topic, std::vector<std::uint8_t> payload, std::string key,
                       double time) {
    const auto sample = std::make_shared<const ToldSample>(ToldSample{.topic = &topic,
                                                                      .payload = std::move(payload),
                                                                      .key = std::move(key),
                                                                      .time = time,
                                                                      .server = server,
                                                                      .number = ++samples});
    told.hear(sample);
    for (const auto& program : programs)
        send_on(*program, sample);
}

Pages::Pages(World& world, Network& network, std::uint64_t seed, Sabotage sabotage)
    : impl_(std::make_unique<Impl>(world, network, seed, sabotage)) {}

Pages::~Pages() = default;

void Pages::tell(const run::Session& session, std::uint64_t server) {
    Impl& impl = *impl_;
    if (impl.programs.empty()) return;
    if (std::exchange(impl.server, server) != server) impl.told = {}, impl.next_status = 0;
    for (const exercise::ExerciseEvent& event : session.events()) {
        Event to;
        dds::convert(event, to);
        impl.tell(wire::topics::event, wire::encode(to), "", event.time);
        if (perceive::is_instruction(event)) continue;
        if (auto noticed = perceive::perceive_event(event, session.snapshot())) {
            noticed->number(++impl.seat_events);
            on_topics_of(*noticed, [&](const wire::TopicInfo& topic) {
                impl.tell(topic, wire::encode(*noticed), "", noticed->time());
            });
        }
    }
    for (const run::AlertView& alert : session.alerts()) {
        Alert to;
        dds::convert(alert, to);
        on_topics_of(alert, [&](const wire::TopicInfo& topic) {
            impl.tell(topic, wire::encode(to), fmt::format("{}/{}", alert.code, alert.side), to.time());
        });
    }
    const double now = impl.world.now();
    const run::RunStatus& status = session.status();
    const bool changed = std::exchange(impl.status_run, status.run) != status.run ||
                         std::exchange(impl.status_state, status.state) != status.state;
    if (changed || now >= impl.next_status) {
        impl.next_status = now + kStatusEvery;
        ExerciseStatus to;
        dds::convert(session.snapshot(), status, to);
        impl.tell(wire::topics::exercise_status, wire::encode(to), "", to.time());
    }
    if (session.seen() && now >= impl.next_ship) {
        impl.next_ship = now + kShipEvery;
        ShipState to;
        dds::convert(session.snapshot(), to);
        impl.tell(wire::topics::ship_state, wire::encode(to), "", to.time());
    }
}

void Pages::end() {
    for (const auto& program : impl_->programs)
        for (const auto& page : program->pages)
            if (page->connection) page->connection->read();
}

std::uint64_t Pages::opened() const {
    return impl_->opened;
}
std::uint64_t Pages::sent_away() const {
    return impl_->sent_away;
}
std::uint64_t Pages::killed() const {
    return impl_->killed;
}
std::uint64_t Pages::taken() const {
    return impl_->taken;
}
std::uint64_t Pages::digest() const {
    return impl_->digest;
}

} // namespace windlass::sim
