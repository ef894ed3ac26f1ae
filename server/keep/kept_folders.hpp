#pragma once
// Where the exercises of a server lie that is several processes: each worker has a folder of its own.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace windlass::keep {

/// The folder of an exercise, in that of its server.
std::filesystem::path folder_of(const std::filesystem::path& folder, const std::string& id);

/// Names of the exercises that are kept in the folder of a server.
std::vector<std::string> kept_in(const std::filesystem::path& folder);

/// The folder of worker 1, 2, ... of a server that keeps its exercises in `folder`; 0: of a server that is
/// one process, the folder itself.
std::filesystem::path folder_of_worker(const std::filesystem::path& folder, unsigned number);

/// Gives what is kept of each exercise to a worker, and says which, by exercise: to the one that has it
/// already, else to one that has fewest. workers: 0, all of it goes to a server that is one process. Of a
/// folder that is not there nothing is kept. While nobody else uses the folder. Throws
/// std::filesystem::filesystem_error.
std::map<std::string, unsigned> settle(const std::filesystem::path& folder, unsigned workers);

} // namespace windlass::keep
