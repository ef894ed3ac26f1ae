#include "server/dds/mailbox.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <utility>

namespace windlass::dds {

namespace {

constexpr std::size_t kSendersRemembered = 256;

const char* topic_name(std::size_t kind) {
    constexpr std::array names{"WindlassCommand",
                               "HelmCommand",
                               "ExerciseCommand",
                               "FaultCommand",
                               "Report",
                               "AlertCommand",
                               "RestoreCommand",
                               "EnvironmentCommand",
                               "BridgeOrderCommand",
                               "WatchCircle",
                               "OwnShipInput",
                               "AssessmentCommand",
                               "LightsAndShapesCommand",
                               "DeckWorkCommand",
                               "ForecastleAnswer",
                               "BridgeAnswer"};
    static_assert(names.size() == std::variant_size_v<Mailbox::Sample>);
    return names.at(kind);
}

/// Of samples that were never opened, or too many, no more can be told than their number.
void add_unseen(const char* topic, const std::array<std::uint64_t, 2>& unseen,
                std::vector<run::Refusal>& refusals) {
    constexpr std::array<std::pair<const char*, const char*>, 2> reasons{
        {{"payload", "CDR of the topic's type, every sequence and string within its bound"},
         {"rate", "of one writer, levers 500 a second, other orders 20, restores 1"}}};
    for (std::size_t why = 0; why < unseen.size(); ++why) {
        if (unseen[why] == 0) continue;
        refusals.push_back({.topic = topic,
                            .source = "",
                            .field = reasons[why].first,
                            .value = fmt::format("{} samples", unseen[why]),
                            .allowed = reasons[why].second,
                            .side = -1,
                            .number = static_cast<double>(unseen[why]),
                            .samples = unseen[why]});
    }
}

} // namespace

std::optional<std::uint64_t> Serials::accept(std::size_t kind, const wire::WriterId& writer,
                                             const std::string& source, std::uint64_t serial) {
    std::vector<Entry>& senders = entries_[kind];
    auto entry = std::ranges::find_if(
        senders, [&](const Entry& e) { return e.writer == writer && e.source == source; });
    const bool known = entry != senders.end();
    if (const std::uint64_t last = known ? entry->serial : 0; serial <= last) return last;
    if (!known)
        entry = senders.size() < kSendersRemembered ? senders.insert(senders.end(), Entry{})
                                                    : std::ranges::min_element(senders, {}, &Entry::used);
    *entry = {writer, source, serial, ++uses_};
    return std::nullopt;
}

Mailbox::Mailbox(std::size_t capacity) : capacity_(capacity) {
    waiting_.reserve(capacity);
    drained_.reserve(capacity);
}

void Mailbox::put(const Sample& sample, const wire::WriterId& writer, bool instructor,
                  std::uint64_t moved_in_run) {
    const auto brings_a_state = [](const Received& received) {
        return std::holds_alternative<RestoreCommand>(received.sample);
    };
    const std::lock_guard lock(mutex_);
    empty_ = false;
    // Of states, which are large, one waits at most, whoever sends them.
    const bool room =
        !std::holds_alternative<RestoreCommand>(sample) || std::ranges::none_of(waiting_, brings_a_state);
    if (room && waiting_.size() < capacity_) {
        waiting_.push_back({sample, writer, instructor, moved_in_run});
    } else {
        ++overflow_;
    }
}

void Mailbox::refuse(std::size_t kind, Unseen why) {
    const std::lock_guard lock(mutex_);
    empty_ = false;
    ++unseen_.at(kind).at(static_cast<std::size_t>(why));
}

void Mailbox::leave(const wire::WriterId& writer) {
    const std::lock_guard lock(mutex_);
    if (left_.size() == kSendersRemembered) return; // silence tells of the others
    empty_ = false;
    left_.push_back(writer);
}

void Mailbox::come(const wire::WriterId& writer) {
    const std::lock_guard lock(mutex_);
    empty_ = false;
    std::erase(left_, writer); // between two looks it was only held up
    if (came_.size() < kSendersRemembered) came_.push_back(writer);
}

void Mailbox::drain(const run::Limits& limits, run::Inbox& inbox) {
    inbox.clear();
    drained_.clear();
    decltype(unseen_) unseen;
    {
        const std::lock_guard lock(mutex_);
        empty_ = true;
        waiting_.swap(drained_);
        left_.swap(inbox.left);
        came_.swap(inbox.came);
        inbox.overflow = std::exchange(overflow_, 0);
        unseen = std::exchange(unseen_, {});
    }
    for (std::size_t kind = 0; kind < unseen.size(); ++kind)
        add_unseen(topic_name(kind), unseen[kind], inbox.refusals);
    for (const Received& received : drained_) {
        const std::size_t kind = received.sample.index();
        std::visit(
            [&](const auto& sample) {
                if (auto refused = refusal(sample, limits)) {
                    inbox.refusals.push_back(std::move(*refused));
                    return;
                }
                const std::string source = sample.origin().source().to_string();
                const std::uint64_t serial = sample.origin().serial();
                if (const auto last = serials_.accept(kind, received.writer, source, serial)) {
                    inbox.refusals.push_back(
                        {.topic = topic_name(kind),
                         .source = source,
                         .field = "origin.serial",
                         .value = fmt::format("{}", serial),
                         .allowed = fmt::format("above {}, the last one accepted", *last),
                         .side = -1,
                         .number = static_cast<double>(serial)});
                    return;
                }
                inbox.orders.push_back(
                    {source, order(sample), received.instructor, received.writer, received.moved_in_run});
            },
            received.sample);
    }
}

} // namespace windlass::dds
