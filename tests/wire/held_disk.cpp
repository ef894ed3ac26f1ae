// A disk that takes nothing for as long as a test says: preloaded into a program, every call by which it
// makes, writes or waits for a file below $WINDLASS_HELD waits while there is a file hold in that folder.

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <climits>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

std::string_view held_folder() {
    static const char* const folder = std::getenv("WINDLASS_HELD");
    return folder == nullptr ? "" : folder;
}

void wait(std::string_view path) {
    const std::string_view folder = held_folder();
    if (folder.empty() || !path.starts_with(folder)) return;
    const std::string hold = std::string(folder) + "/hold";
    struct stat unused {};
    while (stat(hold.c_str(), &unused) == 0)
        usleep(1000);
}

void wait(int file) {
    char link[40], path[PATH_MAX];
    std::snprintf(link, sizeof link, "/proc/self/fd/%d", file);
    const ssize_t size = readlink(link, path, sizeof path);
    if (size > 0) wait(std::string_view(path, static_cast<std::size_t>(size)));
}

template <class Function>
Function* next(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

} // namespace

extern "C" {

ssize_t write(int file, const void* bytes, size_t count) {
    static auto* const real = next<ssize_t(int, const void*, size_t)>("write");
    wait(file);
    return real(file, bytes, count);
}

int fdatasync(int file) {
    static auto* const real = next<int(int)>("fdatasync");
    wait(file);
    return real(file);
}

int open(const char* path, int flags, ...) {
    static auto* const real = next<int(const char*, int, ...)>("open");
    va_list more;
    va_start(more, flags);
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(more, mode_t) : 0;
    va_end(more);
    if ((flags & O_ACCMODE) != O_RDONLY) wait(path);
    return real(path, flags, mode);
}
}
