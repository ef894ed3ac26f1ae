// DDS Security over real DDS: every role does its work, and nobody does more.

#include "rigs/server_process.hpp"
#include "tests/recorder/folder.hpp"
#include "tests/wire/identities.hpp"

#include "idl/fast_dds_2_9/abandoned_memory.hpp"
#include "idl/fast_dds_2_9/ports.hpp"
#include "idl/raw.hpp"
#include "idl/wire.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <map>
#include <set>
#include <sstream>

namespace windlass::test {
using namespace rigs;

namespace {

using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

/// Identities, made once for all tests of a process.
const Identities& ours() {
    static const Identities identities;
    EXPECT_TRUE(identities.made());
    return identities;
}

/// A server with the identity of a server.
ServerProcess secure_server() {
    return ServerProcess({"--domain", std::to_string(own_domain()), "--security", ours().of("server")});
}

/// Runs the instructor's console with that identity, on our domain. patient: for who may come in, who is
/// waited for on a loaded machine too; who may not is given up after 5 s.
Ending console(const std::string& identity, const std::string& command, const std::string& before,
               bool patient) {
    return run(before + " timeout 60 " INSTRUCTOR_CONSOLE " --domain " + std::to_string(own_domain()) +
               (identity.empty() ? "" : " --security " + identity) +
               (patient ? " --timeout 25 " : " --timeout 5 ") + command);
}
Ending console(const std::string& identity, const std::string& command, const std::string& before = "") {
    const bool may = identity == ours().of("instructor") || identity == ours().of("observer");
    return console(identity, command, before, may);
}

/// What the server says it is, asked by an instructor.
std::string status() {
    return console(ours().of("instructor"), "--json status").text;
}

const std::string kFault = "fault brake-lining-faded --severity 1";
const std::string kSkip = "env LD_PRELOAD=" WINDLASS_SKIPS_OWN_CHECKS;

TEST(Security, InstructorCommandsAndOthersDoNot) {
    auto server = secure_server();
    for (const char* role : {"forecastle", "conning", "trainee", "coach", "observer", "recorder", "bridge",
                             "visual", "replay"}) {
        const auto refused = console(ours().of(role), kFault);
        EXPECT_NE(refused.code, 0) << role << refused.text;
        const auto paused = console(ours().of(role), "pause");
        EXPECT_NE(paused.code, 0) << role << paused.text;
    }
    EXPECT_THAT(status(), HasSubstr("\"faults\":[]")) << server.text();
    EXPECT_THAT(status(), HasSubstr("RUN_RUNNING"));
    const auto given = console(ours().of("instructor"), kFault);
    EXPECT_EQ(given.code, 0) << given.text << server.text();
    EXPECT_THAT(status(), Not(HasSubstr("\"faults\":[]")));
}

TEST(Security, ClientThatSkipsItsOwnChecksIsRefusedByTheServer) {
    auto server = secure_server();
    // By itself a trainee's program makes neither the readers of the truth nor the writer; without these
    // checks it does, in vain.
    EXPECT_THAT(console(ours().of("trainee"), kFault).text, HasSubstr("no reader of topic"));
    for (const char* command : {kFault.c_str(), "pause", "stop"}) {
        const auto ending = console(ours().of("trainee"), command, kSkip);
        EXPECT_THAT(ending.text, Not(HasSubstr("no reader of topic"))) << "the check was not skipped";
        EXPECT_THAT(ending.text, Not(HasSubstr("no writer of topic"))) << "the check was not skipped";
        EXPECT_NE(ending.code, 0) << ending.text;
    }
    EXPECT_THAT(status(), HasSubstr("\"faults\":[]")) << server.text();
    EXPECT_THAT(status(), HasSubstr("RUN_RUNNING"));
    EXPECT_EQ(console(ours().of("instructor"), kFault, kSkip).code, 0) << "the way in itself is open";
}

using Names = std::set<std::string>;

/// The topics of the table of which that identity can make a reader in that partition.
Names hears(const std::string& role, const std::string& partition) {
    wire::Participant participant(
        {.domain = own_domain(), .partition = partition, .name = role, .security = ours().of(role)});
    Names names;
    for (const auto& row : wire::topics::all) {
        try {
            const wire::RawReader reader(participant, row, [](const wire::RawSample&) {});
            names.insert(row.name);
        } catch (const std::runtime_error&) {
            continue; // permissions forbid it
        }
    }
    return names;
}

Names every_topic() {
    Names names;
    for (const auto& row : wire::topics::all)
        names.insert(row.name);
    return names;
}

const Names kSeen{"ExerciseStatus",
                  "BridgeOrder",
                  "SeatAssessment",
                  "SceneDescription",
                  "Daylight",
                  "LightsAndShapes",
                  "SeaState",
                  "Landmarks",
                  "ReplayStatus",
                  "WindlassCommand",
                  "InstructorWindlassCommand",
                  "HelmCommand",
                  "InstructorHelmCommand"};

Names with(Names names, std::initializer_list<std::string> more) {
    names.insert(more);
    return names;
}

TEST(Security, TraineeHearsWhatItsSeatsAreGivenAndNothingElse) {
    EXPECT_EQ(hears("trainee", "exercise/default"),
              with(kSeen, {"ForecastleView", "ForecastleEvent", "ForecastleAlert", "ForecastleInstruction",
                           "ForecastleQuestion", "ForecastleGhost", "BridgeView", "BridgeEvent", "Alert",
                           "BridgeInstruction", "BridgeQuestion", "BridgeGhost", "ForecastleCamera", "Chart",
                           "Report"}));
    EXPECT_EQ(hears("forecastle", "exercise/default"),
              with(kSeen, {"ForecastleView", "ForecastleEvent", "ForecastleAlert", "ForecastleInstruction",
                           "ForecastleQuestion", "ForecastleGhost"}));
    EXPECT_EQ(hears("conning", "exercise/default"),
              with(kSeen, {"BridgeView", "BridgeEvent", "Alert", "BridgeInstruction", "BridgeQuestion",
                           "BridgeGhost", "ForecastleCamera", "Chart", "Report"}));
}

TEST(Security, TraineeReadsEverythingInADebriefAndNotInAnExercise) {
    for (const char* role : {"trainee", "forecastle", "conning"})
        EXPECT_EQ(hears(role, "exercise/replay-monday"), every_topic()) << role;
    // A listener to all exercises is one to live ones.
    EXPECT_FALSE(hears("trainee", "exercise/*").contains("ChainState"));
}

TEST(Security, TraineeThatSkipsItsOwnChecksHearsNoTruth) {
    auto server = secure_server();
    const auto looked = console(ours().of("trainee"), "--json status", kSkip);
    EXPECT_EQ(looked.code, 0) << looked.text; // the status is for everybody
    EXPECT_THAT(looked.text, HasSubstr("\"state\":\"RUN_RUNNING\""));
    for (const char* truth : {"faults", "state_hash", "environment"})
        EXPECT_THAT(looked.text, Not(HasSubstr(truth)));
    const auto watched = console(ours().of("trainee"), "--json watch --duration 3", kSkip);
    for (const char* truth :
         {"\"truth\":", "\"windlass\":", "\"chain\":", "\"anchor\":", "\"ship\":", "\"event\":"})
        EXPECT_THAT(watched.text, Not(HasSubstr(truth)));
    EXPECT_THAT(console(ours().of("observer"), "--json watch --duration 3", kSkip).text,
                HasSubstr("\"windlass\":"))
        << "the way in itself is open";
}

TEST(Security, NobodyWithoutAnIdentityOrWithAForeignOneHearsAnything) {
    auto server = secure_server();
    ASSERT_EQ(console(ours().of("observer"), "status").code, 0) << server.text();
    constexpr int kNoServer = 4;
    EXPECT_EQ(console("", "status").code, kNoServer);
    const Identities foreign;
    EXPECT_EQ(console(foreign.of("instructor"), "status").code, kNoServer);
    EXPECT_EQ(console(foreign.of("instructor"), "status", kSkip).code, kNoServer);
}

TEST(Security, TamperedIdentityGetsNothing) {
    auto server = secure_server();
    const Folder folder;
    const auto copy = [&](const std::string& role, const std::string& name) {
        fs::copy(ours().of(role), folder.path() / name);
        return folder.path() / name;
    };

    // A trainee with the permissions of an instructor: they name somebody else.
    const auto borrowed = copy("trainee", "borrowed");
    put(borrowed / "permissions.smime", content(ours().of("instructor") + "/permissions.smime"));
    // One word of its own permissions changed: the signature does not hold.
    const auto edited = copy("trainee", "edited");
    std::string permissions = content(edited / "permissions.smime");
    const auto word = permissions.find("<topic>Report<");
    ASSERT_NE(word, std::string::npos);
    put(edited / "permissions.smime", permissions.replace(word, 14, "<topic>FaultCommand<"));
    // The certificate of an instructor without the key to it.
    const auto stolen = copy("trainee", "stolen");
    for (const std::string file : {"identity.pem", "permissions.smime"})
        put(stolen / file, content(ours().of("instructor/" + file)));

    constexpr int kFailed = 1;
    for (const auto& identity : {borrowed, edited, stolen}) {
        const auto ending = console(identity.string(), kFault, kSkip);
        EXPECT_EQ(ending.code, kFailed) << identity << ending.text;
        EXPECT_THAT(ending.text, HasSubstr("no secure participant can be created")) << identity;
    }
    EXPECT_THAT(status(), HasSubstr("\"faults\":[]")) << server.text();
}

TEST(Security, PermissionsThatATraineeSignsItselfAreRefusedByTheServer) {
    auto server = secure_server();
    // The trainee's own programs believe them: the signer, or who vouches for it, is put among the
    // authorities.
    const Folder folder;
    const auto identity = (folder.path() / "forged").string();
    const auto between = [](const std::string& text, const std::string& first, const std::string& last) {
        const auto at = text.find(first);
        return text.substr(at, text.find(last, at) - at);
    };
    // Those of an instructor, with the trainee's name and subject.
    const auto papers = [](const char* role) { return content(ours().of(role) + "/permissions.smime"); };
    auto wanted = between(papers("instructor"), "<?xml", "</dds>") + "</dds>\n";
    const auto theirs = between(wanted, "<grant", "<validity>");
    wanted.replace(wanted.find(theirs), theirs.size(), between(papers("trainee"), "<grant", "<validity>"));
    const auto sign_as = [&](const std::string& signer, const std::string& key, const std::string& voucher) {
        return run("cd " + identity + " && cat " + voucher +
                   " >> permissions_ca.pem && openssl smime -sign -text -in wanted.xml -out "
                   "permissions.smime "
                   "-signer " +
                   signer + " -inkey " + key)
            .code;
    };
    const auto begin = [&] {
        fs::remove_all(identity);
        fs::copy(ours().of("trainee"), identity);
        put(identity + "/wanted.xml", wanted);
    };
    constexpr int kNoServer = 4; // it joined, and found nobody who takes its order

    begin();
    ASSERT_EQ(sign_as("identity.pem", "key.pem", "identity_ca.pem"), 0);
    auto ending = console(identity, kFault);
    EXPECT_EQ(ending.code, 1) << "a certificate of an identity is not for signing papers (extendedKeyUsage)";
    EXPECT_THAT(ending.text, HasSubstr("no secure participant can be created"));

    begin();
    ASSERT_EQ(run("cd " + identity +
                  " && openssl req -x509 -new -sha256 -newkey ec -pkeyopt "
                  "ec_paramgen_curve:prime256v1 -nodes -keyout own.key -days 9 -subj /CN=own "
                  "-out own.pem")
                  .code,
              0);
    ASSERT_EQ(sign_as("own.pem", "own.key", "own.pem"), 0);
    ending = console(identity, kFault);
    EXPECT_EQ(ending.code, kNoServer) << ending.text;
    EXPECT_THAT(status(), HasSubstr("\"faults\":[]")) << server.text();
}

TEST(Security, IdentityOfOneExerciseIsRefusedInEveryOther) {
    ASSERT_EQ(ours().make("trainee seat-3 --exercise bay-3").code, 0);
    EXPECT_EQ(hears("seat-3", "exercise/bay-3"), hears("trainee", "exercise/default"));
    EXPECT_EQ(hears("seat-3", "exercise/replay-bay-3"), every_topic());
    EXPECT_EQ(hears("seat-3", "exercise/replay-bay-3-1795797600"), every_topic()) << "as a page names it";
    for (const char* other : {"exercise/default", "exercise/bay-30", "exercise/*", "exercise/replay",
                              "exercise/replay-bay-30", "exercise/replay-monday"})
        EXPECT_EQ(hears("seat-3", other), Names{}) << other;

    ASSERT_EQ(ours().make("instructor desk-3 --exercise bay-3").code, 0);
    const std::string domain = std::to_string(own_domain());
    auto server = ServerProcess({"--domain", domain, "--security", ours().of("server"), "--partition",
                                 "bay-3", "--partition", "bay-4"});
    const auto fault = [&](const std::string& partition, const std::string& before) {
        return run(before + " timeout 60 " INSTRUCTOR_CONSOLE " --domain " + domain + " --partition " +
                   partition + " --security " + ours().of("desk-3") + " --timeout " +
                   (partition == "bay-3" ? "25 " : "5 ") + kFault);
    };
    EXPECT_EQ(fault("bay-3", "").code, 0) << server.text();
    EXPECT_EQ(fault("bay-3", kSkip).code, 0) << "the way in itself is open";
    EXPECT_THAT(fault("bay-4", "").text, HasSubstr("in partition exercise/bay-4: the permissions in"));
    constexpr int kNoServer = 4;
    EXPECT_EQ(fault("bay-4", kSkip).code, kNoServer) << "the server refuses it too";
}

TEST(Security, RevokedIdentityIsRefusedByWhoeverStartsAfterwards) {
    const Folder folder;
    const auto lost = (folder / "lost").string();
    ASSERT_EQ(ours().make("instructor desk-1").code, 0);
    fs::copy(ours().of("desk-1"), lost);
    // Renewed since: the certificate of before is revoked as well.
    ASSERT_EQ(ours().make("desk-1", "renew").code, 0);
    const auto renewed = (folder / "renewed").string();
    fs::copy(ours().of("desk-1"), renewed);
    constexpr int kNoServer = 4;
    {
        auto server = secure_server();
        EXPECT_EQ(console(lost, "status", "", true).code, 0) << server.text();
        EXPECT_EQ(console(renewed, "status", "", true).code, 0) << server.text();
        ASSERT_EQ(ours().make("desk-1", "revoke").code, 0);
        EXPECT_EQ(console(lost, "status", "", true).code, 0) << "this server has the list of before";
    }
    auto server = secure_server();
    EXPECT_EQ(console(lost, kFault).code, kNoServer);
    EXPECT_EQ(console(renewed, kFault).code, kNoServer);
    EXPECT_EQ(console(renewed, kFault, kSkip).code, kNoServer);
    EXPECT_THAT(status(), HasSubstr("\"faults\":[]")) << server.text();
    // Where the list has come to its own machine it is told.
    fs::copy_file(ours().of("server/crl.pem"), lost + "/crl.pem", fs::copy_options::overwrite_existing);
    const auto told = console(lost, "status");
    EXPECT_EQ(told.code, 1);
    EXPECT_THAT(told.text, HasSubstr("lost/identity.pem was revoked on "));
    // Another of that name is another identity, and the papers of the last do not fit it.
    ASSERT_EQ(ours().make("observer desk-1").code, 0);
    EXPECT_EQ(console(ours().of("desk-1"), "status", "", true).code, 0) << server.text();
    put(ours().of("desk-1/permissions.smime"), content(renewed + "/permissions.smime"));
    EXPECT_THAT(console(ours().of("desk-1"), "status").text,
                HasSubstr("no secure participant can be created"));
}

TEST(Security, RevokedIdentityIsOutWhenTheServersWorkersHaveBegunAnew) {
    const Folder folder;
    ASSERT_EQ(ours().make("instructor desk-2").code, 0);
    const auto lost = (folder / "lost").string();
    fs::copy(ours().of("desk-2"), lost);
    ServerProcess server({"--domain", std::to_string(own_domain()), "--security", ours().of("server"),
                          "--keep", (folder / "keep").string(), "--workers", "1"});
    EXPECT_EQ(console(lost, "status", "", true).code, 0) << server.text();
    ASSERT_EQ(ours().make("desk-2", "revoke").code, 0);
    const auto began = std::chrono::steady_clock::now();
    server.signal(SIGUSR1);
    ASSERT_TRUE(eventually([&] { return server.text().find("worker 1 begins anew") != std::string::npos; }));
    EXPECT_THAT(console(ours().of("instructor"), "status", "", true).text, HasSubstr("paused"))
        << server.text();
    std::printf("an instructor who joins sees the exercise %.2f s after it was asked\n",
                std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
    constexpr int kNoServer = 4;
    EXPECT_EQ(console(lost, kFault).code, kNoServer);
    EXPECT_THAT(status(), HasSubstr("\"faults\":[]")) << server.text();
}

TEST(Security, IdentityThatEndsIsToldOfAMonthBeforeAndRefusedAfterwards) {
    auto server = secure_server();
    ASSERT_EQ(ours().make("observer soon --days 20").code, 0);
    const auto warned = console(ours().of("soon"), "--json status", "", true);
    EXPECT_EQ(warned.code, 0) << warned.text << server.text();
    EXPECT_THAT(warned.text, HasSubstr("warning: security: " + ours().of("soon") + "/identity.pem ends on "));
    EXPECT_THAT(warned.text, HasSubstr("make_identities renew FOLDER soon\n"));
    EXPECT_THAT(warned.output, Not(HasSubstr("warning"))) << "results are for other programs";
    EXPECT_THAT(console(ours().of("observer"), "status").text, Not(HasSubstr("warning")));

    // A certificate of yesterday, from the same authority.
    ASSERT_EQ(run("cd " + ours().of("soon") +
                  " && openssl req -new -key key.pem -subj /CN=soon | openssl x509 -req "
                  "-days -1 -CA identity_ca.pem -CAkey " +
                  (ours().authorities() / "identity.key").string() + " -set_serial 77 -out identity.pem")
                  .code,
              0);
    const auto ended = console(ours().of("soon"), "status");
    EXPECT_EQ(ended.code, 1);
    EXPECT_THAT(ended.text, HasSubstr("soon/identity.pem ended on "));
    EXPECT_THAT(ended.text, HasSubstr("make_identities renew FOLDER soon\n"));
}

TEST(Security, IncompleteOrOpenIdentityIsToldByFile) {
    const Folder folder;
    fs::copy(ours().of("observer"), folder.path() / "part");
    const auto identity = (folder.path() / "part").string();
    fs::permissions(identity + "/key.pem", fs::perms::others_read, fs::perm_options::add);
    EXPECT_THAT(console(identity, "status").text, HasSubstr("key.pem is open to others; allowed: mode 0600"));
    fs::remove(identity + "/governance.smime");
    EXPECT_THAT(console(identity, "status").text, HasSubstr("governance.smime cannot be read"));
    EXPECT_EQ(console(identity + "/nowhere", "status").code, 2);
}

TEST(Security, ReplayIdentityIsConfinedToItsPartitions) {
    const auto session = [](const std::string& partition) {
        return wire::JoinOptions{own_domain(), partition, "replay", ours().of("replay")};
    };
    wire::Participant apart(session("exercise/replay-1"));
    EXPECT_NO_THROW(wire::Writer<ExerciseStatus>(apart, wire::topics::exercise_status));
    wire::Participant among(session("exercise/default"));
    EXPECT_THROW(wire::Writer<ExerciseStatus>(among, wire::topics::exercise_status), std::runtime_error);
}

TEST(Security, SecureExerciseIsRecordedAndReplayed) {
    const Folder folder;
    const std::string domain = std::to_string(own_domain());
    const auto recording = (folder / "recording").string();
    {
        ChildProcess recorder({WINDLASS_RECORDER, "record", "--output", recording, "--domain", domain,
                               "--security", ours().of("recorder")});
        ASSERT_TRUE(eventually([&] {
            return recorder.text().find("recording partition") != std::string::npos;
        })) << recorder.text();
        ServerProcess server({"--domain", domain, "--security", ours().of("server"), "--duration", "8"});
        EXPECT_EQ(server.exit_code(), 0) << server.text();
        recorder.signal(SIGINT);
        EXPECT_EQ(recorder.exit_code(), 0) << recorder.text();
    }
    EXPECT_THAT(run(WINDLASS_RECORDER " info " + recording).text, HasSubstr("ChainState"));
    const ChildProcess replay({WINDLASS_RECORDER, "replay", recording, "--loop", "--domain", domain,
                               "--security", ours().of("replay")});
    EXPECT_THAT(console(ours().of("observer"), "--partition replay --json status").text,
                HasSubstr("RUN_REPLAY"))
        << replay.text();
}

/// Locks that this process has in shared memory.
std::set<std::string> locks() {
    std::set<std::string> files;
    for (const auto& open : fs::directory_iterator("/proc/self/fd")) {
        std::error_code closed;
        const auto file = fs::read_symlink(open, closed);
        if (file.parent_path() == "/dev/shm" && file.filename().string().ends_with("_el"))
            files.insert(file.string());
    }
    return files;
}

/// Our belief about Fast DDS, held against it: where it listens, and what tidying makes of that.
TEST(SecureMembers, HearSamplesAtPortsOfTheirOwnWhichTidyingLeavesAlone) {
    wire::Participant server(
        {.domain = own_domain(), .name = "server", .security = ours().of("server"), .network = {}});
    wire::Participant trainee(
        {.domain = own_domain(), .name = "trainee", .security = ours().of("trainee"), .network = {}});
    std::atomic<int> heard{0};
    const wire::Reader<SeatEvent> reader(trainee, wire::topics::forecastle_event,
                                         [&](const SeatEvent&) { ++heard; });
    wire::Writer<SeatEvent> writer(server, wire::topics::forecastle_event);
    ASSERT_TRUE(eventually([&] { return writer.matched() == 1 && reader.matched() == 1; }));
    const auto has = locks();
    EXPECT_EQ(has.size(), 4U); // of each a segment, and the port of ours
    const auto memory = [](const std::string& lock) { return lock.substr(0, lock.size() - 3); };
    EXPECT_EQ(std::count_if(has.begin(), has.end(),
                            [&](const std::string& lock) {
                                return wire::is_sample_port(fs::path(memory(lock)).filename().string());
                            }),
              2);
    pace(std::chrono::milliseconds(
        1100)); // a file's age is by the kernel's clock; others may be just starting
    wire::remove_abandoned_memory("/dev/shm", std::chrono::seconds(1));
    for (const auto& lock : has)
        EXPECT_TRUE(fs::exists(lock) && fs::exists(memory(lock))) << lock;
    for (int i = 1; i <= 100; ++i)
        ASSERT_TRUE(writer.write(SeatEvent{}));
    EXPECT_TRUE(eventually([&] { return heard == 100; }));
}

TEST(Roles, CoverTheTopicTable) {
    std::map<std::string, std::set<std::string>> may, debrief, classroom; // "role write" -> topics
    std::ifstream file(WINDLASS_SECURITY_DIR "/roles.txt");
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line.substr(0, line.find('#')));
        std::string role, partition, kind, topic;
        words >> role >> partition >> kind;
        const bool has_more = role == "trainee" || role == "forecastle" || role == "conning" ||
                              role == "watcher" || role == "assessor"; // there than live
        auto& table = partition == "classroom"                               ? classroom
                      : has_more && partition.starts_with("exercise/replay") ? debrief
                                                                             : may;
        while (words >> topic)
            EXPECT_TRUE(table[role + " " + kind].insert(topic).second) << "twice: " << line;
    }
    std::set<std::string> all, from_server, to_server;
    for (const auto& row : wire::topics::all) {
        all.insert(row.name);
        if (std::string(row.name).starts_with("Replay")) continue;
        (row.from_server ? from_server : to_server).insert(row.name);
    }
    EXPECT_EQ(may["server write"], from_server);
    EXPECT_EQ(may["server read"], to_server);
    EXPECT_EQ(may["recorder read"], all);
    EXPECT_EQ(may["instructor read"], all);
    from_server.insert("ReplayStatus");
    EXPECT_EQ(may["replay write"], from_server);
    EXPECT_EQ(debrief["assessor write"], std::set<std::string>{"ReplayCommand"}) << "he seeks in a replay";
    for (const char* none : {"recorder write", "observer write", "visual write", "watcher write"})
        EXPECT_TRUE(may[none].empty()) << none;
    for (const char* topic : {"AnchorState", "ChainState", "WindlassLoad", "CableForce", "ShipState", "Event",
                              "Assessment", "ExerciseTruth", "EnvironmentState", "SeabedDescription",
                              "ServerAlert", "OrderTaken", "Checkpoint", "Prediction"})
        for (const char* seat : {"trainee read", "forecastle read", "conning read", "watcher read"}) {
            EXPECT_FALSE(may[seat].contains(topic)) << seat << " " << topic;
            EXPECT_TRUE(debrief[seat].contains(topic)) << seat << " " << topic;
        }
    for (const auto& [other, topic] :
         {std::pair("conning read", "ForecastleInstruction"),
          std::pair("forecastle read", "BridgeInstruction"), std::pair("conning read", "ForecastleQuestion"),
          std::pair("forecastle read", "BridgeQuestion"), std::pair("conning read", "ForecastleAlert"),
          std::pair("forecastle read", "Alert"), std::pair("conning read", "ForecastleEvent"),
          std::pair("forecastle read", "BridgeEvent")}) {
        EXPECT_FALSE(may[other].contains(topic)) << "what is told to one seat alone";
        EXPECT_TRUE(debrief[other].contains(topic)) << topic;
    }
    for (const auto& [seat, own, other] : {std::tuple("forecastle write", "ForecastleAnswer", "BridgeAnswer"),
                                           std::tuple("conning write", "BridgeAnswer", "ForecastleAnswer")}) {
        EXPECT_TRUE(may[seat].contains(own)) << seat;
        EXPECT_FALSE(may[seat].contains(other)) << "nobody answers for another seat";
        EXPECT_FALSE(may["instructor write"].contains(own)) << "nor does he who knows";
    }
    for (const char* topic :
         {"InstructorWindlassCommand", "InstructorHelmCommand", "EnvironmentCommand", "FaultCommand",
          "ExerciseCommand", "RestoreCommand", "AssessmentCommand", "ReplayCommand"})
        for (const auto& [who, topics] : may)
            if (who.ends_with(" write")) {
                const bool marks = who == "assessor write" && topic == std::string("AssessmentCommand");
                EXPECT_EQ(topics.contains(topic), who == "instructor write" || who == "door write" || marks)
                    << who << " " << topic;
            }
    // The door is for everybody who comes in by a browser, and for nobody else.
    std::set<std::string> by_browser;
    for (const char* who :
         {"instructor", "assessor", "observer", "trainee", "forecastle", "conning", "watcher"})
        by_browser.insert(may[std::string(who) + " write"].begin(), may[std::string(who) + " write"].end());
    EXPECT_EQ(may["door write"], by_browser);
    EXPECT_EQ(may["door read"], all);
    for (const auto& [who, topics] : may)
        if (who.ends_with(" write")) {
            EXPECT_EQ(topics.contains("BridgeOrderCommand"),
                      who == "instructor write" || who == "conning write" || who == "door write")
                << who;
        }
    EXPECT_EQ(classroom["server read"], (std::set<std::string>{"ClassroomStatus", "ClassroomCommand"}));
    EXPECT_EQ(classroom["server write"], (std::set<std::string>{"ClassroomStatus", "Event"}));
    for (const auto& [who, topics] : classroom)
        EXPECT_EQ(topics.contains("ClassroomCommand"),
                  who == "server read" || who == "instructor write" || who == "door write")
            << who;
    for (const auto& [who, topics] : may) {
        for (const auto& topic : topics)
            EXPECT_TRUE(all.contains(topic)) << who << " " << topic;
    }
}

} // namespace
} // namespace windlass::test
