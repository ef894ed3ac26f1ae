#include "instructor_console/debrief_page.hpp"

#include "recorder/debrief/page.hpp"
#include "recorder/debrief/read_attempt.hpp"
#include "recorder/debrief/scenes.hpp"
#include "recorder/debrief/side_by_side.hpp"
#include "recorder/ghost.hpp"
#include "recorder/remedies.hpp"
#include "station/format.hpp"

#include <sched.h>

#include <algorithm>

namespace windlass::console {

namespace fs = std::filesystem;

namespace {

/// Whether an assessor's word was already heard by the recorder: then the attempt has it.
bool is_recorded(const debrief::LaterWord& word, const debrief::Attempt& attempt) {
    return std::ranges::any_of(attempt.words, [&](const debrief::AssessorWord& one) {
        return one.by == word.by && one.command.note().to_string() == word.note;
    });
}

std::string page_of(recording::Recording& recording, const fs::path& config, debrief::PageOptions options) {
    auto attempt = debrief::read_attempt(recording);
    debrief::read_scenes(recording, attempt);
    if (options.word && is_recorded(*options.word, attempt)) options.word.reset();
    std::optional<debrief::Attempt> model;
    if (attempt.assessment) {
        try {
            model = recorder::model_ghost(recording, attempt, config);
            options.ghost = debrief::Ghost{&*model, debrief::kModelGhost};
        } catch (const std::runtime_error& error) {
            options.no_ghost = error.what();
        }
    }
    return debrief::page_of(attempt, options);
}

debrief::Links beside(const std::string& what_if) {
    return {.kind = debrief::Links::Kind::beside, .station = {}, .token = {}, .what_if = what_if};
}

/// When the newest of its files was written.
fs::file_time_type changed(const fs::path& recording) {
    auto last = fs::file_time_type::min(); // before any: this clock counts from a year to come
    std::error_code gone;
    for (fs::directory_iterator file(recording, gone), end; !gone && file != end; file.increment(gone))
        last = std::max(last, file->last_write_time(gone));
    return last;
}

std::string waiting_page(const fs::path& recording, const std::string& words, bool again) {
    return debrief::waiting_page("What would have kept lost points: " + recording.filename().string(), words,
                                 again);
}

/// What is done, for how long the page has waited, and why that may be long.
std::string waiting_words(const std::string& doing, std::chrono::steady_clock::duration waited) {
    const double seconds = std::chrono::duration<double>(waited).count();
    return doing + " " + station::clock(seconds) +
           " min so far. It goes on with what the classes leave of the processor: while they run it may take "
           "long.";
}

} // namespace

std::string debrief_page(const fs::path& path, const fs::path& config, const std::string& what_if,
                         const std::string& who, std::optional<debrief::LaterWord> word) {
    recording::Recording recording({path});
    return page_of(recording, config, {.links = beside(what_if), .word = std::move(word), .who = who});
}

std::string side_by_side_page(const std::string& title, const std::vector<RecordedExercise>& exercises) {
    std::deque<debrief::Attempt> attempts;
    std::vector<debrief::Beside> all;
    for (const auto& [who, link, path, word] : exercises) {
        debrief::Beside one{.who = who, .link = link, .missing = "was not recorded", .word = word};
        if (!path.empty()) try {
                recording::Recording recording({path});
                one.attempt = &attempts.emplace_back(debrief::read_attempt(recording));
                if (one.word && is_recorded(*one.word, *one.attempt)) one.word.reset();
            } catch (const std::exception& error) {
                one.missing = std::string("cannot be read: ") + error.what();
            }
        all.push_back(std::move(one));
    }
    return debrief::side_by_side_page(title, all);
}

WhatIfPages::WhatIfPages(fs::path config, bool beside)
    : config_(std::move(config)),
      thread_([this, beside](const std::stop_token& stop) { work(stop, beside); }) {}

WhatIfPages::~WhatIfPages() = default;

std::string WhatIfPages::page(const fs::path& recording) {
    const auto now = changed(recording);
    const std::lock_guard lock(mutex_);
    Page& page = pages_[recording];
    if (page.of != now && std::ranges::find(waiting_, recording) == waiting_.end()) {
        page = {.of = now,
                .html = {},
                .doing = "It waits for another search.",
                .since = std::chrono::steady_clock::now()};
        waiting_.push_back(recording);
        asked_.notify_one();
    }
    page.asked = ++asked_for_;
    std::string html =
        !page.html.empty()
            ? page.html
            : waiting_page(recording,
                           waiting_words(page.doing, std::chrono::steady_clock::now() - page.since), true);
    if (pages_.size() > kMost)
        pages_.erase(
            std::ranges::min_element(pages_, {}, [](const auto& each) { return each.second.asked; }));
    return html;
}

void WhatIfPages::show(const fs::path& recording, std::string html) {
    const std::lock_guard lock(mutex_);
    if (const auto page = pages_.find(recording); page != pages_.end()) page->second.html = std::move(html);
}

void WhatIfPages::tell(const fs::path& recording, std::string doing) {
    const std::lock_guard lock(mutex_);
    if (const auto page = pages_.find(recording); page != pages_.end()) page->second.doing = std::move(doing);
}

void WhatIfPages::work(const std::stop_token& stop, bool beside) {
    // Threads that the search begins are scheduled in the same way.
    const sched_param idle{};
    if (beside) pthread_setschedparam(pthread_self(), SCHED_IDLE, &idle);
    while (true) {
        fs::path recording;
        {
            std::unique_lock lock(mutex_);
            if (!asked_.wait(lock, stop, [this] { return !waiting_.empty(); })) return;
            recording = waiting_.front();
            waiting_.pop_front();
        }
        try {
            show(recording, search(recording, stop));
        } catch (const std::exception& error) {
            show(recording, waiting_page(recording, error.what(), false));
        }
    }
}

std::string WhatIfPages::search(const fs::path& path, const std::stop_token& stop) {
    tell(path, "Reading the recording ...");
    recording::Recording recording({path});
    auto remedies = recorder::remedies_of(
        recording, 0, config_,
        [&](const std::string& words) { tell(path, "Searching for " + words + " ..."); }, stop);
    return page_of(recording, config_, {.links = beside({}), .remedies = std::move(remedies)});
}

} // namespace windlass::console
