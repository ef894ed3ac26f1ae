#pragma once
// A folder for one server alone.

#include <filesystem>

namespace windlass::keep {

/// Has the folder to itself, by a lock on its file `lock`, for as long as it is there.
class FolderLock {
public:
    /// Makes the folder. Throws KeptError, saying what is wrong with it and who has it.
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock() { leave_to_parent(); }
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    /// In a process that was forked: the lock stays its parent's alone.
    void leave_to_parent();

private:
    int descriptor_;
};

} // namespace windlass::keep
