#include "trainee_client/mate.hpp"

#include "words/words.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::trainee {

namespace {

constexpr double kShackle = words::units::shackle;

// When he begins: what stops cable at once, the rest when he has repeated the order.
constexpr double kAtOnce = 1, kAfterRepeat = 2.5; // s
constexpr double kAnswers = 4;                    // s, to look before he answers

// How a hand works the wheel: it is felt for where the band begins to render, and moved by little from there.
constexpr double kFeel = 0.03;     // a second, easing while nothing moves yet
constexpr double kLetGoTurn = 0.1; // the same for an anchor that is to be let go
constexpr double kScrewUp = 0.3;   // a second, to stop her
constexpr double kFine = 0.008;    // a second for each m/s that she runs too fast or too slowly
constexpr double kLead = 0.05;     // of its way, by which his hand may be ahead of the wheel
constexpr double kHolds = 0.02;    // m/s of cable: she stands

// m/s of cable: as practice has it (UR A3: controlled by the brake; 5 to 6 m/s at most while she runs out)
constexpr double kLetGo = 3.5, kPayOut = 2, kCreep = 0.6;
constexpr double kFallen = 5;   // m that an anchor has fallen before it may have come to the bottom
constexpr double kLanded = 0.7; // of the fastest, to which the cable slows when the anchor's weight is off it
constexpr double kNoHand = 2;   // s since he braked it himself: then it slows by that
constexpr double kGivesUp = 40; // s with the wheel open in which nothing runs: it does not
constexpr double kLashes = 30;  // s for bar pin and lashing
constexpr double kOpen = 0.2;   // of the hand-wheel
constexpr double kMenWait = 30; // s that men wait for something, until he says that it cannot be done
constexpr double kEases = 0.1;  // of the hand-wheel a second, until the cable rests on the stopper
constexpr double kFromPipe = 2, kToGypsy = 7.5; // m inboard of the lip: where a joining shackle is got at

// The speed lever, of its way
constexpr double kTakesWeight = 0.1, kHeaves = 0.7, kGently = 0.25;
constexpr double kNearHome = 12; // m of cable out, from where he heaves gently
constexpr double kReady = 0.6;   // of the hand-wheel, below which the band drags no more

bool stops_at_once(BridgeOrderCode code) {
    return code == BRIDGE_ORDER_CHECK || code == BRIDGE_ORDER_HOLD_ON || code == BRIDGE_ORDER_STOP_HEAVING ||
           code == BRIDGE_ORDER_LET_GO;
}

bool asks(BridgeOrderCode code) {
    return code == BRIDGE_ORDER_HOW_MUCH || code == BRIDGE_ORDER_HOW_LEADING ||
           code == BRIDGE_ORDER_HOW_GROWING || code == BRIDGE_ORDER_HOW_MUCH_WEIGHT ||
           code == BRIDGE_ORDER_BROUGHT_UP;
}

bool is_for_men(BridgeOrderCode code) {
    return code == BRIDGE_ORDER_CLEAR_ANCHOR || code == BRIDGE_ORDER_BUOY_CABLE || code == BRIDGE_ORDER_SLIP;
}

ReportOrder plain(ReportCode code) {
    return {.code = code, .side = {}, .order = {}, .text = {}};
}

} // namespace

std::vector<Step> Mate::advance(const station::Picture& picture) {
    done_.clear();
    const auto& view = picture.tackle.at(static_cast<std::size_t>(side_)).view;
    if (!view || !picture.status) return {};
    view_ = &*view;
    look(picture);
    const station::WindlassLevers before = levers_;
    hear(picture);
    if (deed_.code != BRIDGE_ORDER_TEXT && time_ >= deed_.begin) work();
    for (const Question& question : questions_)
        if (time_ >= question.at) answer(question.code);
    std::erase_if(questions_, [&](const Question& question) { return time_ >= question.at; });
    for (const Word& word : words_)
        if (time_ >= word.at) say(word.report);
    std::erase_if(words_, [&](const Word& word) { return time_ >= word.at; });
    if (answers_.drags()) say(plain(REPORT_DRAGGING));
    if (answers_.comes_up()) say(plain(REPORT_BROUGHT_UP));
    if (!(levers_ == before)) {
        Step& step = done_.emplace_back();
        step.orders.brake = levers_.brake;
        step.orders.speed_lever = levers_.speed_lever;
        step.orders.clutch_in = levers_.clutch_in;
        step.orders.stopper_closed = levers_.stopper_closed;
    }
    view_ = nullptr;
    return done_;
}

/// By the counter; where none is fitted by the painted mark that is nearest the lip, on deck or outboard, and
/// by eye while none is in sight. Not by the call of a mark: a shackle that comes in is called when it has
/// come as far as the windlass, and less is out by then.
void Mate::look(const station::Picture& picture) {
    time_ = picture.time(side_);
    if (looked_ < 0 || time_ < looked_) // he comes to his windlass, or the exercise went back
        levers_ = {view_->brake_position(), view_->speed_lever(), view_->clutch() == CLUTCH_IN,
                   view_->stopper_closed(), view_->emergency_stop()};
    step_ = looked_ < 0 ? 0 : std::clamp(time_ - looked_, 0.0, 0.5);
    looked_ = time_;
    if (view_->counter_fitted()) {
        out_ = view_->cable_out_indicated();
        speed_ = view_->cable_speed_indicated();
    } else {
        speed_ = view_->cable_speed_seen();
        out_ += step_ * speed_;
        const auto from_lip = [](const CableMark& mark) { return std::abs(mark.outboard()); };
        if (!view_->marks().empty()) {
            const CableMark& mark = *std::ranges::min_element(view_->marks(), {}, from_lip);
            out_ = kShackle * mark.shackle() + mark.outboard();
        }
    }
    for (const CableMark& mark : view_->marks())
        if (!mark.last())
            plain_seen_ = true;
        else if (plain_seen_ && warning_ == 0)
            warning_ = mark.shackle();
    answers_.look(*view_, time_);
}

/// The newest order takes the place of what he does; one that is taken back leaves him holding on.
void Mate::hear(const station::Picture& picture) {
    if (picture.status->run() != run_) {
        run_ = picture.status->run();
        heard_ = 0;
        deed_ = {};
        questions_.clear();
        words_.clear();
        for (const BridgeOrder& order :
             picture.orders) // what somebody has repeated already is not his to begin anew
            if (order.run() == run_ && order.state() == ORDER_REPEATED)
                heard_ = std::max<long>(heard_, order.number());
    }
    for (const BridgeOrder& order : picture.orders) {
        if (order.run() != run_) continue;
        if (order.number() == deed_.number && order.state() == ORDER_CANCELLED) {
            call_men_back();
            deed_ = {.code = BRIDGE_ORDER_HOLD_ON, .begin = time_};
        }
        if (order.number() <= heard_) continue;
        if (auto why = cannot(order, picture)) {
            heard_ = order.number();
            ReportOrder report = unable(*std::move(why));
            report.side = order.side();
            report.order_number = order.number();
            words_.push_back({std::move(report), order.time() + kAnswers});
            continue;
        }
        if (!(order.side() < 0 || order.side() == side_)) continue;
        heard_ = order.number();
        if (order.state() == ORDER_CANCELLED || order.code() == BRIDGE_ORDER_TEXT) continue;
        // Whatever comes next: no cable is worked while men are at it.
        if (!asks(order.code())) call_men_back();
        if (order.code() == BRIDGE_ORDER_STAND_CLEAR && is_for_men(deed_.code))
            deed_ = {.number = deed_.number};
        if (order.code() == BRIDGE_ORDER_CANCEL) {
            deed_ = {.code = BRIDGE_ORDER_HOLD_ON, .begin = time_};
            continue;
        }
        if (asks(order.code()) || order.code() == BRIDGE_ORDER_STAND_CLEAR)
            questions_.push_back({order.code(), order.time() + kAnswers});
        else
            deed_ = {.code = order.code(),
                     .value = order.value(),
                     .number = order.number(),
                     .begin = order.time() + (stops_at_once(order.code()) ? kAtOnce : kAfterRepeat),
                     .repeated = order.time() + kAfterRepeat};
    }
}

void Mate::work() {
    if (deed_.stage == 0) stage(1);
    switch (deed_.code) {
    case BRIDGE_ORDER_STAND_BY:
    case BRIDGE_ORDER_CLEAR_AWAY:
        if (on_the_brake())
            finish(plain(deed_.code == BRIDGE_ORDER_STAND_BY ? REPORT_STANDING_BY : REPORT_ANCHOR_READY));
        return;
    case BRIDGE_ORDER_LET_GO:
        return let_go();
    case BRIDGE_ORDER_PAY_OUT:
    case BRIDGE_ORDER_VEER:
        return pay_out();
    case BRIDGE_ORDER_CHECK:
    case BRIDGE_ORDER_HOLD_ON:
        return hold_on();
    case BRIDGE_ORDER_WALK_OUT:
    case BRIDGE_ORDER_WALK_BACK:
        return by_gear(-1);
    case BRIDGE_ORDER_HEAVE:
    case BRIDGE_ORDER_HEAVE_TO:
        return by_gear(1);
    case BRIDGE_ORDER_GEAR_IN:
        return gear(true);
    case BRIDGE_ORDER_GEAR_OUT:
        return gear(false);
    case BRIDGE_ORDER_STOP_HEAVING:
        levers_.speed_lever = 0;
        if (std::abs(speed_) > kHolds) return;
        levers_.brake = 1;
        return finish(shackles());
    case BRIDGE_ORDER_SECURE:
        return secure();
    case BRIDGE_ORDER_CLEAR_ANCHOR:
        if (view_->anchor() == ANCHOR_SEEN_CLEAR) return finish(plain(REPORT_CLEAR_ANCHOR));
        return men(DECK_WORK_CLEAR_ANCHOR, REPORT_CLEAR_ANCHOR);
    case BRIDGE_ORDER_BUOY_CABLE:
        return men(DECK_WORK_BREAK_CABLE, REPORT_READY_TO_SLIP);
    case BRIDGE_ORDER_SLIP:
        return men(DECK_WORK_SLIP, REPORT_SLIPPED);
    default:
        return finish();
    }
}

void Mate::answer(BridgeOrderCode question) {
    switch (question) {
    case BRIDGE_ORDER_HOW_LEADING:
        return say(answers_.lead());
    case BRIDGE_ORDER_HOW_GROWING:
        return say(answers_.growing());
    case BRIDGE_ORDER_HOW_MUCH_WEIGHT:
        return say(answers_.weight());
    case BRIDGE_ORDER_BROUGHT_UP:
        return say(answers_.brought_up());
    case BRIDGE_ORDER_STAND_CLEAR:
        return say(plain(REPORT_STAND_CLEAR));
    default:
        return say(shackles());
    }
}

bool Mate::on_the_brake() {
    const bool free = view_->clutch() == CLUTCH_OUT && !view_->stopper_closed();
    if (free && view_->brake_position() > 0.99) return true;
    levers_.brake = 1;
    levers_.speed_lever = 0;
    if (view_->brake_position() > 0.99) levers_.stopper_closed = levers_.clutch_in = false;
    return false;
}

/// Lets her run and feels when the anchor is on the bottom; then checks her.
void Mate::let_go() {
    if (deed_.stage == 1) {
        if (!on_the_brake()) return;
        fastest_ = 0;
        let_go_at_ = out_;
        stage(2);
    }
    if (deed_.stage == 2) {
        if (std::abs(speed_) <= kHolds) { // a brake that creeps has not let go yet
            turn(-kLetGoTurn);
        } else {
            if (fastest_ == 0) say(plain(REPORT_LET_GO));
            fastest_ = std::max(fastest_, speed_);
        }
        if (fastest_ > 0) {
            if (speed_ > kLetGo) turn(kFine * 4 * (speed_ - kLetGo)), tightened_ = time_;
            const bool slows = fastest_ > 1 && speed_ < kLanded * fastest_ && time_ > tightened_ + kNoHand;
            if (out_ > let_go_at_ + kFallen && slows) {
                say(plain(REPORT_ON_THE_BOTTOM));
                return stage(3);
            }
        }
        if (levers_.brake <= 0 && since() > kGivesUp && fastest_ == 0) finish(plain(REPORT_DOES_NOT_RUN));
        return;
    }
    turn(kScrewUp);
    if (levers_.brake >= 1 && std::abs(speed_) <= kHolds) finish(shackles());
}

/// To so many shackles, checked towards the end; not a metre where there is so much already.
void Mate::pay_out() {
    const double wanted = kShackle * deed_.value, left = wanted - out_;
    if (deed_.stage == 1) {
        levers_.speed_lever = 0;
        if (left <= 0 || last_on_deck()) return stage(3);
        if ((view_->clutch() != CLUTCH_OUT || view_->stopper_closed()) && !on_the_brake()) return;
        stage(2);
    }
    if (deed_.stage == 2) {
        if (!last_on_deck() && left > 0.3 + 0.5 * std::max(0.0, speed_)) {
            render(std::clamp(0.4 * left, kCreep, kPayOut));
            if (levers_.brake <= kOpen && since() > kGivesUp && std::abs(speed_) <= kHolds)
                finish(plain(REPORT_DOES_NOT_RUN));
            return;
        }
        stage(3);
    }
    hold_on();
}

/// The brake hard on, at so many shackles where the order says so.
void Mate::hold_on() {
    const bool more = deed_.code == BRIDGE_ORDER_HOLD_ON && kShackle * deed_.value > out_ + 1;
    if (more && deed_.stage < 3) return pay_out();
    levers_.speed_lever = 0;
    turn(kScrewUp);
    if (levers_.brake < 1 || view_->brake_position() <= 0.99 || std::abs(speed_) > kHolds) return;
    if (last_on_deck() && kShackle * deed_.value > out_ + 1)
        say(unable("the last shackle is on deck, there is no more to pay out"));
    finish(shackles());
}

/// direction: 1 heaves, -1 walks back. Until what was ordered is out, the anchor is home, or it is stopped.
void Mate::by_gear(double direction) {
    if (deed_.stage == 1) {
        if (!in_gear_and_free()) return;
        stage(2);
        if (direction > 0) say(plain(REPORT_HEAVING));
    }
    const bool walks_out = deed_.code == BRIDGE_ORDER_WALK_OUT;
    const double wanted = walks_out ? deed_.value : kShackle * deed_.value;
    const bool there = (deed_.value > 0 || walks_out) && direction * (out_ - wanted) < 0.4;
    const bool home = direction > 0 && view_->anchor() == ANCHOR_SEEN_HOME;
    const bool last = direction < 0 && last_on_deck();
    if (deed_.stage == 2 && !there && !home && !last) {
        const bool gently = out_ < kNearHome || (deed_.value > 0 && std::abs(out_ - wanted) < 3);
        levers_.speed_lever = direction * (gently ? kGently : kHeaves);
        return;
    }
    levers_.speed_lever = 0;
    if (deed_.stage == 2) return stage(3);
    if (std::abs(speed_) > kHolds && since() < 10) return;
    levers_.brake = 1;
    if (view_->brake_position() < 0.99) return;
    if (last && !there) say(unable("the last shackle is on deck, there is no more to walk back"));
    finish(home ? plain(REPORT_ANCHOR_HOME) : walks_out ? plain(REPORT_STANDING_BY) : shackles());
}

/// In gear, brake off, the weight on the motor, stopper off. true once it is so.
bool Mate::in_gear_and_free() {
    if (view_->clutch() != CLUTCH_IN) {
        levers_.brake = 1;
        levers_.speed_lever = 0;
        levers_.clutch_in = view_->brake_position() > 0.99;
        return false;
    }
    levers_.brake = 0;
    levers_.speed_lever = kTakesWeight;
    if (view_->brake_position() > kReady) return false;
    levers_.stopper_closed = false;
    return !view_->stopper_closed();
}

void Mate::gear(bool in) {
    levers_.speed_lever = 0;
    levers_.brake = 1;
    if (view_->brake_position() < 0.99) return;
    levers_.clutch_in = in;
    if (view_->clutch() == (in ? CLUTCH_IN : CLUTCH_OUT)) finish(plain(REPORT_STANDING_BY));
}

/// Brake hard on, stopper on, out of gear.
void Mate::secure() {
    levers_.speed_lever = 0;
    levers_.brake = 1;
    if (view_->brake_position() < 0.99) return;
    levers_.stopper_closed = true;
    if (!view_->stopper_closed()) return;
    levers_.clutch_in = false;
    if (view_->clutch() != CLUTCH_OUT) return;
    if (deed_.stage == 1) return stage(2);
    if (since() > kLashes) finish(plain(REPORT_SECURED));
}

/// Holds the cable as that work needs it, sets the men to it and says when it is done, or why it cannot be.
void Mate::men(DeckWork work, ReportCode done) {
    if (deed_.stage == 1) {
        if (!held_for(work)) return;
        set_men(work);
        return stage(2);
    }
    if (deed_.stage == 2) { // his word is on its way
        if (view_->deck_work() == work) return stage(3);
        if (since() > kMenWait) finish(unable("the men are not at it"));
        return;
    }
    if (view_->deck_work() != work) { // done, or called back by somebody else
        const bool clear = work == DECK_WORK_CLEAR_ANCHOR && view_->anchor() == ANCHOR_SEEN_CLEAR;
        return clear ? finish(plain(done)) : finish();
    }
    if (view_->deck_work_left() <= 0) return finish(plain(done));
    if (view_->deck_work_waits() == DECK_HINDRANCE_NONE) return stage(3);
    if (since() < kMenWait) return;
    set_men(DECK_WORK_NONE);
    finish(unable(
        std::string(words::kDeckHindrance.at(static_cast<std::size_t>(view_->deck_work_waits())).said)));
}

/// To clear the anchor: brake hard on and stopper on. To break the cable: a joining shackle on deck, stopper
/// on, out of gear and the brake eased, so that the stopper alone bears the weight. To slip it: nothing.
bool Mate::held_for(DeckWork work) {
    if (work == DECK_WORK_SLIP) return true;
    levers_.speed_lever = 0;
    const bool breaks = work == DECK_WORK_BREAK_CABLE;
    const bool at_hand = std::ranges::any_of(view_->marks(), [](const CableMark& mark) {
        return -mark.outboard() > kFromPipe && -mark.outboard() < kToGypsy;
    });
    if (breaks && !at_hand && !last_on_deck()) {
        if ((view_->clutch() == CLUTCH_OUT && !view_->stopper_closed()) || on_the_brake()) render(kCreep);
        return false;
    }
    if (!view_->stopper_closed()) {
        turn(kScrewUp);
        levers_.stopper_closed = view_->brake_position() > 0.99 && std::abs(speed_) <= kHolds;
        return false;
    }
    levers_.stopper_closed = true;
    if (!breaks || view_->clutch() != CLUTCH_OUT) levers_.brake = 1;
    if (!breaks) return view_->brake_position() > 0.99 && std::abs(speed_) <= kHolds;
    if (view_->clutch() != CLUTCH_OUT) {
        if (view_->brake_position() > 0.99) levers_.clutch_in = false;
        return false;
    }
    turn(-kEases);
    return view_->brake_position() < 0.01 && std::abs(speed_) <= kHolds;
}

void Mate::set_men(DeckWork work) {
    done_.emplace_back().deck_work = work;
}

void Mate::call_men_back() {
    if (view_->deck_work() != DECK_WORK_NONE && view_->deck_work_left() > 0) set_men(DECK_WORK_NONE);
}

/// By its colour: the last two lengths have it, and it begins at the one before the last.
bool Mate::last_on_deck() const {
    return std::ranges::any_of(
        view_->marks(), [&](const CableMark& mark) { return mark.last() && mark.shackle() != warning_; });
}

std::optional<std::string> Mate::cannot(const BridgeOrder& order, const station::Picture& picture) const {
    const int side = order.side();
    if (side >= 0 && side != side_) {
        if (side > 1 || picture.tackle.at(static_cast<std::size_t>(side)).view) return {};
        return std::string("there is no ") + (side == SIDE_PORT ? "port" : "starboard") + " windlass";
    }
    const auto& row = words::kBridgeOrderCode.at(static_cast<std::size_t>(order.code()));
    const bool has_figure = row.unit == words::Unit::none || !row.said_bare.empty() || order.value() > 0;
    if (has_figure) return {};
    return "that is no figure";
}

ReportOrder Mate::unable(std::string why) const {
    ReportOrder report = plain(REPORT_UNSAFE);
    report.order_number = static_cast<int>(deed_.number);
    report.text = std::move(why);
    return report;
}

void Mate::finish(std::optional<ReportOrder> report) {
    if (report) words_.push_back({std::move(*report), std::max(time_, deed_.repeated)});
    deed_ = {.number = deed_.number};
}

void Mate::stage(int next) {
    deed_.stage = next;
    deed_.since = time_;
}

double Mate::since() const {
    return time_ - deed_.since;
}

void Mate::render(double speed) {
    if (std::abs(speed_) <= kHolds)
        turn(-kFeel);
    else
        turn(std::clamp(kFine * (speed_ - speed), -kFeel, kScrewUp));
}

/// The wheel takes its time: his hand is never far ahead of it.
void Mate::turn(double rate) {
    const double there = view_->brake_position();
    const double wanted = levers_.brake + rate * step_;
    levers_.brake = std::clamp(rate < 0 ? std::max(wanted, there - kLead) : wanted, 0.0, 1.0);
}

/// What is out, to a quarter of a shackle.
ReportOrder Mate::shackles() const {
    ReportOrder report = plain(REPORT_SHACKLES_IN_PIPE);
    report.value = std::round(4 * out_ / kShackle) / 4;
    return report;
}

void Mate::say(ReportOrder report) {
    done_.emplace_back().report = std::move(report);
}

} // namespace windlass::trainee
