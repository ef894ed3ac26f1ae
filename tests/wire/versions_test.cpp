// Members of two versions of the wire in one exercise: each that is of ours is told, by name and number, and
// nothing of the other's is decoded. The member of another version is made by hand of Fast DDS: its types
// have the other version's names, and bytes that ours would take for their own.

#include "idl/network.hpp"
#include "idl/wire.hpp"
#include "tests/wire/run_program.hpp"

#include "rigs/own_domain.hpp"
#include "rigs/wait.hpp"

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <windlassPubSubTypes.h>

#include <atomic>
#include <mutex>
#include <vector>

namespace windlass::wire {
namespace {

namespace dds = eprosima::fastdds::dds;
using rigs::eventually;
using rigs::own_domain;
using testing::HasSubstr;

const std::string kNext = std::to_string(WIRE_VERSION + 1);

/// Type as another version has it: its bytes are those of ours, its name is not.
template <class PubSubType>
struct Renamed : PubSubType {
    explicit Renamed(const std::string& name) {
        this->setName(name.c_str());
        this->auto_fill_type_object(false);
        this->auto_fill_type_information(false);
    }
};

/// A member of an exercise that has one writer or one reader of a type with another version's name.
class Stranger {
public:
    Stranger(const std::string& name, const std::string& partition)
        : participant_(dds::DomainParticipantFactory::get_instance()->create_participant(
              static_cast<std::uint32_t>(own_domain()), qos(name))) {
        dds::PublisherQos publisher;
        publisher.partition().push_back(partition.c_str());
        publisher_ = participant_->create_publisher(publisher);
        dds::SubscriberQos subscriber;
        subscriber.partition().push_back(partition.c_str());
        subscriber_ = participant_->create_subscriber(subscriber);
    }
    ~Stranger() {
        participant_->delete_contained_entities();
        dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
    }
    Stranger(const Stranger&) = delete;
    Stranger& operator=(const Stranger&) = delete;

    /// The QoS are the server's own, so that nothing but the name keeps it from ours.
    template <class PubSubType>
    dds::DataWriter& writes(const TopicInfo& topic, const std::string& type_name) {
        dds::DataWriterQos qos;
        qos.reliability().kind = dds::RELIABLE_RELIABILITY_QOS;
        qos.durability().kind = dds::TRANSIENT_LOCAL_DURABILITY_QOS;
        return *publisher_->create_datawriter(made<PubSubType>(topic, type_name), qos);
    }
    template <class PubSubType>
    void reads(const TopicInfo& topic, const std::string& type_name) {
        subscriber_->create_datareader(made<PubSubType>(topic, type_name), dds::DataReaderQos{});
    }

private:
    static dds::DomainParticipantQos qos(const std::string& name) {
        dds::DomainParticipantQos qos = participant_qos(own_domain(), {}, false);
        qos.name(name);
        return qos;
    }
    template <class PubSubType>
    dds::Topic* made(const TopicInfo& topic, const std::string& type_name) {
        const dds::TypeSupport type(new Renamed<PubSubType>(type_name));
        type.register_type(participant_);
        return participant_->create_topic(topic.name, type_name, dds::TopicQos{});
    }

    dds::DomainParticipant* participant_;
    dds::Publisher* publisher_ = nullptr;
    dds::Subscriber* subscriber_ = nullptr;
};

/// What a member of ours is told of others.
struct Told {
    std::mutex mutex;
    std::vector<OtherVersion> others;

    std::function<void(const OtherVersion&)> callback() {
        return [this](const OtherVersion& other) {
            const std::lock_guard lock(mutex);
            others.push_back(other);
        };
    }
    std::size_t count() {
        const std::lock_guard lock(mutex);
        return others.size();
    }
};

/// A client of ours, a writer of another version: heard of once, and not heard.
void expect_told_and_not_decoded(const std::string& type_name, int version) {
    SCOPED_TRACE(type_name);
    Told told;
    Participant ours({.domain = own_domain(),
                      .partition = "exercise/a",
                      .name = "client",
                      .on_other_version = told.callback()});
    Participant server({.domain = own_domain(), .partition = "exercise/a", .name = "server"});
    std::atomic<int> heard{0}, wrong{0};
    Reader<Event> reader(
        ours, topics::event,
        [&](const Event& event, const WriterId&) { heard += event.number() == 7 ? 1 : 100; },
        [&] { ++wrong; });
    Stranger other("old server", "exercise/a");
    dds::DataWriter& theirs = other.writes<EventPubSubType>(topics::event, type_name);
    Event event;
    event.number(1);
    ASSERT_TRUE(eventually([&] {
        theirs.write(&event);
        return told.count() == 1;
    }));
    EXPECT_EQ(told.others[0].name, "old server");
    EXPECT_EQ(told.others[0].version, version);
    EXPECT_EQ(told.others[0].text(), "old server speaks version " + std::to_string(version) +
                                         " of the wire, this program version " +
                                         std::to_string(WIRE_VERSION) + ": neither hears the other");
    // One of ours that is written after all of theirs is heard, and nothing else.
    theirs.write(&event);
    Writer<Event> writer(server, topics::event);
    event.number(7);
    ASSERT_TRUE(writer.write(event));
    EXPECT_TRUE(eventually([&] { return heard > 0; }));
    EXPECT_EQ(heard, 1);
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(told.count(), 1U);
}

TEST(Versions, AMemberThatSpeaksAnotherIsNamedOnceAndNothingOfItIsDecoded) {
    expect_told_and_not_decoded("windlass::v" + kNext + "::Event", WIRE_VERSION + 1);
}

TEST(Versions, AMemberFromBeforeVersionsHadNumbersIsOne) {
    expect_told_and_not_decoded("windlass::Event", 1);
    expect_told_and_not_decoded("windlass::v1::Event", 1);
}

TEST(Versions, ServerIsToldOfAStationThatOnlyListens) {
    Told told;
    Participant server({.domain = own_domain(),
                        .partition = "exercise/a",
                        .name = "server",
                        .on_other_version = told.callback()});
    Stranger elsewhere("somewhere else", "exercise/b"), station("new station", "exercise/a");
    elsewhere.reads<EventPubSubType>(topics::event, "windlass::v" + kNext + "::Event");
    station.reads<EventPubSubType>(topics::event, "windlass::v" + kNext + "::Event");
    ASSERT_TRUE(eventually([&] { return told.count() == 1; }));
    EXPECT_EQ(told.others[0].name, "new station");
    EXPECT_EQ(told.others[0].version, WIRE_VERSION + 1);
    EXPECT_EQ(told.count(), 1U) << "of another exercise";
}

TEST(Versions, TypesOfOthersAreNoVersionOfOurs) {
    Told told;
    Participant ours({.domain = own_domain(),
                      .partition = "exercise/a",
                      .name = "client",
                      .on_other_version = told.callback()});
    Stranger foreign("somebody else's", "exercise/a"), other("old server", "exercise/a");
    foreign.writes<EventPubSubType>(topics::event, "acme::v9::Event");
    other.writes<EventPubSubType>(topics::event, "windlass::v1::Event");
    ASSERT_TRUE(eventually([&] { return told.count() == 1; }));
    EXPECT_EQ(told.others[0].name, "old server");
}

TEST(Versions, StationEndsWithCodeFourAndASentenceBeforeAServerOfAnother) {
    Stranger server("windlass_server of tomorrow", "exercise/harbour");
    server.writes<ExerciseStatusPubSubType>(topics::exercise_status,
                                            "windlass::v" + kNext + "::ExerciseStatus");
    const std::string who = " --domain " + std::to_string(own_domain()) + " --partition harbour";
    const std::string sentence = "windlass_server of tomorrow speaks version " + kNext +
                                 " of the wire, this program version " + std::to_string(WIRE_VERSION) +
                                 ": neither hears the other";
    for (const std::string& program :
         {TRAINEE_CLIENT + who + " --json", INSTRUCTOR_CONSOLE + who + " status"}) {
        const test::Ending ending = test::run(program);
        EXPECT_EQ(ending.code, 4) << program << '\n' << ending.text;
        EXPECT_THAT(ending.text, HasSubstr(sentence)) << program;
    }
}

} // namespace
} // namespace windlass::wire
