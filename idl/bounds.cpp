#include "idl/bounds.hpp"

#include "idl/idl_text.hpp"
#include "idl/topic_types.hpp"
#include "idl/topics.hpp"

#include <algorithm>
#include <stdexcept>

namespace windlass::wire {

using idl::Kind;
using idl::Type;

namespace {

constexpr std::size_t kHeader = 4; // CDR encapsulation

std::uint8_t bytes_of(Kind kind) {
    switch (kind) {
    case Kind::boolean:
    case Kind::octet:
    case Kind::int8:
        return 1;
    case Kind::int16:
    case Kind::uint16:
        return 2;
    case Kind::int32:
    case Kind::uint32:
    case Kind::float32:
    case Kind::enumeration:
        return 4;
    case Kind::int64:
    case Kind::uint64:
    case Kind::float64:
        return 8;
    case Kind::text:
    case Kind::structure:
        break;
    }
    throw std::logic_error("no number");
}

} // namespace

/// Where a walk over a payload is, and what it found.
class SequenceClaims::Walk {
public:
    explicit Walk(Bytes payload)
        : body_(payload.size() < kHeader ? Bytes() : payload.subspan(kHeader)),
          big_endian_(payload.size() > 1 && (payload[1] & 1U) == 0) {}

    /// False: something is too long, or the payload ends before a length.
    bool along(const Step* step, const Step* end) {
        while (step != end) {
            if (step->what == What::numbers) {
                pass(step->count, step->bytes);
            } else {
                std::uint32_t count = 0;
                if (!length(count)) return false;
                if (step->what == What::text)
                    pass(count, 1);
                else if (!sequence(*step, count))
                    return false;
            }
            step += 1 + step->body;
        }
        return true;
    }

private:
    void pass(std::uint64_t count, std::uint64_t bytes) {
        if (count > 0) at_ = (at_ + bytes - 1) / bytes * bytes + count * bytes;
    }

    bool sequence(const Step& step, std::uint32_t count) {
        if (count > step.bound) return false;
        pass(std::uint64_t{count} * step.count, step.bytes);
        for (std::uint32_t i = 0; step.body > 0 && i < count; ++i)
            if (!along(&step + 1, &step + 1 + step.body)) return false;
        return true;
    }

    bool length(std::uint32_t& value) {
        pass(1, 4);
        if (at_ > body_.size()) return false;
        for (std::uint64_t i = 0; i < 4; ++i)
            value = value << 8U | body_[at_ - (big_endian_ ? 4 - i : 1 + i)];
        return true;
    }

    Bytes body_;
    bool big_endian_;
    std::uint64_t at_ = 0;
};

/// Puts together the steps of a structure, or of one element of a sequence.
class SequenceClaims::Builder {
public:
    void add(const Type& type) {
        if (type.kind == Kind::structure) {
            for (const auto& member : type.members)
                member.sequence ? add_sequence(member) : add(*member.type);
        } else if (type.kind == Kind::text) {
            steps.push_back({.what = What::text});
        } else if (const auto bytes = bytes_of(type.kind); goes_on_with(bytes)) {
            ++steps.back().count;
        } else {
            steps.push_back({.what = What::numbers, .bytes = bytes, .count = 1});
        }
    }

    /// Behind the last sequence nothing needs a look, nor do its elements when no other sequence is in them.
    void leave_out_the_rest() {
        std::size_t last = steps.size();
        for (std::size_t at = 0; at < steps.size(); at += 1 + steps[at].body)
            if (steps[at].what == What::sequence) last = at;
        if (last == steps.size()) return steps.clear();
        const auto elements = steps.begin() + static_cast<std::ptrdiff_t>(last) + 1;
        const auto end = elements + steps[last].body;
        if (std::any_of(elements, end, [](const Step& step) { return step.what == What::sequence; })) {
            steps.erase(end, steps.end());
        } else {
            steps.erase(elements, steps.end());
            steps[last].body = steps[last].count = 0;
        }
    }

    std::vector<Step> steps;

private:
    /// A number of that size is one more of the run before it, which is not inside a sequence.
    bool goes_on_with(std::uint8_t bytes) const {
        return steps.size() > closed_ && steps.back().what == What::numbers && steps.back().bytes == bytes;
    }

    void add_sequence(const idl::Member& member) {
        if (member.bound == 0 || member.bound > 0xFFFFFFFFU)
            throw std::logic_error("the sequence " + member.name + " has no bound that can be kept");
        Step sequence{.what = What::sequence, .bound = static_cast<std::uint32_t>(member.bound)};
        Builder element;
        element.add(*member.type);
        if (element.steps.size() == 1 && element.steps[0].what == What::numbers) {
            sequence.bytes = element.steps[0].bytes; // and so all elements together are one run of numbers
            sequence.count = element.steps[0].count;
            element.steps.clear();
        }
        sequence.body = static_cast<std::uint32_t>(element.steps.size());
        steps.push_back(sequence);
        steps.insert(steps.end(), element.steps.begin(), element.steps.end());
        closed_ = steps.size();
    }

    std::size_t closed_ = 0; // steps up to here are done with
};

SequenceClaims::SequenceClaims(const Type& type) {
    Builder builder;
    builder.add(type);
    builder.leave_out_the_rest();
    steps_ = std::move(builder.steps);
}

bool SequenceClaims::fit(Bytes payload) const {
    return Walk(payload).along(steps_.data(), steps_.data() + steps_.size());
}

// Every type of the topic table, made once at its first sample.
#define WINDLASS_CLAIMS_OF_TYPE(T)                                                                           \
    template <>                                                                                              \
    bool claims_within_bounds<T>(Bytes payload) {                                                            \
        static const SequenceClaims claims(*idl::own_schema().find(type_name(#T)));                          \
        return claims.fit(payload);                                                                          \
    }
WINDLASS_TOPIC_TYPES(WINDLASS_CLAIMS_OF_TYPE)
#undef WINDLASS_CLAIMS_OF_TYPE

} // namespace windlass::wire
