#pragma once
// The messages of a run, one after the other, into an attempt.

#include "recorder/debrief/attempt.hpp"
#include "recorder/recording/recording.hpp"

namespace windlass::debrief {

/// Of each lever of a windlass or the helm which way it goes: -1, 0, 1.
using Way = std::array<int, 5>;

class AttemptReader {
public:
    /// The attempt's run, beginning and end are known already. interval: s, of its curves.
    AttemptReader(Attempt& attempt, double interval);
    /// That of an attempt's curves.
    static double interval_of(const Attempt& attempt);

    /// Those that it understands.
    static std::set<std::string> topics();

    /// In the order of the recording. in_run: false for what came before the run and may hold in it. False:
    /// the message is not of its type.
    bool read(const recording::Message& message, bool in_run);
    /// After the last.
    void finish();

    void add(const WindlassLoad& load);
    void add(const ChainState& chain);
    void add(const AnchorState& anchor);
    void add(const ShipState& ship);
    void add(const EnvironmentState& air);
    void add(const Event& event);
    void add(const BridgeOrder& order);
    void add(const ExerciseTruth& truth);
    void add(const Assessment& assessment);
    void add(const OrderTaken& order);
    void add(const Prediction& prediction);

private:
    bool ours(std::uint64_t run) const;
    /// What was heard beyond that time has not happened: the server was lost before it was kept.
    void take_back_to(double time);

    /// Whether a stream's sample comes after those before it, and lies in the run.
    bool in_order(double time, double& last) const;

    /// One move of levers, in many orders: the same hand, the same way, without a rest.
    struct Stroke {
        /// Whether it is another that this order begins. time: s.
        bool begins(const std::string& by, double time, const Way& way);
        std::string hand;
        double last = -1e9; ///< s, of its last order
        Way towards{};
    };

    Attempt& attempt_;
    struct OfSide {
        double load = -1e9, chain = -1e9, anchor = -1e9; ///< time of the last sample
        Truth now;                                       ///< as told last
        std::optional<WindlassLoad> first;
        std::optional<WindlassCommand> levers;
        Stroke stroke;
    };
    std::array<OfSide, 2> sides_;
    std::optional<HelmCommand> helm_;
    Stroke helm_stroke_;
    double ship_ = -1e9, air_ = -1e9;
    bool sees_ahead_ = false; // predictions are shown, and have not been switched off
    double interval_;         ///< s, of the series
};

} // namespace windlass::debrief
