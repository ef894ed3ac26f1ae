#pragma once
// Devices that stand at one seat: a computer that always is the forecastle of the third exercise.

#include "door/class_book.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace windlass::door {

struct Kiosk {
    std::string name;            ///< of the device, under which it sits
    int exercise = 1;            ///< 1 .. ClassBook::kExercises: which of a class's
    Place place = Place::ship;   ///< there
    std::string invitation = {}; ///< digest of the key in its address; empty: a device has opened it
    std::string key = {};        ///< digest of the cookie of that device; empty: none yet
};

/// Kept in a file, which the door and its command line may both change. One thread of each.
class Kiosks {
public:
    static constexpr std::size_t kMost = 200;

    /// Reads the file; where there is none, there is no kiosk. Throws std::runtime_error with file and what
    /// is wrong.
    explicit Kiosks(std::filesystem::path file);

    const std::map<std::string, Kiosk>& all() const { return kiosks_; } ///< by name
    /// Whose device has that cookie, by its digest; nullptr: none's.
    const Kiosk* with_key(const std::string& key) const;

    /// Adds one, or gives one of that name another seat and address: its device is none any more. Throws
    /// Denied for an exercise that no class has and beyond kMost, std::runtime_error when it cannot be kept.
    void put(Kiosk kiosk);
    /// Throws Denied where there is none of that name, std::runtime_error.
    void remove(const std::string& name);
    /// A device has opened the address with that key, which is good once, and goes by a cookie from now on;
    /// both as digests. Throws Denied when no kiosk waits for it, std::runtime_error.
    Kiosk open(const std::string& invitation, const std::string& key);

    /// Reads the file again where somebody else has changed it. Throws std::runtime_error.
    void refresh();

    /// Keys that were good and are not any more, each once.
    std::vector<std::string> take_revoked();

private:
    template <class Change>
    void change(Change change);
    void take(std::map<std::string, Kiosk> kiosks);
    std::map<std::string, Kiosk> kept() const;

    const std::filesystem::path file_;
    std::map<std::string, Kiosk> kiosks_;
    std::array<std::int64_t, 4> read_{}; // by which the file that was read differs from another
    std::vector<std::string> revoked_;
};

/// What is typed to let a device in: https://HOST:PORT/kiosk#key=KEY.
std::string kiosk_address(const std::string& host, unsigned short port, const std::string& key);

} // namespace windlass::door
