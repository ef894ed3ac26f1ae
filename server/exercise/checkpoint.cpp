#include "server/exercise/checkpoint.hpp"

#include "common/text.hpp"
#include "server/exercise/definition/def_fields.hpp"
#include "server/exercise/state_hash.hpp"

#include <array>
#include <bit>
#include <cstdio>
#include <cstring>

namespace windlass::exercise {

using physics::ConstStateVisitor;
using physics::FieldName;
using physics::StateError;
using physics::StateVisitor;

namespace {

static_assert(std::endian::native == std::endian::little, "the layout is that of the memory");
constexpr std::array<char, 4> kMark{'W', 'L', 'C', 'P'};
constexpr std::size_t kMaxTackle = 2;
constexpr std::size_t kMaxConditions = 64;      // of a cable's pieces
constexpr std::size_t kMaxPoints = 128UL * 128; // of the ground's grid

class Writer final : public ConstStateVisitor {
public:
    std::vector<std::uint8_t> bytes;

    void raw(const void* from, std::size_t size) {
        if (size == 0) return;
        const std::size_t end = bytes.size();
        bytes.resize(end + size);
        std::memcpy(bytes.data() + end, from, size);
    }
    void number(const FieldName&, double value) override { raw(&value, sizeof value); }
    void integer(const FieldName&, std::int64_t value) override { raw(&value, sizeof value); }
    void numbers(const FieldName&, const double* first, std::size_t count) override {
        raw(first, count * sizeof *first);
    }
    void text(const FieldName&, const std::string& value) override {
        const std::uint64_t size = value.size();
        raw(&size, sizeof size);
        raw(value.data(), value.size());
    }
};

/// Reads what may come from anywhere: no number is out of all measure, every text fit for a log.
class StateReader final : public StateVisitor {
public:
    explicit StateReader(const std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}

    void raw(void* to, std::size_t size) {
        if (size > left()) throw CheckpointError("a checkpoint ends in the middle");
        if (size == 0) return;
        std::memcpy(to, bytes_.data() + at_, size);
        at_ += size;
    }
    std::size_t left() const { return bytes_.size() - at_; }
    /// Of the struct whose fields are being read: "port.tackle.".
    const std::string& path() const { return path_; }

    void number(const FieldName& name, double& value) override {
        raw(&value, sizeof value);
        within(name, value, -kMaxNumber, kMaxNumber);
    }
    void integer(const FieldName& name, std::int64_t& value) override {
        raw(&value, sizeof value);
        within(name, value, -kMaxInteger, kMaxInteger);
    }
    void numbers(const FieldName& name, double* first, std::size_t count) override {
        raw(first, count * sizeof *first);
        all_within(name, first, count, -kMaxNumber, kMaxNumber);
    }
    void text(const FieldName& name, std::string& value) override {
        std::uint64_t size = 0;
        raw(&size, sizeof size);
        within(name, size, 0, kMaxText);
        value.resize(size);
        raw(value.data(), size);
        if (printable(value) != value)
            throw StateError(name.text() + ": a text with control characters, or not in UTF-8");
    }
    void enter(const FieldName& name) override { path_ += name.text() + '.'; }
    void leave() override { path_.erase(path_.rfind('.', path_.size() - 2) + 1); }

private:
    /// Nothing that is measured in SI comes near it, and its square is a number still.
    static constexpr double kMaxNumber = 1e25;
    static constexpr std::int64_t kMaxInteger = 1LL << 53; // where a double still has every one
    const std::vector<std::uint8_t>& bytes_;
    std::size_t at_ = 0;
    std::string path_;
};

/// The fields of a definition as a state visitor meets them; names are those of the files.
template <class Visitor>
class DefinitionFields {
public:
    explicit DefinitionFields(Visitor& visitor) : v_(visitor) {}

    void number(const char* name, double& member) { v_.number({name}, member); }
    void degrees(const char* name, double& member) { v_.number({name}, member); } // in radians, as it is
    void hours(const char* name, double& member) { v_.number({name}, member); }   // in seconds, as it is
    void integer(const char* name, int& member) { v_.field({name}, member); }
    void flag(const char* name, bool& member) { v_.field({name}, member); }
    void text(const char* name, std::string& member) { v_.text({name}, member); }
    template <class Enum, class Names>
    void choice(const char* name, Enum& member, const Names& names) {
        auto place = static_cast<int>(member);
        v_.field({name}, place);
        v_.within({name}, place, 0, static_cast<int>(names.size()) - 1);
        member = static_cast<Enum>(place);
    }

private:
    Visitor& v_;
};

template <class Visitor>
void visit_ground(Visitor& v, physics::EnvironmentDef& environment) {
    bool laid = environment.ground != nullptr;
    v.field({"ground"}, laid);
    if (!laid) return;
    physics::GroundDef def = environment.ground ? environment.ground->def() : physics::GroundDef{};
    DefinitionFields fields(v);
    visit_fields(fields, def);
    v.field({"columns"}, def.columns);
    v.field({"rows"}, def.rows);
    v.length({"heights"}, def.heights, kMaxPoints);
    v.numbers({"heights"}, def.heights.data(), def.heights.size());
    v.length({"soils"}, def.soils, kMaxPoints);
    for (physics::Soil& soil : def.soils)
        v.field({"soil"}, soil);
    if (!environment.ground) lay_ground(environment, def);
}

/// Of a copy where it is only looked at: the lists of def_fields.hpp are for files, which fill it.
template <class Visitor>
void visit_definition(Visitor& v, ExerciseDef& def) {
    DefinitionFields fields(v);
    visit_fields(fields, def);
    visit_fields(fields, def.model);
    visit_fields(fields, def.environment);
    visit_ground(v, def.environment);
    v.fields_of(def.weather); // all of it, what files cannot say among it
    v.length({"tide"}, def.tide, kMaxTideRows);
    for (TideRow& row : def.tide)
        v.fields_of(row);
    visit_fitted(fields, def.seats);
    visit_aids(fields, def.seats);
    visit_fields(fields, def.ship);
    visit_fields(fields, def.ship_start);
    v.length({"tackle"}, def.tackle, kMaxTackle);
    for (GroundTackleDef& tackle : def.tackle) {
        visit_fields(fields, tackle);
        visit_fields(fields, tackle.windlass);
        visit_fields(fields, tackle.chain);
        visit_fields(fields, tackle.anchor);
        v.length({"condition"}, tackle.condition, kMaxConditions);
        for (physics::LinkCondition& condition : tackle.condition)
            visit_fields(fields, condition);
    }
    v.length({"faults"}, def.faults, 2 * kFaultCodes);
    for (FaultOrder& fault : def.faults)
        v.field({"fault"}, fault);
    v.text({"landmarks"}, def.landmarks);
    v.text({"lesson"}, def.lesson);
}

std::uint64_t hash_of(const Exercise& exercise) {
    StateHash hash;
    exercise.visit_state(hash);
    return hash.value();
}

/// Every field with its full name and its value as text that shows each bit.
class Listing final : public ConstStateVisitor {
public:
    struct Entry {
        std::string name, value;
    };
    std::vector<Entry> entries;

    void number(const FieldName& name, double value) override { add(name.text(), shown(value)); }
    void integer(const FieldName& name, std::int64_t value) override {
        add(name.text(), std::to_string(value));
    }
    void numbers(const FieldName& name, const double* first, std::size_t count) override {
        for (std::size_t i = 0; i < count; ++i)
            add(name.text() + '[' + std::to_string(i) + ']', shown(first[i]));
    }
    void text(const FieldName& name, const std::string& value) override {
        add(name.text(), '"' + value + '"');
    }
    void enter(const FieldName& name) override { path_.push_back(name.text() + '.'); }
    void leave() override { path_.pop_back(); }

private:
    static std::string shown(double value) {
        std::array<char, 40> buffer{};
        std::snprintf(buffer.data(), buffer.size(), "%.17g", value);
        return buffer.data();
    }
    void add(const std::string& name, std::string value) {
        std::string full;
        for (const std::string& part : path_)
            full += part;
        entries.push_back({full + name, std::move(value)});
    }
    std::vector<std::string> path_;
};

} // namespace

std::uint64_t definition_hash(ExerciseDef def) {
    StateHash hash;
    visit_definition(hash, def);
    return hash.value();
}

namespace {

/// All before the state.
void write_head(Writer& writer, ExerciseDef def) {
    writer.raw(kMark.data(), kMark.size());
    writer.raw(&kCheckpointFormat, sizeof kCheckpointFormat);
    visit_definition(writer, def);
    const std::uint64_t definition = definition_hash(def);
    writer.raw(&definition, sizeof definition);
}

/// The same. Throws CheckpointError; StateError.
ExerciseDef read_head(StateReader& reader) {
    std::array<char, 4> mark{};
    std::uint32_t format = 0;
    reader.raw(mark.data(), mark.size());
    reader.raw(&format, sizeof format);
    if (mark != kMark) throw CheckpointError("these bytes are no checkpoint");
    if (format != kCheckpointFormat) {
        throw CheckpointError("a checkpoint of format " + std::to_string(format) + "; this program reads " +
                              std::to_string(kCheckpointFormat));
    }
    ExerciseDef def;
    visit_definition(reader, def);
    std::uint64_t definition = 0;
    reader.raw(&definition, sizeof definition);
    if (definition != definition_hash(def))
        throw CheckpointError("a checkpoint is damaged: the hash of its definition differs");
    return def;
}

} // namespace

std::vector<std::uint8_t> write_checkpoint(const Exercise& exercise, const KeptBeside* beside) {
    Writer writer;
    write_head(writer, exercise.def());
    exercise.visit_state(writer);
    const std::uint64_t hash = hash_of(exercise);
    writer.raw(&hash, sizeof hash);
    if (beside != nullptr) beside->visit(writer);
    return std::move(writer.bytes);
}

std::vector<std::uint8_t> with_lesson(const std::vector<std::uint8_t>& checkpoint,
                                      const std::function<std::string(const std::string&)>& change) {
    StateReader reader(checkpoint);
    try {
        ExerciseDef def = read_head(reader);
        def.lesson = change(def.lesson);
        Writer writer;
        write_head(writer, def);
        writer.raw(checkpoint.data() + (checkpoint.size() - reader.left()), reader.left());
        return std::move(writer.bytes);
    } catch (const StateError& error) {
        throw CheckpointError("no checkpoint: " + reader.path() + error.what());
    }
}

Exercise read_checkpoint(const std::vector<std::uint8_t>& bytes,
                         const std::function<void(const ExerciseDef&)>& check, KeptBeside* beside) {
    StateReader reader(bytes);
    try {
        ExerciseDef def = read_head(reader);
        lay_out(def);
        if (check) check(def);
        Exercise exercise = Exercise::blank(def);
        exercise.visit_state(reader);
        std::uint64_t hash = 0;
        reader.raw(&hash, sizeof hash);
        if (beside != nullptr) {
            beside->begin(def);
            beside->visit(reader);
        }
        if (reader.left() > 0) throw CheckpointError("a checkpoint goes on behind its end");
        if (hash != hash_of(exercise)) throw CheckpointError("a checkpoint is damaged: its hash differs");
        // A hash sees values, and several bytes may say one: what it writes again must be what it was.
        if (write_checkpoint(exercise, beside) != bytes)
            throw CheckpointError("a checkpoint is damaged: other bytes would say the same");
        return exercise;
    } catch (const CheckpointError&) {
        throw;
    } catch (const StateError& error) {
        throw CheckpointError("a checkpoint of a state that no exercise comes to: " + reader.path() +
                              error.what());
    } catch (const std::exception& error) {
        throw CheckpointError(std::string("a checkpoint makes no exercise: ") + error.what());
    }
}

std::vector<StateDifference> differences(const Exercise& first, const Exercise& second, std::size_t max) {
    Listing one, other;
    first.visit_state(one);
    second.visit_state(other);
    std::vector<StateDifference> found;
    for (std::size_t i = 0; i < std::min(one.entries.size(), other.entries.size()) && found.size() < max;
         ++i) {
        const auto &a = one.entries[i], &b = other.entries[i];
        if (a.name == b.name && a.value == b.value) continue;
        found.push_back({a.name, a.value, a.name == b.name ? b.value : b.name + " = " + b.value});
        if (a.name != b.name) break; // from here on the lists do not run side by side
    }
    return found;
}

} // namespace windlass::exercise
