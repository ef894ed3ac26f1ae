#pragma once
// What goes beside a trainee who practises: the lesson's model hands, whom he may have shown over his own
// levers, and the search for a hint. Both have what time all others leave.

#include "server/assess/state.hpp"
#include "server/dds/ghost.hpp"
#include "server/host/idle_work.hpp"
#include "server/run/hint_search.hpp"
#include "server/run/session.hpp"

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>

namespace windlass::host {

/// One exercise between the thread that ticks it and the lookout, as an Outlook is. The exercise is read, and
/// what is found goes into it as an order.
class Companion final : public IdleWork {
public:
    using Clock = std::chrono::steady_clock;
    using Time = Clock::time_point;
    /// Shows a seat the model's hands.
    using Show = std::function<void(const dds::Ghost& hands, bool forecastle)>;

    /// What there is to do is looked for so often, and so often hands are shown.
    static constexpr std::chrono::milliseconds kApart{100};
    /// A hint that takes longer, of wall or of processor time, is what was known by then.
    static constexpr std::chrono::seconds kPatience{20};
    static constexpr double kMostTime = 12; ///< s

    explicit Companion(run::ModelHandsFrom from) : from_(std::move(from)) {}

    // Of the thread that ticks, between two ticks.

    /// Shows what was made, tells what was found, and gives the lookout what it needs: true, and it is to be
    /// called.
    bool look(run::Session& session, Time now, const Show& show);
    void close() { closed_ = true; }

    // Of the lookout.

    bool go_on() override;
    bool closed() const override { return closed_; }

private:
    bool look_for_hint(run::Session& session, Time now);
    bool look_at_hands(const run::Session& session, const Show& show);
    bool search();
    bool play();
    bool takes_what_is_new();
    void play_on(Time end);
    bool tells_too_much();

    const run::ModelHandsFrom from_;

    // Of the thread that ticks
    Time looked_at_{};
    std::size_t others_given_ = 0;

    std::atomic<bool> closed_{false};

    // Between them
    std::mutex mutex_;     // of what follows; the thread that ticks only tries it
    unsigned attempt_ = 0; // whose hands are wanted: Session::setups(); 0: none are
    std::optional<run::Beginning> beginning_;
    std::vector<run::OrderView> orders_; // that the hands have not taken yet
    std::uint64_t until_ = 0;            // tick of the trainee's exercise
    assess::State trainee_;
    std::vector<exercise::FaultView> faults_; // of his exercise
    bool made_ = false;                       // there is a picture of these hands, as of now or nearly
    dds::Ghost picture_;
    enum class Hint { none, asked, found } hint_ = Hint::none;
    unsigned hint_of_ = 0; // Session::setups()
    bool hint_forecastle_ = true;
    std::vector<std::uint8_t> hint_state_;
    Time asked_at_{};
    assess::AidWord found_;

    // Of the lookout
    unsigned playing_ = 0; // attempt
    std::unique_ptr<run::ModelHands> hands_;
    std::optional<dds::GhostMaker> maker_;
    std::vector<run::OrderView> orders_now_;
    std::uint64_t until_now_ = 0;
    assess::State trainee_now_;
    std::vector<exercise::FaultView> faults_now_;
    bool ahead_ = false;
    dds::Ghost made_now_; // the last that tells nothing; empty: there was none yet
    std::optional<run::HintSearch> search_;
    double spent_ = 0; // s of processor time on it
};

} // namespace windlass::host
