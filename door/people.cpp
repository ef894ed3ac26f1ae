#include "door/people.hpp"

#include "common/text.hpp"
#include "door/denied.hpp"
#include "door/private_file.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <stdexcept>

namespace windlass::door {

using nlohmann::json;

std::optional<Rank> rank_named(const std::string& name) {
    const auto found = std::ranges::find(kRankNames, name);
    if (found == kRankNames.end()) return std::nullopt;
    return static_cast<Rank>(found - kRankNames.begin());
}

std::string plain_name(const std::string& typed) {
    const auto first = typed.find_first_not_of(' ');
    if (first == std::string::npos) return {};
    const std::string name = typed.substr(first, typed.find_last_not_of(' ') - first + 1);
    return name.size() <= 32 && printable(name) == name ? name : std::string();
}

People::People(std::filesystem::path file) : file_{std::move(file)} {
    if (!std::filesystem::exists(file_)) return;
    try {
        const json kept = json::parse(read_file(file_)); // outlives the loop, which only has a part of it
        for (const json& each : kept.at("people")) {
            Person person{.name = each.at("name"), .rank = Rank::observer, .hash = each.at("hash")};
            const auto rank = rank_named(each.at("rank"));
            if (!rank) throw std::runtime_error("no rank: " + each.at("rank").dump());
            person.rank = *rank;
            people_[person.name] = person;
        }
    } catch (const std::exception& error) {
        throw std::runtime_error(file_.string() + ": " + error.what());
    }
}

const Person* People::find(const std::string& name) const {
    const auto found = people_.find(name);
    return found == people_.end() ? nullptr : &found->second;
}

void People::put(Person person) {
    auto people = people_;
    people[person.name] = std::move(person);
    keep(std::move(people));
}

void People::remove(const std::string& name) {
    auto people = people_;
    people.erase(name);
    keep(std::move(people));
}

void People::keep(std::map<std::string, Person> people) {
    if (people.size() > kMost) throw Denied(409, "there are as many people as are kept");
    if (std::ranges::none_of(people, [](const auto& each) { return each.second.rank == Rank::owner; }))
        throw Denied(409, "one owner has to remain");
    json list = json::array();
    for (const auto& [name, person] : people)
        list.push_back({{"name", name}, {"rank", name_of(person.rank)}, {"hash", person.hash}});
    write_private(file_, json{{"people", std::move(list)}}.dump(1) + '\n');
    people_ = std::move(people);
}

} // namespace windlass::door
