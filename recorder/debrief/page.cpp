#include "recorder/debrief/page.hpp"

#include "recorder/debrief/html.hpp"
#include "recorder/debrief/page_parts.hpp"
#include "recorder/debrief/page_style.hpp"
#include "station/format.hpp"

#include <fmt/format.h>

#include <regex>
#include <stdexcept>

namespace windlass::debrief {

namespace {

/// A name of a recording in an address: all but letters, digits, - _ . and ~ as %XX (RFC 3986).
std::string in_address(std::string_view text) {
    std::string address;
    for (const char c : text) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                           c == '-' || c == '_' || c == '.' || c == '~';
        if (plain)
            address += c;
        else
            address += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return address;
}

TensionLimits limits_of(const Attempt& attempt, const PageOptions& options) {
    std::vector<SceneAt> scenes = attempt.scenes;
    if (options.remedies)
        for (const Remedy& each : *options.remedies)
            for (const auto& scene : {each.was, each.would})
                if (scene) scenes.push_back(*scene);
    return tension_limits(scenes);
}

} // namespace

std::string Links::to(const std::string& recording, double position) const {
    if (kind == Kind::none) return {};
    std::string address = fmt::format("/replay?recording={}&t={:.1f}", in_address(recording), position);
    if (kind == Kind::beside) return address;
    address = station + address;
    return token.empty() ? address : address + "#token=" + token;
}

Links links_to(const std::string& address) {
    static const std::regex form(
        R"((https?://[A-Za-z0-9.\-]+(?::[0-9]+)?)(?:/[a-z]*)?(?:#token=([0-9a-f]+))?)");
    std::smatch parts;
    if (!std::regex_match(address, parts, form))
        throw std::runtime_error(address +
                                 " is no address of a station: http://HOST:PORT/instructor#token=... is, "
                                 "as instructor_console ui prints it");
    return {.kind = Links::Kind::station, .station = parts[1], .token = parts[2]};
}

std::string time_link(const PageContext& page, double time) {
    const std::string text = escaped(station::clock(time));
    const std::string to =
        page.options.links.to(page.attempt.origin.recording, page.attempt.position_of(time));
    return to.empty() ? text : fmt::format("<a href=\"{}\">{}</a>", escaped(to), text);
}

std::string timed_tables(const Attempt& attempt, std::string_view caption,
                         const std::vector<std::string>& columns, const std::vector<TimedRow>& rows) {
    std::vector<std::vector<Cell>> counted, later;
    for (const TimedRow& row : rows)
        (attempt.counts(row.time) ? counted : later).push_back(row.cells);
    std::string html = counted.empty() ? "" : table(caption, columns, counted);
    if (later.empty()) return html;
    html +=
        fmt::format("<h3>After the lesson&#39;s end, at {}</h3>\n", station::clock(attempt.counted_end()));
    return html + table(fmt::format("{}; it counts for nothing", caption), columns, later);
}

std::string page_of(const Attempt& attempt, const PageOptions& options) {
    const PageContext page{attempt, options, moments_of(attempt), limits_of(attempt, options)};
    const std::string title =
        fmt::format("Debrief: {}", attempt.title.empty() ? attempt.exercise : attempt.title);
    std::string html = fmt::format("<h1>{}</h1>\n", escaped(title));
    for (const auto part : {summary_part, result_part, moments_part, pictures_part, plots_part,
                            comparison_part, talk_part, events_part, ahead_part, origin_part})
        html += part(page);
    return document(fmt::format("{} ({})", title, attempt.origin.recording), html,
                    options.ghost ? kGhostStyle : std::string_view());
}

std::string waiting_page(const std::string& title, const std::string& words, bool again) {
    return document(title,
                    fmt::format("<h1>{}</h1>\n<p role=\"status\">{}</p>\n", escaped(title), escaped(words)),
                    {}, again ? "<meta http-equiv=\"refresh\" content=\"2\">\n" : "");
}

} // namespace windlass::debrief
