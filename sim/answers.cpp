#include "sim/answers.hpp"

namespace windlass::sim {

Answers::Answers(World& world, Network& network, std::uint64_t seed)
    : world_(world), network_(network), chance_(seed) {
    for (std::size_t k = 0; k < seats_.size(); ++k) {
        seats_[k].forecastle = k == 0;
        seats_[k].writer = {static_cast<std::uint8_t>(k + 1)};
        seats_[k].writer.back() = 2; // no hand's, and no page's
    }
}

void Answers::tell(const run::QuestionView& question) {
    Seat& seat = seats_.at(question.forecastle ? 0 : 1);
    world_.at(world_.now() + chance_.spread(0.002, 0.3), [this, &seat, question] {
        const std::uint64_t told = ++seat.told;
        if (question.id.empty() || chance_.in(0.15)) return;
        world_.at(world_.now() + chance_.spread(0.05, 5),
                  [this, &seat, question, told] { answer(seat, question, told); });
    });
}

/// Again and again until it is told something else: an answer may be refused, or not be heard.
void Answers::answer(Seat& seat, const run::QuestionView& question, std::uint64_t told) {
    if (seat.told != told) return;
    world_.at(world_.now() + chance_.spread(0.5, 8),
              [this, &seat, question, told] { answer(seat, question, told); });
    Answer answer;
    answer.question(chance_.in(0.1) ? "no-such" : question.id);
    const bool of_its_kind = chance_.in(0.9);
    if (chance_.in(0.1)) {
        answer.kind(ANSWER_NOT_KNOWN);
    } else if (question.choices.empty() == of_its_kind) {
        answer.kind(ANSWER_NUMBER);
        answer.value(chance_.between(0, 60));
    } else {
        answer.kind(ANSWER_CHOICE);
        answer.choice(static_cast<std::uint32_t>(chance_.below(4))); // of two that there are
    }
    give(seat, answer);
    if (chance_.in(0.1)) give(seat, answer);
}

void Answers::give(Seat& seat, Answer answer) {
    answer.origin().source(seat.forecastle ? "anna" : "mate");
    answer.origin().serial(++seat.serial);
    dds::Mailbox::Sample sample;
    if (seat.forecastle)
        sample = dds::ForecastleAnswer{answer};
    else
        sample = dds::BridgeAnswer{answer};
    network_.send({.sample = std::move(sample), .writer = seat.writer});
}

} // namespace windlass::sim
