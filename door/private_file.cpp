#include "door/private_file.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <sys/stat.h>
#include <unistd.h>

namespace windlass::door {

namespace fs = std::filesystem;

void private_folder(const fs::path& folder) {
    fs::create_directories(folder.parent_path().empty() ? "." : folder.parent_path());
    if (mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST)
        throw std::runtime_error("cannot make " + folder.string() + ": " + std::strerror(errno));
    const auto mode = fs::status(folder).permissions();
    if ((mode & (fs::perms::group_all | fs::perms::others_all)) != fs::perms::none)
        throw std::runtime_error(folder.string() + ": others may read it; allowed is mode 0700 (chmod 700)");
}

void write_private(const fs::path& file, const std::string& text) {
    const fs::path made = file.string() + ".new";
    const auto fail = [&file](const char* what) {
        throw std::runtime_error(std::string("cannot ") + what + ' ' + file.string() + ": " +
                                 std::strerror(errno));
    };
    fs::remove(made);
    const int to = open(made.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (to < 0) fail("write");
    const bool whole =
        write(to, text.data(), text.size()) == static_cast<ssize_t>(text.size()) && fsync(to) == 0;
    close(to);
    if (!whole) fail("write");
    if (rename(made.c_str(), file.c_str()) != 0) fail("replace");
}

std::string read_file(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw std::runtime_error("cannot read " + file.string());
    return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace windlass::door
