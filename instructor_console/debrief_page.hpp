#pragma once

#include "recorder/debrief/page.hpp"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace windlass::console {

/// The debriefing of a recording's last run as a page that this station serves: its times open the replay
/// beside it. config: folder with the scripts of the lessons' model runs, which are laid behind the curves.
/// what_if: address of the page below. who, word: as debrief::PageOptions. Throws std::exception, with what
/// is wrong, when the recording cannot be read.
std::string debrief_page(const std::filesystem::path& recording, const std::filesystem::path& config,
                         const std::string& what_if, const std::string& who = {},
                         std::optional<debrief::LaterWord> word = {});

/// One exercise of a class, and where the debriefing above of it is served.
struct RecordedExercise {
    std::string who, link;
    std::filesystem::path recording; ///< empty: it was not recorded
    std::optional<debrief::LaterWord> word = {};
};

/// What came of a class, side by side. A recording that cannot be read is left out, and the page says so.
std::string side_by_side_page(const std::string& title, const std::vector<RecordedExercise>& exercises);

/// The same pages with what would have kept each lost point, searched for in one recording after the other.
/// The kMost that were asked for last are kept.
class WhatIfPages {
public:
    /// config: as above. beside: on threads that get what processor time nobody else wants, as a class may
    /// run on this machine.
    explicit WhatIfPages(std::filesystem::path config, bool beside = true);
    ~WhatIfPages(); ///< gives up what is searched for
    WhatIfPages(const WhatIfPages&) = delete;
    WhatIfPages& operator=(const WhatIfPages&) = delete;

    /// The page; until it is made, how far that is, in a page that looks again by itself. The first to ask
    /// begins the search; so does who asks after the recording has grown. From any thread.
    std::string page(const std::filesystem::path& recording);

    static constexpr std::size_t kMost = 32; ///< half a megabyte each

private:
    struct Page {
        std::optional<std::filesystem::file_time_type> of{}; ///< when the recording last changed
        std::string html;                                    ///< empty: it is not made yet
        std::string doing;                                   ///< until then, in words
        std::chrono::steady_clock::time_point since{};       ///< of that search
        std::uint64_t asked = 0;                             ///< counts those who asked
    };
    void work(const std::stop_token& stop, bool beside);
    std::string search(const std::filesystem::path& recording, const std::stop_token& stop);
    void show(const std::filesystem::path& recording, std::string html);
    void tell(const std::filesystem::path& recording, std::string doing);

    const std::filesystem::path config_;
    std::mutex mutex_;
    std::condition_variable_any asked_;
    std::deque<std::filesystem::path> waiting_;
    std::map<std::filesystem::path, Page> pages_;
    std::uint64_t asked_for_ = 0;
    std::jthread thread_; // last: it uses all of the above
};

} // namespace windlass::console
