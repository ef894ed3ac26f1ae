#pragma once
// What a recording is written on: MCAP files in one folder, a new one when one is large enough.

#include "recorder/mcap/writer.hpp"
#include "recorder/record/exercise_files.hpp"
#include "recorder/record/sample_queue.hpp"

#include <memory>

namespace windlass::recorder {

struct TapeOptions {
    std::filesystem::path folder; ///< made if need be; must have no .mcap file in it yet
    mcap::Compression compression = mcap::Compression::zstd;
    std::uint64_t roll_size = 512ULL << 20; ///< bytes of a file, about, at which the next is begun
    mcap::Strings metadata{};               ///< of the recording, goes into each file
};

/// Throws mcap::WriteError when the system refuses to write; what was written before is safe, and close()
/// may still be tried.
class Tape {
public:
    explicit Tape(TapeOptions options, files::Disk& disk = files::system_disk());

    void write(const Sample& sample);
    /// Writes the open chunk: what came until now survives the end of this program.
    void flush();
    /// Keeps the files with the recording, in this file and in those that follow.
    void attach(std::vector<ExerciseFile> files);
    /// Ends the recording, and waits until the disk has it. The entries stand in the last file as metadata
    /// "windlass.closing".
    void close(const mcap::Strings& closing);
    /// Leaves nothing behind: neither its files nor the folders that it made, as far as the system lets them
    /// go. To be called last.
    void discard();

    std::uint64_t messages() const { return taken_ - lost(); } ///< in the files, the open chunk included
    std::uint64_t lost() const;                                ///< that could not be written
    std::uint64_t bytes() const;                               ///< on disk, of all files
    std::size_t files() const { return part_; }

private:
    using ChannelKey = std::pair<std::size_t, WriterId>;

    void begin_file();
    void end_file();
    void make_folder();
    void write_attachments();
    std::uint16_t schema_of(std::size_t topic);
    std::uint16_t channel_of(const Sample& sample);

    TapeOptions options_;
    files::Disk& disk_;
    std::unique_ptr<mcap::Writer> file_;
    std::vector<std::filesystem::path> made_; // files and folders, a folder behind what is in it
    std::size_t part_ = 0;                    // files begun
    std::map<std::size_t, std::uint16_t> schemas_;
    std::map<ChannelKey, std::uint16_t> channels_;
    std::vector<ExerciseFile> attachments_;
    std::size_t attachments_written_ = 0;
    std::uint64_t taken_ = 0, unplaced_ = 0, lost_before_ = 0, bytes_before_ = 0;
};

} // namespace windlass::recorder
