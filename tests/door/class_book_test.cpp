// Who sits where.

#include "door/class_book.hpp"
#include "door/secrets.hpp"

#include <gmock/gmock.h>

namespace windlass::door {
namespace {

using testing::ElementsAre;

constexpr std::int64_t kNow = 1'800'000'000;

int status_of(const std::function<void()>& what) {
    try {
        what();
    } catch (const Denied& denied) {
        return denied.status;
    }
    return 0;
}

class Booked : public ::testing::Test {
protected:
    Booked() { book_.open("mon", {.lesson = "L01_let_go_25m", .exercises = 2, .crew = 2}, "ABCDEF", kNow); }

    ClassBook book_;
};

TEST_F(Booked, SeatsAreTakenInTheirOrderUntilThereAreNone) {
    const auto at = [](const Trainee& seated) { return seated.exercise + " " + name_of(seated.place); };
    EXPECT_EQ(at(book_.join("mon", "anna", "k1")), "mon-1 forecastle");
    EXPECT_EQ(at(book_.join("mon", "ben", "k2")), "mon-1 bridge");
    EXPECT_EQ(at(book_.join("mon", "carl", "k3")), "mon-2 forecastle");
    EXPECT_EQ(at(book_.join("mon", "dora", "k4")), "mon-2 bridge");
    EXPECT_EQ(status_of([&] { book_.join("mon", "emil", "k5"); }), 409);
    book_.remove("mon", "ben");
    EXPECT_EQ(at(book_.join("mon", "emil", "k5")), "mon-1 bridge") << "the one that was freed";
}

TEST_F(Booked, AListSaysWhoMayJoinAndIsKept) {
    book_.open("tue", {.lesson = "L01_let_go_25m", .exercises = 2, .crew = 1, .names = {"anna", "ben"}},
               "GHJKLM", kNow);
    EXPECT_EQ(status_of([&] { book_.join("tue", "carl", "k1"); }), 403);
    EXPECT_EQ(book_.join("tue", "ben", "k2").exercise, "tue-1");
    ClassBook again(book_.to_json());
    EXPECT_EQ(status_of([&] { again.join("tue", "carl", "k3"); }), 403);
    EXPECT_EQ(again.join("tue", "anna", "k4").exercise, "tue-2");
    const auto open = [&](std::vector<std::string> names) {
        return status_of([&] {
            book_.open("wed",
                       {.lesson = "L01_let_go_25m", .exercises = 1, .crew = 2, .names = std::move(names)},
                       "NPQRST", kNow);
        });
    };
    EXPECT_EQ(open({"anna", "ben", "carl"}), 400) << "more than seats";
    EXPECT_EQ(open({"anna", "anna"}), 400);
    EXPECT_EQ(open({"anna", "ben"}), 0);
}

TEST_F(Booked, WhoGoesOnHasTheSeatThatHeHad) {
    book_.open("again",
               {.lesson = "L27_the_conn",
                .exercises = 1,
                .crew = 2,
                .names = {"anna", "ben"},
                .from = Moment{"mon-1-17", 60},
                .bridge_judged = true,
                .places = {{"ben", Place::bridge}, {"anna", Place::forecastle}}},
               "GHJKLM", kNow);
    ClassBook kept(book_.to_json());
    EXPECT_EQ(kept.join("again", "ben", "k1").place, Place::bridge) << "though he is the first who comes";
    EXPECT_EQ(kept.join("again", "anna", "k2").place, Place::forecastle);
}

TEST_F(Booked, WhereTheBridgeIsJudgedItIsMannedAndTheForecastleHasNoMarks) {
    const auto opened = [&](int crew) {
        return status_of([&] {
            book_.open("tue", {.lesson = "L27_the_conn", .exercises = 1, .crew = crew, .bridge_judged = true},
                       "GHJKLM", kNow);
        });
    };
    EXPECT_EQ(opened(1), 400) << "nobody would be at the windlass, or nobody on the bridge";
    EXPECT_EQ(opened(3), 0);
    for (const char* name : {"anna", "ben", "carl"})
        book_.join("tue", name, name);
    const auto parts = book_.find("tue")->parts("tue-1");
    ASSERT_EQ(parts.size(), 3U);
    EXPECT_FALSE(parts[0].judged) << "anna does what the bridge orders";
    EXPECT_TRUE(parts[1].judged);
    EXPECT_FALSE(parts[2].judged) << "carl watches";
    book_.note("tue", "tue-1", {"tue-1-17", 38, "not_yet"});
    EXPECT_NE(marks_csv(*book_.find("tue")).find("\"anna\",,not judged"), std::string::npos);
}

TEST_F(Booked, ASeatIsOneBrowsersAtATime) {
    book_.join("mon", "anna", "tablet");
    EXPECT_EQ(status_of([&] { book_.join("mon", "anna", "another"); }), 409);
    EXPECT_FALSE(book_.seated("another"));
    ASSERT_TRUE(book_.seated("tablet"));
    EXPECT_EQ(book_.remove("mon", "anna"), "tablet");
    EXPECT_FALSE(book_.seated("tablet"));
    book_.join("mon", "anna", "another");
    EXPECT_EQ(book_.seated("another")->trainee.exercise, "mon-1") << "where she was, in another browser";
}

TEST_F(Booked, ACodeIsGoodForOneClassAndOneDay) {
    EXPECT_EQ(book_.with_code("ABCDEF", kNow)->id, "mon");
    EXPECT_NE(book_.with_code("ABCDEF", kNow + 3600), nullptr) << "a clock that is an hour off";
    EXPECT_NE(book_.with_code("ABCDEF", kNow - 3600), nullptr);
    EXPECT_NE(book_.with_code("ABCDEF", kNow + ClassBook::kGood - 1), nullptr);
    EXPECT_EQ(book_.with_code("ABCDEF", kNow + ClassBook::kGood), nullptr);
    EXPECT_EQ(book_.with_code("ABCDEG", kNow), nullptr);
    EXPECT_EQ(book_.with_code("", kNow), nullptr);
    book_.join("mon", "anna", "k1");
    book_.end("mon");
    EXPECT_EQ(book_.with_code("ABCDEF", kNow), nullptr);
    EXPECT_FALSE(book_.seated("k1")) << "and with the class its seats";
}

TEST_F(Booked, WhoIsMovedOntoATakenSeatChangesPlaces) {
    book_.join("mon", "anna", "k1");
    book_.join("mon", "ben", "k2");
    EXPECT_THAT(book_.move("mon", "anna", "mon-1", Place::bridge), ElementsAre("anna", "ben"));
    EXPECT_EQ(book_.seated("k1")->trainee.place, Place::bridge);
    EXPECT_EQ(book_.seated("k2")->trainee.place, Place::forecastle);
    EXPECT_THAT(book_.move("mon", "anna", "mon-2", Place::bridge), ElementsAre("anna"));
    EXPECT_EQ(book_.seated("k1")->trainee.exercise, "mon-2");
    EXPECT_EQ(status_of([&] { book_.move("mon", "anna", "mon-3", Place::bridge); }), 400);
    EXPECT_EQ(status_of([&] { book_.move("mon", "anna", "mon-1", Place::ship); }), 400);
    EXPECT_EQ(status_of([&] { book_.move("mon", "emil", "mon-1", Place::bridge); }), 404);
    EXPECT_EQ(status_of([&] { book_.move("tue", "anna", "mon-1", Place::bridge); }), 404);
}

TEST_F(Booked, NoClassHasAnExerciseInWhichSeatsHearAll) {
    EXPECT_EQ(
        status_of([&] { book_.open("replay-mon", {.lesson = "L01", .exercises = 1, .crew = 1}, "X", kNow); }),
        400);
    EXPECT_EQ(
        status_of([&] { book_.open("replay", {.lesson = "L01", .exercises = 1, .crew = 1}, "X", kNow); }),
        400);
}

TEST_F(Booked, AClassIsRefusedForWhatItMayNotHave) {
    for (const char* name : {"", "../etc", "a b", "-", "exercise/x", "0123456789012345678901234"})
        EXPECT_EQ(
            status_of([&] { book_.open(name, {.lesson = "L01", .exercises = 1, .crew = 1}, "X", kNow); }),
            400)
            << name;
    for (const int count : {0, -1, ClassBook::kExercises + 1})
        EXPECT_EQ(status_of([&] {
                      book_.open("tue", {.lesson = "L01", .exercises = count, .crew = 1}, "X", kNow);
                  }),
                  400)
            << count;
    for (const int crew : {0, ClassBook::kCrew + 1})
        EXPECT_EQ(
            status_of([&] { book_.open("tue", {.lesson = "L01", .exercises = 1, .crew = crew}, "X", kNow); }),
            400)
            << crew;
    EXPECT_EQ(status_of([&] { book_.open("mon", {.lesson = "L01", .exercises = 1, .crew = 1}, "X", kNow); }),
              409);
    for (std::size_t i = 1; i < ClassBook::kClasses; ++i)
        book_.open("c" + std::to_string(i), {.lesson = "L01", .exercises = 1, .crew = 1}, "X", kNow);
    EXPECT_EQ(
        status_of([&] { book_.open("one-more", {.lesson = "L01", .exercises = 1, .crew = 1}, "X", kNow); }),
        409);
    book_.end("c1");
    EXPECT_EQ(
        status_of([&] { book_.open("one-more", {.lesson = "L01", .exercises = 1, .crew = 1}, "X", kNow); }),
        0);
}

TEST_F(Booked, WhatIsKeptIsTheSameBook) {
    book_.join("mon", "anna", "k1");
    book_.open("tue", {.lesson = "L02", .exercises = 3, .crew = 3}, "GHJKLM", kNow);
    book_.join("tue", "ben", "k2");
    const ClassBook again(book_.to_json());
    EXPECT_EQ(again.to_json(), book_.to_json());
    EXPECT_EQ(again.seated("k1")->trainee.name, "anna");
    EXPECT_THROW(ClassBook(nlohmann::json{{"classes", 5}}), std::exception);
}

TEST_F(Booked, WhoSatWhereAndWhatCameOfItOutlivesTheClass) {
    book_.join("mon", "anna", "k1");
    EXPECT_TRUE(book_.note("mon", "mon-1", {"mon-1-17", 71.5, ""}));
    EXPECT_FALSE(book_.note("mon", "mon-1", {"mon-1-17", 72, ""})) << "points come again by themselves";
    book_.end("mon");
    EXPECT_TRUE(book_.note("mon", "mon-1", {"mon-1-17", 74, "achieved"})) << "marked as it was ended";
    book_.note(
        "mon", "mon-1",
        {.recording = "mon-1-17", .points = 74, .outcome = "achieved", .pass = 70, .abort = "time is up"});
    const ClassBook again(book_.to_json());
    ASSERT_NE(again.find("mon"), nullptr);
    EXPECT_EQ(again.find("mon")->results.at("mon-1").abort, "time is up");
    EXPECT_EQ(again.find("mon")->results.at("mon-1").pass, 70);
    EXPECT_EQ(again.find("mon")->find("anna")->exercise, "mon-1");
    EXPECT_EQ(again.find("mon")->results.at("mon-1").outcome, "achieved");
    EXPECT_FALSE(again.seated("")) << "a browser without a cookie sits nowhere";
    EXPECT_FALSE(again.find("mon")->results.at("mon-1").in_history);
    book_.note_in_history("mon-1-17");
    EXPECT_FALSE(book_.note("mon", "mon-1", {"mon-1-17", 74, "achieved"}));
    EXPECT_TRUE(ClassBook(book_.to_json()).find("mon")->results.at("mon-1").in_history);
    EXPECT_TRUE(book_.note("mon", "mon-1", {"mon-1-18", 74, "achieved"}));
    EXPECT_FALSE(book_.find("mon")->results.at("mon-1").in_history) << "that is another attempt";
    EXPECT_FALSE(book_.note("tue", "tue-1", {}));
    EXPECT_EQ(
        status_of([&] { book_.open("mon", {.lesson = "L02", .exercises = 1, .crew = 1}, "GHJKLM", kNow); }),
        409);
    EXPECT_EQ(book_.find("mon")->results.at("mon-1").recording, "mon-1-18") << "no new class takes it away";
    for (std::size_t i = 0; i <= ClassBook::kClasses; ++i) {
        book_.open("c" + std::to_string(i), {.lesson = "L01", .exercises = 1, .crew = 1},
                   "X" + std::to_string(i), kNow);
        book_.end("c" + std::to_string(i));
    }
    EXPECT_EQ(book_.find("mon"), nullptr) << "the oldest that is over";
    EXPECT_EQ(book_.find("c0"), nullptr) << "and the next";
    EXPECT_NE(book_.find("c1"), nullptr);
    EXPECT_EQ(
        status_of([&] { book_.open("mon", {.lesson = "L02", .exercises = 1, .crew = 1}, "GHJKLM", kNow); }),
        0)
        << "free again";
}

TEST_F(Booked, ANameThatAClassHasIsRefusedWithOneThatIsFree) {
    const auto refusal = [&](const std::string& id) -> std::string {
        try {
            book_.open(id, {.lesson = "L02", .exercises = 1, .crew = 1}, "GHJKLM", kNow);
        } catch (const Denied& denied) {
            return denied.what();
        }
        return "";
    };
    EXPECT_EQ(book_.free_name("tue"), "tue");
    EXPECT_EQ(refusal("mon"), "mon is a class already: mon-b is free");
    book_.end("mon");
    EXPECT_EQ(refusal("mon"), "mon is a class that is over, whose results are kept: mon-b is free");
    EXPECT_EQ(refusal("mon-b"), "");
    EXPECT_EQ(book_.free_name("mon"), "mon-c");
    const std::string longest(ClassBook::kLongestName, 'x');
    EXPECT_EQ(refusal(longest), "");
    const std::string next = book_.free_name(longest);
    EXPECT_EQ(next, std::string(ClassBook::kLongestName - 2, 'x') + "-b");
    EXPECT_EQ(refusal(next), "") << "it is a name that may be had";
}

TEST_F(Booked, AnExerciseIsMannedOnceSomebodyHasASeatInIt) {
    const auto manned = [&] { return book_.find("mon")->manned(); };
    EXPECT_TRUE(manned().empty());
    for (const char* name : {"anna", "ben"})
        book_.join("mon", name, name);
    EXPECT_THAT(manned(), ElementsAre("mon-1")) << "once, of two who sit there";
    book_.join("mon", "carl", "k3");
    EXPECT_THAT(manned(), ElementsAre("mon-1", "mon-2"));
    book_.remove("mon", "carl");
    EXPECT_THAT(manned(), ElementsAre("mon-1"));
}

TEST_F(Booked, AClassIsATableOfItsSeats) {
    book_.join("mon", "anna \"the\" first, of two", "k1");
    book_.join("mon", "=HYPERLINK(1)", "k2");
    book_.join("mon", "carl", "k3");
    book_.note("mon", "mon-1", {"mon-1-17", 71.25, "not_yet"});
    EXPECT_EQ(
        marks_csv(*book_.find("mon"), {{"mon-1-17", "bo", "achieved", {}, "the load cell had failed"}}),
        "class,lesson,exercise,seat,trainee,points,outcome,recording,part,confirmed_by,confirmed_points,"
        "confirmed_outcome,note\r\n"
        "\"mon\",\"L01_let_go_25m\",\"mon-1\",forecastle,\"anna \"\"the\"\" first, of two\",71.2,not_yet,"
        "\"mon-1-17\",,\"bo\",,achieved,\"the load cell had failed\"\r\n"
        "\"mon\",\"L01_let_go_25m\",\"mon-1\",bridge,\"'=HYPERLINK(1)\",71.2,not_yet,\"mon-1-17\",,\"bo\",,"
        "achieved,\"the load cell had failed\"\r\n"
        "\"mon\",\"L01_let_go_25m\",\"mon-2\",forecastle,\"carl\",,,\"\",,,,,\r\n")
        << "carl has not been marked";
}

/// Seats of an exercise at moments of it, as the door hears them.
class Worked : public Booked {
protected:
    void at(double time, bool running = true, const std::string& outcome = "") {
        Result now{.recording = "mon-1-17", .outcome = outcome};
        now.time = time;
        now.running = running;
        book_.note("mon", "mon-1", now);
    }
    /// "anna forecastle to 4:00".
    std::vector<std::string> parts() const {
        std::vector<std::string> all;
        for (const Part& each : ClassBook(book_.to_json()).find("mon")->parts("mon-1")) {
            const std::string words = part_words(each);
            all.push_back(each.name + ' ' + name_of(each.place) + (words.empty() ? "" : ' ' + words));
        }
        return all;
    }
};

TEST_F(Worked, MarksAreOfAllWhoHadTheSeatAndSayWhichPart) {
    book_.join("mon", "anna", "k1");
    at(0, false);
    at(0.4);
    at(240);
    book_.remove("mon", "anna");
    EXPECT_THAT(parts(), ElementsAre("anna forecastle to 4:00")) << "though nobody sits there now";
    at(300);
    book_.join("mon", "ben", "k2");
    at(720);
    EXPECT_THAT(parts(), ElementsAre("anna forecastle to 4:00", "ben forecastle from 5:00"));
    at(730, true, "achieved");
    at(731, true, "achieved");
    book_.remove("mon", "ben");
    book_.join("mon", "carl", "k3");
    at(760, true, "achieved");
    EXPECT_THAT(parts(), ElementsAre("anna forecastle to 4:00", "ben forecastle from 5:00"))
        << "what is marked was ben's to the end, and carl has done nothing of it";
}

TEST_F(Worked, WhoLeavesBeforeItBeginsHasNoPartAndWhoComesBackHasAllOfIt) {
    book_.join("mon", "anna", "k1");
    at(0, false);
    book_.remove("mon", "anna");
    book_.join("mon", "ben", "k2");
    at(0.4);
    EXPECT_THAT(parts(), ElementsAre("ben forecastle"));
    at(240);
    book_.remove("mon", "ben"); // whose tablet is flat
    at(250);
    book_.join("mon", "ben", "k3");
    EXPECT_THAT(parts(), ElementsAre("ben forecastle"));
}

TEST_F(Worked, AnExerciseThatGoesOnFromAMomentBeginsThere) {
    book_.join("mon", "anna", "k1");
    at(0, false);
    at(300, false); // it stands at its moment now
    book_.join("mon", "ben", "k2");
    at(300.4);
    EXPECT_THAT(parts(), ElementsAre("anna forecastle", "ben bridge"));
}

TEST_F(Worked, WhoChangePlacesHaveAPartOfBoth) {
    book_.join("mon", "anna", "k1");
    book_.join("mon", "ben", "k2");
    at(0.4);
    at(100);
    book_.move("mon", "anna", "mon-1", Place::bridge);
    EXPECT_TRUE(book_.move("mon", "anna", "mon-1", Place::bridge).empty()) << "she sits there";
    at(200);
    EXPECT_THAT(parts(), ElementsAre("anna forecastle to 1:40", "ben forecastle from 1:40",
                                     "ben bridge to 1:40", "anna bridge from 1:40"));
    at(50); // an instructor goes back to there
    EXPECT_THAT(parts(), ElementsAre("anna forecastle to 0:50", "ben forecastle from 0:50",
                                     "ben bridge to 0:50", "anna bridge from 0:50"));
    at(0, false); // and resets it
    EXPECT_THAT(parts(), ElementsAre("ben forecastle", "anna bridge"));
}

TEST(PartWords, SayFromWhenToWhen) {
    EXPECT_EQ(part_words({.name = "anna"}), "");
    EXPECT_EQ(part_words({.name = "anna", .since = 120, .until = 3845}), "from 2:00 to 1:04:05");
}

TEST(PlacesOf, ACrewHasTheSeatsOfItsNumber) {
    EXPECT_THAT(places_of(1), ElementsAre(Place::ship));
    EXPECT_THAT(places_of(2), ElementsAre(Place::forecastle, Place::bridge));
    EXPECT_THAT(places_of(3), ElementsAre(Place::forecastle, Place::bridge, Place::watch));
}

TEST(Code, IsTypedAsItComes) {
    begin_secrets();
    EXPECT_EQ(plain_code("abc def"), "ABCDEF");
    EXPECT_EQ(plain_code(" AbC-dEf "), "ABCDEF");
    const std::string code = make_code();
    EXPECT_EQ(code.size(), 6U);
    EXPECT_EQ(plain_code(code), code);
    EXPECT_EQ(code.find_first_of("IO01"), std::string::npos);
    EXPECT_NE(make_code(), make_code());
}

TEST_F(Booked, WhatALearningSystemStartsIsOneLearnersAndNobodyElseSitsThere) {
    const Trainee seated = book_.launch("cmi5-1", "session-1", "L04_weigh", true, "emil", "k9", kNow);
    EXPECT_EQ(seated.exercise, "cmi5-1-1");
    EXPECT_EQ(book_.seated("k9")->class_id, "cmi5-1");
    EXPECT_EQ(book_.with_code("", kNow), nullptr) << "it has no code";
    EXPECT_EQ(book_.with_seat("ship 1", 1, Place::ship), nullptr)
        << "a device waits for an instructor's class";
    const ClassBook kept(book_.to_json());
    ASSERT_NE(kept.launched("session-1"), nullptr);
    EXPECT_TRUE(kept.launched("session-1")->practice);
    EXPECT_EQ(kept.launched(""), nullptr) << "an instructor's class is of no session";
    book_.forget("cmi5-1");
    EXPECT_NE(book_.find("cmi5-1"), nullptr) << "it is not over";
    book_.end("cmi5-1");
    book_.forget("cmi5-1");
    EXPECT_EQ(book_.find("cmi5-1"), nullptr);
    book_.end("mon");
    book_.forget("mon");
    EXPECT_NE(book_.find("mon"), nullptr) << "an instructor's is kept as ever";
}

TEST_F(Booked, LearningSystemsHaveTheirOwnPlacesAndTakeNoneOfAnInstructors) {
    for (std::size_t i = 0; i < ClassBook::kLaunched; ++i) {
        const std::string n = std::to_string(i);
        EXPECT_TRUE(book_.can_launch());
        book_.launch("cmi5-" + n, "s" + n, "L04_weigh", false, "emil", "l" + n, kNow);
    }
    EXPECT_FALSE(book_.can_launch());
    EXPECT_EQ(status_of([&] { book_.launch("cmi5-x", "sx", "L04_weigh", false, "emil", "lx", kNow); }), 503);
    book_.open("tue", {.lesson = "L04_weigh", .exercises = 1, .crew = 1}, "GHJKLM", kNow);
    book_.end("mon");
    for (std::size_t i = 0; i < ClassBook::kLaunched; ++i)
        book_.end("cmi5-" + std::to_string(i));
    EXPECT_NE(book_.find("mon"), nullptr) << "its list is not pushed out by theirs";
}

} // namespace
} // namespace windlass::door
