#include "server/host/classroom.hpp"

#include "common/text.hpp"
#include "server/dds/convert.hpp"
#include "server/run/briefing.hpp"
#include "words/words.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>

namespace windlass::host {

namespace {

using Clock = std::chrono::steady_clock;
using exercise::Severity;

constexpr std::size_t kWaiting = 16;                                  // commands; a definition may be long
constexpr dds::FloodGate::Rate kOrders{.per_second = 5, .burst = 64}; // of one writer: a classroom at once
constexpr std::chrono::milliseconds kLookEvery{100};
constexpr std::chrono::seconds kTellEvery{1};
constexpr std::chrono::milliseconds kToldWaiting{500}; // a client waits for some seconds for an answer

double seconds() {
    return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

std::string quoted(const std::string& text) {
    return '"' + printable(text) + '"';
}

run::Refusal refused(const ClassroomCommand& sample, const char* field, std::string value,
                     std::string allowed) {
    return {.topic = wire::topics::classroom_command.name,
            .source = printable(sample.origin().source().to_string()),
            .field = field,
            .value = std::move(value),
            .allowed = std::move(allowed),
            .side = -1,
            .number = 0};
}

void convert(const HostedStatus& from, ClassroomExercise& to) {
    to.id(from.id);
    to.exercise(std::string(clipped(from.run.exercise, 64)));
    to.title(std::string(clipped(from.run.title_instructor, 256)));
    to.state(static_cast<RunState>(from.run.state));
    to.tick(from.tick);
    to.time(from.time);
    to.time_scale(from.run.time_scale);
    to.time_scale_achieved(from.run.time_scale_achieved);
    to.load(from.load);
    to.lateness(from.worst_lateness);
    to.overruns(from.run.overruns);
    to.commands_refused(from.run.commands_refused);
    to.since_unix_ns(from.since_unix_ns);
    to.failure(std::string(clipped(printable(from.failure), 256)));
}

/// What must be told at once: the exercises that there are, their states, and who else is there.
bool same_state(const ClassroomStatus& a, const ClassroomStatus& b) {
    return a.neighbours() == b.neighbours() &&
           std::equal(a.exercises().begin(), a.exercises().end(), b.exercises().begin(), b.exercises().end(),
                      [](const auto& one, const auto& other) {
                          return one.id() == other.id() && one.state() == other.state() &&
                                 one.exercise() == other.exercise();
                      });
}

} // namespace

Classroom::Classroom(wire::Participant& member, std::string name, Host& host, unsigned threads,
                     ExerciseSource source, std::function<double()> load)
    : name_(std::move(name)),
      host_(host),
      source_(std::move(source)),
      load_(std::move(load)),
      gate_(kOrders),
      status_writer_(member, wire::topics::classroom_status),
      event_writer_(member, wire::topics::event),
      neighbours_(member, status_writer_.id()),
      commands_(
          member, wire::topics::classroom_command,
          [this](const ClassroomCommand& sample, const wire::WriterId& writer) { hear(sample, writer); },
          [this] {
              const std::lock_guard lock(mutex_);
              ++malformed_;
          }) {
    status_.server(name_);
    status_.threads(threads);
    status_.max_exercises(Host::kMaxExercises);
}

void Classroom::hear(const ClassroomCommand& sample, const wire::WriterId& writer) {
    // What is for another server is the other's to judge; what is for none is refused by all.
    if (const auto server = sample.server().to_string(); !server.empty() && server != name_) return;
    const std::lock_guard lock(mutex_);
    if (waiting_.size() < kWaiting && gate_.pass(writer, seconds())) {
        waiting_.push_back({sample, writer});
    } else {
        ++too_many_;
    }
}

void Classroom::meet_others() {
    neighbours_.meet();
    name_taken_ = neighbours_.has_namesake(name_);
}

void Classroom::serve() {
    std::vector<Received> received;
    std::uint64_t too_many = 0, malformed = 0;
    {
        const std::lock_guard lock(mutex_);
        if (orders_.empty()) received.swap(waiting_);
        too_many = std::exchange(too_many_, 0);
        malformed = std::exchange(malformed_, 0);
    }
    while (const auto told = refusals_.overdue(seconds()))
        log_refused(*told);
    refuse_unseen(too_many, "rate", "of one writer 5 a second, 64 at once; of all 16 at a time");
    refuse_unseen(malformed, "payload",
                  "CDR of the topic's type, every sequence and string within its bound");
    orders_.insert(orders_.end(), received.begin(), received.end());
    const bool any = creating_ || !orders_.empty();
    while (creating_ || !orders_.empty()) {
        if (creating_ && !creating_->reading.done() &&
            !creating_->reading.hangs(
                std::chrono::duration<double>(Clock::now() - creating_->since).count())) {
            if (Clock::now() - creating_->since >= kToldWaiting) tell_waiting();
            break;
        }
        if (creating_) {
            create();
        } else {
            carry_out(orders_.front());
            orders_.pop_front();
        }
    }
    if ((any && !creating_) || Clock::now() - looked_ >= kLookEvery) {
        looked_ = Clock::now();
        give_way();
        name_taken_ = neighbours_.has_elder_namesake(status_);
        tell_status();
    }
}

std::optional<run::Refusal> Classroom::refusal(const Received& received) {
    const ClassroomCommand& sample = received.sample;
    const auto& origin = sample.origin();
    const std::string source = origin.source().to_string();
    if (source.empty() || source == run::kServerName || printable(source) != source)
        return refused(sample, "origin.source", quoted(source), "the name of the sender, 1..32 characters");
    if (sample.server().to_string() != name_)
        return refused(sample, "server", "\"\"", "the name of a server, e.g. " + name_);
    if (sample.action() != CLASSROOM_CREATE && sample.action() != CLASSROOM_REMOVE)
        return refused(sample, "action", fmt::format("{}", static_cast<std::uint32_t>(sample.action())),
                       "CLASSROOM_CREATE or CLASSROOM_REMOVE");
    if (const auto id = sample.id().to_string(); !wire::is_exercise_name(id))
        return refused(sample, "id", quoted(id), "1 to 64 letters, digits, - _ .");
    if (const auto last = serials_.accept(0, received.writer, source, origin.serial()))
        return refused(sample, "origin.serial", fmt::format("{}", origin.serial()),
                       fmt::format("above {}, the last one accepted", *last));
    return std::nullopt;
}

void Classroom::carry_out(const Received& received) {
    const ClassroomCommand& order = received.sample;
    if (const auto why = refusal(received)) return refuse(*why);
    const std::string source = order.origin().source().to_string();
    const std::string id = order.id().to_string();
    if (order.action() == CLASSROOM_CREATE) {
        if (const auto why = begin_create(received)) refuse(*why);
    } else if (host_.close(id, "removed by " + source)) {
        log("classroom.removed", fmt::format("exercise {} removed by {}", id, source));
    } else {
        refuse(refused(order, "id", quoted(id), "an exercise of this server"));
    }
}

std::optional<run::Refusal> Classroom::begin_create(const Received& received) {
    const ClassroomCommand& order = received.sample;
    const std::string id = order.id().to_string();
    if (host_.has(id)) return refused(order, "id", quoted(id), "a name not in use; this server has it");
    if (const auto other = server_of(id); !other.empty())
        return refused(order, "id", quoted(id), "a name not in use; server " + printable(other) + " has it");
    if (const double load = load_(), threads = status_.threads(); load > kMaxLoad * threads)
        return refused(
            order, "server", quoted(name_),
            fmt::format("one with room: its exercises take {:.2f} of {} threads' time, and none is created "
                        "beyond {:.2f}",
                        load, threads, kMaxLoad * threads));
    const std::string file = order.exercise().to_string();
    const std::string text(order.definition().begin(), order.definition().end());
    if (file.empty() == text.empty())
        return refused(order, "exercise", quoted(file), "a file name, or a definition in place of it");
    if (text.empty() && !run::stays_in_folder(file))
        return refused(order, "exercise", quoted(file), "a file name inside the server's exercise folder");
    creating_ = {.received = received,
                 .reading = text.empty() ? source_.load(file) : source_.parse(text, "definition"),
                 .since = Clock::now()};
    return std::nullopt;
}

/// Says once of each order that it takes its time, since an exercise is being read: whoever gave it waits.
/// What is read at once is not told of, so that a flood of orders does not fill the log.
void Classroom::tell_waiting() {
    const auto tell = [this](Received& order) {
        if (std::exchange(order.told, true)) return;
        log("classroom.reading",
            fmt::format("exercise {}: the order of {} takes its time, an exercise is being read",
                        printable(order.sample.id().to_string()),
                        printable(order.sample.origin().source().to_string())));
    };
    tell(creating_->received);
    std::ranges::for_each(orders_, tell);
}

/// Opens the exercise that was read, or says why not.
void Classroom::create() {
    Creating done = std::move(*creating_);
    creating_.reset();
    const ClassroomCommand& order = done.received.sample;
    const std::string id = order.id().to_string(), source = order.origin().source().to_string();
    try {
        if (!done.reading.done())
            throw std::runtime_error(fmt::format("read within {:g} s", run::kReadingTime));
        auto def = done.reading.def.get();
        if (order.practice()) run::put_to_practice(def);
        host_.open(id, def, source_.options(order.wait()));
        log("classroom.created", fmt::format("exercise {} ({}) created by {}", id, def.name, source));
    } catch (const std::exception& error) { // a definition that cannot be used, or no room for it
        const std::string file = order.exercise().to_string();
        refuse(refused(order, file.empty() ? "definition" : "exercise",
                       file.empty() ? fmt::format("{} bytes", order.definition().size()) : quoted(file),
                       printable(error.what())));
    }
}

/// Two servers may have opened one name before they heard of each other: when the network was cut, or both
/// were started at once.
void Classroom::give_way() {
    for (const auto& mine : host_.status()) {
        const auto first = neighbours_.earlier(mine.id, mine.since_unix_ns, name_);
        if (first.empty()) continue;
        gave_way_ = true;
        host_.close(mine.id, "server " + printable(first) + " has exercise " + mine.id + " already");
        log("classroom.gave_way",
            fmt::format("exercise {} closed by {}: server {} has one of this name already", mine.id, name_,
                        printable(first)));
    }
}

void Classroom::tell_status() {
    ClassroomStatus now = status_;
    now.neighbours(static_cast<std::uint32_t>(neighbours_.count()));
    now.exercises().clear();
    for (const auto& one : host_.status())
        convert(one, now.exercises().emplace_back());
    if (same_state(now, status_) && Clock::now() - told_ < kTellEvery) return;
    told_ = Clock::now();
    status_ = std::move(now);
    status_writer_.write(status_);
}

void Classroom::refuse(const run::Refusal& refusal) {
    if (const auto told = refusals_.add(refusal, seconds())) log_refused(*told);
}

void Classroom::log_refused(const run::RefusalLog::Told& refusal) {
    log("command.refused", refusal.text);
}

/// Of samples that were not looked at no more can be told than their number.
void Classroom::refuse_unseen(std::uint64_t samples, const char* field, const char* allowed) {
    if (samples == 0) return;
    refuse({.topic = wire::topics::classroom_command.name,
            .source = "",
            .field = field,
            .value = fmt::format("{} samples", samples),
            .allowed = allowed,
            .side = -1,
            .number = static_cast<double>(samples),
            .samples = samples});
}

void Classroom::log(words::EventCode code, std::string text) {
    const Severity severity = code.row().severity;
    spdlog::log(severity == Severity::info    ? spdlog::level::info
                : severity == Severity::alarm ? spdlog::level::err
                                              : spdlog::level::warn,
                "{}: {}", code.row().name, text);
    Event event;
    dds::convert(exercise::ExerciseEvent{.tick = 0,
                                         .time = 0,
                                         .number = ++events_,
                                         .severity = severity,
                                         .code = std::string(code.row().name),
                                         .side = -1,
                                         .value = 0,
                                         .text = std::move(text)},
                 event);
    event_writer_.write(event);
}

} // namespace windlass::host
