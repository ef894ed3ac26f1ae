#include "sim/checks.hpp"

#include "server/exercise/checkpoint.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace windlass::sim {

namespace {

using exercise::RunState;
using run::AlertCondition;

constexpr std::uint64_t kMarkEvery = 30; // ticks

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

/// Where what ran is to run on: what ran when its server was lost does, and what held for a question holds
/// for it again; neither stands until somebody starts it.
void Checks::hold_what_ran(const run::Session& session) const {
    const bool goes_on = session.running() || session.held();
    if (goes_on != goes_on_)
        fail("kept", goes_on_ ? "the exercise runs on, or holds for its question" : "the exercise stands",
             goes_on ? "it goes on" : "it stands until somebody starts it");
}

void Checks::note_whether_it_goes_on(const run::Session& session) {
    const bool goes_on = session.running() || session.held();
    if (std::exchange(goes_on_, goes_on) != goes_on) ++turns_;
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
        note_whether_it_goes_on(session);
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
    const bool as_promised = promise && how.set_back.empty() && !how.rotten && !how.set_back_before;
    if (as_promised && (promise->line > here.line || (promise->line == here.line && before(here, *promise))))
        fail("kept", "taken up at " + text(*promise) + " or later", "taken up at " + text(here));
    if (as_promised && promise->turns == turns_) {
        if (how.running) hold_what_ran(session);
    } else {
        ++turns_; // behind what was read, of which it is not known whether it ran
    }
    if (how.set_back.empty()) { // what was read is there, and there again
        line().handed_over = here;
        if (how.lost_by == Loss::power_cut) line().on_disk = here;
    }
    line().ended = false;
    branch(session, tick_);
    note_whether_it_goes_on(session);
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
    find_levers(session.def(), undisturbed_->course.exercise());
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
    return {
        .line = lines_.back().number, .tick = tick_, .orders = lines_.back().orders.size(), .turns = turns_};
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
    note_whether_it_goes_on(session);
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

} // namespace windlass::sim
