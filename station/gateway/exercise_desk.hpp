#pragma once
// One exercise as the station's pages have it: what its role hears there, the orders that go out, and who has
// the levers.

#include "station/gateway/feed.hpp"
#include "station/gateway/page_host.hpp"

#include <map>
#include <memory>

namespace windlass::gateway {

/// Orders on one topic. One thread.
class OrderWriter {
public:
    /// name: under which the orders go out. Throws std::runtime_error when the role may not write the topic.
    OrderWriter(wire::Participant& participant, const wire::TopicInfo& topic, std::string name);

    bool heard_by(const wire::WriterId& peer) const { return writer_->heard_by(peer); } ///< as wire::Writer's

    /// Encodes and writes one sample. by: who gives it; empty: the name. Throws Refused.
    void write(const nlohmann::json& sample, const std::string& by = {});

    /// The same of levers, as LeverDesk::Write has them.
    void write_levers(const nlohmann::json& sample, std::uint64_t moved_in_run, const std::string& by = {});

    void outrank() { writer_->outrank(); } ///< as wire::RawWriter's, until the hand lets go
    bool outranked_by(const wire::WriterId& writer) const { return writer_->outranked_by(writer); }
    bool is_own(const wire::WriterId& writer) const { return writer_->id() == writer; }

    /// The hand lets go: its writer is disposed of, by which everybody knows at once, and another one made
    /// for the next hand. Throws std::runtime_error, and then the writer is the same.
    void let_go();

private:
    wire::Participant& participant_;
    const wire::TopicInfo& topic_;
    std::string name_;
    std::unique_ptr<wire::RawWriter> writer_;
    std::uint64_t serial_ = 0;
};

/// Orders of one role in one partition, each topic with a writer of its own. One thread.
class OrderWriters {
public:
    /// name: under which the orders go out. Throws std::runtime_error when the role may not write a topic.
    OrderWriters(wire::Participant& participant, const Topics& topics, const std::string& name);

    bool has(const wire::TopicInfo& topic) const;
    bool heard_by(const wire::TopicInfo& topic, const wire::WriterId& peer) const; ///< as wire::Writer's

    /// As OrderWriter's.
    void write(const wire::TopicInfo& topic, const nlohmann::json& sample, const std::string& by = {});

private:
    std::map<std::string, OrderWriter> writers_; // by topic
};

/// One thread.
class ExerciseDesk final : public PageDesk {
public:
    /// exercise: NAME without "exercise/". levers_changed: as LeverDesk::Changed. Throws std::runtime_error.
    ExerciseDesk(const SharedReaders& readers, const std::string& exercise, station::Seat seat,
                 const std::string& name, LeverDesk::Changed levers_changed);

    const std::string& exercise() const override { return exercise_; }
    const Role& role() const override { return role_; }
    Feed& feed() { return feed_; }
    LeverDesk& levers() override { return levers_; }

    void give(const wire::TopicInfo& topic, const nlohmann::json& sample,
              const std::string& by = {}) override;
    void call(LeverDesk::Page page, const std::string& name) override { names_[page] = name; }
    void leave(LeverDesk::Page page) override;

    /// Looks whose word counts on the levers, and repeats that of the hands of these pages. 20 times a
    /// second.
    void tick(Clock::time_point now);

    const wire::TopicInfo* lever_topic(Hand hand) const override;

private:
    void look_whose_word_counts(Hand hand);
    std::uint64_t run_heard() const;

    std::string exercise_;
    Role role_;
    bool takes_over_; ///< an instructor's hand takes levers from another's
    Feed feed_;
    OrderWriters writers_;
    std::map<Hand, OrderWriter>
        hands_; // each with a writer of its own: it is disposed of when the hand lets go
    std::map<LeverDesk::Page, std::string> names_; // of pages that have one of their own
    LeverDesk levers_;
};

} // namespace windlass::gateway
