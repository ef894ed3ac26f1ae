// Devices that stand at one seat, as they are kept.

#include "door/kiosks.hpp"
#include "door/private_file.hpp"
#include "tests/recorder/folder.hpp"

#include <gmock/gmock.h>

namespace windlass::door {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

int refusal(const std::function<void()>& what) {
    try {
        what();
    } catch (const Denied& denied) {
        return denied.status;
    }
    return 0;
}

class KeptKiosks : public ::testing::Test {
protected:
    const Kiosk third_{.name = "third", .exercise = 3, .place = Place::forecastle, .invitation = "i1"};
    test::Folder folder_;
    const std::filesystem::path file_ = folder_ / "kiosks.json";
    Kiosks kiosks_{file_};
};

TEST_F(KeptKiosks, AnAddressIsGoodOnceAndItsDeviceIsKnownAfterARestart) {
    kiosks_.put(third_);
    EXPECT_EQ(refusal([&] { kiosks_.open("guess", "k1"); }), 403);
    EXPECT_EQ(kiosks_.with_key(""), nullptr) << "nobody is the device that has none";
    EXPECT_EQ(kiosks_.open("i1", "k1").name, "third");
    EXPECT_EQ(refusal([&] { kiosks_.open("i1", "k2"); }), 403);
    EXPECT_EQ(refusal([&] { kiosks_.open("", "k2"); }), 403);
    const Kiosks again(file_);
    ASSERT_NE(again.with_key("k1"), nullptr);
    EXPECT_EQ(again.with_key("k1")->exercise, 3);
    EXPECT_EQ(again.with_key("k1")->place, Place::forecastle);
}

TEST_F(KeptKiosks, WhatAnotherProcessHasTakenBackIsRevokedHere) {
    kiosks_.put(third_);
    kiosks_.open("i1", "k1");
    EXPECT_THAT(kiosks_.take_revoked(), IsEmpty());
    Kiosks command_line(file_);
    command_line.put({.name = "fourth", .exercise = 4, .place = Place::bridge, .invitation = "i2"});
    kiosks_.refresh();
    EXPECT_THAT(kiosks_.take_revoked(), IsEmpty()) << "another's";
    EXPECT_EQ(kiosks_.all().size(), 2);
    command_line.remove("third");
    kiosks_.refresh();
    EXPECT_THAT(kiosks_.take_revoked(), ElementsAre("k1"));
    EXPECT_THAT(kiosks_.take_revoked(), IsEmpty()) << "once";
    EXPECT_EQ(kiosks_.with_key("k1"), nullptr);
    EXPECT_EQ(refusal([&] { kiosks_.remove("third"); }), 404);
}

TEST_F(KeptKiosks, AnotherAddressEndsTheDeviceThatHadTheName) {
    kiosks_.put(third_);
    kiosks_.open("i1", "k1");
    Kiosk moved = third_;
    moved.invitation = "i3";
    kiosks_.put(moved);
    EXPECT_THAT(kiosks_.take_revoked(), ElementsAre("k1"));
    EXPECT_EQ(refusal([&] { kiosks_.put({.name = "x", .exercise = 0}); }), 400);
    EXPECT_EQ(refusal([&] { kiosks_.put({.name = "x", .exercise = 65}); }), 400);
}

TEST_F(KeptKiosks, AFileThatIsNoneIsToldWithItsName) {
    test::put(file_, R"({"kiosks":[{"name":"x","exercise":1,"place":"roof","invitation":"","key":""}]})");
    try {
        const Kiosks read(file_);
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr(file_.string() + ": no place: \"roof\""));
    }
}

TEST(KiosksSeat, IsOfTheClassThatWasOpenedLastAndHasIt) {
    constexpr std::int64_t kNow = 1'800'000'000;
    ClassBook book;
    EXPECT_EQ(book.with_seat("third", 1, Place::ship), nullptr);
    book.open("mon", {.lesson = "L01_let_go_25m", .exercises = 4, .crew = 2}, "ABCDEF", kNow);
    book.open("tue", {.lesson = "L01_let_go_25m", .exercises = 2, .crew = 2}, "GHJKLM", kNow);
    const auto id = [&](int exercise, Place place) {
        const auto* found = book.with_seat("third", exercise, place);
        return found == nullptr ? std::string() : found->id;
    };
    EXPECT_EQ(id(2, Place::forecastle), "tue");
    EXPECT_EQ(id(3, Place::forecastle), "mon") << "tue has two exercises";
    EXPECT_EQ(id(5, Place::forecastle), "");
    EXPECT_EQ(id(0, Place::forecastle), "");
    EXPECT_EQ(id(1, Place::ship), "") << "two sit at forecastle and bridge";
    EXPECT_EQ(book.sit("tue", "third", "k1", 2, Place::forecastle).exercise, "tue-2");
    EXPECT_EQ(refusal([&] { book.sit("tue", "other", "k2", 2, Place::forecastle); }), 409) << "taken";
    EXPECT_EQ(refusal([&] { book.sit("tue", "third", "k2", 1, Place::forecastle); }), 409) << "the name";
    EXPECT_EQ(book.seated("k1")->class_id, "tue");
    book.open("wed", {.lesson = "L01_let_go_25m", .exercises = 2, .crew = 2, .names = {"anna"}}, "NPQRST",
              kNow);
    EXPECT_EQ(refusal([&] { book.sit("wed", "third", "k3", 2, Place::forecastle); }), 403) << "a list";
    book.end("wed");
    EXPECT_EQ(id(2, Place::forecastle), "tue");
}

// It sat in exercise 3, and went wrong there: the class that goes on has one exercise.
TEST(KiosksSeat, OfAClassWhoseListHasItsNameIsTheOneThatItHadWhateverItsNumber) {
    constexpr std::int64_t kNow = 1'800'000'000;
    ClassBook book;
    book.open("mon", {.lesson = "L01_let_go_25m", .exercises = 4, .crew = 2}, "ABCDEF", kNow);
    book.open("again",
              {.lesson = "L01_let_go_25m",
               .exercises = 1,
               .crew = 2,
               .names = {"deck 3", "bridge 3"},
               .from = Moment{"mon-3-17", 60},
               .places = {{"deck 3", Place::bridge}, {"bridge 3", Place::forecastle}}},
              "GHJKLM", kNow);
    EXPECT_EQ(book.with_seat("deck 3", 3, Place::forecastle)->id, "again");
    EXPECT_EQ(book.with_seat("deck 4", 4, Place::forecastle)->id, "mon") << "which is not on the list";
    const Trainee seated = book.sit("again", "deck 3", "k1", 3, Place::forecastle);
    EXPECT_EQ(seated.exercise, "again-1");
    EXPECT_EQ(seated.place, Place::bridge) << "where it was moved to then";
    EXPECT_EQ(book.sit("again", "bridge 3", "k2", 3, Place::bridge).place, Place::forecastle);
}

TEST(KiosksSeat, OnAListIsThatOfItsNumberWhereItIsFreeAndElseTheFirstThatIs) {
    constexpr std::int64_t kNow = 1'800'000'000;
    ClassBook book;
    book.open("next",
              {.lesson = "L01_let_go_25m", .exercises = 3, .crew = 1, .names = {"ship 2", "ship 7", "ben"}},
              "ABCDEF", kNow);
    EXPECT_EQ(book.sit("next", "ship 2", "k1", 2, Place::ship).exercise, "next-2");
    EXPECT_EQ(book.join("next", "ben", "k2").exercise, "next-1");
    EXPECT_EQ(book.sit("next", "ship 7", "k3", 7, Place::ship).exercise, "next-3");
    EXPECT_EQ(refusal([&] { book.sit("next", "ship 9", "k4", 1, Place::ship); }), 403);
    EXPECT_EQ(refusal([&] { book.sit("next", "ship 2", "k5", 2, Place::ship); }), 409) << "it sits there";
}

} // namespace
} // namespace windlass::door
