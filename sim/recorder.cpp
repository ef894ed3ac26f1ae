#include "sim/recorder.hpp"

#include "server/dds/convert.hpp"
#include "server/dds/order_taken.hpp"
#include "sim/told_topics.hpp"

#include "idl/payload.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string_view>
#include <utility>

namespace windlass::sim {

namespace {

const std::filesystem::path kRecordings = "/recordings";
constexpr double kTapeEvery = 0.1, kFlushEvery = 1;                 // s, as recorder record
constexpr std::int64_t kRecordedFrom = 1'800'000'000'000'000'000LL; // ns since 1970
constexpr std::size_t kRecordingsKept = 3;
constexpr std::size_t kShortened = 4000; // bytes

template <class Sample>
std::size_t row_of(const wire::Topic<Sample>& topic) {
    const auto& all = wire::topics::all;
    const auto same = [&](const wire::TopicInfo& one) { return std::string_view(one.name) == topic.name; };
    return static_cast<std::size_t>(std::ranges::find_if(all, same) - all.begin());
}

} // namespace

Recorder::Process::Process(std::filesystem::path folder, std::size_t queue_size,
                           const recorder::QueueClock& clock, recorder::TapeOptions options, SimDisk& disk)
    : queue(queue_size, clock),
      tape(std::move(options), disk),
      recorded{.folder = std::move(folder)},
      flushes_at(0) {}

Recorder::Recorder(World& world, std::uint64_t seed, Sabotage sabotage)
    : world_(world), chance_(seed), disk_(world, chance_), sabotage_(sabotage) {
    begin_in(0);
    world_.at(chance_.spread(1, 60), [this] { weather_the_disk(); });
}

/// Of this recorder, or until the next one begins. Only a recorder can be lost in it: the server's are other
/// calls, and a slow disk of the recorder's lets nobody come in between.
template <class What>
void Recorder::after(double seconds, What what) {
    world_.at(world_.now() + seconds, [this, life = life_, what] {
        if (life != life_) return;
        try {
            (this->*what)();
        } catch (const Crash& crash) {
            lose(crash.how);
        }
    });
}

// ---- what it hears

std::int64_t Recorder::unix_ns(double at) const {
    return kRecordedFrom + static_cast<std::int64_t>(std::llround(1e9 * at));
}

void Recorder::server_begins() {
    ++servers_;
    sequences_ = {};
}

template <class Sample, class View>
void Recorder::publish(const wire::Topic<Sample>& topic, const View& view, Samples& samples) {
    recorder::Sample& made = samples.emplace_back();
    made.topic = row_of(topic);
    for (std::size_t k = 0; k < 8; ++k)
        made.writer[k] = static_cast<std::uint8_t>(servers_ >> (8 * k));
    made.writer[8] = static_cast<std::uint8_t>(made.topic);
    made.sequence = ++sequences_[made.topic];
    if (!listens(life_)) return; // nobody asks what is in it
    Sample sample;
    dds::convert(view, sample);
    made.payload = wire::encode(sample);
}

void Recorder::hear(const run::Session& session) {
    Samples samples;
    for (const auto& event : session.events())
        publish(wire::topics::event, event, samples);
    for (const auto& alert : session.alerts())
        on_topics_of(alert, [&](const auto& topic) { publish(topic, alert, samples); });
    for (const auto& order : session.orders())
        publish(wire::topics::order_taken, order, samples);
    if (const auto& assessment = session.assessment())
        publish(wire::topics::assessment, *assessment, samples);
    if (const auto* checkpoint = session.checkpoint())
        publish(wire::topics::checkpoint, *checkpoint, samples);
    if (!samples.empty()) send(std::move(samples));
}

/// Reliable: late, in order, and nothing lost but for who is not there.
void Recorder::send(Samples samples) {
    const double now = world_.now();
    if (now > congested_until_ && chance_.in(0.001)) congested_until_ = now + chance_.spread(0.2, 4);
    arrived_ = std::max(arrived_, std::max(now, congested_until_) + chance_.spread(0.0002, 0.02));
    const std::uint64_t to = listens(life_) ? life_ : 0;
    world_.at(arrived_, [this, to, now, sent = std::make_shared<Samples>(std::move(samples))] {
        arrive(to, now, *sent);
    });
}

void Recorder::arrive(std::uint64_t life, double sent, Samples& samples) {
    for (recorder::Sample& sample : samples) {
        if (!listens(life)) {
            account(sample);
            continue;
        }
        Recorded& recorded = process_->recorded;
        if (sabotage_ == Sabotage::recording_deaf && recorded.heard.size() > 20 &&
            !std::exchange(sabotaged_, true))
            continue;
        account(sample);
        const HeardSample heard{.topic = sample.topic,
                                .writer = sample.writer,
                                .sequence = sample.sequence,
                                .log_time = unix_ns(world_.now()),
                                .publish_time = unix_ns(sent),
                                .payload = hash_of(sample.payload)};
        if (sabotage_ == Sabotage::recording_doubled && recorded.heard.size() > 20 &&
            !std::exchange(sabotaged_, true))
            process_->queue.push(recorder::Sample(sample), unix_ns(sent));
        if (process_->queue.push(std::move(sample), unix_ns(sent)))
            recorded.heard.push_back(heard);
        else
            ++recorded.dropped;
    }
}

/// Across the recordings: each sample comes to the recorder that listens, or to nobody as none does.
void Recorder::account(const recorder::Sample& sample) {
    std::uint32_t& last = accounted_[sample.writer];
    if (sample.sequence != last + 1)
        throw Failure{"recording",
                      fmt::format("sample {} of {}, heard or between two recordings", last + 1,
                                  wire::topics::all[sample.topic].name),
                      fmt::format("sample {}", sample.sequence)};
    last = sample.sequence;
}

// ---- what it does

void Recorder::begin_in(double seconds) {
    ++life_;
    after(seconds, &Recorder::begin);
}

/// As the door begins it.
void Recorder::begin() {
    const double how = chance_.unit();
    ends_at_ = std::numeric_limits<double>::infinity();
    disk_.lose_in(0, Loss::killed);
    if (how < 0.4)
        disk_.lose_in(1 + static_cast<std::uint64_t>(chance_.spread(1, 300)), Loss::killed);
    else if (how < 0.7)
        world_.at(world_.now() + chance_.spread(0.01, 60), [this, life = life_] {
            if (life == life_ && process_) lose(Loss::killed);
        });
    else
        ends_at_ = world_.now() + chance_.spread(0.5, 60);
    const double compressed = chance_.unit();
    const auto folder = kRecordings / fmt::format("anna_{:06}", ++folders_);
    recorder::TapeOptions options{.folder = folder,
                                  .compression = compressed < 0.2   ? mcap::Compression::none
                                                 : compressed < 0.4 ? mcap::Compression::lz4
                                                                    : mcap::Compression::zstd,
                                  .metadata = {{"recording", folder.filename().string()}}};
    if (chance_.in(0.3)) options.roll_size = static_cast<std::uint64_t>(chance_.spread(400'000, 3'000'000));
    const auto queue_size =
        static_cast<std::size_t>(chance_.in(0.2) ? chance_.spread(20'000, 200'000) : 64e6);
    const auto now = [this] { return unix_ns(world_.now()); };
    disk_.took = 0;
    try {
        process_.emplace(folder, queue_size, recorder::QueueClock{.wall = now, .steady = now}, options,
                         disk_);
    } catch (const mcap::WriteError& refused) {
        world_.tell(fmt::format("no recorder begins: {}", refused.what()));
        begin_in(*disk_.took + chance_.spread(1, 10));
        return;
    }
    ++recordings_;
    clear_away_old();
    world_.tell(fmt::format("a recorder begins: {}", folder.filename().string()));
    process_->flushes_at = world_.now() + kFlushEvery;
    after(*disk_.took + kTapeEvery, &Recorder::step);
}

void Recorder::step() {
    Process& process = *process_;
    disk_.took = 0;
    try {
        process.feed.write_what_came(std::chrono::milliseconds(0));
        if (world_.now() >= ends_at_) {
            process.listens = false;
            close("stopped");
        } else if (world_.now() >= process.flushes_at) {
            process.flushes_at = world_.now() + kFlushEvery;
            if (sabotage_ != Sabotage::recording_unflushed) process.tape.flush();
            process.recorded.flushed = process.recorded.heard.size();
        }
    } catch (const mcap::WriteError& refused) {
        world_.tell(fmt::format("the recorder's disk refuses: {}", refused.what()));
        process.listens = false;
        process.recorded.refused = true;
        process.feed.give_up();
        try {
            close(refused.what());
        } catch (const mcap::WriteError&) {
            world_.tell("there is no room for the summary either");
        }
    }
    if (process.listens)
        after(*disk_.took + kTapeEvery, &Recorder::step);
    else
        after(*disk_.took, &Recorder::finish);
}

void Recorder::close(const char* because) {
    Process& process = *process_;
    process.tape.close(process.feed.closing("now", because));
    process.closed = true;
    if (process.feed.heard_something()) return;
    process.tape.discard();
    process.discarded = true;
    if (!disk_.refuses && disk_.exists(process.recorded.folder))
        throw Failure{"recording", "nothing, as nothing was heard", process.recorded.folder.string()};
}

/// The program ends: its disk has what it waited for.
void Recorder::finish() {
    world_.tell("the recorder has ended");
    Recorded recorded = std::move(process_->recorded);
    recorded.ended = true, recorded.closed = process_->closed;
    const bool discarded = process_->discarded;
    process_.reset();
    disk_.lose(Loss::killed);
    if (!discarded) hold(std::move(recorded));
    begin_in(chance_.spread(0.2, 5));
}

void Recorder::lose(Loss how) {
    std::optional<Recorded> lost;
    if (process_ && !process_->discarded) lost = std::move(process_->recorded);
    process_.reset();
    disk_.lose(how);
    if (how == Loss::killed) {
        world_.tell("the recorder is killed");
        ++kills_;
    } else {
        for (Recorded& recorded : kept_) {
            recorded.power_cut = true;
            hold_recording(disk_, recorded);
        }
        if (lost) lost->power_cut = true;
    }
    if (lost) hold(*std::move(lost));
    begin_in(chance_.spread(0.2, 10));
}

void Recorder::lose_power() {
    lose(Loss::power_cut);
    // A disk that was full or broken may be so still, but not for ever.
    if (chance_.in(0.7)) disk_.refuses = false, disk_.room = std::numeric_limits<std::uint64_t>::max();
}

void Recorder::end() {
    if (process_ && !process_->discarded) hold(std::move(process_->recorded));
    process_.reset();
}

void Recorder::hold(Recorded recorded) {
    if (sabotage_ == Sabotage::recording_shortened) disk_.lose_the_end(".mcap", kShortened);
    hold_recording(disk_, recorded);
    kept_.push_back(std::move(recorded));
    if (kept_.size() > kRecordingsKept) kept_.pop_front();
}

/// An instructor has no use for them any more.
void Recorder::clear_away_old() {
    for (const auto& folder : disk_.list(kRecordings)) {
        const bool kept =
            std::ranges::any_of(kept_, [&](const Recorded& recorded) { return recorded.folder == folder; });
        if (!kept && folder != process_->recorded.folder) disk_.clear_away(folder);
    }
}

/// It becomes full, slow or broken, or well again.
void Recorder::weather_the_disk() {
    disk_.room = std::numeric_limits<std::uint64_t>::max();
    disk_.refuses = false;
    disk_.write_takes = disk_.sync_takes = 0;
    const double drawn = chance_.unit();
    if (drawn < 0.15)
        disk_.room = disk_.bytes() + static_cast<std::uint64_t>(chance_.spread(1, 1'000'000));
    else if (drawn < 0.25)
        disk_.refuses = true;
    else if (drawn < 0.45)
        disk_.write_takes = chance_.spread(0.001, 8);
    else if (drawn < 0.65)
        disk_.sync_takes = chance_.spread(0.01, 8);
    world_.tell(fmt::format("the recorder's disk: room {}, {}, writes take {:.3f} s, syncs {:.3f} s",
                            disk_.room, disk_.refuses ? "refuses" : "takes", disk_.write_takes,
                            disk_.sync_takes));
    world_.at(world_.now() + chance_.spread(0.5, 40), [this] { weather_the_disk(); });
}

} // namespace windlass::sim
