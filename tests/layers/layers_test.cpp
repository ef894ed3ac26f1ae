// The rooms of the house and their doors: who may include whom. docs/architecture.md tells what lives in
// each.

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// A room, the namespaces that its files may open (one or what lies in it; none named: any), and the rooms
/// beside itself whose files its own may include. A room named "a/..." is a and all below.
struct Room {
    std::string folder;
    std::vector<std::string> spaces;
    std::vector<std::string> below;
};

/// Every folder with C++ in it stands here, the lowest first: none may name a room that comes after it.
const std::vector<Room>& rooms() {
    static const std::string physics = "server/physics/", exercise = "server/exercise/";
    static const std::vector<Room> all{
        {"words", {"windlass::words"}, {}},
        {"common", {"windlass", "windlass::files"}, {"words"}},
        {"idl/fast_dds_2_9", {"windlass::wire"}, {}},
        {"idl", {"windlass", "windlass::wire", "windlass::idl"}, {"common", "idl/fast_dds_2_9"}},
        {physics + "base", {"windlass::physics"}, {"words"}},
        {physics + "sea", {"windlass::physics"}, {physics + "base"}},
        {physics + "chain", {"windlass::physics"}, {physics + "base", physics + "sea"}},
        {physics + "contact", {"windlass::physics"}, {physics + "base", physics + "sea", physics + "chain"}},
        {physics + "solver",
         {"windlass::physics"},
         {physics + "base", physics + "sea", physics + "chain", physics + "contact"}},
        {physics + "ship", {"windlass::physics"}, {physics + "base", physics + "sea", physics + "contact"}},
        {physics + "windlass",
         {"windlass::physics"},
         {physics + "base", physics + "chain", physics + "solver"}},
        {physics + "anchor",
         {"windlass::physics"},
         {physics + "base", physics + "sea", physics + "contact", physics + "solver", physics + "ship"}},
        {physics + "lod", {"windlass::physics"}, {physics + "base", physics + "sea", physics + "chain"}},
        {physics + "tackle",
         {"windlass::physics"},
         {physics + "base", physics + "sea", physics + "chain", physics + "contact", physics + "solver",
          physics + "ship", physics + "windlass", physics + "anchor", physics + "lod"}},
        {exercise + "weather", {"windlass::exercise"}, {"common", physics + "base", physics + "sea"}},
        {exercise + "definition",
         {"windlass::exercise"},
         {"common", exercise + "weather", physics + "...", "words"}},
        {exercise + "picture", {"windlass::exercise"}, {exercise + "definition", physics + "...", "words"}},
        {exercise + "faults",
         {"windlass::exercise"},
         {exercise + "picture", physics + "base", physics + "windlass", "words"}},
        {exercise + "talk",
         {"windlass::exercise"},
         {exercise + "definition", exercise + "faults", exercise + "picture", "words"}},
        {exercise + "watch", {"windlass::exercise"}, {exercise + "faults", physics + "..."}},
        {exercise + "tick",
         {"windlass::exercise"},
         {exercise + "definition", exercise + "faults", exercise + "picture", exercise + "watch",
          exercise + "weather", physics + "...", "words"}},
        {"server/exercise",
         {"windlass::exercise"},
         {"common", exercise + "definition", exercise + "picture", exercise + "talk", exercise + "tick",
          exercise + "watch", exercise + "weather", physics + "..."}},
        {"server/assess",
         {"windlass::assess"},
         {"common", exercise + "...", physics + "base", physics + "chain", "words"}},
        {"server/config",
         {"windlass::config"},
         {"common", "server/assess", exercise + "...", physics + "...", "words"}},
        {"server/perceive",
         {"windlass::perceive"},
         {"common", "idl", exercise + "...", physics + "...", "words"}},
        {"server/run", {"windlass::run"}, {"common", "server/assess", exercise + "...", "words"}},
        {"server/dds",
         {"windlass::dds"},
         {"common", "idl", "server/assess", exercise + "...", "server/perceive", "server/run",
          physics + "base", "words"}},
        {"server/keep", {"windlass::keep"}, {"common", "idl", "server/dds", exercise + "...", "server/run"}},
        {"server/host",
         {"windlass::host"},
         {"common", "idl", "server/assess", "server/dds", exercise + "...", "server/keep", "server/run",
          "words"}},
        {"server/workers", {"windlass::workers"}, {}},
        {"server",
         {"windlass::server"},
         {"common", "idl", "lesson", "server/config", exercise + "...", "server/host", "server/keep",
          "server/run", "server/workers"}},
        {"station", {"windlass::station"}, {"idl", "words"}},
        {"station/gateway", {"windlass::gateway"}, {"common", "idl", "station", "words"}},
        {"trainee_client", {"windlass::trainee"}, {"common", "station", "station/gateway", "words"}},
        {"lesson",
         {"windlass::lesson"},
         {"server/assess", "server/dds", exercise + "...", "server/perceive", "server/run", "station",
          "trainee_client", "words"}},
        {"lesson/whatif", {"windlass::whatif"}, {"common", "lesson", "server/assess", "server/run", "words"}},
        {"recorder/mcap", {"windlass::mcap"}, {"common"}},
        {"recorder/recording", {"windlass::recording"}, {"idl", "recorder/mcap"}},
        {"recorder/debrief",
         {"windlass::debrief"},
         {"common", "idl", "recorder/recording", "station", "words"}},
        {"recorder/resimulate",
         {"windlass::recorder"},
         {"idl", "recorder/recording", "server/assess", "server/config", "server/dds", exercise + "...",
          "server/run", "recorder"}},
        {"recorder/ghost",
         {"windlass::recorder"},
         {"idl", "lesson", "recorder/debrief", "recorder/resimulate", "server/dds", "server/run",
          "recorder"}},
        {"recorder/whatif",
         {"windlass::recorder"},
         {"lesson/whatif", "recorder/debrief", "server/assess", "server/config", "server/dds", "words",
          "recorder/resimulate", "recorder"}},
        {"recorder/record",
         {"windlass::recorder"},
         {"idl", "recorder/mcap", "recorder/recording", "server/config", "station", "recorder"}},
        {"recorder/replay",
         {"windlass::recorder"},
         {"idl", "recorder/recording", "server/host", "station", "recorder"}},
        {"recorder/blind",
         {"windlass::blind", "windlass::recorder"},
         {"common", "recorder/debrief", "recorder/export", "recorder/resimulate", "server/assess", "station",
          "words", "recorder"}},
        {"recorder/info", {"windlass::recorder"}, {"idl", "recorder/recording", "station", "recorder"}},
        {"recorder/export", {"windlass::recorder"}, {"idl", "recorder/recording", "recorder"}},
        {"recorder",
         {"windlass::recorder"},
         {"recorder/debrief", "recorder/mcap", "recorder/recording", "station"}},
        {"instructor_console/history", {"windlass::history"}, {"common", "recorder/debrief", "station"}},
        {"instructor_console",
         {"windlass::console"},
         {"common", "idl", "instructor_console/history", "lesson", "lesson/whatif", "recorder",
          "recorder/debrief", "recorder/recording", "recorder/resimulate", "server/assess", "server/config",
          exercise + "...", "station", "station/gateway", "trainee_client", "words"}},
        {"door/cmi5", {"windlass::cmi5"}, {"common"}},
        {"door",
         {"windlass::door"},
         {"common", "door/cmi5", "idl", "instructor_console", "instructor_console/history",
          "recorder/debrief", "station", "station/gateway"}},
        {"rigs", {"windlass::rigs"}, {"common", "server/config", exercise + "...", physics + "..."}},
        {"sim",
         {"windlass::sim"},
         {"common", "idl", "recorder/mcap", "recorder/record", "server/config", "server/dds",
          "server/exercise", "server/exercise/definition", "server/host", "server/keep", "server/perceive",
          "server/run", "station/gateway", "words"}},
        {"bench/problem", {"windlass::lab"}, {physics + "..."}},
        {"bench/methods", {"windlass::lab"}, {"bench/problem", physics + "..."}},
        {"bench/lab/draw", {"windlass::lab"}, {}},
        {"bench/lab/case", {"windlass::lab"}, {"common", "bench/problem", "bench/methods"}},
        {"bench/lab/accuracy", {"windlass::lab"}, {"common", "bench/lab/case", "bench/lab/draw"}},
        {"bench/lab/stability", {"windlass::lab"}, {"common", "bench/lab/case", "bench/lab/draw"}},
        {"bench/lab/convergence",
         {"windlass::lab"},
         {"common", "bench/methods", "bench/lab/case", "bench/lab/draw"}},
        {"bench/lab/shapes",
         {"windlass::lab"},
         {"common", "bench/methods", "bench/lab/case", "bench/lab/draw"}},
        {"bench/lab", {"windlass::lab"}, {"bench/lab/...", "bench/problem"}},
        {"bench/acceptance", {"windlass::lab"}, {"rigs", "server/config", physics + "..."}},
        {"bench",
         {"windlass::bench"},
         {"bench/...", "idl", "rigs", "common", "server/config", "server/dds", exercise + "...", "server/run",
          physics + "..."}},
        {"tests/...", {}, {"..."}},
    };
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
                            "instructor_console", "door", "recorder", "rigs", "sim", "bench", "tests"}) {
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

/// What nobody goes through any more is closed, or the next one who does is not noticed.
TEST(Layers, EveryDoorIsUsed) {
    std::map<std::string, std::set<std::string>> entered; // by the room's name in the list
    for (const std::string& file : sources()) {
        const Room* room = room_of(folder_of(file));
        if (room == nullptr) continue; // told by EveryFolderIsARoom
        for (const std::string& included : includes(file))
            if (folder_of(included) != folder_of(file)) entered[room->folder].insert(folder_of(included));
    }
    std::vector<std::string> unused;
    for (const Room& room : rooms())
        for (const std::string& door : room.below)
            if (std::ranges::none_of(entered[room.folder],
                                     [&](const std::string& to) { return covers(door, to); }))
                unused.push_back(room.folder + " to " + door);
    EXPECT_THAT(unused, testing::IsEmpty());
}

/// A namespace that a file opens, and what stands in it up to its end.
struct Space {
    std::string name, content;
};

std::vector<Space> spaces_of(const std::string& file) {
    std::ifstream in(fs::path(WINDLASS_SOURCE_DIR) / file);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    static const std::regex opened(R"re(\n(?:inline )?namespace (windlass[:\w]*) \{)re");
    std::vector<Space> found;
    for (auto m = std::sregex_iterator(text.begin(), text.end(), opened); m != std::sregex_iterator(); ++m) {
        const auto begin = static_cast<std::size_t>(m->position() + m->length());
        found.push_back({(*m)[1], text.substr(begin, text.find("\n}", begin) - begin)});
    }
    return found;
}

/// What may stand in another room's namespace: names of its types, said beforehand, and lists of their
/// fields, which are found there.
bool only_names(const std::string& content) {
    static const std::regex harmless(R"re(//[^\n]*|(?:struct|class) \w+;|WINDLASS_FIELDS\([^)]*\)|\s+)re");
    return std::regex_replace(content, harmless, "").empty();
}

TEST(Layers, NamespacesFollowRooms) {
    std::vector<std::string> strangers;
    for (const std::string& file : sources()) {
        const Room* room = room_of(folder_of(file));
        if (room == nullptr || room->spaces.empty()) continue;
        for (const Space& space : spaces_of(file)) {
            const bool own = std::ranges::any_of(room->spaces, [&](const std::string& mine) {
                return space.name == mine || (mine != "windlass" && space.name.starts_with(mine + "::"));
            });
            if (!own && !only_names(space.content)) strangers.push_back(file + " opens " + space.name);
        }
    }
    EXPECT_THAT(strangers, testing::IsEmpty());
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
