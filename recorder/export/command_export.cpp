// recorder export: a recording as tables, or as JSON lines.

#include "recorder/command.hpp"
#include "recorder/export/csv_text.hpp"
#include "recorder/export/types_of.hpp"
#include "recorder/recording/typed.hpp"

#include "idl/json_text.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <iostream>
#include <system_error>

namespace windlass::recorder {

namespace {

namespace fs = std::filesystem;
using recording::Message;
using recording::Recording;

struct ExportOptions {
    std::vector<fs::path> paths;
    std::string format = "csv";
    fs::path output;
    std::vector<std::string> topics;
    double from = 0;
    std::optional<double> until;
};

std::ofstream create(const fs::path& path) {
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    if (!file)
        throw std::runtime_error(path.string() +
                                 ": cannot make this file: " + std::generic_category().message(errno));
    return file;
}

std::string writer_of(const Message& message) {
    const auto writer = message.channel->metadata.find("writer");
    return writer == message.channel->metadata.end() ? "" : writer->second;
}

/// One file a topic.
class CsvFiles {
public:
    explicit CsvFiles(fs::path folder) : folder_(std::move(folder)) { fs::create_directories(folder_); }

    void add(const Message& message, const idl::Type& type, double at) {
        auto& file = files_[message.topic()];
        if (!file.is_open()) {
            file = create(folder_ / (message.topic() + ".csv"));
            file << "recorded (s),log_time (ns),publish_time (ns),writer,sequence";
            for (const auto& column : csv_columns(type))
                file << ',' << csv_cell(column);
            file << "\r\n";
        }
        line_ = fmt::format("{:.9f},{},{},{},{}", at, message.log_time, message.publish_time,
                            writer_of(message), message.sequence);
        append_csv(type, message.payload, line_);
        file << line_ << "\r\n";
    }

    void finish() {
        for (auto& [topic, file] : files_)
            if (!file.flush())
                throw std::runtime_error((folder_ / (topic + ".csv")).string() + ": cannot write");
        tell(fmt::format("{} files in {}", files_.size(), folder_.string()));
    }

private:
    fs::path folder_;
    std::map<std::string, std::ofstream> files_;
    std::string line_;
};

class JsonLines {
public:
    explicit JsonLines(const fs::path& path) : path_(path) {
        if (path != "-") file_ = create(path);
    }

    void add(const Message& message, const idl::Type& type, double at) {
        line_ = fmt::format(
            R"({{"topic":{},"recorded":{:.9f},"log_time":{},"publish_time":{},"writer":"{}","sequence":{},"message":)",
            idl::json_quoted(message.topic()), at, message.log_time, message.publish_time, writer_of(message),
            message.sequence);
        idl::JsonText visitor(line_);
        recording::walk(type, message.payload, visitor);
        if (!(out() << line_ << "}\n")) throw std::runtime_error(where() + ": cannot write");
    }

    void finish() {
        if (!out().flush()) throw std::runtime_error(where() + ": cannot write");
    }

private:
    std::ostream& out() { return file_.is_open() ? file_ : std::cout; }
    std::string where() const { return file_.is_open() ? path_.string() : "stdout"; }

    fs::path path_;
    std::ofstream file_;
    std::string line_;
};

/// Damaged messages are counted, told and left out.
template <class Output>
int write_out(const ExportOptions& options, Output output) {
    Recording recording(options.paths);
    const auto time = [&](double seconds) {
        return recording.start() + static_cast<recording::Nanoseconds>(seconds * 1e9);
    };
    recording::Query query{.topics = {options.topics.begin(), options.topics.end()},
                           .from = time(options.from)};
    if (options.until) query.until = time(*options.until);
    TypesOf types(recording);
    std::uint64_t left_out = 0;
    auto cursor = recording.messages(query);
    while (const auto message = cursor.next()) {
        try {
            const auto* type = types.find(*message->channel);
            if (type == nullptr) throw mcap::Damage("no type");
            output.add(*message, *type, static_cast<double>(message->log_time - recording.start()) * 1e-9);
        } catch (const mcap::Damage&) {
            ++left_out;
        }
    }
    output.finish();
    for (const auto& damage : recording.damage())
        tell(damage);
    if (left_out > 0) tell(fmt::format("{} messages could not be opened, and are left out", left_out));
    return recording.damage().empty() && left_out == 0 ? kOk : kDamaged;
}

int export_recording(const ExportOptions& options) {
    if (options.format == "csv")
        return write_out(options, CsvFiles(options.output.empty() ? fs::path("csv") : options.output));
    return write_out(options, JsonLines(options.output.empty() ? fs::path("-") : options.output));
}

} // namespace

void add_export(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<ExportOptions>();
    CLI::App& sub = *app.add_subcommand("export", "to CSV, one file a topic, or to JSON lines");
    sub.add_option("recording", options->paths, "folder of a recording, or its MCAP files")->required();
    sub.add_option("--format", options->format, "csv or jsonl")
        ->check(CLI::IsMember({"csv", "jsonl"}))
        ->capture_default_str();
    sub.add_option("--output", options->output,
                   "csv: the folder (default: csv); jsonl: the file, - is stdout (default: -)");
    sub.add_option("--topic", options->topics, "only these topics; may be given several times");
    sub.add_option("--from", options->from, "s from the recording's beginning")
        ->check(number_in(0, 1e9))
        ->capture_default_str();
    sub.add_option("--until", options->until, "s from the recording's beginning")->check(number_in(0, 1e9));
    sub.footer("Units stand in the header of a CSV file, and in windlass.idl, which the recording carries.\n"
               "Exit codes: 0 done, 1 failed, 2 bad option, 3 damaged: what could be read was exported.");
    sub.callback([&chosen, options] { chosen = [options] { return export_recording(*options); }; });
}

} // namespace windlass::recorder
