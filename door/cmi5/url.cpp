#include "door/cmi5/url.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>

namespace windlass::cmi5 {

namespace {

constexpr unsigned short kHttp = 80, kHttps = 443;

bool is_printable(const std::string& text) {
    return std::ranges::all_of(text, [](unsigned char c) { return c > ' ' && c < 0x7F; });
}

bool is_unreserved(unsigned char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '-' ||
           c == '.' || c == '_' || c == '~';
}

int digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

} // namespace

std::string Url::origin() const {
    const std::string name = host.find(':') == std::string::npos ? host : '[' + host + ']';
    const std::string scheme = tls ? "https" : "http";
    if (port == (tls ? kHttps : kHttp)) return fmt::format("{}://{}", scheme, name);
    return fmt::format("{}://{}:{}", scheme, name, port);
}

std::optional<Url> url_of(const std::string& text) {
    if (!is_printable(text) || text.find_first_of("\"<>\\^`{|}#") != std::string::npos) return std::nullopt;
    Url url;
    const auto scheme_end = text.find("://");
    if (scheme_end == std::string::npos) return std::nullopt;
    std::string scheme = text.substr(0, scheme_end);
    std::ranges::transform(scheme, scheme.begin(), [](unsigned char c) { return std::tolower(c); });
    if (scheme != "https" && scheme != "http") return std::nullopt;
    url.tls = scheme == "https";
    url.port = url.tls ? kHttps : kHttp;
    const auto begin = scheme_end + 3, end = std::min(text.find_first_of("/?", begin), text.size());
    std::string host = text.substr(begin, end - begin);
    const auto colon = host.rfind(':');
    if (colon != std::string::npos && host.find(']', colon) == std::string::npos) {
        const char *first = host.data() + colon + 1, *last = host.data() + host.size();
        const auto [read, error] = std::from_chars(first, last, url.port);
        if (error != std::errc{} || read != last || url.port == 0) return std::nullopt;
        host.erase(colon);
    }
    std::ranges::transform(host, host.begin(), [](unsigned char c) { return std::tolower(c); });
    const bool six = host.size() > 2 && host.front() == '[' && host.back() == ']';
    if (six) host = host.substr(1, host.size() - 2);
    const char* allowed = six ? "0123456789abcdef:." : "0123456789abcdefghijklmnopqrstuvwxyz.-_";
    if (host.empty() || host.find_first_not_of(allowed) != std::string::npos) return std::nullopt;
    url.host = host;
    url.target = text.substr(end);
    if (!url.target.starts_with('/')) url.target.insert(0, "/");
    return url;
}

std::string escaped(const std::string& text) {
    std::string made;
    for (const char c : text)
        made += is_unreserved(static_cast<unsigned char>(c))
                    ? std::string(1, c)
                    : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    return made;
}

std::string plain(const std::string& text) {
    std::string made;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const int high = text[i] == '%' && i + 2 < text.size() ? digit(text[i + 1]) : -1;
        const int low = high >= 0 ? digit(text[i + 2]) : -1;
        if (low >= 0) i += 2;
        made += low >= 0 ? static_cast<char>(16 * high + low) : text[i] == '+' ? ' ' : text[i];
    }
    return made;
}

LearningSystems::LearningSystems(const std::vector<std::string>& origins) {
    constexpr std::array kHere{"127.0.0.1", "localhost", "::1"};
    for (const std::string& each : origins) {
        const auto url = url_of(each);
        const bool origin = url && url->target == "/";
        const bool here = origin && std::ranges::find(kHere, url->host) != kHere.end();
        if (!origin || !(url->tls || here))
            throw std::runtime_error("learning system: " + each +
                                     ": https://HOST or https://HOST:PORT is allowed, and http of this "
                                     "computer (127.0.0.1, localhost)");
        origins_.push_back(url->origin());
    }
}

bool LearningSystems::allow(const Url& url) const {
    return std::ranges::find(origins_, url.origin()) != origins_.end();
}

std::string LearningSystems::told() const {
    return fmt::format("{}", fmt::join(origins_, ", "));
}

} // namespace windlass::cmi5
