#include "sim/centre.hpp"

#include "server/dds/flood_gate.hpp"
#include "server/exercise/definition/def_fields.hpp"
#include "server/host/pacer.hpp"
#include "server/keep/beginning.hpp"
#include "server/keep/kept_exercise.hpp"
#include "server/keep/take_up.hpp"
#include "server/run/prediction.hpp"
#include "sim/answers.hpp"
#include "sim/checks.hpp"
#include "sim/disk.hpp"
#include "sim/drawn_exercise.hpp"
#include "sim/hands.hpp"
#include "sim/pages.hpp"
#include "sim/recorder.hpp"

#include <spdlog/fmt/fmt.h>

#include <malloc.h>

#include <algorithm>
#include <cmath>

namespace windlass::sim {

namespace {

namespace fs = std::filesystem;

constexpr const char* kId = "anna";
const fs::path kFolder = "/kept/exercise-anna", kAside = "/kept/aside";
constexpr double kWriteEvery = 0.01, kSyncEvery = 1; // s, as keep::Keeper
constexpr double kBeatCost = 0.0003;                 // s of processor time in a beat
constexpr int kLookedAhead = 30;                     // ticks, beside a beat
constexpr std::size_t kRoomy = 8 << 20;              // bytes: more than an exercise may take of the disk
constexpr std::size_t kMemory = 256 << 20;           // bytes
constexpr double kMemoryEvery = 5; // s: the allocator goes through all that is free to tell what is not
constexpr std::uint64_t kFirstRun = 1'800'000'000'000;      // ms since 1970
constexpr std::uint64_t kRecordersOwn = 0x7265636f72646572; // chance
constexpr std::uint64_t kAnswersOwn = 0x616e7377657273;     // the same
constexpr double kHangs =
    10; // s, in which a server must have ended that is to begin anew, as workers::supervise

/// How often the exercise was taken up since it settled, as the newest file has it.
std::size_t attempts(SimDisk& disk) {
    const auto files = keep::kept_files(kFolder, disk);
    for (auto file = files.rbegin(); file != files.rend(); ++file) {
        try {
            const keep::KeptContents contents(*file, disk);
            const bool whole = std::ranges::any_of(
                contents.entries(), [](const auto& entry) { return entry.kind == keep::Record::checkpoint; });
            if (!whole) continue;
            const auto course = keep::decode_beginning(contents.entries().front().payload).course;
            const auto counted = keep::attempts_file(kFolder, course.settled);
            return disk.exists(counted) ? disk.read(counted).size() : 0;
        } catch (const std::exception&) { // damaged
            return 0;
        }
    }
    return 0;
}

exercise::ExerciseDef exercise_of(const Plan& plan) {
    if (plan.def) return *plan.def;
    const bool asks =
        plan.sabotage == Sabotage::question_untold || plan.sabotage == Sabotage::question_passed_over;
    exercise::ExerciseDef drawn = drawn_exercise(plan.seed);
    return asks || draws_questions(plan.seed) ? with_questions(std::move(drawn)) : drawn;
}

/// A prediction that is being made, or was.
struct Ahead {
    run::Branch branch;
    int ticks = 0;          // that are still to be gone through
    double rests_until = 0; // s, up to the next
};

/// What one server is, until it is lost.
struct Server {
    Server(World& world, SimDisk& disk, const exercise::ExerciseDef& def, run::SessionOptions options)
        : session(def, std::move(options)),
          kept(kFolder, kId, exercise::definition_hash(def), disk, [&world] { return world.time(); }),
          pacer(session.dt(), session.status().time_scale, world.time()),
          scale(session.status().time_scale),
          setups(session.setups()) {}

    run::Session session;
    dds::Mailbox mailbox;
    std::map<std::size_t, dds::FloodGate> gates; // by kind of sample
    keep::KeptExercise kept;
    host::Pacer pacer;
    double scale;
    unsigned setups;
    run::Inbox inbox;
    std::optional<Checks::Place> handed_over{}; // since the disk was waited for last
    std::optional<Ahead> ahead{};
    bool leaves = false; // ticks no more, and waits for its disk
};

class Centre {
public:
    explicit Centre(const Plan& plan)
        : plan_(plan),
          def_(exercise_of(plan)),
          world_(plan.sabotage == Sabotage::chance ? plan.seed ^ reinterpret_cast<std::uintptr_t>(this) ^
                                                         static_cast<std::uint64_t>(clock())
                                                   : plan.seed,
                 plan.story),
          disk_(world_),
          network_(world_),
          checks_(world_),
          hands_(world_, network_, plan.seed, def_.tackle.size()),
          answers_(world_, network_, plan.seed ^ kAnswersOwn),
          pages_(world_, network_, plan.seed, plan.sabotage),
          anew_(~plan.seed),
          recorder_(world_, plan.seed ^ kRecordersOwn, plan.sabotage),
          end_(static_cast<std::uint64_t>(plan.minutes * 60 * def_.tick_rate_hz)) {}

    Outcome run();

private:
    void start();
    void lose(Loss how);
    void begin_anew(std::uint64_t life);
    void leave();
    void beat(std::uint64_t life);
    void tick();
    void look_ahead();
    void write(std::uint64_t life);
    void sync(std::uint64_t life);
    void weather_the_disk(std::uint64_t life);
    void stall(std::uint64_t life);
    void plan_the_end(std::uint64_t life);
    void tell();
    void hear(const Sent& sent);
    void hold_memory();
    bool lives(std::uint64_t life) const { return server_ && life == life_; }
    template <class What>
    void after(double seconds, What what) { // of this server
        world_.at(world_.now() + seconds, [this, life = life_, what] {
            if (lives(life)) (this->*what)(life);
        });
    }

    const Plan& plan_;
    const exercise::ExerciseDef def_;
    World world_;
    SimDisk disk_;
    Network network_;
    Checks checks_;
    Hands hands_;
    Answers answers_;
    Pages pages_;
    Chance anew_; // of its own, so that a seed without a server that begins anew is what it was before there
                  // were such
    Recorder recorder_;
    double memory_at_ = 0; // s, when the heap is looked at next
    const std::uint64_t end_;
    std::optional<Server> server_;
    std::uint64_t life_ = 0;
    double stalled_until_ = 0, clock_is_off_ = 0; // s
    Loss lost_by_ = Loss::killed;
    bool rotten_ = false, sabotaged_ = false, lost_setting_back_ = false;
    Outcome outcome_;
};

/// As main.cpp opens an exercise with --keep.
void Centre::start() {
    Chance& chance = world_.chance();
    ++life_;
    clock_is_off_ += chance.in(0.3) ? chance.between(-100, 100) : 0; // what the machine takes for the time
    Beginning how{.lost_by = lost_by_, .first = life_ == 1, .rotten = rotten_ || disk_.refuses};
    how.attempts = attempts(disk_);
    checks_.starts(how);
    how.set_back_before =
        lost_setting_back_ || std::ranges::any_of(keep::kept_files(kFolder, disk_), keep::is_set_back);
    lost_setting_back_ = lost_setting_back_ || how.attempts >= 2; // until it has begun
    if (plan_.sabotage == Sabotage::last_record_lost && life_ > 1) disk_.lose_the_end(".kept", 60);
    if (chance.in(0.1)) disk_.lose_in(1 + chance.below(12), chance.in(0.5) ? Loss::killed : Loss::power_cut);
    how.running = chance.in(0.3);
    const auto taken = keep::take_up(
        kFolder, kId, kAside,
        {.definition_hash = exercise::definition_hash(def_), .check = {}, .running = how.running}, disk_);
    run::SessionOptions options;
    options.fault_folder = "/dev/null/none";
    options.seed = chance.bits();
    options.first_run =
        kFirstRun + static_cast<std::uint64_t>(std::llround(1000 * (world_.now() + 200 + clock_is_off_)));
    if (taken) {
        options.resumption = taken->how;
        how.taken_up = taken->def.has_value();
        how.refused = taken->how.refused;
        how.set_back = taken->how.set_back;
    }
    ++(how.taken_up ? outcome_.taken_up : outcome_.anew);
    outcome_.set_back += how.set_back.empty() ? 0 : 1;
    world_.tell(fmt::format("a server begins: {}{}{}, attempts {}", how.taken_up ? "taken up" : "anew",
                            how.refused.empty() ? "" : ", refused: " + how.refused,
                            how.set_back.empty() ? "" : ", set back: " + how.set_back, how.attempts));
    lost_setting_back_ = false;
    server_.emplace(world_, disk_, taken && taken->def ? *taken->def : def_, options);
    checks_.begins(server_->session, how);
    recorder_.server_begins();
    lost_by_ = Loss::killed;
    disk_.served = true;
    stalled_until_ = 0;
    network_.serve([this](const Sent& sent) { hear(sent); },
                   [this](const wire::WriterId& writer, bool there) {
                       if (there)
                           server_->mailbox.come(writer), checks_.comes(writer);
                       else
                           server_->mailbox.leave(writer), checks_.leaves(writer);
                   });
    after(0, &Centre::beat);
    after(kWriteEvery, &Centre::write);
    after(kSyncEvery, &Centre::sync);
    after(chance.spread(0.5, 60), &Centre::weather_the_disk);
    after(chance.spread(0.5, 60), &Centre::stall);
    if (anew_.in(0.1)) after(anew_.spread(0.01, 60), &Centre::begin_anew);
    plan_the_end(life_);
}

/// When and how this server is lost: at any instant, or at any call that it makes to the disk.
void Centre::plan_the_end(std::uint64_t) {
    Chance& chance = world_.chance();
    const Loss how = chance.in(0.5) ? Loss::killed : Loss::power_cut;
    if (chance.in(0.5)) {
        disk_.lose_in(1 + static_cast<std::uint64_t>(chance.spread(1, 4000)), how);
    } else {
        disk_.lose_in(0, how);
        world_.at(world_.now() + chance.spread(0.01, 60), [this, how, life = life_] {
            if (lives(life)) throw Crash{how};
        });
    }
}

void Centre::lose(Loss how) {
    world_.tell(how == Loss::killed ? "the server is killed" : "the power is cut");
    server_.reset();
    network_.serve_nobody();
    ++(how == Loss::killed ? outcome_.kills : outcome_.power_cuts);
    disk_.lose(how);
    if (how == Loss::power_cut) lost_by_ = how; // be it as the server starts again
    if (how == Loss::power_cut) recorder_.lose_power();
    if (world_.chance().in(0.02) && disk_.rot(".kept")) {
        rotten_ = true; // from now on
        ++outcome_.rotten;
        world_.tell("a byte on the disk changes");
    }
    // A disk that was full or broken may be so still, but not for ever.
    if (world_.chance().in(0.7))
        disk_.refuses = false, disk_.room = std::numeric_limits<std::uint64_t>::max();
}

/// As main.cpp by SIGUSR1, and host::HostedExercise: what the exercise has come to goes to the disk, and then
/// the server ends. One that does not come to its end is killed.
void Centre::begin_anew(std::uint64_t life) {
    Server& server = *server_;
    if (std::exchange(server.leaves, true)) return;
    world_.tell("the server is told to begin anew");
    server.kept.look(server.session, true);
    server.kept.let_go(false);
    world_.at(world_.now() + kHangs, [this, life] {
        if (lives(life)) throw Crash{Loss::killed};
    });
}

void Centre::leave() {
    world_.tell("the server has ended, and begins anew");
    server_.reset();
    network_.serve_nobody();
    ++outcome_.left;
    disk_.lose(Loss::killed);
}

/// As dds::CommandReaders.
void Centre::hear(const Sent& sent) {
    const std::size_t kind = sent.sample.index();
    const bool levers = kind < 2;
    const auto gate = server_->gates.try_emplace(
        kind, dds::FloodGate::Rate{.per_second = levers ? 500.0 : 20.0, .burst = levers ? 250.0 : 50.0});
    if (!gate.first->second.pass(sent.writer, world_.now())) {
        server_->mailbox.refuse(kind, dds::Mailbox::Unseen::too_fast);
        return;
    }
    server_->mailbox.put(sent.sample, sent.writer, sent.instructor, levers ? sent.moved_in_run : 0);
    checks_.hears(sent);
}

/// As host::HostedExercise.
void Centre::beat(std::uint64_t) {
    if (server_->leaves) return;
    if (world_.now() < stalled_until_) {
        after(stalled_until_ - world_.now(), &Centre::beat);
        return;
    }
    Server& server = *server_;
    run::Session& session = server.session;
    const std::uint64_t before = session.now_tick();
    for (int k = server.pacer.ticks_per_beat(); k > 0; --k)
        tick();
    const auto ticks = static_cast<int>(session.now_tick() - before);
    if (server.kept.wants_checkpoint()) session.take_checkpoint_now();
    const auto now = world_.time();
    server.pacer.beat_ended(std::max(ticks, 0), now);
    if (std::exchange(server.setups, session.setups()) != session.setups())
        server.pacer.set_tick(session.dt(), now);
    if (std::exchange(server.scale, session.status().time_scale) != session.status().time_scale)
        server.pacer.set_scale(session.status().time_scale, now);
    server.pacer.hold_back(session.hand_is_late(), now);
    server.pacer.set_standing(!session.running(), now);
    look_ahead();
    tell();
    after(std::max(world_.seconds(server.pacer.due()) - world_.now(), kBeatCost), &Centre::beat);
}

void Centre::tick() {
    Server& server = *server_;
    run::Session& session = server.session;
    const double now = world_.now();
    if (server.mailbox.empty())
        server.inbox.clear();
    else
        server.mailbox.drain(session.limits(), server.inbox);
    const bool sabotage = !sabotaged_ && session.now_tick() > 900;
    if (sabotage && plan_.sabotage == Sabotage::ghost_hand) {
        sabotaged_ = true;
        server.inbox.orders.push_back(
            {"anna", exercise::Order(exercise::WindlassOrder{.brake = 0.123}), true});
    }
    if (sabotage && plan_.sabotage == Sabotage::question_passed_over && session.held()) {
        run::Inbox start;
        start.orders.push_back({"nobody", run::RunOrder{}, true});
        session.carry_out(start, now);
    }
    session.carry_out(server.inbox, now);
    session.tick((session.now_tick() + 1) % 3 == 0);
    server.kept.look(session);
    if (plan_.sabotage != Sabotage::alert_untold) session.report_keeping(server.kept.trouble());
    if (sabotage && plan_.sabotage == Sabotage::event_lost && !session.events().empty() &&
        session.orders().empty() && session.checkpoint() == nullptr && session.alerts().empty()) {
        sabotaged_ = true;
        session.clear_news();
    }
    checks_.sabotage_order = sabotage && plan_.sabotage == Sabotage::order_altered;
    checks_.sabotage_marks = sabotage && plan_.sabotage == Sabotage::marks_altered;
    checks_.sabotage_taking = sabotage && plan_.sabotage == Sabotage::taking_altered;
    checks_.sabotage_question = plan_.sabotage == Sabotage::question_untold;
    checks_.look(session, server.inbox, now, server.kept.trouble());
    for (const run::QuestionView& question : session.questions())
        answers_.tell(question);
    recorder_.hear(session);
    pages_.tell(session, life_);
    session.clear_news();
}

/// As host::Outlook: a branch is made of a copy of the state and gone through beside the exercise, which goes
/// on as if there were none.
void Centre::look_ahead() {
    Server& server = *server_;
    const run::Session& session = server.session;
    std::optional<Ahead>& ahead = server.ahead;
    if (!session.predicts() || (ahead && ahead->branch.found().run != session.status().run)) ahead.reset();
    if (!session.predicts()) return;
    if (!ahead || (ahead->ticks == 0 && world_.now() >= ahead->rests_until)) {
        Chance& chance = world_.chance();
        const auto state = session.state();
        ahead.emplace(Ahead{.branch = {state, session.status().run},
                            .ticks = static_cast<int>(chance.spread(1, 3000)),
                            .rests_until = world_.now() + chance.spread(2, 20)});
        ++outcome_.predictions;
        ahead->branch.step();
        if (session.state() != state)
            throw Failure{"prediction", "the exercise stays as it is",
                          "another state, as it is looked ahead"};
    }
    for (int k = 0; k < kLookedAhead && ahead->ticks > 0; ++k)
        ahead->ticks = ahead->branch.step() ? ahead->ticks - 1 : 0;
}

void Centre::tell() {
    static constexpr std::uint64_t kEvery = 30; // ticks
    const run::Session& session = server_->session;
    if (session.running() && session.now_tick() % kEvery != 0) return;
    Told told{.run = session.status().run, .state = session.status().state, .time = session.now_time()};
    told.alerts = checks_.open_alerts();
    hands_.tell(std::move(told));
}

/// As the keeper's thread that writes.
void Centre::write(std::uint64_t life) {
    Server& server = *server_;
    const auto place = checks_.place();
    const std::uint64_t before = disk_.errors();
    const bool whole = server.kept.trouble().empty() && !disk_.failed();
    const bool goes_on = server.kept.write_waiting();
    if (!lives(life)) return;
    if (whole && disk_.errors() == before && server.kept.trouble().empty()) {
        server.handed_over = place;
        checks_.handed_over(place);
        if (!goes_on) checks_.left_whole();
    }
    if (!goes_on) throw Left();
    hold_memory();
    after(kWriteEvery + world_.chance().spread(1e-5, 3e-3), &Centre::write);
}

/// As the keeper's thread that waits for the disk.
void Centre::sync(std::uint64_t life) {
    Server& server = *server_;
    const auto place = server.handed_over;
    const std::uint64_t before = disk_.errors();
    server.kept.sync();
    if (!lives(life)) return;
    if (place && disk_.errors() == before) checks_.on_disk(*place);
    after(kSyncEvery, &Centre::sync);
}

/// The disk becomes full, slow or broken, or well again.
void Centre::weather_the_disk(std::uint64_t) {
    Chance& chance = world_.chance();
    disk_.room = std::numeric_limits<std::uint64_t>::max();
    disk_.refuses = false;
    disk_.write_takes = disk_.sync_takes = 0;
    const double drawn = chance.unit();
    if (drawn < 0.15)
        disk_.room = disk_.bytes() + static_cast<std::uint64_t>(chance.spread(1, 100'000));
    else if (drawn < 0.25)
        disk_.refuses = true;
    else if (drawn < 0.45)
        disk_.write_takes = chance.spread(0.001, 8);
    else if (drawn < 0.65)
        disk_.sync_takes = chance.spread(0.01, 8);
    world_.tell(fmt::format("the disk: room {}, {}, writes take {:.3f} s, syncs {:.3f} s", disk_.room,
                            disk_.refuses ? "refuses" : "takes", disk_.write_takes, disk_.sync_takes));
    after(chance.spread(0.5, 40), &Centre::weather_the_disk);
}

/// The machine is stopped, sleeps, or has other work: for the server its clock jumps.
void Centre::stall(std::uint64_t) {
    stalled_until_ = world_.now() + world_.chance().spread(0.01, 30);
    after(world_.chance().spread(1, 120), &Centre::stall);
}

void Centre::hold_memory() {
    if (disk_.bytes_below(kFolder) > kRoomy)
        throw Failure{"memory", "at most " + std::to_string(kRoomy) + " bytes on the disk for an exercise",
                      std::to_string(disk_.bytes_below(kFolder))};
    if (world_.now() < memory_at_) return;
    memory_at_ = world_.now() + kMemoryEvery;
    if (const std::size_t used = mallinfo2().uordblks; used > kMemory)
        throw Failure{"memory", "at most " + std::to_string(kMemory) + " bytes", std::to_string(used)};
}

Outcome Centre::run() {
    try {
        const double longest = 60 * plan_.minutes * 20; // s: it stands still now and then, and is hurried
        bool restart = true;
        while (checks_.seen() < end_ && world_.now() < longest) {
            try {
                if (std::exchange(restart, false)) start();
                world_.run_until(world_.now() + 0.05);
            } catch (const Crash& crash) {
                lose(crash.how);
                world_.run_until(world_.now() + world_.chance().spread(0.2, 10));
                restart = true;
            } catch (const Left&) {
                leave();
                world_.run_until(world_.now() + anew_.spread(0.2, 1));
                restart = true;
            }
        }
        if (server_) checks_.end();
        recorder_.end();
        pages_.end();
    } catch (const Failure& failure) {
        outcome_.failed = {failure, checks_.tick(), world_.now()};
    } catch (const std::exception& error) {
        outcome_.failed = {{"server", "nothing is thrown", error.what()}, checks_.tick(), world_.now()};
    }
    outcome_.ticks = checks_.seen();
    outcome_.exercised = static_cast<double>(checks_.seen()) / def_.tick_rate_hz;
    outcome_.simulated = world_.now();
    const Checks::Counts& counts = checks_.counts();
    outcome_.takings = counts.takings;
    outcome_.questions = counts.questions, outcome_.answered = counts.answered;
    outcome_.passed_over = counts.passed_over, outcome_.stood_again = counts.stood_again;
    outcome_.digest = checks_.digest() ^ pages_.digest();
    outcome_.recordings = recorder_.recordings();
    outcome_.recorder_kills = recorder_.kills();
    outcome_.pages = pages_.opened();
    outcome_.sent_away = pages_.sent_away();
    outcome_.taken = pages_.taken();
    outcome_.stations = pages_.killed();
    return outcome_;
}

} // namespace

Outcome run(const Plan& plan) {
    return std::make_unique<Centre>(plan)->run();
}

} // namespace windlass::sim
