// The rooms of the house and their doors: who may include whom. docs/architecture.md tells what lives in
// each.

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// A room, and the rooms beside itself whose files its own may include. A room named "a/..." is a and all
/// below.
struct Room {
    std::string folder;
    std::vector<std::string> below;
};

/// Every folder with C++ in it stands here, the lowest first: none may name a room that comes after it.
const std::vector<Room>& rooms() {
    static const std::string physics = "server/physics/";
    static const std::vector<Room> all = [] {
        std::vector<Room> list{{"words", {}},
                               {"common", {"words"}},
                               {"idl/fast_dds_2_9", {}},
                               {"idl", {"common", "idl/fast_dds_2_9"}}};
        list.push_back({physics + "base", {"words"}});
        std::vector<std::string> below{physics + "base"};
        for (const char* room :
             {"sea", "chain", "contact", "solver", "ship", "windlass", "anchor", "lod", "tackle"}) {
            list.push_back({physics + room, below});
            below.push_back(physics + room);
        }
        static const std::string exercise = "server/exercise/";
        std::vector<std::string> in_exercise{"common", "words", physics + "..."};
        for (const char* room : {"weather", "definition", "picture", "faults", "talk", "watch", "tick"}) {
            list.push_back({exercise + room, in_exercise});
            in_exercise.push_back(exercise + room);
        }
        list.push_back({"server/exercise", in_exercise});
        const std::vector<Room> rest{
            {"server/assess",
             {"common", "server/exercise/...", physics + "base", physics + "chain", "words"}},
            {"server/config", {"common", "server/assess", "server/exercise/...", physics + "...", "words"}},
            {"server/perceive", {"common", "idl", "server/exercise/...", physics + "...", "words"}},
            {"server/run", {"common", "server/assess", "server/exercise/...", physics + "...", "words"}},
            {"server/dds",
             {"common", "idl", "server/assess", "server/exercise/...", "server/perceive", "server/run",
              physics + "base", "words"}},
            {"server/host",
             {"common", "idl", "server/config", "server/dds", "server/exercise/...", "server/run", "words"}},
            {"server",
             {"common", "idl", "server/config", "server/exercise/...", "server/host", "server/run"}},
            {"station", {"common", "idl", "words"}},
            {"station/gateway", {"common", "idl", "station", "words"}},
            {"trainee_client", {"common", "idl", "station", "station/gateway", "words"}},
            {"lesson",
             {"common", "idl", "server/assess", "server/config", "server/dds", "server/exercise/...",
              "server/perceive", "server/run", "station", "trainee_client", "words"}},
            {"recorder/mcap", {}},
            {"recorder/recording", {"idl", "recorder/mcap"}},
            {"recorder/debrief", {"common", "idl", "recorder/recording", "station", "recorder", "words"}},
            {"recorder/resimulate",
             {"common", "idl", "recorder/mcap", "recorder/recording", "server/assess", "server/config",
              "server/dds", "server/exercise/...", "server/run", "recorder"}},
            {"recorder/record",
             {"common", "idl", "recorder/mcap", "recorder/recording", "server/config", "station",
              "recorder"}},
            {"recorder/replay",
             {"common", "idl", "recorder/recording", "server/host", "station", "recorder"}},
            {"recorder/info", {"common", "idl", "recorder/recording", "station", "recorder"}},
            {"recorder/export", {"idl", "recorder/recording", "recorder"}},
            {"recorder", {"idl", "recorder/debrief", "recorder/mcap", "recorder/recording", "station"}},
            {"instructor_console/history", {"recorder/debrief", "recorder/recording", "station"}},
            {"instructor_console",
             {"common", "idl", "instructor_console/history", "lesson", "recorder/debrief",
              "recorder/recording", "recorder/resimulate", "server/assess", "server/config",
              "server/exercise/...", "station", "station/gateway", "trainee_client", "words"}},
            {"rigs", {"common", "server/config", "server/exercise/...", physics + "..."}},
            {"bench/problem", {"common", physics + "..."}},
            {"bench/methods", {"bench/problem", physics + "..."}},
            {"bench/lab/draw", {"common"}},
            {"bench/lab/case", {"common", "bench/problem", "bench/methods", physics + "..."}},
            {"bench/lab/accuracy",
             {"common", "bench/problem", "bench/methods", "bench/lab/case", "bench/lab/draw"}},
            {"bench/lab/stability",
             {"common", "bench/problem", "bench/methods", "bench/lab/case", "bench/lab/draw",
              physics + "..."}},
            {"bench/lab/convergence",
             {"common", "bench/problem", "bench/methods", "bench/lab/case", "bench/lab/draw",
              physics + "..."}},
            {"bench/lab/shapes",
             {"common", "bench/problem", "bench/methods", "bench/lab/case", "bench/lab/draw",
              physics + "..."}},
            {"bench/lab", {"bench/lab/...", "bench/problem"}},
            {"bench/acceptance", {"rigs", "server/config", "server/exercise/...", physics + "..."}},
            {"bench",
             {"bench/...", "idl", "rigs", "common", "server/config", "server/dds", "server/exercise/...",
              "server/run", physics + "..."}},
            {"tests/...", {"..."}},
        };
        list.insert(list.end(), rest.begin(), rest.end());
        return list;
    }();
    return all;
}

bool covers(const std::string& pattern, const std::string& folder) {
    if (pattern == "...") return true;
    if (!pattern.ends_with("/...")) return folder == pattern;
    return folder.starts_with(pattern.substr(0, pattern.size() - 3)) || folder + "/..." == pattern;
}

const Room* room_of(const std::string& folder) {
    const auto found = std::ranges::find_if(rooms(), [&](const Room& r) { return covers(r.folder, folder); });
    return found == rooms().end() ? nullptr : &*found;
}

/// Files with C++ of ours below the source folder, as paths from there.
std::vector<std::string> sources() {
    const fs::path root = WINDLASS_SOURCE_DIR;
    std::vector<std::string> files;
    for (const char* top : {"common", "words", "idl", "server", "station", "trainee_client", "lesson",
                            "instructor_console", "recorder", "rigs", "bench", "tests"}) {
        for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
            const std::string kind = entry.path().extension();
            if (kind == ".cpp" || kind == ".hpp")
                files.push_back(entry.path().lexically_relative(root).string());
        }
    }
    std::ranges::sort(files);
    return files;
}

/// The files of ours that a file includes.
std::vector<std::string> includes(const std::string& file) {
    static const std::regex include(R"re(^\s*#\s*include\s+"([^"]+)")re");
    std::ifstream in(fs::path(WINDLASS_SOURCE_DIR) / file);
    std::vector<std::string> found;
    std::smatch match;
    for (std::string line; std::getline(in, line);)
        if (std::regex_search(line, match, include)) found.push_back(match[1]);
    return found;
}

std::string folder_of(const std::string& file) {
    return fs::path(file).parent_path().string();
}

TEST(Layers, EveryFolderIsARoom) {
    std::set<std::string> strangers;
    for (const std::string& file : sources())
        if (room_of(folder_of(file)) == nullptr) strangers.insert(folder_of(file));
    EXPECT_THAT(strangers, testing::IsEmpty());
}

TEST(Layers, EveryIncludeGoesThroughADoor) {
    std::vector<std::string> trespassers;
    for (const std::string& file : sources()) {
        const std::string from = folder_of(file);
        const Room* room = room_of(from);
        if (room == nullptr) continue; // told by EveryFolderIsARoom
        for (const std::string& included : includes(file)) {
            const std::string to = folder_of(included);
            if (to.empty() || to == "embedded" || to == from) continue; // generated, or at home
            if (std::ranges::none_of(room->below, [&](const std::string& b) { return covers(b, to); }))
                trespassers.push_back(file + " includes " + included);
        }
    }
    EXPECT_THAT(trespassers, testing::IsEmpty());
}

/// Were a room to include one that includes it, no order of the two would be the lower.
TEST(Layers, NoTwoRoomsIncludeEachOther) {
    std::map<std::string, std::set<std::string>> doors;
    for (const std::string& file : sources())
        for (const std::string& included : includes(file))
            if (folder_of(included) != folder_of(file)) doors[folder_of(file)].insert(folder_of(included));
    // Rooms that only rooms already taken include are taken; what is left at the end goes round.
    std::set<std::string> left;
    for (const auto& [from, to] : doors)
        left.insert(from);
    for (bool again = true; again;) {
        again = false;
        for (auto room = left.begin(); room != left.end();) {
            const auto& to = doors[*room];
            const bool free =
                std::ranges::none_of(to, [&](const std::string& t) { return left.contains(t); });
            room = free ? (again = true, left.erase(room)) : std::next(room);
        }
    }
    EXPECT_THAT(left, testing::IsEmpty());
}

} // namespace
