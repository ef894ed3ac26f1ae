#pragma once
// A hint that is searched for: the smallest single move of a lever, made now, that keeps what is lost within
// a minute if nobody does anything. Every move is played, by a branch that is thrown away.
//
// A hint must not tell what is to come. No branch has the lesson's next orders, faults or weather in it, and
// no fault that is armed comes: each goes on from what is so now, with what there is now.

#include "server/assess/aids.hpp"
#include "server/run/course.hpp"

#include <optional>
#include <vector>

namespace windlass::run {

class HintSearch {
public:
    static constexpr double kAhead = 60; ///< s of exercise that are looked ahead
    /// s behind the instant at which it is lost else, for which a move is to keep it.
    static constexpr double kBeyond = 15;
    static constexpr double kReading = 2; ///< s in which a trainee has read it, and has his hand at the lever

    /// checkpoint: of an exercise with a lesson as it stands. forecastle: who asks: he has levers of his own.
    /// Throws exercise::CheckpointError.
    HintSearch(const std::vector<std::uint8_t>& checkpoint, bool forecastle);

    /// One tick of a branch. False: it is at its end, and what was found says what is known.
    bool step();
    /// It has cost enough: what was found by now.
    void give_up();

    const assess::AidWord& found() const { return found_; }
    std::size_t tried() const { return tried_; } ///< branches

private:
    struct Move {
        assess::Lever lever;
        double value = 0;
        double from = 0; ///< where the lever stands
    };
    /// What a branch has come to: when each criterion was lost, in ticks; -1: it was not.
    using Lost = std::vector<std::int64_t>;
    enum class Part { as_it_is, strong, smaller, later, weak, done };

    void begin(const std::optional<Move>& move, double at);
    void look();
    void end_of_branch();
    bool over() const;
    bool keeps() const;
    void after_as_it_is();
    void next_of(const std::vector<Move>& moves, Part behind);
    void begin_smaller();
    void tell(const Move& move);
    std::vector<Move> strong_moves() const;
    std::vector<Move> weak_moves() const;
    std::vector<assess::Lever> levers() const;
    double value_now(const assess::Lever& lever) const;
    int goal(std::size_t criterion) const;

    std::vector<std::uint8_t> checkpoint_;
    bool forecastle_;
    assess::AidWord found_;
    std::size_t tried_ = 0;

    std::optional<Course> course_;
    std::optional<Move> move_; // of this branch; nothing: as it is
    std::uint64_t moves_at_ = 0, began_ = 0, ends_ = 0;
    Lost lost_;

    assess::Lesson lesson_;
    std::array<exercise::WindlassOrder, 2> windlass_{};
    exercise::HelmOrder helm_{};
    std::vector<exercise::Side> sides_;
    double rudder_max_ = 0;
    std::vector<bool> open_; // criteria that can still be lost
    Lost as_it_is_;
    std::size_t target_ = 0;
    Part part_ = Part::as_it_is;
    std::vector<Move> moves_;
    std::size_t at_ = 0;
    Move best_;
    double keeps_ = 0, fails_ = 0; // the lever's places between which the smallest is searched
};

} // namespace windlass::run
