#include "server/keep/kept_exercise.hpp"

#include "server/keep/beginning.hpp"

#include "server/dds/convert.hpp"
#include "server/dds/order_taken.hpp"

#include "idl/payload.hpp"
#include "idl/topics.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <utility>

namespace windlass::keep {

namespace fs = std::filesystem;

namespace {

using namespace std::chrono_literals;
using exercise::RunState;

constexpr std::size_t kMaxWaiting = 4096; // orders and checkpoints; levers alone make some 60 a second
constexpr std::uint64_t kLong = 4 << 20;  // bytes: a paused exercise takes no checkpoints, but levers
constexpr auto kPatience = 3s;            // with a disk, before it is told of
constexpr auto kClosing = 3s;
constexpr std::string_view kAttempts = ".attempts";
constexpr std::string_view kSetBack = "-set-back";

std::vector<fs::path> files_of(const fs::path& folder, std::string_view ending, files::Disk& disk) {
    std::vector<fs::path> files;
    for (fs::path& path : disk.list(folder))
        if (path.extension() == ending) files.push_back(std::move(path));
    return files;
}

/// The last that a file there has, of whatever kind.
std::uint64_t last_number(const fs::path& folder, files::Disk& disk) {
    std::uint64_t last = 0;
    for (const fs::path& path : disk.list(folder))
        last = std::max(last, number_of(path));
    return last;
}

/// Where it can be removed.
void try_to_remove(files::Disk& disk, const fs::path& path) {
    try {
        disk.remove(path);
    } catch (const std::system_error&) { // it stays, then
    }
}

std::string slow(const fs::path& folder) {
    return fmt::format("{}: what is written does not come to the disk within {} s", folder.string(),
                       kPatience.count());
}

} // namespace

std::uint64_t number_of(const fs::path& file) {
    return std::strtoull(file.stem().c_str(), nullptr, 10);
}

std::vector<fs::path> kept_files(const fs::path& folder, files::Disk& disk) {
    std::vector<fs::path> files = files_of(folder, ".kept", disk);
    std::ranges::sort(files, {}, number_of);
    return files;
}

fs::path set_back_file(const fs::path& behind) {
    return behind.parent_path() / fmt::format("{:06}{}.kept", number_of(behind) + 1, kSetBack);
}

bool is_set_back(const fs::path& file) {
    return file.stem().native().ends_with(kSetBack);
}

fs::path attempts_file(const fs::path& folder, std::uint64_t settled) {
    return folder / fmt::format("{:06}{}", settled, kAttempts);
}

std::vector<fs::path> attempts_files(const fs::path& folder, files::Disk& disk) {
    return files_of(folder, kAttempts, disk);
}

void forget_attempts(const fs::path& folder, files::Disk& disk) {
    for (const fs::path& file : attempts_files(folder, disk))
        disk.remove(file);
}

void remove_kept(const fs::path& folder, files::Disk& disk) {
    for (const fs::path& file : kept_files(folder, disk)) // the newest last: an earlier state is not taken up
        try_to_remove(disk, file);
    for (const fs::path& file : attempts_files(folder, disk))
        try_to_remove(disk, file);
    try_to_remove(disk, folder);
}

void settle(files::Disk& disk, std::initializer_list<fs::path> folders) {
    for (const fs::path& folder : folders) {
        try {
            disk.sync_folder(folder);
        } catch (const std::system_error&) { // a disk that refuses hinders nobody
        }
    }
}

KeptExercise::KeptExercise(fs::path folder, std::string id, std::uint64_t definition_hash, files::Disk& disk,
                           Now now)
    : folder_(std::move(folder)),
      id_(std::move(id)),
      definition_hash_(definition_hash),
      disk_(disk),
      now_(std::move(now)),
      before_(kept_files(folder_, disk_)),
      number_(last_number(folder_, disk_)) {}

// ---- the thread that ticks

void KeptExercise::put(News news) {
    if (gap_ || pending_.size() >= kMaxWaiting)
        gap_ = true;
    else
        pending_.push_back(std::move(news));
}

/// Orders that a checkpoint has in it go before it, and all others behind it.
void KeptExercise::collect(const run::Session& session) {
    const run::CheckpointView* checkpoint = session.checkpoint();
    const auto before = [&](const run::OrderView& order) {
        return checkpoint != nullptr &&
               (order.run != checkpoint->run || order.number <= checkpoint->orders_taken);
    };
    for (const auto& order : session.orders())
        if (before(order)) put(order);
    if (checkpoint != nullptr) {
        if (pending_.empty()) gap_ = false; // from here on nothing is missing
        put(*checkpoint);
    }
    for (const auto& order : session.orders())
        if (!before(order)) put(order);
}

void KeptExercise::look(const run::Session& session, bool last) {
    const run::RunStatus& status = session.status();
    const bool over = status.state == RunState::finished || status.state == RunState::stopped_by_fault;
    if (over)
        pending_.clear();
    else
        collect(session);
    std::unique_lock lock(mutex_, std::defer_lock);
    if (last)
        lock.lock();
    else if (!lock.try_lock()) // the exercise waits for nobody who writes
        return;
    const auto now = now_();
    if (session.kept_course().first != 0) resumed_ = Resumed{status.run, session.kept_course()};
    if (waiting_.empty() && !reached_) waits_since_ = now;
    if (over) {
        if (!std::exchange(end_told_, true)) over_ = true;
        waiting_.clear();
        reached_.reset();
    } else if (waiting_.size() + pending_.size() > kMaxWaiting) {
        gap_ = true;
    } else {
        std::ranges::move(pending_, std::back_inserter(waiting_));
    }
    pending_.clear();
    if (!over) end_told_ = false;
    if (!gap_ && !over)
        reached_ = Reached{.state = {.tick = session.now_tick(),
                                     .time = session.now_time(),
                                     .state_hash = session.seen() ? session.snapshot().state_hash : 0,
                                     .definition_hash = status.definition_hash,
                                     .run = status.run,
                                     .orders_taken = session.seen() ? status.orders_taken : 0,
                                     .format = 0,
                                     .data = {}},
                           .run_state = session.held() ? RunState::running : status.state,
                           .time_scale = status.time_scale};
    if (disk_is_slow(now))
        trouble_ = slow(folder_);
    else if (trouble_ != failure_)
        trouble_ = failure_;
}

/// To be called with the mutex.
bool KeptExercise::disk_is_slow(Clock::time_point now) const {
    const bool all_there = to_sync_.file == synced_.file && to_sync_.size == synced_.size;
    return gap_ || now - waits_since_ > kPatience || (!all_there && now - to_sync_.since > kPatience);
}

void KeptExercise::let_go(bool in_order) {
    const std::lock_guard lock(mutex_);
    if (in_order) {
        over_ = true;
        waiting_.clear();
        reached_.reset();
    }
    closing_ = true;
}

void KeptExercise::close(bool in_order) {
    let_go(in_order);
    std::unique_lock lock(mutex_);
    closed_.wait_for(lock, kClosing, [this] { return gone_; });
}

// ---- the thread that writes

bool KeptExercise::write_waiting() {
    std::optional<Reached> reached;
    std::optional<Resumed> resumed;
    bool over = false, closing = false;
    {
        const std::lock_guard lock(mutex_);
        writing_.swap(waiting_);
        reached = std::exchange(reached_, std::nullopt);
        resumed = std::exchange(resumed_, std::nullopt);
        over = std::exchange(over_, false);
        closing = closing_;
    }
    if (resumed && begun_ == 0) run_ = resumed->run, course_ = resumed->course;
    try {
        if (over) remove_all();
        for (const News& news : writing_) {
            if (const auto* order = std::get_if<run::OrderView>(&news))
                write(*order);
            else
                write(std::get<run::CheckpointView>(news), reached);
        }
        if (reached) write(*reached);
        if (file_ && std::exchange(news_, false)) {
            file_->write();
            const std::lock_guard lock(mutex_);
            if (to_sync_.file == synced_.file && to_sync_.size == synced_.size) to_sync_.since = now_();
            to_sync_.file = file_, to_sync_.size = file_->size();
        }
        note_synced();
        if (closing && !over) forget_attempts(folder_, disk_);
    } catch (const std::exception& error) {
        fail(error.what());
    }
    writing_.clear();
    const std::lock_guard lock(mutex_);
    gone_ = closing;
    if (closing) closed_.notify_all();
    return !closing;
}

void KeptExercise::write(const run::OrderView& order) {
    if (!file_ || order.run != run_) return;
    dds::convert(order, order_);
    file_->add(Record::order, wire::encode(order_));
    news_ = true;
}

/// reached: how far the exercise has come by now.
void KeptExercise::write(const run::CheckpointView& checkpoint, const std::optional<Reached>& reached) {
    if (file_) { // what came before stands whole, should the next file not
        if (checkpoint.run == run_) add_reached(checkpoint);
        file_->write();
        before_.push_back(file_->path());
        file_.reset();
    }
    disk_.make_folder(folder_);
    const fs::path path = folder_ / fmt::format("{:06}.kept", ++number_);
    run::KeptCourse course = course_;
    if (course.first == 0 || checkpoint.run != run_) course = {.first = number_, .settled = number_};
    if (begun_ > 0) course.settled = number_; // it came on from where it was taken up
    try {
        auto file = std::make_shared<KeptWriter>(path, disk_);
        file->add(Record::beginning, encode(Beginning{.orders = wire::topics::order_taken.type,
                                                      .format = checkpoint.format,
                                                      .id = id_,
                                                      .definition_hash = definition_hash_,
                                                      .course = course}));
        // Before the checkpoint, with which the file is whole: whoever takes it up knows whether it ran.
        const auto of_its_run = [&](const std::optional<Reached>& one) {
            return one && one->state.run == checkpoint.run;
        };
        status_.reset();
        if (of_its_run(reached))
            add_status(*file, *reached);
        else if (of_its_run(last_))
            add_status(*file, *last_);
        dds::convert(checkpoint, checkpoint_);
        file->add(Record::checkpoint, wire::encode(checkpoint_));
        file->write();
        file_ = std::move(file);
    } catch (...) {
        try_to_remove(disk_, path);
        throw;
    }
    run_ = checkpoint.run;
    course_ = course;
    last_.reset();
    noted_ = 0;
    long_ = false;
    ++begun_;
    news_ = true;
    const std::lock_guard lock(mutex_);
    failure_.clear();
}

void KeptExercise::add_reached(run::CheckpointView state) {
    state.data.clear();
    dds::convert(state, checkpoint_);
    file_->add(Record::reached, wire::encode(checkpoint_));
}

void KeptExercise::add_status(KeptWriter& file, const Reached& reached) {
    ExerciseStatus status;
    status.tick(reached.state.tick);
    status.time(reached.state.time);
    status.run(reached.state.run);
    status.state(static_cast<windlass::RunState>(reached.run_state));
    status.time_scale(reached.time_scale);
    file.add(Record::status, wire::encode(status));
    status_ = reached;
}

void KeptExercise::write(const Reached& reached) {
    if (!file_ || reached.state.run != run_) return;
    if (!status_ || status_->run_state != reached.run_state || status_->time_scale != reached.time_scale) {
        add_status(*file_, reached);
        news_ = true;
    }
    if (!last_ || last_->state.tick != reached.state.tick ||
        last_->state.orders_taken != reached.state.orders_taken) {
        add_reached(reached.state);
        news_ = true;
    }
    last_ = reached;
    if (file_->size() > kLong) long_ = true;
}

/// Says in the file what the disk has of it, and lets go of what that makes needless.
void KeptExercise::note_synced() {
    std::uint64_t synced = 0;
    {
        const std::lock_guard lock(mutex_);
        if (!file_ || synced_.file != file_ || synced_.size == noted_) return;
        synced = synced_.size;
    }
    if (noted_ == 0) prune();
    noted_ = synced;
    std::array<std::uint8_t, sizeof synced> payload{};
    std::memcpy(payload.data(), &synced, sizeof synced);
    file_->add(Record::synced, payload);
    file_->write(); // by itself it is not worth to be waited for again
}

/// One file of this course before this one is enough, once the disk has this one. The first since the
/// server's start has what was taken up: until the exercise has come to its next checkpoint, that may be what
/// ends the server.
void KeptExercise::prune() {
    if (begun_ < 2) return;
    while (before_.size() > 1 || (!before_.empty() && number_of(before_.front()) < course_.first)) {
        disk_.remove(before_.front());
        before_.erase(before_.begin());
    }
    for (const fs::path& file : attempts_files(folder_, disk_))
        if (number_of(file) < course_.settled) disk_.remove(file);
}

/// The disk has refused: what is in the file stays, and no more comes to it.
void KeptExercise::fail(const std::string& why) {
    if (file_) before_.push_back(file_->path());
    file_.reset();
    long_ = false;
    const std::lock_guard lock(mutex_);
    failure_ = why;
}

void KeptExercise::remove_all() {
    file_.reset();
    remove_kept(folder_, disk_);
    settle(disk_, {folder_, folder_.parent_path()});
    before_ = kept_files(folder_, disk_); // that the disk refused to remove
    const std::lock_guard lock(mutex_);
    to_sync_ = synced_ = {};
    failure_.clear();
}

// ---- the thread that waits for the disk

void KeptExercise::sync() {
    Written wanted;
    bool first = false;
    const auto began = now_();
    {
        const std::lock_guard lock(mutex_);
        if (!to_sync_.file || (to_sync_.file == synced_.file && to_sync_.size == synced_.size)) return;
        wanted = to_sync_;
        first = synced_.file != wanted.file;
    }
    try {
        wanted.file->sync();
        if (first) {
            disk_.sync_folder(folder_);
            disk_.sync_folder(folder_.parent_path());
        }
        const std::lock_guard lock(mutex_);
        if (!to_sync_.file) return; // the exercise ended meanwhile
        synced_ = wanted;
        to_sync_.since = began;
    } catch (const std::exception& error) {
        const std::lock_guard lock(mutex_);
        if (to_sync_.file) failure_ = error.what();
    }
}

} // namespace windlass::keep
