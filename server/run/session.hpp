#pragma once
// The run of one exercise after another: ready, running, paused, finished or stopped by a fault. Owns the
// exercise, carries out orders, and keeps the log. Knows neither wall time (it is passed in) nor DDS.

#include "server/assess/aids.hpp"
#include "server/assess/assessor.hpp"
#include "server/exercise/exercise.hpp"
#include "server/run/alert_board.hpp"
#include "server/run/fault_dump.hpp"
#include "server/run/inbox.hpp"
#include "server/run/lever_ownership.hpp"
#include "server/run/lever_pickup.hpp"
#include "server/run/limits.hpp"
#include "server/run/model_hands.hpp"
#include "server/run/reading.hpp"
#include "server/run/refusal_log.hpp"
#include "server/run/resumption.hpp"
#include "words/words.hpp"

#include <array>
#include <deque>
#include <filesystem>
#include <functional>
#include <random>
#include <vector>

namespace windlass::run {

struct SessionOptions {
    std::string id;                           ///< tells one exercise of a server from another in its dump
    double time_scale = 1;                    ///< exercise seconds per wall second, 0 = as fast as possible
    double duration = 0;                      ///< s of exercise after which the run ends; 0: no end
    bool wait = false;                        ///< begin in READY, until an instructor starts
    bool realtime = false;                    ///< time scale 0 is refused then
    std::filesystem::path fault_folder = "."; ///< for the dump when the exercise has to be stopped
    /// Begins to read an exercise by the name an instructor gives, and returns at once: a file may take long,
    /// and no tick waits for one. What is wrong with it comes as a std::exception with a text for people.
    std::function<Reading(const std::string& name)> load;
    /// Begins to play the prelude of a definition (exercise/prelude.hpp), for a RESET, and returns at once.
    /// Without it preludes are played where they are needed, and a tick waits.
    std::function<Reading(const exercise::ExerciseDef&)> prepare;
    /// Throws std::exception when a definition that came with a state is not one that a file could give.
    std::function<void(const exercise::ExerciseDef&)> check;
    /// The lesson's model hands, to go beside a trainee who practises; none: nobody can be shown them.
    ModelHandsFrom model_hands{};
    std::uint64_t first_run = 1;         ///< number of the first run; each later one has the next
    std::optional<std::uint64_t> seed{}; ///< of all that is left to chance; nothing: chance itself
    /// What was kept of it when its server was lost; nothing: it was not looked for.
    std::optional<Resumption> resumption{};
};

/// What a seat may ask for in an attempt for practice: what its event "practice.SEAT" has as its figure.
enum AidsOffered : unsigned { aid_ghost = 1, aid_ghost_on = 2, aid_hints = 4, aid_hint_wanted = 8 };

class Session {
public:
    /// Throws std::invalid_argument when the exercise cannot be set up from its definition;
    /// exercise::CheckpointError when it cannot be taken up from the checkpoint that was kept.
    Session(const exercise::ExerciseDef& def, SessionOptions options);

    /// Carries out the orders, in their order, and logs the refusals. now: s of wall time, never going back.
    /// While a file is being read for a LOAD, levers are obeyed and the exercise goes on; all other orders
    /// wait until the LOAD is answered; for its file, kReadingTime at most.
    void carry_out(const Inbox& inbox, double now);

    /// Runs one tick when the exercise is running; false when it stands still. show: the snapshot is to be of
    /// this tick, whatever happens in it; without, only where something was called out, or it stands still.
    bool tick(bool show = true);
    /// The last tick that went well.
    std::uint64_t now_tick() const { return tick_; }
    double now_time() const { return time_; } ///< s of exercise, of it
    /// Whether the snapshot is of it, whole: of other ticks a lesson sees it without its hash.
    bool seen() const { return seen_; }

    /// Takes a checkpoint of the present state.
    void take_checkpoint_now();

    /// Whether its checkpoint and orders are kept on disk, and if not, why: told when that changes.
    void report_keeping(const std::string& trouble);

    /// Ends the run from outside, e.g. on a signal.
    void finish(const std::string& reason);

    /// Stops the exercise because the simulation itself went wrong, so that its state means nothing any more:
    /// alarm, dump of the last good state, and no tick until it is reset, loaded or restored.
    void fail(const std::string& why);
    /// Why it was stopped; empty when it was not.
    const std::string& failure() const { return failure_; }

    const exercise::Snapshot& snapshot() const { return snapshot_; }
    const RunStatus& status() const { return status_; }
    const exercise::ExerciseDef& def() const { return exercise_.def(); }
    Limits limits() const;

    bool running() const { return status_.state == exercise::RunState::running; }
    /// The set duration has been run, or a run with a set duration was stopped by a fault.
    bool ended() const;
    /// A hand that has levers has not been heard for so long that the exercise, where it is hurried, is to
    /// run no faster than real time until it speaks or is given up.
    bool hand_is_late() const;
    /// Counts exercises set up: changes with each load, reset and restore.
    unsigned setups() const { return setups_; }
    /// Of which kept course this run is the next part; `first` 0: of none, it begins one.
    const KeptCourse& kept_course() const { return kept_course_; }
    double dt() const { return 1.0 / def().tick_rate_hz; } ///< s

    /// What the pacer measured and the publisher dropped, for the status.
    void report_pace(double lateness, std::uint64_t overruns, double scale_achieved, std::uint64_t dropped);

    /// Events and alerts since the last clear_news(), to be published.
    const std::vector<exercise::ExerciseEvent>& events() const { return events_; }
    const std::vector<AlertView>& alerts() const { return alerts_.changes(); }
    /// Orders that went into the exercise since then.
    const std::vector<OrderView>& orders() const { return orders_; }
    /// The assessment as it came to stand since then: once a second of the lesson, at its end, and after an
    /// assessor's word. Nothing: no news, or no lesson.
    const std::optional<assess::Result>& assessment() const { return new_assessment_; }
    /// The seats may read it, too: the lesson is over, and lets them know.
    bool marks_are_told() const;
    /// Lesson and marks as they stand now.
    const assess::Assessor& assessor() const { return assessor_; }
    /// The checkpoint taken or gone back to since then; none: nullptr.
    const CheckpointView* checkpoint() const { return new_checkpoint_ ? &checkpoints_.back() : nullptr; }
    /// What a seat is asked, as it came to be since then; an empty id: nothing any more.
    const std::vector<QuestionView>& questions() const { return questions_; }
    /// An instructor wants to see a minute ahead; nothing in the exercise comes of it.
    bool predicts() const { return predicts_; }
    /// Orders that went into this run so far.
    std::uint64_t orders_taken() const { return orders_taken_; }
    /// The present state as bytes, with all that goes with it (exercise/checkpoint.hpp).
    std::vector<std::uint8_t> state() const;
    /// It stands for a question: the answer makes it go on, or an instructor's start.
    bool held() const { return held_; }
    /// How the attempt began, for the model's hands.
    Beginning beginning() const { return {.def = def(), .seed = assessor_.state().seed}; }
    /// What went into it since then that neither its hands nor its lesson did, by tick. To be asked for while
    /// a seat wants_ghost().
    const std::vector<OrderView>& others() const { return others_.value(); }
    const ModelHandsFrom& model_hands() const { return options_.model_hands; }
    /// A seat has asked for them, and may have them.
    bool wants_ghost() const;
    /// The model's hands are to be shown to that seat now.
    bool shows_ghost(bool forecastle) const;
    /// A seat waits for a hint: whether it is the forecastle. Nothing: none does.
    std::optional<bool> hint_wanted() const;
    /// The hint that was found for it. One whose lever stands there already is not told: it waits for
    /// another.
    void tell_hint(const assess::AidWord& told);
    void clear_news();

private:
    void carry_out(const exercise::Order& command, const ReceivedOrder& from);
    void carry_out(const RunOrder& order, const ReceivedOrder& from);
    void carry_out(const AlertOrder& order, const ReceivedOrder& from);
    void carry_out(const StateOrder& order, const ReceivedOrder& from);
    void carry_out(const AnswerOrder& order, const ReceivedOrder& from);
    void apply(const exercise::Order& command, const std::string& source);
    void begin_load(const RunOrder& order, const std::string& source);
    void reset(const std::string& source);
    void tell_reading();
    void wait_for_load(const ReceivedOrder& order);
    void answer_load();
    void take_what_waited();
    void begin_run();
    double draw();
    void look();
    bool take_levers(LeverGroup levers, const ReceivedOrder& from);
    void look_for_hands();
    void watch_for_a_hand();
    void forget_hands();
    void leave_alone(LeverGroup levers, const LeverOwnership::Hand& hand);
    void tell_of_levers_left();
    bool checkpoint_due(std::uint64_t tick) const;
    void take_checkpoint();
    void restore(double time, const std::string& source);
    /// An exercise that was kept, and its assessment.
    struct Kept {
        exercise::Exercise exercise;
        assess::Assessor assessor;
    };
    Kept read_state(const std::vector<std::uint8_t>& checkpoint);
    void go_on_from(Kept kept);
    void begin_after_loss();
    void look_for_the_beginning();
    void keep_for_the_model(const exercise::Order& command, const std::string& source);
    void forget_for_the_model();
    bool practises() const;
    unsigned aids(std::size_t seat) const;
    void tell_aids();
    void carry_out_aid(const AnswerOrder& order, const ReceivedOrder& from);
    void assess();
    void tell_hints();
    bool is_done(const assess::AidWord& hint) const;
    void tell_when_the_lesson_is_over();
    void tell_unanswered(int asked_before, bool misled_before);
    void tell_when_the_bridge_gives_up();
    bool asks() const;
    void tell_questions();
    void hold_for_questions();
    void go_on_when_answered();
    void pass_over_questions(const std::string& source);
    void close_assessment(const std::string& reason);
    bool judged(const exercise::AssessorsWord& word, const std::string& source);
    void set_up();
    void brief();
    void brief_each_seat();
    void refuse(const char* topic, const std::string& source, const char* field, std::string value,
                std::string allowed);
    void keep_events();
    void watch_what_stands();
    bool comes_up(words::AlertCode code, int side, bool stands);
    void watch_the_circle();
    void watch_for_a_fast_cable();
    void watch_for_a_runaway();
    void watch_the_motors();
    void watch_the_foreign_ship();
    void watch_the_model();
    void log(words::EventCode code, std::string text, int side = -1, double value = 0);
    void log(words::EventCode code, words::Severity severity, std::string text, int side, double value = 0);
    void log(const RefusalLog::Told& refusal);
    AlertView alert(words::AlertCode code, int side, double value,
                    const std::vector<std::string>& said = {}) const;
    bool over() const;

    static constexpr const char* kStopped = "exercise.stopped_by_fault";

    SessionOptions options_;
    exercise::Exercise exercise_;
    assess::Assessor assessor_;
    exercise::Snapshot snapshot_; // the last good one
    exercise::Snapshot next_;     // being filled
    std::uint64_t tick_ = 0;      // the last good one
    double time_ = 0;             // s, of it
    bool seen_ = false;           // the snapshot shows it
    RunStatus status_;
    KeptCourse kept_course_;
    AlertBoard alerts_;
    RefusalLog refusals_;
    CommandHistory history_;
    std::string failure_;
    bool not_kept_ = false;                  // an alert says so
    std::deque<CheckpointView> checkpoints_; // of this exercise, by time
    bool new_checkpoint_ = false;            // the last of them is news
    /// Levers that nobody has since a hand has left them.
    struct LeversLeft {
        std::string source;
        bool goes_over = false; ///< it let go, and may be at the other place's levers
        AlertView alert;
        bool told = false;
    };
    std::array<std::optional<LeversLeft>, kAllLeverGroups.size()> left_;
    LeverOwnership lever_ownership_;
    LeverPickup lever_pickup_;
    std::vector<exercise::ExerciseEvent> events_;
    std::vector<OrderView> orders_;
    std::vector<exercise::Order> due_; // by the lesson, of one tick
    std::optional<assess::Result> new_assessment_;
    std::vector<QuestionView> questions_;
    /// What a seat was last told of: place in the lesson's questions, -1 none.
    struct Asked {
        int question = -1;
        std::uint64_t run = 0;
    };
    std::array<Asked, 2> asked_{};                 // forecastle, bridge
    bool held_ = false;                            // paused for a question, and for nothing else
    bool predicts_ = false;                        // an instructor wants it, whatever is run
    std::array<bool, 2> instructed_{};             // forecastle, bridge: something was told to it alone
    std::array<unsigned, 2> aids_told_{};          // forecastle, bridge: AidsOffered, as last told
    std::optional<std::vector<OrderView>> others_; // of an attempt for practice whose beginning is known
    bool lesson_over_told_ = false;                // to the seats, of this run
    std::uint64_t orders_taken_ = 0;               // of this run
    std::uint64_t event_number_ = 0;
    unsigned setups_ = 0;
    double now_ = 0;         // wall time of the orders being carried out
    std::mt19937_64 chance_; // draws for faults in a window, which are orders, and an attempt's own chances

    /// A LOAD whose file is being read, or a RESET whose prelude is being played.
    struct Loading {
        std::string name, source;
        bool practice = false; ///< its lesson is played for practice
        bool reset = false;
        Reading file;
        double since = 0; ///< wall time
    };
    std::optional<Loading> loading_;
    std::deque<ReceivedOrder> waiting_; // behind it
};

} // namespace windlass::run
