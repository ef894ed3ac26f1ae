#pragma once
// The recorder program at work for an instructor: a process for each dozen of exercises.

#include "station/gateway/recorder_process.hpp"

#include <memory>
#include <set>

namespace windlass::gateway {

class Recorders {
public:
    /// program: `recorder`; arguments: of its record-many.
    Recorders(std::filesystem::path program, std::vector<std::string> arguments);

    /// Records that exercise, which is not recorded yet, into a folder. Throws std::runtime_error when no
    /// recorder can be started.
    void begin(const std::string& exercise, const std::filesystem::path& folder);
    /// Asks for its end; it has ended once ended() tells.
    void end(const std::string& exercise);

    struct Ended {
        std::string exercise;
        bool with_its_process = false; ///< lost, with all that this process recorded
    };
    /// Those whose recording has ended since this was asked last.
    std::vector<Ended> ended();

private:
    /// One for all would lose all with it; one for each is a member of the domain more, which every other one
    /// has to find (bench/README.md, bench_door).
    static constexpr std::size_t kExercisesEach = 12;

    struct Recorder {
        explicit Recorder(std::unique_ptr<RecorderProcess> started) : process(std::move(started)) {}
        std::unique_ptr<RecorderProcess> process;
        std::set<std::string> exercises = {};
        bool leaving = false; ///< has none left, and is asked to end
    };

    std::filesystem::path program_;
    std::vector<std::string> arguments_;
    std::vector<Recorder> all_;
};

} // namespace windlass::gateway
