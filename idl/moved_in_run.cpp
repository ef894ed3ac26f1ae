#include "idl/moved_in_run.hpp"

#include "idl/participant.hpp"

#include <fastdds/dds/publisher/DataWriter.hpp>

#include <charconv>
#include <string_view>

namespace windlass::wire {

namespace {

constexpr std::string_view kMovedInRun = "moved_in_run=";

} // namespace

std::uint64_t moved_in_run_of(const std::vector<std::uint8_t>& user_data) {
    const std::string text(user_data.begin(), user_data.end());
    if (!text.starts_with(kMovedInRun)) return 0;
    std::uint64_t run = 0;
    const char* end = text.data() + text.size();
    const auto [read_until, error] = std::from_chars(text.data() + kMovedInRun.size(), end, run);
    return error == std::errc() && read_until == end ? run : 0;
}

void tell_moved_in_run(const Participant& participant, const WriterId& writer, std::uint64_t run) {
    std::vector<eprosima::fastdds::dds::DataWriter*> writers;
    participant.impl()->publisher->get_datawriters(writers);
    for (eprosima::fastdds::dds::DataWriter* candidate : writers) {
        if (writer_id(candidate->guid()) != writer) continue;
        auto qos = candidate->get_qos();
        if (moved_in_run_of(qos.user_data().getValue()) == run) return;
        const std::string text = std::string(kMovedInRun) + std::to_string(run);
        qos.user_data().setValue({text.begin(), text.end()});
        candidate->set_qos(qos);
    }
}

std::uint64_t told_moved_in_run(const Participant& participant, const WriterId& writer) {
    return participant.impl()->member->versions().exclusive_writers().moved_in_run(writer);
}

} // namespace windlass::wire
