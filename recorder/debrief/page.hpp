#pragma once
// The debriefing as one HTML document: no script, no file beside it, no network.

#include "recorder/debrief/attempt.hpp"

#include <optional>

namespace windlass::debrief {

/// Where a key moment leads to.
struct Links {
    enum class Kind {
        none,   ///< commands as text only: a file that nobody serves
        beside, ///< the page is served by the station that has the replay
        station ///< a station elsewhere
    };
    Kind kind = Kind::none;
    std::string station;      ///< its address, e.g. "http://127.0.0.1:8765"
    std::string token;        ///< of it; empty: the browser's session has it
    std::string what_if = {}; ///< beside: of the same page with what would have kept lost points; empty: none

    /// The replay of that recording at that position, s from its beginning; empty: there is none.
    std::string to(const std::string& recording, double position) const;
};

/// What the instructor's station printed, e.g. "http://127.0.0.1:8765/instructor#token=0123ab": its address
/// and token. Throws std::runtime_error when it is none.
Links links_to(const std::string& address);

/// The name of a ghost that is the lesson's model run.
inline constexpr const char* kModelGhost = "as the model hands did it";

/// The same lesson as other hands did it, behind one's own curves. It can be put out of sight.
struct Ghost {
    const Attempt* attempt = nullptr;
    std::string name; ///< kModelGhost, "as in monday"
};

/// One quantity as it was, and as it would have been by one change.
struct TwoCourses {
    std::string title, unit; ///< what it is; of the values
    std::vector<Sample> was, would;
    std::optional<double> least, most; ///< that the lesson allows
};

/// What would have kept a criterion that lost points, as the search for it says (docs/whatif.md).
struct Remedy {
    std::string criterion;      ///< its code
    std::optional<double> time; ///< s of exercise, at which something is otherwise; nothing: nothing helps
    std::string words;
    double changed = 0, lost = 0;         ///< s of exercise: when something is otherwise, when it was lost
    std::vector<TwoCourses> courses = {}; ///< of a change that moves anything
    bool only_said = false;               ///< nothing moves otherwise than it did: the change is one of words
    int side = 0;                         ///< whose cable the pictures are of
    std::optional<SceneAt> was = {}, would = {}; ///< at the end of the curves; nothing: no change helps
};

/// What an assessor has said of an attempt once it was over, as a history has it.
struct LaterWord {
    std::string by;
    std::optional<double> points; ///< of 100, that stand; nothing: there are none
    std::string outcome, note;    ///< achieved, not_yet, not_shown; why

    /// "80.0 points, achieved".
    std::string stands() const;
};

struct PageOptions {
    Links links;
    std::vector<const Attempt*> over = {}; ///< other attempts, laid over the plots: three at most
    std::optional<Ghost> ghost = {};
    std::string no_ghost = {};                        ///< why there is none where one was wanted
    std::optional<std::vector<Remedy>> remedies = {}; ///< nothing: they were not searched for
    std::optional<LaterWord> word = {};               ///< nothing: no assessor has said anything since
    std::string who =
        {}; ///< "anna, forecastle; ben, bridge": who sat there; empty: only who did something is known
};

std::string page_of(const Attempt& attempt, const PageOptions& options);

/// Stands for a page that is not made yet, says how far that is, and looks again by itself. again: false: it
/// says why there will be none.
std::string waiting_page(const std::string& title, const std::string& words, bool again);

} // namespace windlass::debrief
