#pragma once
// One exercise on its way to the disk: its last checkpoint, and the one before it, each with the orders that
// were taken behind it, in a file of its own (kept_file.hpp). Files are numbered on, whatever becomes of
// those before: each says in its beginning with which number its course began, and from which one on losses
// count. So what the disk refuses to remove is never taken for a part of a later course.

#include "server/keep/kept_file.hpp"
#include "server/run/session.hpp"

#include "idl/types.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <initializer_list>
#include <memory>
#include <mutex>
#include <optional>
#include <variant>

namespace windlass::keep {

/// NNNNNN of NNNNNN.kept, NNNNNN-set-back.kept and NNNNNN.attempts.
std::uint64_t number_of(const std::filesystem::path& file);
/// Files of kept exercises in a folder, the oldest first.
std::vector<std::filesystem::path> kept_files(const std::filesystem::path& folder,
                                              files::Disk& disk = files::system_disk());
/// The file of a checkpoint alone, behind that one, at which an exercise stands that was set back; and
/// whether a file is one.
std::filesystem::path set_back_file(const std::filesystem::path& behind);
bool is_set_back(const std::filesystem::path& file);
/// Of such a folder: as many bytes as the exercise was taken up since the file of that number, which is
/// run::KeptCourse::settled, and the server lost before its next checkpoint.
std::filesystem::path attempts_file(const std::filesystem::path& folder, std::uint64_t settled);
/// Those that are there, in any order.
std::vector<std::filesystem::path> attempts_files(const std::filesystem::path& folder,
                                                  files::Disk& disk = files::system_disk());
/// Nothing was counted, then. Throws std::system_error.
void forget_attempts(const std::filesystem::path& folder, files::Disk& disk = files::system_disk());
/// Removes what is kept in the folder, and the folder.
void remove_kept(const std::filesystem::path& folder, files::Disk& disk = files::system_disk());
/// What was removed or put aside there stays so after a power cut, as far as the disk can be waited for: else
/// a state that killed comes back, or an older course, or an exercise that had ended.
void settle(files::Disk& disk, std::initializer_list<std::filesystem::path> folders);

/// Takes what is new of a session from the thread that ticks, which never waits for it; writes it on a second
/// thread, and waits for the disk on a third.
class KeptExercise {
public:
    using Clock = std::chrono::steady_clock;
    using Now = std::function<Clock::time_point()>; ///< what time it is

    /// folder: of this exercise alone; made when something is written. definition_hash: of the definition
    /// that the exercise was opened with.
    KeptExercise(std::filesystem::path folder, std::string id, std::uint64_t definition_hash,
                 files::Disk& disk = files::system_disk(), Now now = Clock::now);

    // Of the thread that ticks.

    /// Takes what is new, before clear_news(). Of an exercise that has ended nothing is kept any more. last:
    /// nothing comes behind it, and whoever is at what waits is waited for.
    void look(const run::Session& session, bool last = false);
    /// Why the exercise is not kept as it should be; empty: it is.
    const std::string& trouble() const { return trouble_; }
    /// The file has grown so long that the next one should begin, with a checkpoint.
    bool wants_checkpoint() const { return long_; }

    /// Nothing more comes. in_order: nothing is to be taken up. Who comes so far was not lost by the
    /// exercise's state: it is no attempt.
    void let_go(bool in_order);
    /// The same; returns when all is written, or time is up.
    void close(bool in_order);

    // Of the keeper's threads.

    /// Writes what waits. False: it was closed, and this was the last of it.
    bool write_waiting();
    /// Waits until the disk has what was written.
    void sync();

private:
    using News = std::variant<run::OrderView, run::CheckpointView>;
    /// The run with which a course goes on that was taken up.
    struct Resumed {
        std::uint64_t run = 0;
        run::KeptCourse course;
    };
    /// How far the exercise has come.
    struct Reached {
        run::CheckpointView state; ///< without data; state_hash 0: not known
        /// One that holds for a question runs: it goes on by itself once that is answered.
        exercise::RunState run_state = exercise::RunState::ready;
        double time_scale = 1;
    };

    void collect(const run::Session& session);
    bool disk_is_slow(Clock::time_point now) const;
    void put(News news);
    void write(const run::OrderView& order);
    void write(const run::CheckpointView& checkpoint, const std::optional<Reached>& reached);
    void write(const Reached& reached);
    void add_status(KeptWriter& file, const Reached& reached);
    void add_reached(run::CheckpointView state);
    void note_synced();
    void prune();
    void fail(const std::string& why);
    void remove_all();

    const std::filesystem::path folder_;
    const std::string id_;
    const std::uint64_t definition_hash_;
    files::Disk& disk_;
    const Now now_;

    // Of the thread that ticks
    std::vector<News> pending_;
    bool gap_ = false; // something was lost: nothing can be kept up to the next checkpoint
    bool end_told_ = false;
    std::string trouble_;

    // Between them
    std::atomic<bool> long_{false};
    std::mutex mutex_; // of what follows; never held while the disk is asked for anything
    std::condition_variable closed_;
    std::vector<News> waiting_;
    std::optional<Reached> reached_;
    std::optional<Resumed> resumed_;
    bool over_ = false, closing_ = false, gone_ = false;
    Clock::time_point waits_since_{};
    std::string failure_; // of the disk
    struct Written {
        std::shared_ptr<const KeptWriter> file;
        std::uint64_t size = 0;
        Clock::time_point since{};
    };
    Written to_sync_, synced_; // since: when the first of what the disk has not yet was written

    // Of the thread that writes
    std::shared_ptr<KeptWriter> file_;          // none: what comes cannot be kept, up to the next checkpoint
    std::vector<std::filesystem::path> before_; // older files, the oldest first
    std::uint64_t number_ = 0;                  // of the last file
    run::KeptCourse course_;                    // of that file
    bool news_ = false;                         // something to write that is worth it
    std::optional<Reached> last_;               // that stands in the file
    std::optional<Reached> status_;             // whose status does
    std::uint64_t run_ = 0;                     // of the file
    int begun_ = 0;                             // files, since the server's start
    std::uint64_t noted_ = 0;                   // up to which byte the file says to be on the disk
    std::vector<News> writing_;
    OrderTaken order_;
    Checkpoint checkpoint_;
};

} // namespace windlass::keep
