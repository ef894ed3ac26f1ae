#pragma once
// Checkpoints as somebody outside may forge them: fields of a real state changed, and the hash that belongs
// to it.

#include "server/exercise/checkpoint.hpp"
#include "server/exercise/state_hash.hpp"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace windlass::exercise {

using physics::FieldName;

/// What is put in place of a field: the one or the other, by its type.
struct Hostile {
    double number = 0;
    std::int64_t integer = 0;
};

/// How the numbers of a list are changed.
enum class Spread {
    one,       ///< the one in the middle of the list
    all,       ///< all alike
    alternate, ///< to and fro: what a cable bears worst
};

/// A field of a state, by its place in the list of all, and what is put there: in place of what stands there,
/// or added to it.
struct Change {
    int field = 0;
    Hostile hostile;
    bool added = false;
    Spread spread = Spread::one;
};
using Changes = std::vector<Change>;

/// Writes a state as a checkpoint does, hash and all, but for the fields that it changes.
class Forger final : public physics::ConstStateVisitor {
public:
    explicit Forger(Changes changes) : changes_(std::move(changes)) {}

    void number(const FieldName& name, double value) override {
        const Change* change = met(name);
        const double put = change != nullptr ? change->hostile.number + (change->added ? value : 0) : value;
        append(&put, sizeof put);
        hash_.number(name, put);
    }
    void integer(const FieldName& name, std::int64_t value) override {
        const Change* change = met(name);
        const std::int64_t put =
            change != nullptr ? change->hostile.integer + (change->added ? value : 0) : value;
        append(&put, sizeof put);
        hash_.integer(name, put);
    }
    void numbers(const FieldName& name, const double* first, std::size_t count) override {
        std::vector<double> put(first, first + count);
        if (const Change* change = met(name); change != nullptr && count > 0) {
            const bool one = change->spread == Spread::one;
            for (std::size_t i = one ? count / 2 : 0; i < (one ? count / 2 + 1 : count); ++i) {
                const bool back = change->spread == Spread::alternate && i % 2 != 0;
                const double number = back ? -change->hostile.number : change->hostile.number;
                put[i] = number + (change->added ? put[i] : 0);
            }
        }
        append(put.data(), count * sizeof *first);
        hash_.numbers(name, put.data(), count);
    }
    void text(const FieldName& name, const std::string& value) override {
        const std::string put = met(name) != nullptr ? "\x1b[2J" : value;
        const std::uint64_t size = put.size();
        append(&size, sizeof size);
        append(put.data(), put.size());
        hash_.text(name, put);
    }
    void enter(const FieldName& name) override { path_.push_back(name.text() + '.'); }
    void leave() override { path_.pop_back(); }

    /// The full names of all fields, in their order: "port.tackle.chain.position_x".
    const std::vector<std::string>& names() const { return names_; }
    std::vector<std::uint8_t> bytes() const {
        std::vector<std::uint8_t> all = bytes_;
        const std::uint64_t hash = hash_.value();
        const auto* from = reinterpret_cast<const std::uint8_t*>(&hash);
        all.insert(all.end(), from, from + sizeof hash);
        return all;
    }

private:
    const Change* met(const FieldName& name) {
        const auto field = static_cast<int>(names_.size());
        std::string full;
        for (const std::string& part : path_)
            full += part;
        names_.push_back(full + name.text());
        const auto found =
            std::ranges::find_if(changes_, [&](const Change& change) { return change.field == field; });
        return found == changes_.end() ? nullptr : &*found;
    }
    void append(const void* from, std::size_t size) {
        const auto* first = static_cast<const std::uint8_t*>(from);
        bytes_.insert(bytes_.end(), first, first + size);
    }

    Changes changes_;
    StateHash hash_;
    std::vector<std::uint8_t> bytes_;
    std::vector<std::string> path_, names_;
};

/// An exercise whose states are forged.
class ForgedState {
public:
    explicit ForgedState(const Exercise& source) : source_(source), honest_(write_checkpoint(source)) {
        Forger copy({});
        source.visit_state(copy);
        names_ = copy.names();
        head_ = static_cast<std::ptrdiff_t>(honest_.size() - copy.bytes().size()); // the definition
    }

    const Exercise& source() const { return source_; }
    const std::vector<std::uint8_t>& honest() const { return honest_; }
    const std::vector<std::string>& names() const { return names_; } ///< of its fields
    int fields() const { return static_cast<int>(names_.size()); }

    /// Throws std::out_of_range when no field has that name.
    int field(const std::string& name) const {
        const auto found = std::ranges::find(names_, name);
        if (found == names_.end()) throw std::out_of_range(name + ": no such field");
        return static_cast<int>(found - names_.begin());
    }
    std::vector<std::uint8_t> checkpoint(const Changes& changes) const {
        Forger forger(changes);
        source_.visit_state(forger);
        std::vector<std::uint8_t> bytes(honest_.begin(), honest_.begin() + head_);
        const std::vector<std::uint8_t> state = forger.bytes();
        bytes.insert(bytes.end(), state.begin(), state.end());
        return bytes;
    }
    /// "ship.heave = 1e+300 or 2, chain.position_x += 0.5 or 1 (all), ..."
    std::string words(const Changes& changes) const {
        std::string text;
        for (const auto& [field, hostile, added, spread] : changes) {
            char put[80];
            std::snprintf(put, sizeof put, " %s %g or %lld%s", added ? "+=" : "=", hostile.number,
                          static_cast<long long>(hostile.integer),
                          spread == Spread::one   ? ""
                          : spread == Spread::all ? " (all)"
                                                  : " (alternate)");
            text += (text.empty() ? "" : ", ") + names_[static_cast<std::size_t>(field)] + put;
        }
        return text;
    }

private:
    const Exercise& source_;
    std::vector<std::uint8_t> honest_;
    std::vector<std::string> names_;
    std::ptrdiff_t head_ = 0;
};

} // namespace windlass::exercise
