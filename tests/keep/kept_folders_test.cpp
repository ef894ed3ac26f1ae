// Where the exercises of several workers are kept, and who has them after a restart with more or fewer.

#include "server/keep/folder_lock.hpp"
#include "server/keep/kept_file.hpp"
#include "server/keep/kept_folders.hpp"

#include "tests/recorder/folder.hpp"

#include <gmock/gmock.h>

namespace windlass::keep {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

/// As if it had been kept there: what counts is that a file of it is there.
void kept(const std::filesystem::path& folder, unsigned worker, const std::string& id) {
    const auto place = folder_of(folder_of_worker(folder, worker), id);
    std::filesystem::create_directories(place);
    KeptWriter(place / "0000000001.kept");
}

TEST(KeptFolders, WhoHasAnExerciseGetsItBack) {
    const windlass::test::Folder folder;
    kept(folder.path(), 2, "a");
    kept(folder.path(), 1, "b");
    EXPECT_THAT(settle(folder.path(), 3), ElementsAre(Pair("a", 2), Pair("b", 1)));
    EXPECT_THAT(kept_in(folder_of_worker(folder.path(), 2)), ElementsAre("a"));
}

TEST(KeptFolders, OfFewerWorkersEachIsGivenToOneThatHasFewest) {
    const windlass::test::Folder folder;
    kept(folder.path(), 1, "a");
    kept(folder.path(), 3, "b");
    kept(folder.path(), 4, "c");
    kept(folder.path(), 0, "d"); // of a server that was one process
    EXPECT_THAT(settle(folder.path(), 2),
                ElementsAre(Pair("a", 1), Pair("b", 1), Pair("c", 2), Pair("d", 2)));
    EXPECT_THAT(kept_in(folder_of_worker(folder.path(), 1)), ElementsAre("a", "b"));
    EXPECT_THAT(kept_in(folder_of_worker(folder.path(), 2)), ElementsAre("c", "d"));
    EXPECT_THAT(kept_in(folder.path()), IsEmpty());
}

TEST(KeptFolders, OfOneProcessLieInTheFolderItself) {
    const windlass::test::Folder folder;
    kept(folder.path(), 1, "a");
    kept(folder.path(), 2, "b");
    EXPECT_THAT(settle(folder.path(), 0), ElementsAre(Pair("a", 0), Pair("b", 0)));
    EXPECT_THAT(kept_in(folder.path()), ElementsAre("a", "b"));
}

TEST(KeptFolders, WhereNothingWasKeptNothingIs) {
    const windlass::test::Folder folder;
    EXPECT_THAT(settle(folder.path() / "none", 2), IsEmpty());
    std::filesystem::create_directories(folder_of(folder_of_worker(folder.path(), 3), "ended"));
    EXPECT_THAT(settle(folder.path(), 2), IsEmpty());
}

TEST(KeptFolders, AreOneServersAlone) {
    const windlass::test::Folder folder;
    const FolderLock lock(folder.path());
    EXPECT_THROW(FolderLock(folder.path()), KeptError);
}

} // namespace
} // namespace windlass::keep
