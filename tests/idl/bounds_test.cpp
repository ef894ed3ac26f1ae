// Every sequence of every type of the topic table, those inside other structures and sequences included: a
// payload whose sequence is as long as its bound passes, one that claims more does not.

#include "idl/bounds.hpp"
#include "idl/idl_text.hpp"
#include "idl/topic_types.hpp"
#include "idl/topics.hpp"

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstring>
#include <set>

namespace windlass::wire {
namespace {

using idl::Kind;
using idl::Type;
using Payload = std::vector<std::uint8_t>;

/// Where a sequence is in its type: names of members, "now.current_profile".
using Place = std::string;

void find_sequences(const Type& type, const Place& at, std::vector<std::pair<Place, std::uint64_t>>& found) {
    for (const auto& member : type.members) {
        const Place place = at.empty() ? member.name : at + "." + member.name;
        if (member.sequence) found.emplace_back(place, member.bound);
        if (member.type->kind == Kind::structure) find_sequences(*member.type, place, found);
    }
}

/// A payload made along the IDL, by hand and not by Fast CDR: so that a claim can stand in it that no sample
/// has. One sequence is as long as asked for; of the others, none is empty. Texts leave what follows at odd
/// places.
class Made {
public:
    Made(const Type& type, Place longest, std::uint32_t size, bool big_endian = false)
        : longest_(std::move(longest)), size_(size), big_endian_(big_endian) {
        structure(type, "");
        bytes.insert(bytes.begin(), {0, static_cast<std::uint8_t>(big_endian ? 0 : 1), 0, 0});
        length_at += 4;
    }

    Payload bytes;
    std::size_t length_at = 0; ///< where the length of that sequence stands (its first, in another sequence)

private:
    void align(std::size_t to) { bytes.resize((bytes.size() + to - 1) / to * to); }
    void number(std::uint64_t value, std::size_t size) {
        align(size);
        for (std::size_t i = 0; i < size; ++i)
            bytes.push_back(static_cast<std::uint8_t>(value >> 8 * (big_endian_ ? size - 1 - i : i)));
    }
    void structure(const Type& type, const Place& at) {
        for (const auto& member : type.members) {
            const Place place = at.empty() ? member.name : at + "." + member.name;
            if (!member.sequence) {
                value(*member.type, place);
                continue;
            }
            align(4);
            if (place == longest_ && length_at == 0) length_at = bytes.size();
            const std::uint32_t size = place == longest_ ? size_ : 1 + bytes.size() % 3 % member.bound;
            number(size, 4);
            for (std::uint32_t i = 0; i < size; ++i)
                value(*member.type, place);
        }
    }
    void value(const Type& type, const Place& place) {
        switch (type.kind) {
        case Kind::structure:
            return structure(type, place);
        case Kind::text: {
            const std::string text(1 + bytes.size() % 7, 'x');
            number(text.size() + 1, 4);
            bytes.insert(bytes.end(), text.c_str(), text.c_str() + text.size() + 1);
            return;
        }
        case Kind::boolean:
        case Kind::octet:
        case Kind::int8:
            return number(1, 1);
        case Kind::int16:
        case Kind::uint16:
            return number(1, 2);
        case Kind::int32:
        case Kind::uint32:
        case Kind::float32:
        case Kind::enumeration:
            return number(1, 4);
        case Kind::int64:
        case Kind::uint64:
        case Kind::float64:
            return number(0, 8);
        }
    }

    Place longest_;
    std::uint32_t size_;
    bool big_endian_;
};

template <class T>
T opened(Payload& bytes) {
    eprosima::fastcdr::FastBuffer buffer(reinterpret_cast<char*>(bytes.data()), bytes.size());
    eprosima::fastcdr::Cdr in(buffer, eprosima::fastcdr::Cdr::DEFAULT_ENDIAN,
                              eprosima::fastcdr::Cdr::DDS_CDR);
    in.read_encapsulation();
    T value;
    value.deserialize(in);
    return value;
}

template <class T>
Payload closed(const T& value) {
    Payload bytes(T::getCdrSerializedSize(value) + 8);
    eprosima::fastcdr::FastBuffer buffer(reinterpret_cast<char*>(bytes.data()), bytes.size());
    eprosima::fastcdr::Cdr out(buffer, eprosima::fastcdr::Cdr::DEFAULT_ENDIAN,
                               eprosima::fastcdr::Cdr::DDS_CDR);
    out.serialize_encapsulation();
    value.serialize(out);
    bytes.resize(out.getSerializedDataLength());
    return bytes;
}

std::string of(const char* type, const Place& place) {
    return std::string(type) + "." + place;
}

template <class T>
void expect_bounds_kept(const char* name) {
    const Type& type = *idl::own_schema().find(type_name(name));
    std::vector<std::pair<Place, std::uint64_t>> sequences;
    find_sequences(type, "", sequences);
    EXPECT_EQ(type.has_sequence, !sequences.empty()) << name;
    for (const auto& [place, long_bound] : sequences) {
        const auto bound = static_cast<std::uint32_t>(long_bound);
        ASSERT_GT(bound, 0U) << of(name, place);
        for (const bool big_endian : {false, true}) {
            EXPECT_TRUE(claims_within_bounds<T>(Made(type, place, bound, big_endian).bytes))
                << of(name, place);
            EXPECT_FALSE(claims_within_bounds<T>(Made(type, place, bound + 1, big_endian).bytes))
                << of(name, place);
        }
        // The payload is what the compiled type makes of it, too: it goes through it byte for byte, and what
        // is made of a sample that is too long is seen as such before it is sent.
        Made full(type, place, bound);
        EXPECT_EQ(closed(opened<T>(full.bytes)), full.bytes) << of(name, place);
        Made over(type, place, bound + 1);
        EXPECT_FALSE(claims_within_bounds<T>(closed(opened<T>(over.bytes)))) << of(name, place);

        // A claim with nothing behind it, and a payload that ends before the claim.
        Payload cut(full.bytes.begin(), full.bytes.begin() + static_cast<std::ptrdiff_t>(full.length_at) + 4);
        for (const std::uint32_t claim : {bound + 1, 0x7FFFFFFFU, 0xFFFFFFFFU}) {
            std::memcpy(&cut[full.length_at], &claim, 4);
            EXPECT_FALSE(claims_within_bounds<T>(cut)) << of(name, place) << " " << claim;
        }
        cut.resize(full.length_at + 3);
        EXPECT_FALSE(claims_within_bounds<T>(cut)) << of(name, place);
    }
}

#define WINDLASS_BOUNDS_TEST(T)                                                                              \
    TEST(Bounds, AreKeptOnBothSidesOf##T) {                                                                  \
        expect_bounds_kept<T>(#T);                                                                           \
    }
WINDLASS_TOPIC_TYPES(WINDLASS_BOUNDS_TEST)

TEST(Bounds, AreOfEverySequenceThatTheIdlHas) {
    std::set<std::string> types, covered;
    for (const auto& row : topics::all)
        types.insert(row.type);
    for (const auto& row : topics::classroom)
        types.insert(row.type);
    const auto in_text = [](std::string_view text) {
        std::size_t count = 0;
        for (auto at = text.find("\n  sequence<"); at != text.npos; at = text.find("\n  sequence<", at + 1))
            ++count;
        return count;
    };
    // By the structure that has it, not by the way to it.
    const std::function<void(const Type&)> collect = [&](const Type& type) {
        for (const auto& member : type.members) {
            if (member.sequence) covered.insert(type.name + "." + member.name);
            if (member.type->kind == Kind::structure) collect(*member.type);
        }
    };
    for (const auto& type : types)
        collect(*idl::own_schema().find(type_name(type)));
    EXPECT_EQ(covered.size(), in_text(idl::own_text()));
    EXPECT_GE(covered.size(), 20U);
}

TEST(Bounds, OfATypeInsideASequenceOfSequencesAreKept) {
    const idl::IdlSchema schema("struct A { string<9> name; sequence<double, 3> numbers; octet last; };\n"
                                "struct B { octet first; sequence<A, 2> all; sequence<octet, 5> rest; };");
    const Type& b = *schema.find("B");
    for (const auto& [place, bound] :
         std::vector<std::pair<Place, std::uint32_t>>{{"all", 2}, {"all.numbers", 3}, {"rest", 5}}) {
        EXPECT_TRUE(claims_within_bounds(b, Made(b, place, bound).bytes)) << place;
        EXPECT_TRUE(claims_within_bounds(b, Made(b, place, 0).bytes)) << place;
        EXPECT_FALSE(claims_within_bounds(b, Made(b, place, bound + 1).bytes)) << place;
    }
}

TEST(Bounds, OfGarbageAreLookedAtWithoutHarm) {
    Payload garbage;
    std::uint32_t state = 7;
    for (int i = 0; i < 300; ++i) {
        garbage.push_back(static_cast<std::uint8_t>((state = state * 1664525U + 1013904223U) >> 24));
        claims_within_bounds<OrderTaken>(garbage);
        claims_within_bounds<SceneDescription>(garbage);
        claims_within_bounds<ClassroomStatus>(garbage);
    }
    EXPECT_FALSE(claims_within_bounds<ChainState>({}));
    EXPECT_TRUE(claims_within_bounds<ShipState>({})) << "no sequence to look at: opening it finds out";
}

TEST(Bounds, OfAFullCableAreSeenInMicroseconds) {
    const Made full(*idl::own_schema().find(type_name("ChainState")), "nodes", 2048);
    constexpr int kTimes = 10'000;
    const auto begin = std::chrono::steady_clock::now();
    int fit = 0;
    for (int i = 0; i < kTimes; ++i)
        fit += claims_within_bounds<ChainState>(full.bytes) ? 1 : 0;
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    EXPECT_EQ(fit, kTimes);
    EXPECT_LT(took.count() / kTimes,
              20e-6); // some 1 us in a release build; 10 000 us are between two samples
}

} // namespace
} // namespace windlass::wire
