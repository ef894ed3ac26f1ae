#include "station/gateway/assets.hpp"

#include <array>
#include <fstream>
#include <iterator>
#include <regex>
#include <stdexcept>

namespace windlass::gateway {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::array<const char*, 2>, 8> kTypes{{{".html", "text/html; charset=utf-8"},
                                                            {".js", "text/javascript; charset=utf-8"},
                                                            {".css", "text/css; charset=utf-8"},
                                                            {".svg", "image/svg+xml"},
                                                            {".png", "image/png"},
                                                            {".woff2", "font/woff2"},
                                                            {".json", "application/json"},
                                                            {".txt", "text/plain; charset=utf-8"}}};

/// Empty: of no kind that pages load.
std::string type_of(const fs::path& file) {
    for (const auto& [ending, type] : kTypes)
        if (file.extension() == ending) return type;
    return {};
}

std::string read(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw std::runtime_error("cannot read " + file.string());
    return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace

Assets::Assets(const fs::path& folder, const std::string& first_page) {
    static const std::regex hashed(R"(.*-[A-Z0-9]{8}\.[a-z0-9]+)"); // as the bundler names them
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const fs::path& file = entry->path();
        const std::string type = type_of(file);
        if (!entry->is_regular_file() || type.empty()) continue;
        const std::string name = file.lexically_relative(folder).generic_string();
        Asset asset{
            .content = read(file), .zipped = {}, .type = type, .immutable = std::regex_match(name, hashed)};
        if (const fs::path twin = file.string() + ".gz"; fs::exists(twin)) asset.zipped = read(twin);
        const bool page = file.extension() == ".html";
        files_.emplace('/' + (page ? name.substr(0, name.size() - 5) : name),
                       std::make_shared<const Asset>(std::move(asset)));
    }
    if (error)
        throw std::runtime_error("cannot read the pages in " + folder.string() + ": " + error.message());
    const auto first = files_.find('/' + first_page);
    if (first == files_.end())
        throw std::runtime_error("there is no page " + first_page + " in " + folder.string() +
                                 ": this program was built without npm, or without its pages (target "
                                 "station_pages)");
    files_.emplace("/", first->second);
    // Browsers ask for it by this name where nothing names the icon: beside a debriefing, a table, a text.
    if (const auto icon = files_.find("/favicon.svg"); icon != files_.end())
        files_.emplace("/favicon.ico", icon->second);
}

void Assets::add_page(const std::string& path, std::function<std::string()> content) {
    made_.insert_or_assign(path, std::move(content));
}

std::shared_ptr<const Asset> Assets::find(const std::string& path) const {
    if (const auto made = made_.find(path); made != made_.end())
        return std::make_shared<const Asset>(
            Asset{.content = made->second(), .zipped = {}, .type = type_of("a.html")});
    const auto found = files_.find(path);
    return found == files_.end() ? nullptr : found->second;
}

fs::path folder_of_pages() {
    return fs::read_symlink("/proc/self/exe").parent_path() / "web";
}

} // namespace windlass::gateway
