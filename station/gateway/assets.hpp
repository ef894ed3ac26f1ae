#pragma once
// The pages: every file of a folder, read once at the start, by the path under which it is asked for.

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>

namespace windlass::gateway {

struct Asset {
    std::string content;
    std::string zipped;     ///< gzip; empty: gains nothing by it
    std::string type;       ///< MIME
    bool immutable = false; ///< its name has a hash of its content
};

class Assets {
public:
    /// "/forecastle" for forecastle.html, "/" for the page of that name, "/assets/kit.css" ...,
    /// "/favicon.ico" for favicon.svg; FILE.gz is the twin of FILE. Files of kinds that pages do not load are
    /// left out. Throws std::runtime_error when the folder cannot be read or has no such page: the stations
    /// were built without their pages.
    Assets(const std::filesystem::path& folder, const std::string& first_page);

    /// One more, which is in no folder: an HTML page at that path, made anew each time that it is asked for.
    void add_page(const std::string& path, std::function<std::string()> content);

    /// nullptr: there is none of exactly that path. Whoever has it may go on sending it after it was
    /// replaced.
    std::shared_ptr<const Asset> find(const std::string& path) const;

private:
    std::map<std::string, std::shared_ptr<const Asset>> files_;
    std::map<std::string, std::function<std::string()>> made_;
};

/// The folder "web" beside the program that runs.
std::filesystem::path folder_of_pages();

} // namespace windlass::gateway
