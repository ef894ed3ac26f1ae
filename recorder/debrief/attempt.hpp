#pragma once
// One attempt at an exercise, as a recording has it: what its debriefing is made of. Times are s of exercise
// unless their name says otherwise.

#include "recorder/debrief/series.hpp"

#include "idl/types.hpp"

#include <array>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace windlass::debrief {

/// Where everything comes from.
struct Origin {
    std::string recording; ///< its name
    std::string sha256;    ///< of its files, one behind the other
    std::uint64_t run = 0; ///< as the server counts; of several that are one attempt, the last
    /// Runs before it at whose end the server was lost, and from which it was taken up: one attempt with it.
    std::vector<std::uint64_t> taken_up_from;
    std::size_t runs = 0;           ///< attempts in the recording
    std::int64_t began_unix_ns = 0; ///< of the run, by the recorder's clock
    std::int64_t recording_began_unix_ns = 0;
    std::string recorder_version;
    bool complete = true; ///< false: a part of the recording could not be read
};

/// The state of one side at a moment, as far as reports are held against it.
struct Truth {
    double time = 0;
    double cable_out = 0; ///< m
    double lead_clock = 0;
    Stay stay = STAY_UP_AND_DOWN;
    double tension = 0;                        ///< N, at the lip
    std::optional<AnchorPhase> anchor = {};    ///< nothing: none was recorded yet
    double dragged = 0;                        ///< m, as Side
    double brake = 0;                          ///< 0..1, where the hand-wheel was
    double brake_load = 0, brake_capacity = 0; ///< N
    double cable_speed = 0;                    ///< m/s, paying out positive
    bool stopper_closed = false, power = true; ///< power: the motor had it, and had not tripped
};

/// One windlass with its cable.
struct Side {
    std::vector<Series> curves; ///< in the order of windlass_curves()
    std::vector<Truth> truths;  ///< by time, some ten a second
    std::vector<Vec3> anchor; ///< places on the ground, m, world: where it landed, and each metre it moved on
    double dragged = 0;       ///< m, on the bottom in all
    double breaking_load = 0, brake_rating = 0; ///< N
    double cable_out = 0;                       ///< m, at the end
    double brake_energy = 0;                    ///< J, since the start
    bool worked = false;                        ///< a lever or the cable was moved

    /// The last at or before that time; nullptr before the first.
    const Truth* truth_at(double time) const;
};

/// Where the ship was.
struct Place {
    double time = 0;
    double x = 0, y = 0; ///< m, world, midships
    double heading = 0;  ///< rad clockwise from north
};

struct SaidReport {
    double time = 0; ///< at which the server took it
    std::uint64_t tick = 0;
    std::string by;
    Report report;
};

struct GivenOrder {
    BridgeOrder order;  ///< its last state; time is when it was given
    double changed = 0; ///< time of its last change of state
};

/// A lever of a windlass moved by hand.
struct LeverMove {
    double time = 0;
    int side = 0;
    std::string by;
};

/// What an assessor said beside a computed mark.
struct AssessorWord {
    double time = 0;
    std::string by;
    AssessmentCommand command;
};

/// What a prediction told the instructor: it would come if nobody did anything.
struct Foreseen {
    double told = 0;      ///< the prediction's, by which it was told first
    double last_told = 0; ///< the last that still told it
    Event event;          ///< of the branch, as the first told it; its time is when it would come
};

/// How much somebody did; levers that go on the same way, as a wheel that is spun open, are moved once.
struct Hand {
    int windlass = 0, helm = 0, orders = 0, reports = 0, others = 0;
};

/// From the exercise's file, where the recording has it attached.
struct LessonText {
    std::string name;    ///< of the attachment
    std::string json;    ///< all of it
    bool taught = false; ///< there is a lesson in it; the rest is that
    std::string title;
    std::vector<std::string> questions; ///< to ask at the debriefing
};

/// Ship, cables and anchors at a moment; what was not recorded then is empty.
struct SceneAt {
    double time =
        0; ///< s of exercise, of the moment: the samples are the first at or after it, else the last before
    std::optional<ShipState> ship;
    std::array<std::optional<ChainState>, 2> chains; ///< by side
    std::array<std::optional<AnchorState>, 2> anchors;
};

struct Attempt {
    Origin origin;
    std::string exercise, title;
    std::uint64_t definition_hash = 0;
    double began = 0, ended = 0;
    double dt = 0;                       ///< s, of a tick; 0: not known
    RunState state = RUN_READY;          ///< the last that was recorded
    std::uint32_t wave_seed = 0;         ///< of the sea's phases, at the end
    double depth = 0;                    ///< m, at the bow, at the end
    double length_overall = 0, beam = 0; ///< m; 0: not known
    std::array<Side, 2> sides;
    std::vector<Series> ship;    ///< in the order of ship_curves()
    std::vector<Series> weather; ///< in the order of weather_curves()
    std::vector<Place> track;
    std::vector<Event> events;      ///< but for those of the model's own course, which are for engineers
    std::vector<GivenOrder> orders; ///< by number
    std::vector<SaidReport> reports;
    std::vector<LeverMove> lever_moves;
    std::vector<AssessorWord> words;
    std::vector<std::pair<double, double>> ahead; ///< from and until when the instructor had predictions
    std::vector<Foreseen> foreseen;               ///< by when it was told first
    std::map<std::string, Hand> hands;            ///< by the name under which orders went out
    std::optional<Assessment> assessment;
    std::optional<WatchCircle> watch; ///< the last that was set
    std::optional<SceneDescription> ship_form;
    std::optional<SeabedDescription> bed;
    std::vector<SceneAt> scenes; ///< by time, where read_scenes() has read them
    LessonText lesson;

    double duration() const { return ended - began; }
    /// When its lesson was over, where the exercise went on after that; nothing: it did not. What came then
    /// counts for nothing.
    std::optional<double> lesson_over() const;
    /// Until when it counts; infinity: all of it does.
    double counted_until() const { return lesson_over().value_or(std::numeric_limits<double>::infinity()); }
    /// s of exercise, where what counts ends.
    double counted_end() const { return lesson_over().value_or(ended); }
    /// Whether what was at that time counts; what the lesson's end itself brings does, a tick or two later.
    bool counts(double time) const { return time <= counted_until() + 0.05; }
    double time_of(std::uint64_t tick) const { return static_cast<double>(tick) * dt; }
    /// s from the recording's beginning at which a replay shows that time of exercise.
    double position_of(double time) const;
    /// The first event of that code from that time on; nullptr: there is none. side -1: of any.
    const Event* event(std::string_view code, int side = -1, double from = -1e9) const;

    /// That it goes on from a moment of another attempt, or of its own past, after which it is no test any
    /// more; nullptr: it does not.
    const Event* restored() const { return event("exercise.restored"); }

    /// Exercise time and where in the recording it is, s, by time.
    std::vector<std::pair<double, double>> positions;
};

} // namespace windlass::debrief
