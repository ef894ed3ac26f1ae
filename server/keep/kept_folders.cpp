#include "server/keep/kept_folders.hpp"

#include "server/keep/kept_exercise.hpp"

#include <algorithm>
#include <charconv>
#include <vector>

namespace windlass::keep {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kExercise = "exercise-"; // an exercise may be called ".." or "aside"
constexpr std::string_view kWorker = "worker-";

/// Numbers of the workers that have a folder there, and 0.
std::vector<unsigned> numbers_in(const fs::path& folder) {
    std::vector<unsigned> numbers{0};
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename();
        unsigned number = 0;
        if (name.starts_with(kWorker) &&
            std::from_chars(name.data() + kWorker.size(), name.data() + name.size(), number).ec ==
                std::errc() &&
            number > 0)
            numbers.push_back(number);
    }
    std::ranges::sort(numbers);
    return numbers;
}

} // namespace

fs::path folder_of(const fs::path& folder, const std::string& id) {
    return folder / (std::string(kExercise) + id);
}

fs::path folder_of_worker(const fs::path& folder, unsigned number) {
    return number == 0 ? folder : folder / (std::string(kWorker) + std::to_string(number));
}

std::vector<std::string> kept_in(const fs::path& folder) {
    std::vector<std::string> ids;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename();
        if (name.starts_with(kExercise) && !kept_files(entry.path()).empty())
            ids.push_back(name.substr(kExercise.size()));
    }
    std::ranges::sort(ids);
    return ids;
}

std::map<std::string, unsigned> settle(const fs::path& folder, unsigned workers) {
    std::map<std::string, unsigned> at; // by exercise, the worker that has it
    if (!fs::exists(folder)) return at;
    std::vector<std::pair<std::string, unsigned>> elsewhere;
    for (const unsigned number : numbers_in(folder))
        for (const std::string& id : kept_in(folder_of_worker(folder, number))) {
            const bool stays = workers == 0 ? number == 0 : number >= 1 && number <= workers;
            if (stays && !at.contains(id)) at[id] = number;
            if (!stays) elsewhere.emplace_back(id, number);
        }
    for (const auto& [id, number] : elsewhere) {
        if (at.contains(id)) continue; // it has been kept twice: what lies where nobody looks stays there
        std::map<unsigned, int> has;
        for (unsigned worker = std::min(1U, workers); worker <= workers; ++worker)
            has[worker] = 0;
        for (const auto& one : at)
            ++has[one.second];
        const unsigned to =
            std::ranges::min_element(has, {}, [](const auto& one) { return one.second; })->first;
        fs::create_directories(folder_of_worker(folder, to));
        const fs::path place = folder_of(folder_of_worker(folder, to), id);
        fs::remove_all(place); // without kept files in it
        fs::rename(folder_of(folder_of_worker(folder, number), id), place);
        at[id] = to;
    }
    return at;
}

} // namespace windlass::keep
