#pragma once
// The door: who somebody is, and what they get. What a session hears and writes is decided here, by its seat.

#include "door/attempts.hpp"
#include "door/audit.hpp"
#include "door/certificate.hpp"
#include "door/class_runs.hpp"
#include "door/cmi5/outbox.hpp"
#include "door/kiosks.hpp"
#include "door/slow_work.hpp"
#include "door/staff_sessions.hpp"
#include "door/stations.hpp"
#include "station/gateway/assets.hpp"
#include "station/gateway/host.hpp"
#include "station/gateway/line_log.hpp"

#include <set>

namespace windlass::door {

/// What a class that is over leaves of one exercise.
struct AttemptMade {
    std::string recording;   ///< its name
    std::string class_id;    ///< of whom they are
    std::vector<Part> parts; ///< whose work it was
};

/// One exercise of a class that is over.
struct ExerciseMade {
    std::string who;       ///< "anna, forecastle; ben, bridge to 4:00"; its name where nobody sat there
    std::string recording; ///< its name; empty: none was made
};

struct DoorOptions {
    std::filesystem::path state;    ///< folder: people, classes, audit log
    std::string exercise;           ///< that staff's pages show unless they name another
    std::vector<std::string> names; ///< under which people reach this machine
    Certificate certificate;        ///< to tell of
    /// Exercise files as ExerciseFiles lists them. Runs on a thread of its own. Throws std::exception.
    std::function<nlohmann::json()> lessons;
    /// Whether a lesson, by its file's name, judges a trainee on the bridge. Nothing: none does.
    std::function<bool(const std::string& lesson)> bridge_is_judged = {};
    /// The page of a recording's debriefing, by the recording's name. The same. who: sat there.
    /// what_if: address of the page below.
    std::function<std::string(const std::string& recording, const std::string& who,
                              const std::string& what_if)>
        debriefing;
    /// The page of a class side by side, each exercise leading to its debriefing. On a thread of its own.
    std::function<std::string(const std::string& title, const std::vector<ExerciseMade>& exercises)>
        side_by_side = {};
    /// That page with what would have kept lost points, or how far the search is. On the network's thread.
    std::function<std::string(const std::string& recording)> what_if;
    /// Puts an attempt into the history, or brings it up to date there. The same.
    std::function<void(const AttemptMade& made)> put_in_history;
    /// What each of these trainees is to practise next, by the history: their names in, [{name, file, title,
    /// why, practice, after, from, no_from}] out; who is in no history has no row. The same.
    std::function<nlohmann::json(const std::vector<std::string>& names)> next = {};
    /// Puts an assessor's word into the history. Why it does not take it; empty: it stands. The same.
    std::function<std::string(const AttemptJudged& judged)> judge = {};
    /// The words of assessors that stand on the attempts of these recordings, by the history. The same.
    std::function<std::vector<AttemptJudged>(const std::vector<std::string>& recordings)> words = {};
    /// Who may start lessons here; none: nobody does, and nothing goes out.
    cmi5::LearningSystems learning_systems = {};
    cmi5::WebClient web = cmi5::WebClient(); ///< asks them
    /// What came of a recording's attempt. The same.
    std::function<cmi5::Marks(const std::string& recording)> marks_of = {};
};

/// How a request came: by TLS, or without on loopback.
enum class Way { tls, loopback };

/// Of the cookie by which a browser is known; by TLS no other site of this machine can set it.
const char* cookie_name(Way way);
/// The same of a device that stands at one seat.
const char* kiosk_cookie_name(Way way);

/// Close codes of a WebSocket that has a seat no more: the page asks where its browser belongs now; after the
/// second it may show its marks until they are read.
constexpr int kSentAway = 4001, kMayRead = 4002;

class DoorHost final : public gateway::Host {
public:
    static constexpr std::size_t kLinks = 6; ///< WebSockets of one browser at a time: the pages of its seat

    /// Reads what the state folder keeps. Throws std::runtime_error.
    DoorHost(DoorOptions options, const gateway::Assets& assets, Stations& stations, gateway::LineLog& log);

    /// With which the first owner sets themselves up; empty: there is one.
    const std::string& setup_token() const { return setup_token_; }

    /// Where people come to, once it is known.
    void at_port(unsigned short port) { port_ = port; }

    void judge(const gateway::Request& request, Reply reply) override { judge(Way::tls, request, reply); }
    void judge(Way way, const gateway::Request& request, const Reply& reply);
    void tick(gateway::Clock::time_point now) override;
    void log(const std::string& line) override { log_.tell(line); }

private:
    /// Whose browser a request is of.
    struct Who {
        Way way = Way::tls;
        std::string address;
        std::string key;                  ///< of its cookie, or of the kiosk's; empty: it has none
        std::optional<Person> staff = {}; // one of the two, or nobody
        std::optional<ClassBook::Seated> trainee = {};
        std::optional<Kiosk> kiosk = {}; // whoever sits at it
    };
    /// An open WebSocket.
    struct Link {
        std::weak_ptr<gateway::PageSession> session;
        std::string address;
    };
    using Json = nlohmann::json;

    Who who(Way way, const gateway::Request& request);

    // Pages (door_pages.cpp).
    gateway::Verdict file(const std::string& path, const Who& who) const;
    gateway::Verdict link(const gateway::Request& request, const Who& who);
    std::vector<Link>& links(const std::string& key);
    void send_away(const std::string& key, const std::string& why, int code = kSentAway);
    void part_with(const TrainingClass& its_class);
    void see_out(gateway::Clock::time_point now);

    // Questions and acts, as JSON (door_acts.cpp).
    void ask(const std::string& target, const Who& who, const Reply& reply);
    void act(const std::string& path, const std::string& body, const Who& who, const Reply& reply);
    gateway::Verdict join(const Who& who, const Json& asked);
    const TrainingClass& class_of(const Who& who, const Json& asked, const std::string& name);
    gateway::Verdict names(const Who& who, const Json& asked);
    void leave_seat(const Who& who);
    gateway::Verdict open_kiosk(const Who& who, const Json& asked);
    gateway::Verdict sit(const Who& who);
    gateway::Verdict keep_kiosks(const Who& who, const Json& asked);
    Json kiosks() const;
    void turn_out_kiosks();

    // Lessons that a learning system starts (launch_acts.cpp).
    struct Arrived;
    void launch(const Who& who, const Json& asked, const Reply& reply);
    gateway::Verdict arrive(const Who& who, const Arrived& arrived);
    std::string learner_name(const Json& actor) const;
    gateway::Verdict finish(const Who& who);
    Json launch_told(const std::string& browser) const;
    void end_launch(const std::string& class_id);
    void tend_launches(gateway::Clock::time_point now);
    void tend_launch(const TrainingClass& its_class, gateway::Clock::time_point now);
    void settle_launch(const TrainingClass& its_class);
    void close_session(const std::string& id, const std::optional<cmi5::Marks>& marks);
    void post_statements();

    void log_in(const Who& who, const Json& asked, const Reply& reply);
    void set_up(const Who& who, const Json& asked, const Reply& reply);
    gateway::Verdict logged_in(const Who& who, const std::string& name, const std::string& how);
    gateway::Verdict log_out(const Who& who);
    gateway::Verdict lead(const Who& who, const Json& asked);
    void marks(const std::string& id, const Reply& reply);
    void next(const std::string& id, const Reply& reply);
    void take_word(const Who& who, const Json& asked, const Reply& reply);
    void debrief(const std::string& recording, bool what_if, const Reply& reply);
    void lay_side_by_side(const std::string& id, const Reply& reply);
    std::optional<std::string> who_made(const std::string& recording) const;
    void let_in(const Who& who, const Json& asked, const Reply& reply);
    void log_out_all(const std::string& name);
    Json me(const Who& who) const;
    Json classes();
    Json class_told(const TrainingClass& told);
    /// s for which the hand at the pages of that key has done nothing; nothing: none is open.
    std::optional<double> silence_of(const std::string& key);
    Json people() const;
    gateway::Verdict with_cookie(const Who& who, const std::string& secret, Json body) const;
    void keep_classes() const;
    void note_results();
    void keep_attempts();

    const DoorOptions options_;
    const gateway::Assets& assets_;
    Stations& stations_;
    gateway::LineLog& log_;
    const Audit audit_;
    People people_;
    Kiosks kiosks_;
    ClassBook book_;
    ClassRuns runs_;
    StaffSessions staff_;
    Attempts wrong_codes_, wrong_passwords_;
    std::string setup_token_;
    unsigned short port_ = 0;                        // of TLS
    std::map<std::string, std::vector<Link>> links_; // by key
    std::map<std::string, std::string>
        turned_away_; // address that was told last that it is elsewhere, by key
    /// Who sat in a class that is over, until the marks have come.
    struct Leaver {
        std::string key, exercise;
        gateway::Clock::time_point until; // no longer than that
    };
    std::vector<Leaver> leavers_;
    gateway::Clock::time_point next_look_{};
    std::set<std::string> asked_for_history_; // recordings, by this program: each once
    /// How many words of assessors this program has put into the history, by class: pages look again when it
    /// counts up.
    std::map<std::string, int> words_given_;
    SlowWork slow_;

    cmi5::Outbox outbox_;
    struct Watched {
        gateway::Clock::time_point seen;                         // its page was open
        std::optional<gateway::Clock::time_point> recorded = {}; // since when
        std::optional<gateway::Clock::time_point> finished = {}; // since when
        bool asked_for_marks = false;
    };
    std::map<std::string, Watched> watched_;  // launches, by class
    std::set<std::string> launching_;         // digests of fetch addresses that are being asked
    SlowWork launches_{8, 64}, posts_{4, 64}; // a learning system that is slow holds up no login
};

} // namespace windlass::door
