#pragma once
// With what a file of a kept exercise begins.

#include "common/disk.hpp"
#include "server/run/resumption.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace windlass::keep {

/// Which exercise is kept there, of which course, and by which version of the server.
struct Beginning {
    std::string orders;                ///< name and hash of their type
    std::uint32_t format = 0;          ///< of its checkpoint
    std::string id;                    ///< of the exercise
    std::uint64_t definition_hash = 0; ///< of the definition that it was opened with
    run::KeptCourse course;
};

std::vector<std::uint8_t> encode(const Beginning& beginning);
/// Throws idl::PayloadError where the bytes are none.
Beginning decode_beginning(files::Bytes payload);

} // namespace windlass::keep
