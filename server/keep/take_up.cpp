#include "server/keep/take_up.hpp"

#include "server/dds/order_taken.hpp"
#include "server/exercise/checkpoint.hpp"
#include "server/keep/beginning.hpp"
#include "server/keep/kept_exercise.hpp"
#include "server/keep/kept_file.hpp"
#include "server/run/course.hpp"
#include "server/run/limits.hpp"

#include "idl/payload.hpp"
#include "idl/topics.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <span>
#include <system_error>
#include <utility>
#include <vector>

namespace windlass::keep {

namespace fs = std::filesystem;

namespace {

using exercise::RunState;

constexpr std::size_t kMaxAttempts = 2;

/// s of exercise, that are worked again at most: a checkpoint is kept every ten, and a disk that did not take
/// one for an hour kept nothing else either. A file that asks for more would hold up the start of the server
/// for nothing.
constexpr double kMaxBehindCheckpoint = 3600;

/// A file, opened.
struct Kept {
    fs::path file;
    run::KeptCourse course;
    Checkpoint checkpoint;
    std::vector<run::OrderView> orders{};
    std::vector<Checkpoint> reached{}; ///< without data
    std::optional<ExerciseStatus> status{};
};

/// Throws std::runtime_error when the file is of another version, exercise or definition.
void check(const Beginning& beginning, const std::string& id, const TakeUp& wanted) {
    const std::string ours = wire::topics::order_taken.type;
    if (beginning.orders != ours)
        throw std::runtime_error(
            fmt::format("orders of type {} are not allowed: this version of the server takes {}",
                        beginning.orders, ours));
    if (beginning.format != exercise::kCheckpointFormat)
        throw std::runtime_error(
            fmt::format("a checkpoint of format {} is not allowed: this version of the server takes {}",
                        beginning.format, exercise::kCheckpointFormat));
    if (beginning.id != id)
        throw std::runtime_error(fmt::format("of exercise {}, where {} is looked for", beginning.id, id));
    if (wanted.definition_hash && *wanted.definition_hash != beginning.definition_hash)
        throw std::runtime_error(fmt::format(
            "the exercise was opened with a definition of hash {:016x}, and the file that it is opened with "
            "now has {:016x}: it was changed, or is another one",
            beginning.definition_hash, *wanted.definition_hash));
}

/// Throws std::runtime_error.
void check_time_scale(double scale) {
    if (scale == 0 || (scale >= run::kTimeScaleMin && scale <= run::kTimeScaleMax)) return;
    throw std::runtime_error(fmt::format("ExerciseStatus.time_scale: {} is not allowed: {}..{}, or 0", scale,
                                         run::kTimeScaleMin, run::kTimeScaleMax));
}

/// Of which course the file is; nothing: the server was lost before it had a whole checkpoint. Throws
/// KeptError.
std::optional<run::KeptCourse> course_of(const KeptContents& contents, const fs::path& file) {
    const auto find = [&](Record kind) {
        return std::ranges::find(contents.entries(), kind, &KeptContents::Entry::kind);
    };
    const auto end = contents.entries().end(), beginning = find(Record::beginning);
    if (beginning == end || find(Record::checkpoint) == end) return std::nullopt;
    try {
        return decode_beginning(beginning->payload).course;
    } catch (const std::exception& error) {
        throw KeptError(file.string() + ": " + error.what());
    }
}

/// What is in the file; nothing: the server was lost before it had a whole checkpoint. Throws KeptError.
std::optional<Kept> open_kept(const KeptContents& contents, const fs::path& file, const std::string& id,
                              const TakeUp& wanted) {
    std::optional<Kept> kept;
    run::KeptCourse course;
    std::optional<ExerciseStatus> status; // the first one stands before the checkpoint
    try {
        for (const auto& [kind, at, payload] : contents.entries()) {
            if (kind == Record::beginning) {
                const Beginning beginning = decode_beginning(payload);
                check(beginning, id, wanted);
                course = beginning.course;
            } else if (kind == Record::checkpoint) {
                kept = Kept{.file = file, .course = course, .checkpoint = wire::decode<Checkpoint>(payload)};
            } else if (kind == Record::status) {
                status = wire::decode<ExerciseStatus>(payload);
                check_time_scale(status->time_scale());
            } else if (!kept) {
                continue;
            } else if (kind == Record::order) {
                kept->orders.push_back(dds::order_view(wire::decode<OrderTaken>(payload)));
            } else if (kind == Record::reached) {
                kept->reached.push_back(wire::decode<Checkpoint>(payload));
            }
        }
    } catch (const std::exception& error) {
        throw KeptError(file.string() + ": " + error.what());
    }
    if (kept) kept->status = std::move(status);
    return kept;
}

std::optional<Kept> open_kept(files::Disk& disk, const fs::path& file, const std::string& id,
                              const TakeUp& wanted) {
    return open_kept(KeptContents(file, disk), file, id, wanted);
}

run::Course begin(const Kept& kept, const TakeUp& wanted) {
    try {
        assess::Assessor assessor;
        auto exercise = exercise::read_checkpoint(kept.checkpoint.data(), wanted.check, &assessor);
        return {std::move(exercise), std::move(assessor), kept.checkpoint.orders_taken()};
    } catch (const std::exception& error) {
        throw KeptError(kept.file.string() + ": " + error.what());
    }
}

/// Works the orders again up to that tick, and at it those up to that number. Throws KeptError.
void work(run::Course& course, const Kept& kept, std::uint64_t tick, std::uint64_t last_order) {
    auto next = std::ranges::upper_bound(kept.orders, course.orders_taken(), {}, &run::OrderView::number);
    for (;;) {
        const bool there = course.exercise().tick() >= tick;
        for (; next != kept.orders.end() && next->tick <= course.exercise().tick() &&
               !(there && next->number > last_order);
             ++next) {
            if (!course.is_next(*next))
                throw KeptError(fmt::format("{}: order {} is missing at tick {}", kept.file.string(),
                                            course.orders_taken() + 1, course.exercise().tick()));
            course.take(*next);
        }
        if (there) return;
        if (!course.step())
            throw KeptError(fmt::format("{}: the state ceases to be finite at tick {}", kept.file.string(),
                                        course.exercise().tick()));
    }
}

/// The tick at which the exercise stopped. Throws KeptError where that is too far behind its checkpoint.
std::uint64_t last_tick(const Kept& kept, const exercise::Exercise& at_checkpoint) {
    std::uint64_t last = at_checkpoint.tick();
    for (const Checkpoint& reached : kept.reached)
        last = std::max(last, reached.tick());
    for (const run::OrderView& order : kept.orders)
        last = std::max(last, order.tick);
    const double behind = static_cast<double>(last - at_checkpoint.tick()) / at_checkpoint.def().tick_rate_hz;
    if (behind > kMaxBehindCheckpoint)
        throw KeptError(
            fmt::format("{}: tick {} is {:.0f} s behind its checkpoint at tick {}; allowed are {:.0f} s",
                        kept.file.string(), last, behind, at_checkpoint.tick(), kMaxBehindCheckpoint));
    return last;
}

/// Goes to where the exercise stopped; its states are the same, or it is refused. Throws KeptError.
run::Course work_again(const Kept& kept, const TakeUp& wanted) {
    run::Course course = begin(kept, wanted);
    const std::uint64_t last = last_tick(kept, course.exercise());
    const auto known = std::find_if(kept.reached.rbegin(), kept.reached.rend(),
                                    [](const Checkpoint& reached) { return reached.state_hash() != 0; });
    if (known != kept.reached.rend() && known->tick() >= course.exercise().tick() &&
        known->orders_taken() >= course.orders_taken()) {
        work(course, kept, known->tick(), known->orders_taken());
        if (course.state_hash() != known->state_hash())
            throw KeptError(fmt::format("{}: another state comes of its orders at tick {} than the server "
                                        "had, as when another version "
                                        "of the model kept it, or a machine with another libm",
                                        kept.file.string(), known->tick()));
    }
    work(course, kept, last, std::numeric_limits<std::uint64_t>::max());
    return course;
}

/// Leaves so many places below `aside` at most, those that were put there last: each is some megabytes.
void tidy(files::Disk& disk, const fs::path& aside, std::size_t most) {
    std::vector<std::pair<fs::file_time_type, fs::path>> places;
    for (fs::path& place : disk.list(aside)) {
        const auto written_at = disk.written_at(place);
        places.emplace_back(written_at, std::move(place));
    }
    std::ranges::sort(places, std::greater{});
    for (std::size_t k = most; k < places.size(); ++k)
        disk.remove_all(places[k].second);
}

/// A place below `aside` that is free: ID-1, ID-2 and so on.
fs::path free_place(files::Disk& disk, const fs::path& aside, const std::string& id) {
    disk.make_folder(aside);
    tidy(disk, aside, kMaxAside - 1);
    for (int number = 1;; ++number)
        if (fs::path place = aside / fmt::format("{}-{}", id, number); !disk.exists(place)) return place;
}

/// Leaves the checkpoint of that file alone, without what is behind it, in one of its own: who is lost before
/// he has a file of his own stands at that checkpoint again, and of him it counts anew. Throws KeptError.
void leave_checkpoint(files::Disk& disk, const fs::path& file, const fs::path& alone) {
    const KeptContents contents(file, disk);
    try {
        KeptWriter writer(alone, disk);
        for (const auto& [kind, at, payload] : contents.entries())
            if (kind == Record::beginning) {
                Beginning beginning = decode_beginning(payload);
                beginning.course.settled = number_of(alone);
                writer.add(kind, encode(beginning));
            } else if (kind == Record::checkpoint) {
                writer.add(kind, payload);
            }
        writer.write();
        writer.sync();
    } catch (const KeptError&) {
        disk.remove(alone);
        throw;
    }
}

/// One for each time that the exercise was taken up since the file with which it settled.
std::size_t attempts_in(files::Disk& disk, const fs::path& file) {
    return disk.exists(file) ? disk.read(file).size() : 0;
}

void count_attempt(files::Disk& disk, const fs::path& file) {
    constexpr std::uint8_t kOne = '.';
    try {
        disk.append(file, {&kOne, 1});
    } catch (const std::system_error&) { // a full disk hinders no start
    }
}

TakenUp taken_up(const Kept& kept, const run::Course& course, const TakeUp& wanted) {
    TakenUp taken;
    taken.how.course = kept.course;
    taken.def = course.exercise().def();
    taken.how.checkpoint = course.checkpoint();
    if (!kept.status) return taken;
    taken.how.time_scale = kept.status->time_scale();
    const auto state = static_cast<RunState>(kept.status->state());
    if (state == RunState::ready || (state == RunState::running && wanted.running)) taken.how.state = state;
    return taken;
}

/// Says of an exercise that was set back to there which state ended the server, and in which folder it lies.
TakenUp tell_set_back(TakenUp taken, const std::string& state, const fs::path& place) {
    const std::string why =
        fmt::format("{} ended the server {} times and lies in {}", state, kMaxAttempts, place.string());
    taken.how.set_back = why + (taken.def ? "; it stands at the checkpoint before, paused"
                                          : "; it begins from its file, and waits to be started");
    taken.how.refused = taken.def ? "" : why;
    return taken;
}

/// Where an exercise is set back to.
struct Checkpointed {
    fs::path file;
    double time = 0; ///< s of exercise, of its checkpoint
    TakenUp taken;
};

/// The newest checkpoint of a course that is before that time (s); nothing: there is none. first: number of
/// the course's first file.
std::optional<Checkpointed> checkpoint_before(double time, std::uint64_t first, files::Disk& disk,
                                              std::span<const fs::path> files, const std::string& id,
                                              const TakeUp& wanted) {
    for (auto file = files.rbegin(); file != files.rend() && number_of(*file) >= first; ++file) {
        try {
            const auto kept = open_kept(disk, *file, id, wanted);
            if (kept && kept->checkpoint.time() < time) // not where it was taken up, and lost again
                return Checkpointed{.file = *file,
                                    .time = kept->checkpoint.time(),
                                    .taken = taken_up(*kept, begin(*kept, wanted), wanted)};
        } catch (const KeptError&) { // the one before, then
        }
    }
    return std::nullopt;
}

/// Of an exercise that was set back to that: what it is not to be taken up from any more, in the order in
/// which it is to go: where it begins from its file the newest last, since a server that is lost in the midst
/// of it is followed by one that takes up the newest that is there, and is not to come to an older course.
std::vector<fs::path> left_behind(const std::optional<Checkpointed>& stands, files::Disk& disk,
                                  const std::vector<fs::path>& files, const std::string& id,
                                  const TakeUp& wanted) {
    if (!stands) return files;
    std::vector<fs::path> left;
    std::copy_if(files.rbegin(), files.rend(), std::back_inserter(left), [&](const fs::path& file) {
        if (file == stands->file) return false;
        if (number_of(file) < stands->taken.how.course.first) return true;
        try {
            const auto kept = open_kept(disk, file, id, wanted);
            return !kept || kept->checkpoint.time() >= stands->time;
        } catch (const KeptError&) {
            return true;
        }
    });
    return left;
}

/// The state that was kept last goes aside, and the checkpoint before it is gone on from, without the orders
/// behind it; without one, the exercise begins from its file. A server that is lost in the midst of it, or
/// before it had a file of its own, is followed by one that stands at the same checkpoint and says so, too.
/// files: the last can be opened. Throws KeptError.
TakenUp set_back(files::Disk& disk, const std::vector<fs::path>& files, const fs::path& folder,
                 const std::string& id, const fs::path& aside, const TakeUp& wanted, std::size_t attempts) {
    const bool again = is_set_back(files.back()) && attempts < kMaxAttempts;
    const auto newest = open_kept(disk, files.back(), id, wanted).value();
    const double lost_at = newest.reached.empty() ? newest.checkpoint.time() : newest.reached.back().time();
    constexpr double kAny = std::numeric_limits<double>::infinity();
    const std::span all(files);
    auto stands = checkpoint_before(again ? kAny : lost_at, newest.course.first, disk,
                                    again ? all : all.first(all.size() - 1), id, wanted);
    if (stands && !again) {
        try {
            const fs::path alone = set_back_file(files.back());
            leave_checkpoint(disk, stands->file, alone);
            stands->file = alone;
            stands->taken.how.course.settled = number_of(alone);
        } catch (const KeptError&) {
            // A disk that takes nothing: it stands there all the same, until it is lost.
            forget_attempts(folder, disk);
        }
    }
    fs::path place = aside;
    if (const auto left = left_behind(stands, disk, files, id, wanted); !left.empty()) {
        place = free_place(disk, aside, id);
        disk.make_folder(place);
        for (const fs::path& file : left) {
            if (!stands && file == left.back()) settle(disk, {place, folder}); // older ones do not come back
            disk.rename(file, place / file.filename());
        }
    }
    settle(disk, {place, aside, folder});
    if (!stands) { // as long as they are there, nobody was told
        forget_attempts(folder, disk);
        settle(disk, {folder});
    }
    return tell_set_back(stands ? std::move(stands->taken) : TakenUp{},
                         again ? "its last state" : "its state at " + run::clock_text(lost_at), place);
}

std::optional<TakenUp> look_for(files::Disk& disk, const fs::path& folder, const std::string& id,
                                const fs::path& aside, const TakeUp& wanted) {
    auto files = kept_files(folder, disk);
    if (files.empty()) {
        const bool told = std::ranges::none_of(attempts_files(folder, disk), [&](const fs::path& file) {
            return attempts_in(disk, file) > kMaxAttempts;
        });
        if (told) return std::nullopt;
        forget_attempts(folder, disk); // set back, and lost before anybody was told
        settle(disk, {folder});
        return tell_set_back({}, "its last state", aside);
    }
    try {
        for (; !files.empty(); files.pop_back()) {
            const KeptContents contents(files.back(), disk);
            const auto course = course_of(contents, files.back());
            if (!course) { // lost before it was whole: the one before goes up to the same tick
                disk.remove(files.back());
                continue;
            }
            const fs::path counted = attempts_file(folder, course->settled);
            const std::size_t attempts = attempts_in(disk, counted);
            count_attempt(disk, counted);
            const Kept kept = open_kept(contents, files.back(), id, wanted).value();
            if (attempts >= kMaxAttempts || is_set_back(files.back()))
                return set_back(disk, files, folder, id, aside, wanted, attempts);
            return taken_up(kept, work_again(kept, wanted), wanted);
        }
        remove_kept(folder, disk); // lost before anything was kept
        return std::nullopt;
    } catch (const KeptError& error) {
        const fs::path place = free_place(disk, aside, id);
        disk.rename(folder, place);
        settle(disk, {aside, folder.parent_path()});
        TakenUp anew;
        anew.how.refused = fmt::format("{}; the file lies in {}", error.what(), place.string());
        return anew;
    }
}

} // namespace

std::optional<TakenUp> take_up(const fs::path& folder, const std::string& id, const fs::path& aside,
                               const TakeUp& wanted, files::Disk& disk) {
    try {
        return look_for(disk, folder, id, aside, wanted);
    } catch (const std::system_error& error) { // of what is kept no more can be had, nor moved aside
        TakenUp anew;
        anew.how.refused = error.what();
        return anew;
    }
}

} // namespace windlass::keep
