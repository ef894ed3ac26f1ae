#pragma once
// Visitors of def_fields.hpp that read and write JSON.

#include "server/physics/base/units.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

namespace windlass::config {

inline constexpr double kHour = 3600; ///< s

/// Flags as a list of the names of those that are set: one that does not stand in it is not.
class NamesReader {
public:
    explicit NamesReader(const nlohmann::json& list) : list_(list) {}
    void flag(const char* name, bool& member) const {
        member = std::find(list_.begin(), list_.end(), name) != list_.end();
    }

private:
    const nlohmann::json& list_;
};

class NamesWriter {
public:
    explicit NamesWriter(nlohmann::json& list) : list_(list) {}
    void flag(const char* name, bool member) {
        if (member) list_.push_back(name);
    }

private:
    nlohmann::json& list_;
};

/// Lays what an object gives over the members; what it does not give stays.
class FieldReader {
public:
    explicit FieldReader(const nlohmann::json& object) : object_(object) {}

    void number(const char* name, double& member) const { read(name, member); }
    void integer(const char* name, int& member) const { read(name, member); }
    void flag(const char* name, bool& member) const { read(name, member); }
    void text(const char* name, std::string& member) const { read(name, member); }
    void degrees(const char* name, double& member) const {
        if (object_.contains(name)) member = physics::radians_from_degrees(object_.at(name).get<double>());
    }
    void hours(const char* name, double& member) const {
        if (object_.contains(name)) member = kHour * object_.at(name).get<double>();
    }
    template <class Enum, class Names>
    void choice(const char* name, Enum& member, const Names& names) const {
        if (object_.contains(name))
            member = Enum(std::find(names.begin(), names.end(), object_.at(name).get<std::string>()) -
                          names.begin());
    }

private:
    template <class T>
    void read(const char* name, T& member) const {
        if (object_.contains(name)) object_.at(name).get_to(member);
    }
    const nlohmann::json& object_;
};

class FieldWriter {
public:
    explicit FieldWriter(nlohmann::json& object) : object_(object) {}

    void number(const char* name, double member) { object_[name] = member; }
    void integer(const char* name, int member) { object_[name] = member; }
    void flag(const char* name, bool member) { object_[name] = member; }
    void text(const char* name, const std::string& member) { object_[name] = member; }
    void degrees(const char* name, double member) { object_[name] = physics::degrees_from_radians(member); }
    void hours(const char* name, double member) { object_[name] = member / kHour; }
    template <class Enum, class Names>
    void choice(const char* name, Enum member, const Names& names) {
        object_[name] = names.at(std::size_t(member));
    }

private:
    nlohmann::json& object_;
};

} // namespace windlass::config
