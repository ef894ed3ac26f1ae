// A disk that takes as long as a test says, in each call that is made to it: nobody who ticks waits for it.
// Ticks are counted, and no time is measured.

#include "tests/keep/let_go.hpp"
#include "tests/recorder/folder.hpp"

#include <gmock/gmock.h>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace windlass::keep {
namespace {

namespace fs = std::filesystem;

using test::LetGo;
using testing::HasSubstr;

/// The machine's disk, behind a door at which every call waits while it is held.
class HeldDisk final : public files::Disk {
public:
    void hold() {
        const std::lock_guard lock(mutex_);
        held_ = true;
    }
    void release() {
        {
            const std::lock_guard lock(mutex_);
            held_ = false;
        }
        released_.notify_all();
    }
    /// Calls that wait now.
    int waiting() const {
        const std::lock_guard lock(mutex_);
        return waiting_;
    }

    std::unique_ptr<files::File> make(const fs::path& file, files::ReadBy readers) override {
        pass();
        return std::make_unique<File>(*this, files::system_disk().make(file, readers));
    }
    void append(const fs::path& file, files::Bytes bytes) override {
        pass(), files::system_disk().append(file, bytes);
    }
    std::vector<std::uint8_t> read(const fs::path& file) override {
        return pass(), files::system_disk().read(file);
    }
    bool exists(const fs::path& path) override { return pass(), files::system_disk().exists(path); }
    std::vector<fs::path> list(const fs::path& folder) override {
        return pass(), files::system_disk().list(folder);
    }
    fs::file_time_type written_at(const fs::path& path) override {
        return pass(), files::system_disk().written_at(path);
    }
    void make_folder(const fs::path& folder) override { pass(), files::system_disk().make_folder(folder); }
    void rename(const fs::path& from, const fs::path& to) override {
        pass(), files::system_disk().rename(from, to);
    }
    void remove(const fs::path& path) override { pass(), files::system_disk().remove(path); }
    void remove_all(const fs::path& path) override { pass(), files::system_disk().remove_all(path); }
    void sync_folder(const fs::path& folder) override { pass(), files::system_disk().sync_folder(folder); }

private:
    class File final : public files::File {
    public:
        File(HeldDisk& disk, std::unique_ptr<files::File> file) : disk_(disk), file_(std::move(file)) {}
        std::size_t append(files::Bytes bytes) override { return disk_.pass(), file_->append(bytes); }
        void cut(std::uint64_t size) override { disk_.pass(), file_->cut(size); }
        void sync() override { disk_.pass(), file_->sync(); }

    private:
        HeldDisk& disk_;
        const std::unique_ptr<files::File> file_;
    };

    void pass() {
        std::unique_lock lock(mutex_);
        ++waiting_;
        released_.wait(lock, [this] { return !held_; });
        --waiting_;
    }

    mutable std::mutex mutex_;
    std::condition_variable released_;
    bool held_ = false;
    int waiting_ = 0;
};

/// An exercise that is kept there by two threads, as keep::Keeper has them, by the exercise's own clock.
class KeptOnAHeldDisk : public testing::Test {
protected:
    KeptOnAHeldDisk() {
        writing_ = std::thread([this] {
            while (!end_)
                kept_.write_waiting(), rests();
        });
        syncing_ = std::thread([this] {
            while (!end_)
                kept_.sync(), rests();
        });
    }
    ~KeptOnAHeldDisk() override {
        end_ = true;
        disk_.release();
        writing_.join();
        syncing_.join();
    }
    void go_to(std::uint64_t tick) {
        while (let_go_.session().now_tick() < tick) {
            ticks_ = let_go_.session().now_tick() + 1;
            let_go_.go_to(let_go_.session().now_tick() + 1, &kept_);
        }
    }
    template <class Condition>
    void go_on_until(Condition condition) {
        while (!condition())
            let_go_.look(&kept_), rests();
    }

    static void rests() { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }

    HeldDisk disk_;
    const windlass::test::Folder folder_;
    std::atomic<std::uint64_t> ticks_ = 0;
    KeptExercise kept_{
        folder_ / "exercise-anna", "anna", test::let_go_hash(), disk_,
        [this] { return KeptExercise::Clock::time_point(std::chrono::milliseconds(ticks_ * 1000 / 300)); }};
    LetGo let_go_;

private:
    std::atomic<bool> end_ = false;
    std::thread writing_, syncing_;
};

TEST_F(KeptOnAHeldDisk, AnExerciseGoesOnTickByTickAndSaysThatItIsNotKept) {
    go_to(300);
    go_on_until([&] { return !kept_files(folder_ / "exercise-anna").empty(); });
    disk_.hold();
    go_to(330);
    go_on_until([&] { return disk_.waiting() > 0; });
    go_to(9300); // thirty seconds, and three checkpoints that nobody can write
    EXPECT_GT(disk_.waiting(), 0) << "the disk has been held throughout";
    EXPECT_EQ(let_go_.session().now_tick(), 9300U);
    EXPECT_THAT(kept_.trouble(), HasSubstr("does not come to the disk within 3 s"));

    LetGo alone;
    alone.go_to(9300);
    EXPECT_EQ(let_go_.session().snapshot().tick, 9300U);
    EXPECT_EQ(let_go_.hash(), alone.hash()) << "it ran as if there were no disk";

    disk_.release();
    let_go_.session().clear_news();
    go_to(12030); // with the next checkpoint
    go_on_until([&] { return kept_.trouble().empty(); });
}

} // namespace
} // namespace windlass::keep
