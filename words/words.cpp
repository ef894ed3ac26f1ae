#include "words/words.hpp"

#include "embedded/words.hpp"

#include <cstdio>
#include <cstdlib>

namespace windlass::words {

namespace {

/// "3", "1.5": six figures at most, and no more than are needed.
std::string figure(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%g", value);
    return text.data();
}

/// A sentence with each {place} filled in.
template <class Fill>
std::string fill_in(std::string_view sentence, const Fill& fill) {
    std::string text;
    while (!sentence.empty()) {
        const std::size_t open = sentence.find('{');
        text += sentence.substr(0, open);
        if (open == std::string_view::npos) break;
        const std::size_t close = sentence.find('}', open);
        text += fill(sentence.substr(open + 1, close - open - 1));
        sentence.remove_prefix(close + 1);
    }
    return text;
}

/// "port anchor", "both anchors"; of neither: "anchor".
std::string noun(std::string_view place, int side, bool both) {
    const std::string one{place};
    if (side == 0) return "port " + one;
    if (side == 1) return "starboard " + one;
    if (!both) return one;
    return "both " + one + (one.ends_with('s') ? "es" : "s");
}

/// Fills in what orders and reports share.
std::string fill_thing(std::string_view place, int side, bool both) {
    if (place == "side") return side == 0 ? "port " : side == 1 ? "starboard " : "";
    return noun(place, side, both);
}

template <std::size_t N>
std::string said(const std::array<Named, N>& rows, std::size_t place) {
    return std::string(place < N ? rows[place].said : "");
}

void join(std::string& line, const std::string& part) {
    if (!part.empty()) line += (line.empty() ? "" : ", ") + part;
}

std::string or_else(std::string text, const char* otherwise) {
    return text.empty() ? otherwise : text;
}

} // namespace

std::string_view json_text() {
    return embedded::words;
}

std::string figure_text(double value, Unit unit) {
    const UnitWords& words = words_of(unit);
    const bool one = value == 1 && words.written == words.many;
    return figure(value) + ' ' + std::string(one ? words.one : words.written);
}

std::string fault_text(const Fault& fault) {
    return std::string(fault.symptom) + "; " + std::string(fault.reason) + "; " + std::string(fault.way_out);
}

std::string order_text(std::size_t code, int side, double value) {
    if (code >= kBridgeOrderCode.size()) return "";
    const Order& order = kBridgeOrderCode[code];
    const bool bare = value == 0 && !order.said_bare.empty();
    return fill_in(bare ? order.said_bare : order.said, [&](std::string_view place) {
        return place == "figure" ? figure_text(value, order.unit) : fill_thing(place, side, true);
    });
}

std::string order_with(std::string order, std::string_view added) {
    if (!order.ends_with('?') || added.empty()) {
        join(order, std::string(added));
        return order;
    }
    order += ' ';
    order += added;
    char& first = order[order.size() - added.size()];
    if (first >= 'a' && first <= 'z') first = static_cast<char>(first - 'a' + 'A');
    return order;
}

std::string report_text(const ReportSaid& report) {
    if (report.code >= kReportCode.size()) return std::string(report.text);
    const Report& row = kReportCode[report.code];
    const std::string hour = report.lead > 0 ? std::to_string(report.lead) + " o'clock" : "";
    const std::string stay = said(kStayGiven, report.stay);
    const std::string order = order_text(report.order_code, report.side, report.value);
    const auto has = [&](const char* place) { return row.said.find(place) != std::string_view::npos; };
    const bool own_words = has("{order}") && order.empty(); // the order had no others
    std::string line = fill_in(row.said, [&](std::string_view place) -> std::string {
        if (place == "figure") return figure_text(report.value, row.unit);
        if (place == "order") return own_words ? or_else(std::string(report.text), "the order") : order;
        if (place == "proposal") return order.empty() ? "" : ": I propose to " + order;
        if (place == "growing") return or_else(said(kGrowing, report.growing), "growing");
        if (place == "weight") return or_else(said(kCableWeight, report.weight), "weight");
        if (place != "lead") return fill_thing(place, report.side, false);
        std::string how = hour.empty() ? "" : "leading " + hour;
        join(how, stay);
        return or_else(how, "leading");
    });
    // What was given beside what the sentence has a place for.
    if (!has("{lead}")) join(line, hour), join(line, stay);
    if (!has("{growing}")) join(line, said(kGrowing, report.growing));
    if (!has("{weight}")) join(line, said(kCableWeight, report.weight));
    if (!own_words) join(line, std::string(report.text));
    return line;
}

std::string filled(std::string_view sentence, const std::vector<std::string>& parts) {
    return fill_in(sentence,
                   [&](std::string_view place) { return parts.at(std::stoul(std::string(place))); });
}

std::string event_text(const Event& event, double value) {
    return fill_in(event.said, [&](std::string_view place) {
        std::array<char, 32> text{};
        std::snprintf(text.data(), text.size(), "%.*f", std::atoi(std::string(place.substr(1)).c_str()),
                      value);
        return std::string(text.data());
    });
}

} // namespace windlass::words
