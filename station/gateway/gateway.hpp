#pragma once
// A station's pages and the exercises that they look at. No network but DDS; all on one thread, but for what
// says otherwise. docs/gateway.md has the protocol.

#include "station/gateway/alert_watch.hpp"
#include "station/gateway/camera_watch.hpp"
#include "station/gateway/exercise_desk.hpp"
#include "station/gateway/line_log.hpp"
#include "station/gateway/page_host.hpp"
#include "station/gateway/recorders.hpp"
#include "station/gateway/replays.hpp"
#include "station/gateway/session.hpp"

#include <functional>
#include <future>

namespace windlass::gateway {

struct GatewayOptions {
    wire::JoinOptions member;                  ///< its name is the one under which orders go out
    std::optional<SharedReaders> readers = {}; ///< of that member, where the program has joined already
    station::Seat seat = station::Seat::trainee;
    std::string exercise = "default"; ///< that the program joined, without "exercise/"; empty: none yet
    std::function<void(const std::string&)> log; ///< a line for whoever runs the program; from any thread
    /// Told of each order that a page has given, levers that it has taken among them: by whom, in which
    /// exercise, the topic.
    std::function<void(const std::string& by, const std::string& exercise, const std::string& topic)> given =
        {};

    /// Where recordings are shown, to who may look at them (may_replay); nothing: here alone, by `recorder`.
    std::shared_ptr<Replays> replays;

    /// The rest is an instructor's, but that an assessor reads events_of and past_of, too. Program that
    /// records; empty: none is there.
    std::filesystem::path recorder;
    std::vector<std::string> recorder_arguments;     ///< domain, network, identity
    std::filesystem::path recordings = "recordings"; ///< folder of them
    std::filesystem::path config_root;               ///< whose files a recording takes along; empty: "config"
    /// A sample of RestoreCommand of a recording's state at that position (s from its beginning). Runs on a
    /// thread of its own. Throws std::exception.
    std::function<nlohmann::json(const std::filesystem::path& recording, double position)> state_at;
    /// The events of a recording as a page shows them (docs/gateway.md, recording_events). Runs on a thread
    /// of its own. Throws std::exception.
    std::function<nlohmann::json(const std::filesystem::path& recording)> events_of;
    /// What a page draws of a recording over time (docs/gateway.md, recording_events). The same.
    std::function<nlohmann::json(const std::filesystem::path& recording)> past_of;
    /// The page of a recording's debriefing. The same.
    /// what_if: address of the page below.
    std::function<std::string(const std::filesystem::path& recording, const std::string& what_if)> debrief_of;
    /// That page with what would have kept lost points, or how far the search for it is, which it begins.
    /// Called on the server's thread, and throws nothing.
    std::function<std::string(const std::filesystem::path& recording)> what_if_of;
    /// What a page asks of the exercise files, and the answer (docs/gateway.md, exercise_files). The same.
    std::function<nlohmann::json(const nlohmann::json& request)> exercise_files;
    /// Puts a page among those that are served, which makes it each time that it is asked for. Called on the
    /// server's thread.
    std::function<void(const std::string& path, std::function<std::string()> page)> publish;
};

class Gateway final : public PageHost {
public:
    /// Joins the exercise. Throws std::runtime_error as wire::Participant does.
    explicit Gateway(GatewayOptions options);
    ~Gateway() override;

    const GatewayOptions& options() const { return options_; }

    /// A session of a page, or of a foreign client that only looks on, in that exercise; it begins with
    /// open(). name: of who sits there, as PageSession has it. Throws std::runtime_error when the exercise
    /// cannot be joined.
    std::shared_ptr<PageSession> open_page(const std::string& exercise, Transport& transport,
                                           const std::string& name = {});
    std::shared_ptr<FoxgloveSession> open_foxglove(const std::string& exercise, Transport& transport);

    /// What servers tell of themselves.
    std::vector<ClassroomStatus> servers() const;

    /// Sends an order about the classroom; false: the topic is none of those. by: as ExerciseDesk::give's.
    /// Throws Refused.
    bool order_classroom(const wire::TopicInfo& topic, const nlohmann::json& sample,
                         const std::string& by = {}) override;

    /// What the camera on the forecastle of a live exercise sees, of what was heard later than that look of a
    /// page, for who has the truth: `at`, of this look, and `samples` as samples_since() has them. Throws
    /// Refused.
    nlohmann::json look_at_forecastle(const std::string& exercise, std::int64_t since) override;

    /// An instructor's: an exercise goes on from a moment of a recording, position s from its beginning,
    /// paused. It is read first; what fails then is told to refused, or goes to the log. Throws Refused.
    void continue_in(const std::string& exercise, const std::string& recording, double position,
                     std::function<void(const Refused&)> refused = {});
    /// Whether another one may be asked for now: so many are read at a time.
    bool can_continue() const { return continuations_.size() < 4; }

    /// An instructor's: records an exercise from now on, or no longer. name: of the recording; empty: one is
    /// made of the exercise's and the time. Throws Refused.
    void record(const std::string& exercise, bool on, const std::string& name = {}) override;

    /// The recording that is being made of an exercise; nothing: none. It is one until its file is whole.
    std::optional<std::string> recording_of(const std::string& exercise) const;

    /// Levers, recorders, exercises that nobody looks at any more. 20 times a second.
    void tick(Clock::time_point now);

    /// A line for whoever runs the program; of a flood, the first few each second. From any thread.
    void log(const std::string& line) override { log_.tell(line); }

private:
    /// An exercise, and since when no page has it.
    struct Desk {
        std::shared_ptr<ExerciseDesk> desk;
        Clock::time_point used;
    };
    struct Recording {
        std::string asked_as, name; ///< not the same where recorders were lost: each was followed by another
        int recorders = 1;
        bool stopping = false;
    };
    /// A recording's state on its way into an exercise.
    struct Continuation {
        std::future<nlohmann::json> state;
        std::optional<nlohmann::json> sample; // once it is there
        std::shared_ptr<ExerciseDesk> desk;
        PageSession* page; // nullptr: gone
        nlohmann::json id;
        std::function<void(const Refused&)> refused; // where no page asked
        Clock::time_point until;                     // for an exercise that is not heard yet
    };

    /// What is made of a recording or an exercise's file, on its way to a page.
    struct Reading {
        std::future<nlohmann::json> made;
        std::function<nlohmann::json(nlohmann::json)> message; // of what was made
        std::string field, value;                              // that it was asked for by
        PageSession* page;                                     // nullptr: gone
        nlohmann::json id;
    };

    std::shared_ptr<ExerciseDesk> desk(const std::string& exercise);
    void continue_live(PageSession& page, const nlohmann::json& id, const std::string& recording,
                       double position, const std::string& exercise) override;
    void read_events(PageSession& page, const nlohmann::json& id, const std::string& recording) override;
    void debrief(PageSession& page, const nlohmann::json& id, const std::string& recording) override;
    void ask_exercise_files(PageSession& page, const nlohmann::json& id,
                            const nlohmann::json& request) override;
    void read(Reading reading);
    /// False: it is not there yet.
    static bool show(Reading& reading);
    /// Shows a recording in an exercise of its own, whose name it returns.
    std::string replay(const std::string& recording) override;
    std::filesystem::path folder_of(const std::string& recording) const;
    /// False: it waits for the exercise to be heard.
    bool go_on(Continuation& continuation, Clock::time_point now);
    std::vector<std::string> live() const;
    bool sees_truth() const override { return has_truth(options_.seat); }
    void tell_given(const PageSession& by, const std::string& topic) const override;
    nlohmann::json hello(const PageSession& page) const override;
    void forget(PageSession& page) override;
    void levers_changed(const std::string& exercise, Hand hand, LeverDesk::Page holder,
                        const std::string& taken_by);
    void tend_recorders();
    /// Throws Refused.
    void begin_recording(const std::string& exercise, const Recording& recording);
    void record_on(const std::string& exercise, const Recording& was);
    void tell_news();
    void tell_alerts();

    GatewayOptions options_;
    SharedReaders readers_;
    std::unique_ptr<Feed> classroom_;
    std::unique_ptr<OrderWriters> classroom_orders_;
    AlertWatch alerts_; // while a page watches the classroom
    CameraWatch cameras_;
    std::map<std::string, Desk> desks_; // by exercise
    std::set<PageSession*> pages_;
    std::optional<Recorders> recorders_;          // where there is a recorder
    std::map<std::string, Recording> recordings_; // by exercise
    std::map<std::string, std::string> recorded_; // the last that was made here, by exercise
    std::vector<Continuation> continuations_;
    std::vector<Reading> readings_;
    std::map<std::string, std::string> debriefs_; // paths of pages, by recording
    Clock::time_point next_news_{};

    LineLog log_;
};

} // namespace windlass::gateway
