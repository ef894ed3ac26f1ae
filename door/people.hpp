#pragma once
// Who logs in with a password: instructors and those beside them.

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace windlass::door {

/// What somebody may do, the most first. Each but the owner's is a role of config/security/roles.txt; an
/// owner is an instructor who lets others in.
enum class Rank { owner, instructor, assessor, observer };
inline constexpr std::array kRankNames{"owner", "instructor", "assessor", "observer"};

inline const char* name_of(Rank rank) {
    return kRankNames.at(static_cast<std::size_t>(rank));
}
std::optional<Rank> rank_named(const std::string& name);

/// May make classes, move people and give orders.
inline bool leads(Rank rank) {
    return rank == Rank::owner || rank == Rank::instructor;
}

/// May say what an attempt comes to.
inline bool judges(Rank rank) {
    return leads(rank) || rank == Rank::assessor;
}

struct Person {
    std::string name;
    Rank rank = Rank::observer;
    std::string hash; ///< as password_hash()
};

/// Kept in a file. One thread.
class People {
public:
    static constexpr std::size_t kMost = 200;
    static constexpr std::size_t kPasswordLeast = 10, kPasswordMost = 128; ///< bytes

    /// Reads the file; where there is none, there is nobody. Throws std::runtime_error with file and what is
    /// wrong.
    explicit People(std::filesystem::path file);

    bool empty() const { return people_.empty(); }
    const Person* find(const std::string& name) const;
    const std::map<std::string, Person>& all() const { return people_; } ///< by name

    /// Adds somebody, or gives them another rank or password. Throws Denied when they are too many, or the
    /// last owner would be none any more, std::runtime_error when they cannot be kept.
    void put(Person person);
    void remove(const std::string& name); ///< the same

private:
    void keep(std::map<std::string, Person> people);

    const std::filesystem::path file_;
    std::map<std::string, Person> people_;
};

/// A name that people go by, as it is typed: 1 to 32 bytes without control characters, no blanks at the ends.
/// Empty: it is none.
std::string plain_name(const std::string& typed);

} // namespace windlass::door
