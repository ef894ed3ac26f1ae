#pragma once
// Orders of a page: the JSON of a command's sample into the CDR that goes over the wire, or why not. Pure.

#include "idl/topics.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace windlass::gateway {

using Payload = std::vector<std::uint8_t>;

/// An order that nobody would take: thrown by what reads it. what() is a line for people.
struct Refused : std::runtime_error {
    Refused(std::string topic, std::string field, std::string value, std::string allowed);

    std::string topic; ///< empty: of no topic
    std::string field; ///< by its IDL name, with those around it: "weather.wind_speed"
    std::string value; ///< as it came, cut to 64 characters
    std::string allowed;
    bool again = false; ///< nobody hears it yet: the same may be taken in a moment
};

/// The fields of Origin.
struct Sender {
    std::string source;
    std::uint64_t serial = 0;
    std::int64_t sent_unix_ns = 0;
};

/// The payload (CDR header and CDR, as a writer of this host sends it) of one sample of the topic's type, as
/// the IDL has it: fields by name, enumerators by name, a sequence of octets as text; what is left out is 0,
/// false, empty or the first enumerator. `origin` is the sender's and must not be in the sample. Ranges are
/// the server's business; what has no place in the type is not: throws Refused for an unknown field, another
/// type, a number that the type has not, an unknown enumerator, text with control characters or not UTF-8,
/// what is longer than its bound.
Payload encode_order(const wire::TopicInfo& topic, const nlohmann::json& sample, const Sender& sender);

/// A sample of one of the lever topics, as encode_order takes it, of a message of a page: set points, whole,
/// each within its range. Units and signs as in WindlassCommand and HelmCommand. Throws Refused.
nlohmann::json windlass_levers(const wire::TopicInfo& topic, const nlohmann::json& message);
nlohmann::json helm_levers(const wire::TopicInfo& topic, const nlohmann::json& message);

} // namespace windlass::gateway
