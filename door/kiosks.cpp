#include "door/kiosks.hpp"

#include "door/private_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <stdexcept>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace windlass::door {

using nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// While it lives no other process changes the file.
class Alone {
public:
    explicit Alone(const fs::path& file) {
        const std::string lock = file.string() + ".lock";
        lock_ = ::open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
        if (lock_ < 0 || flock(lock_, LOCK_EX) != 0)
            throw std::runtime_error("cannot lock " + lock + ": " + std::strerror(errno));
    }
    ~Alone() { close(lock_); }
    Alone(const Alone&) = delete;
    Alone& operator=(const Alone&) = delete;

private:
    int lock_;
};

/// By which a file that was written anew differs: the clock of a file has steps of some ms.
std::array<std::int64_t, 4> mark_of(const fs::path& file) {
    struct stat now {};
    if (stat(file.c_str(), &now) != 0) return {};
    return {static_cast<std::int64_t>(now.st_ino), now.st_size, now.st_mtim.tv_sec, now.st_mtim.tv_nsec};
}

} // namespace

Kiosks::Kiosks(fs::path file) : file_{std::move(file)} {
    refresh();
}

std::map<std::string, Kiosk> Kiosks::kept() const {
    std::map<std::string, Kiosk> found;
    if (!fs::exists(file_)) return found;
    try {
        const json all = json::parse(read_file(file_)); // outlives the loop
        for (const json& each : all.at("kiosks")) {
            const auto place = place_named(each.at("place"));
            if (!place) throw std::runtime_error("no place: " + each.at("place").dump());
            found[each.at("name")] = {.name = each.at("name"),
                                      .exercise = each.at("exercise"),
                                      .place = *place,
                                      .invitation = each.at("invitation"),
                                      .key = each.at("key")};
        }
    } catch (const std::exception& error) {
        throw std::runtime_error(file_.string() + ": " + error.what());
    }
    return found;
}

void Kiosks::refresh() {
    const auto mark = mark_of(file_);
    if (mark == read_) return;
    take(kept());
    read_ = mark;
}

void Kiosks::take(std::map<std::string, Kiosk> kiosks) {
    std::swap(kiosks_, kiosks);
    for (const auto& [name, before] : kiosks)
        if (!before.key.empty() && with_key(before.key) == nullptr) revoked_.push_back(before.key);
}

std::vector<std::string> Kiosks::take_revoked() {
    return std::exchange(revoked_, {});
}

const Kiosk* Kiosks::with_key(const std::string& key) const {
    const auto found =
        std::ranges::find_if(kiosks_, [&](const auto& each) { return each.second.key == key; });
    return key.empty() || found == kiosks_.end() ? nullptr : &found->second;
}

template <class Change>
void Kiosks::change(Change change) {
    const Alone alone(file_);
    auto kiosks = kept();
    change(kiosks);
    json list = json::array();
    for (const auto& [name, each] : kiosks)
        list.push_back({{"name", name},
                        {"exercise", each.exercise},
                        {"place", name_of(each.place)},
                        {"invitation", each.invitation},
                        {"key", each.key}});
    write_private(file_, json{{"kiosks", std::move(list)}}.dump(1) + '\n');
    read_ = mark_of(file_);
    take(std::move(kiosks));
}

void Kiosks::put(Kiosk kiosk) {
    if (kiosk.exercise < 1 || kiosk.exercise > ClassBook::kExercises)
        throw Denied(400, fmt::format("exercise: 1 to {} are allowed", ClassBook::kExercises));
    change([&](auto& kiosks) {
        kiosks[kiosk.name] = kiosk;
        if (kiosks.size() > kMost) throw Denied(409, fmt::format("{} kiosks are kept: remove one", kMost));
    });
}

void Kiosks::remove(const std::string& name) {
    change([&](auto& kiosks) {
        if (kiosks.erase(name) == 0) throw Denied(404, "there is no kiosk of that name");
    });
}

Kiosk Kiosks::open(const std::string& invitation, const std::string& key) {
    Kiosk opened;
    change([&](auto& kiosks) {
        const auto found = std::ranges::find_if(
            kiosks, [&](const auto& each) { return each.second.invitation == invitation; });
        if (invitation.empty() || found == kiosks.end())
            throw Denied(403, "this address was opened before, or was taken back: ask the owner for another");
        found->second.invitation.clear();
        found->second.key = key;
        opened = found->second;
    });
    return opened;
}

std::string kiosk_address(const std::string& host, unsigned short port, const std::string& key) {
    return fmt::format("https://{}:{}/kiosk#key={}", host, port, key);
}

} // namespace windlass::door
