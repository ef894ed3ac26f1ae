#include "station/gateway/orders.hpp"

#include "common/text.hpp"
#include "idl/cdr.hpp"
#include "idl/idl_text.hpp"
#include "station/lever_sender.hpp"
#include "words/words.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace windlass::gateway {

using idl::Kind;
using nlohmann::json;

namespace {

std::string shown(const json& value) {
    const std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
    return printable(text.size() > 64 ? std::string(clipped(text, 61)) + "..." : text);
}

/// A sample along its type in the IDL.
class Encoder {
public:
    Encoder(const wire::TopicInfo& topic, const Sender& sender) : topic_(topic), sender_(sender) {}

    Payload encode(const json& sample) {
        const auto* type = idl::own_schema().find(wire::type_name(topic_));
        if (type == nullptr) throw std::logic_error(std::string("no type of topic ") + topic_.name);
        structure(*type, sample, "");
        return out_.release();
    }

private:
    [[noreturn]] void refuse(const std::string& field, const json& value, const std::string& allowed) const {
        throw Refused(topic_.name, field, shown(value), allowed);
    }

    void structure(const idl::Type& type, const json& value, const std::string& where) {
        if (!value.is_null() && !value.is_object()) refuse(where, value, "an object of " + names(type));
        if (value.is_object())
            for (const auto& given : value.items())
                if (std::ranges::none_of(type.members, [&](const auto& m) {
                        return m.name == given.key() && !(where.empty() && given.key() == "origin");
                    }))
                    refuse(where + printable(clipped(given.key(), 64)), given.value(), names(type));
        static const json kLeftOut;
        for (const idl::Member& member : type.members) {
            const auto given = value.is_object() ? value.find(member.name) : value.end();
            const bool there = value.is_object() && given != value.end();
            if (there && given->is_null()) refuse(where + member.name, *given, "a value, or to be left out");
            const json& inside = there ? *given : kLeftOut;
            if (where.empty() && member.name == "origin")
                origin();
            else if (member.sequence)
                sequence(member, inside, where + member.name);
            else
                element(member, inside, where + member.name);
        }
    }

    /// "brake, speed_lever, ..."
    static std::string names(const idl::Type& type) {
        std::string text;
        for (const auto& member : type.members)
            if (member.name != "origin") text += (text.empty() ? "" : ", ") + member.name;
        return text;
    }

    void origin() {
        out_.text(sender_.source);
        out_.number(sender_.serial);
        out_.number(sender_.sent_unix_ns);
    }

    void sequence(const idl::Member& member, const json& value, const std::string& where) {
        if (member.type->kind == Kind::octet) {
            if (!value.is_null() && !value.is_string()) refuse(where, value, "text");
            const std::string text = value.is_null() ? "" : value.get<std::string>();
            if (text.size() > member.bound)
                refuse(where, value, fmt::format("{} bytes at most", member.bound));
            return out_.octets(text);
        }
        if (!value.is_null() && !value.is_array()) refuse(where, value, "a list");
        if (value.size() > member.bound)
            refuse(where, value, fmt::format("{} elements at most", member.bound));
        out_.number(static_cast<std::uint32_t>(value.size()));
        for (std::size_t i = 0; i < value.size(); ++i)
            element(member, value[i], fmt::format("{}[{}]", where, i));
    }

    /// Null: the element is left out.
    void element(const idl::Member& member, const json& value, const std::string& where) {
        switch (member.type->kind) {
        case Kind::structure:
            return structure(*member.type, value, where + ".");
        case Kind::enumeration:
            return enumerator(*member.type, value, where);
        case Kind::text:
            return text(member, value, where);
        default:
            idl::with_number_of(member.type->kind, [&](auto zero) { number<decltype(zero)>(value, where); });
        }
    }

    void enumerator(const idl::Type& type, const json& value, const std::string& where) {
        std::uint32_t index = 0;
        if (!value.is_null()) {
            const auto found = value.is_string()
                                   ? std::ranges::find(type.enumerators, value.get<std::string>())
                                   : type.enumerators.end();
            if (found == type.enumerators.end())
                refuse(where, value, fmt::format("{}", fmt::join(type.enumerators, ", ")));
            index = static_cast<std::uint32_t>(found - type.enumerators.begin());
        }
        out_.number(index);
    }

    void text(const idl::Member& member, const json& value, const std::string& where) {
        if (!value.is_null() && !value.is_string()) refuse(where, value, "text");
        const std::string text = value.is_null() ? "" : value.get<std::string>();
        if (member.text_bound != 0 && text.size() > member.text_bound)
            refuse(where, value, fmt::format("{} bytes of UTF-8 at most", member.text_bound));
        if (printable(text) != text) refuse(where, value, "text in UTF-8 without control characters");
        out_.text(text);
    }

    template <class Number>
    void number(const json& value, const std::string& where) {
        if constexpr (std::is_same_v<Number, bool>) {
            if (!value.is_null() && !value.is_boolean()) refuse(where, value, "true or false");
            out_.number(static_cast<std::uint8_t>(value.is_boolean() && value.get<bool>()));
        } else if constexpr (std::is_floating_point_v<Number>) {
            out_.number(real<Number>(value, where));
        } else {
            out_.number(whole<Number>(value, where));
        }
    }

    template <class Real>
    Real real(const json& value, const std::string& where) const {
        if (value.is_null()) return 0;
        const double number = value.is_number() ? value.get<double>() : std::nan("");
        if (!std::isfinite(number) || std::abs(number) > double(std::numeric_limits<Real>::max()))
            refuse(where, value, "a finite number");
        return static_cast<Real>(number);
    }

    template <class Whole>
    Whole whole(const json& value, const std::string& where) const {
        if (value.is_null()) return 0;
        if (value.is_number_unsigned()) {
            if (std::in_range<Whole>(value.get<std::uint64_t>()))
                return static_cast<Whole>(value.get<std::uint64_t>());
        } else if (value.is_number_integer() && std::in_range<Whole>(value.get<std::int64_t>())) {
            return static_cast<Whole>(value.get<std::int64_t>());
        }
        refuse(where, value,
               fmt::format("a whole number from {} to {}", std::numeric_limits<Whole>::min(),
                           std::numeric_limits<Whole>::max()));
    }

    const wire::TopicInfo& topic_;
    const Sender& sender_;
    idl::CdrWriter out_;
};

/// A set point of a lever: a number within its stops, or a switch (low above high).
struct SetPoint {
    const char* name;
    double low, high;
    const char* unit;
};

/// The set points of a message, each there and within its stops.
template <std::size_t N>
json set_points(const wire::TopicInfo& topic, const json& message, const std::array<SetPoint, N>& points) {
    json sample = json::object();
    for (const SetPoint& point : points) {
        const bool is_switch = point.low > point.high;
        const std::string allowed =
            is_switch ? "true or false" : fmt::format("{:g}..{:g}{}", point.low, point.high, point.unit);
        const auto found = message.find(point.name);
        if (found == message.end()) throw Refused(topic.name, point.name, "nothing", allowed);
        const bool good = is_switch ? found->is_boolean()
                                    : found->is_number() && found->template get<double>() >= point.low &&
                                          found->template get<double>() <= point.high;
        if (!good) throw Refused(topic.name, point.name, shown(*found), allowed);
        sample[point.name] = *found;
    }
    for (const auto& [name, value] : message.items())
        if (name != "op" && name != "side" && !sample.contains(name))
            throw Refused(topic.name, printable(clipped(name, 64)), shown(value), "no such lever");
    return sample;
}

} // namespace

Refused::Refused(std::string its_topic, std::string its_field, std::string its_value, std::string what_is)
    : std::runtime_error(its_field.empty()
                             ? fmt::format("{}{}{}", its_topic, its_topic.empty() ? "" : ": ", what_is)
                             : fmt::format("{}{}{}: {} is not allowed: {}", its_topic,
                                           its_topic.empty() ? "" : ".", its_field, its_value, what_is)),
      topic(std::move(its_topic)),
      field(std::move(its_field)),
      value(std::move(its_value)),
      allowed(std::move(what_is)) {}

Payload encode_order(const wire::TopicInfo& topic, const json& sample, const Sender& sender) {
    if (!sample.is_object()) throw Refused(topic.name, "sample", shown(sample), "an object");
    return Encoder(topic, sender).encode(sample);
}

json windlass_levers(const wire::TopicInfo& topic, const json& message) {
    const auto side = message.find("side");
    if (side == message.end() || (*side != 0 && *side != 1) || !side->is_number_integer())
        throw Refused(topic.name, "side", side == message.end() ? "nothing" : shown(*side),
                      "0 (port) or 1 (starboard)");
    static constexpr std::array<SetPoint, 5> kPoints{{{"brake", 0, 1, ""},
                                                      {"speed_lever", -1, 1, ""},
                                                      {"clutch_in", 1, 0, ""},
                                                      {"stopper_closed", 1, 0, ""},
                                                      {"emergency_stop", 1, 0, ""}}};
    json sample = set_points(topic, message, kPoints);
    sample["side"] = *side;
    return sample;
}

json helm_levers(const wire::TopicInfo& topic, const json& message) {
    static constexpr std::array<SetPoint, 4> kPoints{
        {{"engine", -1, 1, ""},
         {"rudder", -station::kRudderMax, station::kRudderMax, " rad"},
         {"bow_thruster", -1, 1, ""},
         {"stern_thruster", -1, 1, ""}}};
    return set_points(topic, message, kPoints);
}

} // namespace windlass::gateway
