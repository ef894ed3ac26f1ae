// recorder control: steers a replay that runs, over DDS.

#include "idl/wire.hpp"
#include "recorder/command.hpp"
#include "recorder/replay/playhead.hpp"
#include "station/options.hpp"

#include <fmt/format.h>

#include <condition_variable>
#include <mutex>
#include <optional>
#include <unistd.h>

namespace windlass::recorder {

namespace {

using namespace std::chrono_literals;

struct ControlOptions {
    station::SessionOptions session{.partition = "replay", .name = fmt::format("control-{}", getpid())};
    double timeout = 3;
    std::optional<ReplayAction> action; ///< nothing: only look
    double value = 0;
};

/// What the replay says of itself, as it comes in.
class Heard {
public:
    void take(const ReplayStatus& status, const wire::WriterId& replay) {
        const std::lock_guard lock(mutex_);
        last_ = status;
        replay_ = replay;
        news_.notify_all();
    }

    /// The replay that was heard last hears that writer too, and not only who looks on.
    bool has(const wire::Writer<ReplayCommand>& writer) {
        const std::lock_guard lock(mutex_);
        return writer.heard_by(replay_);
    }

    template <class Condition>
    std::optional<ReplayStatus> wait(double timeout, Condition condition) {
        std::unique_lock lock(mutex_);
        news_.wait_for(lock, std::chrono::duration<double>(timeout),
                       [&] { return last_ && condition(*last_); });
        return last_ && condition(*last_) ? last_ : std::nullopt;
    }

private:
    std::mutex mutex_;
    std::condition_variable news_;
    std::optional<ReplayStatus> last_;
    wire::WriterId replay_{};
};

int control(const ControlOptions& options) {
    wire::Participant participant(options.session.session());
    Heard heard;
    const wire::Reader<ReplayStatus> reader(
        participant, wire::topics::replay_status,
        [&](const ReplayStatus& status, const wire::WriterId& replay) { heard.take(status, replay); });
    wire::Writer<ReplayCommand> writer(participant, wire::topics::replay_command);
    auto status = heard.wait(options.timeout, [&](const auto&) { return true; });
    for (auto end = Playhead::Clock::now() + std::chrono::duration<double>(options.timeout);
         status && !heard.has(writer) && Playhead::Clock::now() < end;)
        std::this_thread::sleep_for(5ms);
    if (!status || !heard.has(writer))
        throw std::runtime_error(fmt::format("no replay heard on domain {}, partition {}, in {:g} s",
                                             options.session.domain, options.session.partition,
                                             options.timeout));
    if (options.action) {
        ReplayCommand command;
        command.origin().source(options.session.name);
        command.origin().serial(1);
        command.origin().sent_unix_ns(std::chrono::system_clock::now().time_since_epoch() / 1ns);
        command.action(*options.action);
        command.value(options.value);
        writer.write(command);
        const auto before = *status;
        if (*options.action == REPLAY_STOP) {
            writer.wait_acknowledged(std::chrono::milliseconds(static_cast<int>(options.timeout * 1000)));
            fmt::print("stop asked\n");
            return kOk;
        }
        status = heard.wait(options.timeout, [&](const ReplayStatus& now) {
            return now.commands_accepted() + now.commands_refused() >
                   before.commands_accepted() + before.commands_refused();
        });
        if (!status) throw std::runtime_error("the replay does not answer");
        if (status->commands_refused() > before.commands_refused())
            throw std::runtime_error(status->refusal().to_string());
    }
    fmt::print("{}: {} at {:.1f} of {:.1f} s, speed {:g}{}\n", status->recording().to_string(),
               status->playing() ? "playing" : "paused", status->position(), status->duration(),
               status->speed(), status->loop() ? ", loop" : "");
    return kOk;
}

} // namespace

void add_control(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<ControlOptions>();
    CLI::App& sub = *app.add_subcommand("control", "steer a replay that runs");
    options->session.add_to(sub);
    sub.add_option("--timeout", options->timeout, "s to wait for the replay and for its answer")
        ->check(number_in(0.01, 1e4))
        ->capture_default_str();
    sub.fallthrough();
    const auto add = [&](const char* name, const char* text, std::optional<ReplayAction> action) {
        CLI::App* one = sub.add_subcommand(name, text);
        one->callback([&chosen, options, action] {
            options->action = action;
            chosen = [options] { return control(*options); };
        });
        return one;
    };
    add("status", "what it does now", std::nullopt);
    add("play", "go on, or begin again at the end", REPLAY_PLAY);
    add("pause", "hold the picture", REPLAY_PAUSE);
    add("stop", "end the replay", REPLAY_STOP);
    add("seek", "show another moment", REPLAY_SEEK)
        ->add_option("seconds", options->value, "from the recording's beginning")
        ->required();
    add("speed", "faster or slower", REPLAY_SPEED)
        ->add_option("speed", options->value, "seconds of the recording per second, 0.1 to 10")
        ->required();
    add("loop", "begin again at the end, or not", REPLAY_LOOP)
        ->add_option("on", options->value, "1: on, 0: off")
        ->required();
    sub.require_subcommand(1);
    sub.footer("Exit codes: 0 done, 1 no replay, refused or not answered, 2 bad option.");
}

} // namespace windlass::recorder
