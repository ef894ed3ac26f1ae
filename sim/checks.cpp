#include "sim/checks.hpp"

#include "server/exercise/checkpoint.hpp"
#include "server/run/questions.hpp"
#include "words/words.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace windlass::sim {

namespace {

using exercise::RunState;
using run::AlertCondition;

constexpr std::uint64_t kMarkEvery = 30; // ticks
constexpr double kMoved = -1;            // s: a lever that lay there, and was moved since
constexpr std::array<const char*, 2> kSeats{"forecastle", "bridge"};

std::array<double, 5> values_of(const exercise::Order& order) {
    if (const auto* windlass = std::get_if<exercise::WindlassOrder>(&order))
        return {windlass->brake, windlass->speed_lever, windlass->clutch_in ? 1.0 : 0.0,
                windlass->stopper_closed ? 1.0 : 0.0, windlass->emergency_stop ? 1.0 : 0.0};
    const auto& helm = std::get<exercise::HelmOrder>(order);
    return {helm.engine, helm.rudder, helm.bow_thruster, helm.stern_thruster, 0};
}

std::array<double, 5> values_of(const dds::Mailbox::Sample& sample) {
    if (const auto* windlass = std::get_if<WindlassCommand>(&sample))
        return {windlass->brake(), windlass->speed_lever(), windlass->clutch_in() ? 1.0 : 0.0,
                windlass->stopper_closed() ? 1.0 : 0.0, windlass->emergency_stop() ? 1.0 : 0.0};
    const auto& helm = std::get<HelmCommand>(sample);
    return {helm.engine(), helm.rudder(), helm.bow_thruster(), helm.stern_thruster(), 0};
}

/// 0 port, 1 starboard, 2 helm; -1: no levers.
int group_of(const exercise::Order& order) {
    const auto group = run::LeverOwnership::levers_of(order);
    return group ? static_cast<int>(*group) : -1;
}

int group_of(const dds::Mailbox::Sample& sample) {
    if (const auto* windlass = std::get_if<WindlassCommand>(&sample)) return windlass->side();
    return std::holds_alternative<HelmCommand>(sample) ? 2 : -1;
}

std::string source_of(const dds::Mailbox::Sample& sample) {
    return std::visit([](const auto& one) { return one.origin().source().to_string(); }, sample);
}

std::uint64_t serial_of(const dds::Mailbox::Sample& sample) {
    return std::visit([](const auto& one) { return one.origin().serial(); }, sample);
}

std::string text(const Checks::Place& place) {
    return fmt::format("tick {} with {} orders", place.tick, place.orders);
}

bool before(const Checks::Place& one, const Checks::Place& other) {
    return one.tick < other.tick || one.orders < other.orders;
}

std::uint64_t assessment_of(const assess::Assessor& assessor) {
    return assessor.assesses() ? assessor.result().assessment_hash : 0;
}

} // namespace

void Checks::fail(std::string check, std::string expected, std::string found) const {
    throw Failure{std::move(check), std::move(expected), std::move(found)};
}

void Checks::add(std::uint64_t number) {
    for (int k = 0; k < 8; ++k)
        digest_ = (digest_ ^ ((number >> (8 * k)) & 0xff)) * 1099511628211ULL;
}

void Checks::add(const std::string& said) {
    for (const char c : said)
        digest_ = (digest_ ^ static_cast<std::uint8_t>(c)) * 1099511628211ULL;
}

// ---- the course, and the undisturbed one

/// The course begins at its definition.
void Checks::begin_line(const run::Session& session) {
    Line anew;
    anew.number = ++line_number_;
    anew.def = std::make_shared<const exercise::ExerciseDef>(session.def());
    // Its chance was drawn as it was set up, and stands in its checkpoint alone.
    const run::CheckpointView* checkpoint = session.checkpoint();
    if (checkpoint != nullptr && checkpoint->tick == 0 && checkpoint->orders_taken == 0) {
        assess::Assessor assessor;
        exercise::read_checkpoint(checkpoint->data, {}, &assessor);
        anew.assessor = std::move(assessor);
    }
    lines_.push_back(std::move(anew));
    run_base_ = 0;
}

/// One tick after the other, each order at its tick, and each mark held against it.
void Checks::go_through(Line& line, std::uint64_t tick, std::size_t orders) {
    const auto past = [&] {
        return undisturbed_->course.exercise().tick() > tick || undisturbed_->orders > orders;
    };
    if (!undisturbed_ || undisturbed_->line != line.number || past())
        undisturbed_.emplace(Undisturbed{
            .line = line.number,
            .course = {exercise::Exercise(*line.def), line.assessor.value_or(assess::Assessor()), 0}});
    Undisturbed& at = *undisturbed_;
    for (;;) {
        hold_against(line);
        const std::uint64_t now = at.course.exercise().tick();
        if (at.orders < orders && line.orders[at.orders].tick <= now) {
            at.course.take(line.orders[at.orders++]);
        } else if (now >= tick) {
            return;
        } else if (!at.course.step()) {
            fail("state", "finite", fmt::format("not finite at tick {}", now));
        }
    }
}

void Checks::hold_against(Line& line) {
    Undisturbed& at = *undisturbed_;
    const std::uint64_t tick = at.course.exercise().tick();
    while (at.marks < line.marks.size()) {
        const Line::Mark& mark = line.marks[at.marks];
        if (mark.tick > tick || (mark.tick == tick && mark.orders > at.orders)) return;
        ++at.marks;
        if (mark.tick < tick || mark.orders < at.orders) continue; // gone through already
        if (const std::uint64_t hash = at.course.state_hash(); hash != mark.hash)
            fail("state",
                 fmt::format("{:016x} at tick {}, of {} orders undisturbed", hash, tick, mark.orders),
                 fmt::format("{:016x}", mark.hash));
        if (!line.assessor) continue;
        if (const std::uint64_t hash = assessment_of(at.course.assessor()); hash != mark.assessment)
            fail("marks", fmt::format("{:016x} at tick {}, undisturbed", hash, tick),
                 fmt::format("{:016x}", mark.assessment));
    }
}

/// Whether that is the state; where there was a lesson as it began, with its marks.
bool Checks::is(const run::Course& course, const Line& line, const State& state) {
    return course.exercise().tick() == state.tick && course.state_hash() == state.hash &&
           (!state.assessment || !line.assessor || assessment_of(course.assessor()) == *state.assessment);
}

/// The same once more, to try something with. What the undisturbed course itself goes through comes from no
/// checkpoint: where one forgot something, a server that was taken up from it would be held against the same.
run::Course Checks::copy_of(const run::Course& course, const Line& line) {
    const bool lesson = line.assessor.has_value();
    assess::Assessor assessor;
    exercise::Exercise copy = exercise::read_checkpoint(
        exercise::write_checkpoint(course.exercise(), lesson ? &course.assessor() : nullptr), {},
        lesson ? &assessor : nullptr);
    return {std::move(copy), std::move(assessor), course.orders_taken()};
}

/// With how many of the line's orders it comes to that state, at that tick or, with the orders behind them,
/// at a later one; nothing: with no number. The undisturbed course stands there then, with no more of that
/// tick's orders.
std::optional<std::size_t> Checks::orders_of(Line& line, std::uint64_t tick, const State& state) {
    const auto number = [&](auto order) { return static_cast<std::size_t>(order - line.orders.begin()); };
    const std::size_t least = number(std::ranges::lower_bound(line.orders, tick, {}, &run::OrderView::tick));
    const std::size_t most = number(std::ranges::upper_bound(line.orders, tick, {}, &run::OrderView::tick));
    const auto told = line.checkpoints.find(tick);
    const auto last_of = [&](std::size_t orders, std::size_t last) { // where levers were moved and moved back
        go_through(line, tick, orders);
        std::optional<run::Course> copy; // with more of the tick's orders
        std::optional<std::size_t> found;
        for (;; copy->take(line.orders[orders++])) {
            const run::Course& course = copy ? *copy : undisturbed_->course;
            if (state.behind.empty() ? is(course, line, state) : comes_to(course, line, state)) {
                found = orders;
                if (!state.behind.empty() && told != line.checkpoints.end() && told->second == orders) break;
            }
            if (orders == last) break;
            if (!copy) copy = copy_of(undisturbed_->course, line);
        }
        return found;
    };
    // Where the course stands among these already, as of an exercise that was lost and stands still, it need
    // not be gone through from its beginning for those before.
    std::size_t first = least;
    if (state.behind.empty() && undisturbed_ && undisturbed_->line == line.number &&
        undisturbed_->course.exercise().tick() == tick && undisturbed_->orders > least &&
        undisturbed_->orders <= most)
        first = undisturbed_->orders;
    if (const auto found = last_of(first, most); found || first == least) return found;
    return last_of(least, first - 1);
}

/// Whether the orders behind it make that state of the course.
bool Checks::comes_to(const run::Course& course, const Line& line, const State& state) {
    run::Course copy = copy_of(course, line);
    const auto go_on = [&](std::uint64_t tick) {
        while (copy.exercise().tick() < tick)
            if (!copy.step()) return;
    };
    for (const run::OrderView& order : state.behind) {
        go_on(order.tick);
        copy.take(order);
    }
    go_on(state.tick);
    return is(copy, line, state);
}

/// The line is left there; false: it does not come to that state.
bool Checks::go_on_from(Line& line, std::uint64_t tick, const State& state) {
    const auto found = orders_of(line, tick, state);
    if (!found) return false;
    line.orders.resize(*found);
    std::erase_if(line.marks,
                  [&](const Line::Mark& mark) { return mark.tick > tick || mark.orders > *found; });
    std::erase_if(line.checkpoints, [&](const auto& one) { return one.first > tick || one.second > *found; });
    undisturbed_->marks = std::min(undisturbed_->marks, line.marks.size());
    go_through(line, tick, *found);
    if (state.behind.empty() && !is(undisturbed_->course, line, state))
        fail("state", fmt::format("{:016x} at tick {}, as a copy of the course came to", state.hash, tick),
             fmt::format("{:016x} of the course", undisturbed_->course.state_hash()));
    return true;
}

void Checks::starts(const Beginning& how) {
    if (std::exchange(left_whole_, false) && how.attempts > 0 && !how.rotten)
        fail("kept", "no loss is counted of a server that ended by itself",
             fmt::format("{} are", how.attempts));
    for (Line& one : lines_) {
        if (how.lost_by == Loss::power_cut) one.left = 0; // what was forgotten may be there again
        ++one.starts;
    }
}

void Checks::left_whole() {
    left_whole_ = true;
    for (Line& one : lines_)
        one.left = one.starts;
}

/// A course of which something is kept is set back when servers that took it up were lost twice, and for no
/// loss of a course before it.
void Checks::hold_set_back(const Place& promise, const Beginning& how) const {
    const auto kept = std::ranges::find(lines_, promise.line, &Line::number);
    const std::size_t starts = kept == lines_.end() ? 3 : kept->losses();
    if (starts < 3 && !how.set_back_before)
        fail("kept", "taken up at " + text(promise) + " or later",
             fmt::format("set back, as server {} of its course begins: {}", starts, how.set_back));
}

void Checks::begins(const run::Session& session, const Beginning& how) {
    run_ = session.status().run;
    event_ = 0;
    alerts_.clear();
    raised_.clear();
    heard_.clear(), left_.clear(), serials_.clear(), taken_ = 0;
    levers_ = {}, holders_ = {}, takings_ = {}, asked_ = {};
    was_running_ = was_held_ = false;
    listened_ = 0, listened_at_ = 0, ran_ = false;
    tick_ = session.now_tick();
    const auto promise = promised(how.lost_by);
    if (promise && !how.set_back.empty()) hold_set_back(*promise, how);
    if (!how.taken_up) {
        const bool excused = how.first || how.rotten || !how.set_back.empty() || how.set_back_before;
        if (!how.refused.empty() && how.set_back.empty() && !how.rotten)
            fail("kept", "what was kept is taken up", "refused: " + how.refused);
        if (!excused && promise)
            fail("kept", "taken up at " + text(*promise) + " or later", "begins anew: nothing was kept");
        for (Line& left : lines_) // until the disk has the new one, the power may bring them back
            left.handed_over.reset(), left.on_disk.reset();
        begin_line(session);
        branch(session, tick_);
        return;
    }
    const std::uint64_t hash = session.snapshot().state_hash;
    world_.tell(fmt::format("taken up at tick {}, promised {}", tick_, promise ? text(*promise) : "nothing"));
    for (const Line& one : lines_)
        world_.tell(fmt::format("  line {}: {} orders{}{}{}", one.number, one.orders.size(),
                                one.handed_over ? ", handed over " + text(*one.handed_over) : "",
                                one.on_disk ? ", on the disk " + text(*one.on_disk) : "",
                                one.ended ? ", ended" : ""));
    if (!how.set_back.empty() && how.attempts < 2 && !how.set_back_before)
        fail("kept", "taken up where it stopped",
             "set back after " + std::to_string(how.attempts) + " losses: " + how.set_back);
    const bool back = !how.set_back.empty();
    const State state{.tick = tick_, .hash = hash, .assessment = assessment_of(session.assessor())};
    if (back) line().on_disk.reset(), line().handed_over.reset();
    for (;;) {
        if (back) leave_line(); // until the disk has that, the power may bring the line back
        if (go_on_from(line(), tick_, state)) break;
        lines_.pop_back();
        if (back) lines_.pop_back();
        if (lines_.empty())
            fail("state",
                 fmt::format("that of the undisturbed course at tick {}, with orders that were taken", tick_),
                 fmt::format("{:016x}, which is of none", hash));
    }
    // Where two lines come to the same state, as at their beginnings, which of them was kept cannot be told:
    // an older one that a power cut has brought back has its own losses counted.
    auto here_undisturbed = std::exchange(undisturbed_, std::nullopt);
    for (auto older = lines_.begin(); older != std::prev(lines_.end()); ++older)
        if (older->losses() > line().losses() && orders_of(*older, tick_, state))
            line().starts = older->starts, line().left = older->left;
    undisturbed_ = std::move(here_undisturbed);
    const Place here = place();
    if (promise && how.set_back.empty() && !how.rotten && !how.set_back_before &&
        (promise->line > here.line || (promise->line == here.line && before(here, *promise))))
        fail("kept", "taken up at " + text(*promise) + " or later", "taken up at " + text(here));
    if (how.set_back.empty()) { // what was read is there, and there again
        line().handed_over = here;
        if (how.lost_by == Loss::power_cut) line().on_disk = here;
    }
    line().ended = false;
    branch(session, tick_);
    hold_questions_again(session);
}

/// A course goes on beside the line, from somewhere on it; a server that is lost may come back to the line.
void Checks::leave_line() {
    Line beside = line();
    beside.number = ++line_number_;
    if (undisturbed_ && undisturbed_->line == line().number) undisturbed_->line = beside.number;
    beside.handed_over.reset(), beside.on_disk.reset();
    beside.ended = false;
    lines_.push_back(std::move(beside));
}

/// The run that begins goes on from the end of the line.
void Checks::branch(const run::Session& session, std::uint64_t tick) {
    run_base_ = line().orders.size();
    go_through(line(), tick, run_base_);
    const exercise::Exercise& now = undisturbed_->course.exercise();
    for (const auto& tackle : session.def().tackle)
        levers_.at(static_cast<std::size_t>(tackle.side)).at =
            values_of(exercise::Order(now.levers(tackle.side)));
    levers_[2].at = values_of(exercise::Order(now.helm()));
}

std::optional<Checks::Place> Checks::promised(Loss how) const {
    for (auto line = lines_.rbegin(); line != lines_.rend(); ++line) {
        if (line->ended) return std::nullopt;
        const auto& promise = how == Loss::killed ? line->handed_over : line->on_disk;
        if (promise) return promise;
    }
    return std::nullopt;
}

Checks::Place Checks::place() const {
    return {.line = lines_.back().number, .tick = tick_, .orders = lines_.back().orders.size()};
}

void Checks::handed_over(const Place& place) {
    for (Line& one : lines_)
        if (one.number == place.line) one.handed_over = place;
}

void Checks::on_disk(const Place& place) {
    // Of a course that has ended nothing is waited for any more: a disk that refused it until then has none
    // of it, and may also refuse to remove it (seed 29).
    const auto its = std::ranges::find(lines_, place.line, &Line::number);
    if (its == lines_.end() || its->ended) return;
    its->on_disk = place;
    // Of what was left before that course began, nothing comes back.
    while (lines_.front().number < place.line)
        lines_.pop_front();
}

void Checks::end() {
    go_through(line(), tick_, line().orders.size());
    hold_against(line());
}

std::vector<run::AlertView> Checks::open_alerts() const {
    std::vector<run::AlertView> open;
    for (const auto& [which, condition] : alerts_) {
        if (condition == AlertCondition::normal) continue;
        run::AlertView& alert = open.emplace_back();
        alert.code = which.first;
        alert.side = which.second;
    }
    return open;
}

// ---- each tick

void Checks::hears(const Sent& sent) {
    if (group_of(sent.sample) >= 0) heard_.push_back(sent);
}

void Checks::leaves(const wire::WriterId& writer) {
    left_.insert(writer);
}

void Checks::comes(const wire::WriterId& writer) {
    left_.erase(writer);
}

/// A writer is there no more whose words they may have been.
bool Checks::has_left(const Levers& levers) const {
    return std::ranges::any_of(levers.writers, [this](const auto& writer) { return left_.contains(writer); });
}

void Checks::forget_hands() {
    for (Levers& levers : levers_) {
        levers.source.clear();
        levers.instructor = false;
        levers.lay_there = !levers.hand.empty();
        levers.lay_since = levers.moved;
    }
}

void Checks::look(const run::Session& session, const run::Inbox& inbox, double now,
                  const std::string& trouble) {
    seen_ += session.now_tick() != tick_ ? 1 : 0;
    tick_ = session.now_tick();
    listened_ += std::clamp(now - listened_at_, 0.0, 0.1);
    listened_at_ = now;
    if (inbox.orders.size() + inbox.refusals.size() > 1024 + 32)
        fail("memory", "1024 samples a tick at most", std::to_string(inbox.orders.size()));
    leave_out_what_was_not_taken(inbox);
    run_began_ = false;
    look_at_orders(session);
    look_at_takings(session);
    look_at_answers(session, inbox);
    look_at_questions(session, inbox);
    if (const auto* checkpoint = session.checkpoint())
        line().checkpoints[checkpoint->tick] = run_base_ + checkpoint->orders_taken;
    for (Levers& levers : levers_) // behind what they sent
        if (has_left(levers)) levers.instructor = false;
    look_at_events(session);
    look_at_alerts(session, trouble);
    look_for_silence(session);
    if (session.seen() && (tick_ % kMarkEvery == 0 || session.checkpoint() != nullptr) &&
        session.status().state != RunState::stopped_by_fault && !lines_.back().ended) {
        if (session.status().orders_taken + run_base_ == line().orders.size())
            line().marks.push_back({.tick = tick_,
                                    .orders = line().orders.size(),
                                    .hash = session.snapshot().state_hash,
                                    .assessment = assessment_of(session.assessor()) ^
                                                  (std::exchange(sabotage_marks, false) ? 1U : 0U)});
        add(session.snapshot().state_hash);
    }
    if (session.status().state == RunState::finished || session.status().state == RunState::stopped_by_fault)
        line().ended = true;
    heard_.clear(), taken_ = 0;
}

/// Of what was heard, a late word of a writer whose later one was taken already is not, and what found the
/// mailbox full came behind all that found room.
void Checks::leave_out_what_was_not_taken(const run::Inbox& inbox) {
    auto taken = std::ranges::count_if(inbox.orders, [](const run::ReceivedOrder& order) {
        const auto* command = std::get_if<exercise::Order>(&order.what);
        return command != nullptr && group_of(*command) >= 0;
    });
    std::erase_if(heard_, [&](const Sent& sent) {
        std::uint64_t& last = serials_[sent.writer];
        if (taken == 0 || serial_of(sent.sample) <= last) return true;
        last = serial_of(sent.sample);
        --taken;
        return false;
    });
    if (taken != 0) fail("levers", "no order but those that were sent", fmt::format("{} more", taken));
}

void Checks::look_at_orders(const run::Session& session) {
    const auto begin_run = [&] {
        run_ = session.status().run;
        forget_hands();
        holders_ = {}, takings_ = {};
        run_began_ = true;
        ran_ = false;
        world_.tell(fmt::format("run {} begins at tick {}", run_, session.now_tick()));
        const run::CheckpointView* base = session.checkpoint();
        if (base == nullptr || base->run != run_)
            fail("kept", "a checkpoint at the beginning of each run", "none");
        // Of the checkpoints since the last look the newest is told: it may have orders of the run in it.
        State state{.tick = base->tick, .hash = base->state_hash};
        if (session.assessor().assesses()) { // an answer is in no other part of the state
            assess::Assessor assessor;
            exercise::read_checkpoint(base->data, {}, &assessor);
            state.assessment = assessment_of(assessor);
        }
        std::ranges::copy_if(session.orders(), std::back_inserter(state.behind),
                             [&](const run::OrderView& order) {
                                 return order.run == run_ && order.number <= base->orders_taken;
                             });
        if (state.behind.size() != base->orders_taken)
            fail("orders", fmt::format("{} of run {}", base->orders_taken, run_),
                 std::to_string(state.behind.size()));
        const std::uint64_t begins_at = state.behind.empty() ? base->tick : state.behind.front().tick;
        // Where a run begins with words for every lever, its state does not tell whether it was set up.
        const bool set_up = std::ranges::any_of(
            session.events(), [](const auto& event) { return event.code == "exercise.ready"; });
        if (set_up)
            begin_line(session);
        else
            leave_line();
        if (!(set_up ? begins_at == 0 && orders_of(line(), 0, state) : go_on_from(line(), begins_at, state)))
            fail("state", fmt::format("that of the undisturbed course at tick {}", base->tick),
                 fmt::format("{:016x} after a {}", base->state_hash, set_up ? "reset" : "restore"));
        branch(session, begins_at);
    };
    for (const run::OrderView& order : session.orders()) {
        if (order.run != run_ && order.run == session.status().run) begin_run();
        if (order.run > run_) continue; // of a run that another one followed in the same tick
        if (order.run != run_)
            fail("orders", fmt::format("of run {}", run_), fmt::format("of run {}", order.run));
        if (order.number != line().orders.size() - run_base_ + 1)
            fail("orders", fmt::format("number {}", line().orders.size() - run_base_ + 1),
                 fmt::format("number {}", order.number));
        look_at_levers(order, world_.now());
        line().orders.push_back(order);
        if (auto* levers = std::get_if<exercise::WindlassOrder>(&line().orders.back().command);
            levers && sabotage_order)
            levers->brake = 1 - levers->brake, sabotage_order = false;
        add(order.tick), add(order.source);
    }
    if (session.status().run != run_) begin_run();
}

/// Whose order it is, and whether a hand moved what moves.
void Checks::look_at_levers(const run::OrderView& order, double) {
    const int group = group_of(order.command);
    if (group < 0) return;
    Levers& levers = levers_.at(static_cast<std::size_t>(group));
    const auto ordered = values_of(order.command);
    const char* const name = run::name(static_cast<run::LeverGroup>(group));
    if (order.source == run::kServerName) { // leaves a windlass as its hand did
        auto left = levers.at;
        left[1] = 0;
        if (ordered != left) fail("levers", "the server moves no lever but the speed lever, to zero", name);
        levers.at = ordered;
        levers.source.clear();
        holders_.at(static_cast<std::size_t>(group)).clear();
        return;
    }
    // Taken in the order in which they came; some were not heard, as an instructor had the levers.
    const auto may_be = [&](const Sent& one) {
        if (group_of(one.sample) != group || source_of(one.sample) != order.source) return false;
        const auto values = values_of(one.sample);
        for (std::size_t k = 0; k < values.size(); ++k)
            if (ordered[k] != values[k] && ordered[k] != levers.at[k] && !(k == 1 && ordered[k] == 0))
                return false;
        return true;
    };
    const auto sent = std::find_if(heard_.begin() + taken_, heard_.end(), may_be);
    if (sent == heard_.end())
        fail("levers", fmt::format("an order to the {} that {} sent", name, order.source),
             "one that nobody sent since the last tick");
    taken_ = sent - heard_.begin() + 1;
    if (levers.instructor && !sent->instructor && listened_ - levers.heard <= kHandSilent)
        fail("levers", fmt::format("the instructor has the {}", name), order.source + " is heard");
    // A hand that lay there as the run began moves a lever by moving it behind its last word that was heard
    // before, or, where it had not been heard, behind its first in this run: a word on its way is heard late.
    if (levers.hand != order.source) {
        levers.hand = order.source;
        levers.lay_there = sent->moved_in_run != 0 && sent->moved_in_run != run_;
        levers.lay_since = sent->moved_at;
    }
    for (std::size_t k = 0; k < ordered.size(); ++k) {
        if (sent->moved_at[k] > levers.lay_since[k]) { // it follows its hand from now on, late words of a
            levers.lay_since[k] = kMoved;              // program that was killed included
            continue;
        }
        if (ordered[k] == levers.at[k] || (group < 2 && k == 1 && ordered[k] == 0) || !levers.lay_there)
            continue;
        fail("levers",
             fmt::format("lever {} of the {} stays at {:g} until its hand moves it", k, name, levers.at[k]),
             fmt::format("at {:g}, which {} moved {:.2f} s before", ordered[k], order.source,
                         world_.now() - sent->moved_at[k]));
    }
    levers.moved = sent->moved_at;
    levers.at = ordered;
    levers.source = order.source;
    std::string& holder = holders_.at(static_cast<std::size_t>(group));
    if (holder != order.source)
        takings_.at(static_cast<std::size_t>(group))
            .push_back({order.source, std::exchange(holder, order.source)});
    levers.instructor = sent->instructor && !left_.contains(sent->writer); // his last word may come late
    levers.writers.clear();
    for (auto one = sent; one != heard_.end(); ++one)
        if (may_be(*one)) levers.writers.insert(one->writer);
    levers.heard = listened_;
}

/// A speed lever that is not at zero has a hand, or had one until a moment ago.
void Checks::look_for_silence(const run::Session& session) {
    constexpr double kLongest = kHandSilent + 0.2 + 0.15; // s
    if (!session.running()) {
        ran_ = false;
        return;
    }
    if (!std::exchange(ran_, true)) ran_since_ = listened_;
    for (const auto& tackle : session.def().tackle) {
        const Levers& levers = levers_.at(static_cast<std::size_t>(tackle.side));
        const double silent = listened_ - std::max(levers.heard, ran_since_);
        if (levers.at[1] != 0 && silent > kLongest)
            fail("levers", fmt::format("speed lever at zero after {:g} s of silence", kLongest),
                 fmt::format("at {:g} after {:.2f} s", levers.at[1], silent));
    }
}

/// Whose hand has which levers is told as it takes them, with whose they were, and once.
void Checks::look_at_takings(const run::Session& session) {
    for (std::size_t group = 0; group < takings_.size(); ++group) {
        const int side =
            group == static_cast<std::size_t>(run::LeverGroup::helm) ? -1 : static_cast<int>(group);
        const char* const name = run::name(static_cast<run::LeverGroup>(group));
        std::vector<std::string> told;
        for (const auto& event : session.events()) {
            if (event.side != side) continue;
            if (event.code == "levers.taken") told.push_back(event.text);
            if (event.code == "levers.lost") holders_.at(group).clear(); // behind all that was taken
        }
        std::vector<Taking> takings = std::exchange(takings_.at(group), {});
        if (!takings.empty() && std::exchange(sabotage_taking, false)) takings.front().source = "nobody";
        const auto text_of = [&](const Taking& taking, const char* how) {
            return fmt::format("{} has the {}{}", taking.source, name,
                               taking.before.empty() ? "" : how + taking.before);
        };
        // Of a run that another one followed in the same tick they stand before those of the present one.
        if (run_began_ && told.size() > takings.size())
            told.erase(told.begin(), told.end() - static_cast<std::ptrdiff_t>(takings.size()));
        if (told.size() != takings.size())
            fail("takings", fmt::format("{} of the {} told", takings.size(), name),
                 std::to_string(told.size()));
        for (std::size_t k = 0; k < told.size(); ++k) {
            counts_.takings += takings[k].before.empty() ? 0 : 1;
            if (told[k] != text_of(takings[k], ", taken from ") &&
                told[k] != text_of(takings[k], ", handed back by "))
                fail("takings", text_of(takings[k], ", taken from "), told[k]);
        }
    }
}

/// What a seat's question gets is an answer that it sent, or an instructor's start.
void Checks::look_at_answers(const run::Session& session, const run::Inbox& inbox) {
    for (const run::OrderView& order : session.orders()) {
        const auto* const given = std::get_if<exercise::AnswerGiven>(&order.command);
        if (given == nullptr) continue;
        const bool passed_over = given->kind == exercise::AnswerKind::passed_over;
        const bool sent = std::ranges::any_of(inbox.orders, [&](const run::ReceivedOrder& one) {
            if (passed_over) {
                const auto* const about_run = std::get_if<run::RunOrder>(&one.what);
                return about_run != nullptr && about_run->action == run::RunAction::start;
            }
            const auto* const answer = std::get_if<run::AnswerOrder>(&one.what);
            return answer != nullptr && one.source == order.source &&
                   answer->answer.question == given->question;
        });
        if (!sent)
            fail("questions",
                 passed_over ? "passed over as an instructor starts the exercise" : "an answer that was sent",
                 fmt::format("{} of {}", given->question, order.source));
        ++(passed_over ? counts_.passed_over : counts_.answered);
    }
}

/// What is asked is told once, as long as it is asked; the exercise holds for it, and goes on when it is
/// answered.
void Checks::look_at_questions(const run::Session& session, const run::Inbox& inbox) {
    std::ptrdiff_t told = 0;
    for (const run::QuestionView& question : session.questions()) {
        if (!question.id.empty() && std::exchange(sabotage_question, false)) continue;
        Asked& asked = asked_.at(question.forecastle ? 0 : 1);
        if (question.id == asked.id && (question.id.empty() || question.run == asked.run))
            fail("questions", fmt::format("\"{}\" is told once", question.id), "told again");
        asked = {question.id, question.run, question.tick};
        told += question.id.empty() ? 0 : 1;
    }
    counts_.questions += static_cast<std::uint64_t>(told);
    const auto logged =
        std::ranges::count(session.events(), std::string("question.asked"), &exercise::ExerciseEvent::code);
    if (logged != told) fail("questions", fmt::format("{} in the log", told), std::to_string(logged));
    bool asks = false;
    for (std::size_t seat = 0; seat < asked_.size(); ++seat) {
        const Asked& asked = asked_[seat];
        const std::string open = run::question_to(seat == 0, session.assessor()).id;
        if (open != asked.id || session.status().asked.at(seat) == open.empty())
            fail("questions", fmt::format("the {} is told that it is asked \"{}\"", kSeats[seat], open),
                 fmt::format("\"{}\"", asked.id));
        asks = asks || !open.empty();
        if (!open.empty() && (session.running() || tick_ != asked.tick))
            fail("questions", fmt::format("the exercise holds at tick {} for \"{}\"", asked.tick, open),
                 fmt::format("{} at tick {}", session.running() ? "runs" : "stands", tick_));
    }
    const bool others = std::ranges::any_of(inbox.orders, [](const run::ReceivedOrder& order) {
        return std::holds_alternative<run::RunOrder>(order.what) ||
               std::holds_alternative<run::StateOrder>(order.what);
    });
    if (!others && was_running_ && asks && !session.held())
        fail("questions", "the exercise goes on with the answer", "it stands until somebody starts it");
    if (!others && was_held_ && !asks && session.status().state == RunState::paused)
        fail("questions", "the exercise goes on, as it is answered", "it stands");
    was_running_ = session.running(), was_held_ = session.held();
}

/// A question that stood when the server was lost is asked again by the next one.
void Checks::hold_questions_again(const run::Session& session) {
    if (!line().assessor) return; // it was not seen as it began
    for (const bool forecastle : {true, false}) {
        const std::string open = run::question_to(forecastle, undisturbed_->course.assessor()).id;
        std::string told;
        for (const run::QuestionView& question : session.questions())
            if (question.forecastle == forecastle) told = question.id;
        if (told != open)
            fail("questions",
                 fmt::format("the {} is asked \"{}\" again", kSeats.at(forecastle ? 0 : 1), open),
                 fmt::format("\"{}\"", told));
        counts_.stood_again += open.empty() ? 0 : 1;
    }
}

void Checks::look_at_events(const run::Session& session) {
    for (const auto& event : session.events()) {
        const bool anew = event.number == 1 && event.tick == 0; // set up
        if (event.number != event_ + 1 && !anew)
            fail("events", fmt::format("event {} once, behind event {}", event_ + 1, event_),
                 fmt::format("event {}, {}", event.number, event.code));
        event_ = event.number;
        add(event.tick), add(event.code), add(event.text);
        if (event.code != "levers.lost") continue;
        const int group = event.side < 0 ? static_cast<int>(run::LeverGroup::helm) : event.side;
        const Levers& levers = levers_.at(static_cast<std::size_t>(group));
        if (!has_left(levers) && listened_ - levers.heard < kHandSilent)
            fail("levers", "a hand that is heard has what it holds", event.text);
    }
}

void Checks::look_at_alerts(const run::Session& session, const std::string& trouble) {
    using enum AlertCondition;
    const auto condition = [&](const std::string& code, int side) {
        const auto known = alerts_.find({code, side});
        return known == alerts_.end() ? normal : known->second;
    };
    const auto active = [&](const std::string& code, int side) {
        const auto now = condition(code, side);
        return now == active_unacknowledged || now == active_silenced || now == active_acknowledged;
    };
    for (const run::AlertView& alert : session.alerts()) {
        const AlertCondition was = condition(alert.code, alert.side);
        const auto from = [&](std::initializer_list<AlertCondition> allowed) {
            return std::ranges::find(allowed, was) != allowed.end();
        };
        const bool may = alert.condition == active_unacknowledged
                             ? from({normal, rectified_unacknowledged, active_silenced})
                         : alert.condition == active_silenced ? from({active_unacknowledged})
                         : alert.condition == active_acknowledged
                             ? from({active_unacknowledged, active_silenced})
                         : alert.condition == rectified_unacknowledged
                             ? from({active_unacknowledged, active_silenced})
                             : from({active_acknowledged, rectified_unacknowledged});
        double& raised = raised_[{alert.code, alert.side}];
        // One that was raised later is of a course that was gone back before, and is told anew.
        const bool anew = alert.condition == active_unacknowledged && raised > alert.time;
        raised = alert.raised_time;
        if (!may && !anew)
            fail("alerts", fmt::format("{} of side {} is told once", alert.code, alert.side),
                 fmt::format("condition {} again, after {}", static_cast<int>(alert.condition),
                             static_cast<int>(was)));
        alerts_[{alert.code, alert.side}] = alert.condition;
        add(alert.tick), add(alert.code), add(static_cast<std::uint64_t>(alert.condition));
    }
    const auto must = [&](const char* code, int side, bool there) {
        if (active(code, side) != there)
            fail("alerts", fmt::format("{} of side {}: {}", code, side, there ? "active" : "not active"),
                 fmt::format("condition {}", static_cast<int>(condition(code, side))));
    };
    must("exercise.not_kept", -1, !trouble.empty());
    if (!session.running() || !session.seen()) return;
    const exercise::Snapshot& seen = session.snapshot();
    must("watch.circle", -1, seen.outside_watch_circle);
    must("model.in_doubt", -1, seen.model_in_doubt);
    for (const auto& tackle : seen.tackle) {
        const int side = static_cast<int>(tackle.side);
        if (!tackle.windlass.tripped) must("motor.trip", side, false);
        if (tackle.windlass.cable_speed > words::limits::cable_runaway ||
            tackle.windlass.cable_speed < words::limits::cable_fast)
            must("cable.runaway", side, tackle.windlass.cable_speed > words::limits::cable_runaway);
    }
}

} // namespace windlass::sim
