#include "sim/disk.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace windlass::sim {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kPage = 4096; // bytes, that come to the disk together

bool is_below(const fs::path& path, const fs::path& folder) {
    return path.native().starts_with(folder.native() + "/");
}

} // namespace

/// A file that a server has open.
class SimDisk::File final : public files::File {
public:
    File(SimDisk& disk, std::shared_ptr<Node> node) : disk_(disk), node_(std::move(node)) {}
    std::size_t append(files::Bytes bytes) override {
        std::size_t taken = 0;
        disk_.write(*node_, bytes, taken);
        return taken;
    }
    void cut(std::uint64_t size) override {
        disk_.operation(true);
        node_->bytes.resize(size);
        node_->synced = std::min<std::size_t>(node_->synced, size);
    }
    void sync() override {
        disk_.operation(true);
        const auto synced = [node = node_, size = node_->bytes.size()] {
            node->synced = std::max(node->synced, std::min(size, node->bytes.size()));
        };
        disk_.wait(disk_.sync_takes);
        if (disk_.took)
            disk_.world_.at(disk_.world_.now() + *disk_.took, synced);
        else
            synced();
    }

private:
    SimDisk& disk_;
    std::shared_ptr<Node> node_;
};

/// Any call at which the server may be lost.
bool SimDisk::lost_now() {
    if (lost_) return true;
    ++operations_;
    lost_ = lost_at_ != 0 && operations_ >= lost_at_;
    return lost_;
}

void SimDisk::operation(bool writes) {
    if (lost_now()) throw Crash{lost_how_};
    if (writes && refuses) refuse(EIO);
}

void SimDisk::refuse(int error) {
    failed_ = true;
    ++errors_;
    throw std::system_error(error, std::generic_category());
}

void SimDisk::wait(double seconds) {
    if (took)
        *took += seconds;
    else if (served && seconds > 0)
        world_.run_until(world_.now() + seconds);
}

void SimDisk::write(Node& node, files::Bytes bytes, std::size_t& taken) {
    if (lost_) throw Crash{lost_how_};
    const bool lost = lost_now();
    std::size_t most = bytes.size();
    if (lost) most = chance_.below(most + 1); // in the midst of it
    if (!lost && refuses) refuse(EIO);
    const std::uint64_t used = this->bytes();
    most = std::min<std::uint64_t>(most, room > used ? room - used : 0);
    if (most == 0 && !bytes.empty() && !lost) refuse(ENOSPC);
    node.bytes.insert(node.bytes.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(most));
    node.written = ++writes_;
    taken = most;
    if (lost) throw Crash{lost_how_};
    wait(write_takes);
}

/// A change of folders; the disk has it with the next sync of a folder.
template <class Change>
void SimDisk::change(Change change) {
    operation(true);
    change(entries_);
    changes_.emplace_back(std::move(change));
}

std::uint64_t SimDisk::bytes() const {
    std::uint64_t sum = 0;
    for (const auto& [path, node] : entries_)
        sum += node->bytes.size();
    return sum;
}

std::uint64_t SimDisk::bytes_below(const fs::path& folder) const {
    std::uint64_t sum = 0;
    for (const auto& [path, node] : entries_)
        if (is_below(path, folder)) sum += node->bytes.size();
    return sum;
}

std::optional<files::Bytes> SimDisk::content(const fs::path& file) const {
    const auto found = entries_.find(file);
    if (found == entries_.end()) return std::nullopt;
    return files::Bytes(found->second->bytes);
}

void SimDisk::clear_away(const fs::path& path) {
    for (Entries* entries : {&entries_, &on_disk_})
        std::erase_if(*entries,
                      [&](const auto& entry) { return entry.first == path || is_below(entry.first, path); });
}

void SimDisk::lose_the_end(const std::string& ending, std::size_t bytes) {
    for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry) {
        auto& all = entry->second->bytes;
        if (!entry->first.native().ends_with(ending) || all.size() < bytes) continue;
        all.resize(all.size() - bytes);
        entry->second->synced = std::min(entry->second->synced, all.size());
        return;
    }
}

void SimDisk::lose(Loss how) {
    lost_ = served = false;
    lost_at_ = 0;
    if (how == Loss::power_cut) {
        const std::size_t have = chance_.below(changes_.size() + 1);
        for (std::size_t k = 0; k < have; ++k)
            changes_[k](on_disk_);
        for (auto& [path, node] : on_disk_) {
            auto& bytes = node->bytes;
            bytes.resize(node->synced + chance_.below(bytes.size() - node->synced + 1));
            for (std::size_t at = node->synced; at < bytes.size(); at = (at / kPage + 1) * kPage)
                if (chance_.in(0.3))
                    std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                              bytes.begin() + static_cast<std::ptrdiff_t>(
                                                  std::min(bytes.size(), (at / kPage + 1) * kPage)),
                              std::uint8_t{0});
        }
        entries_ = on_disk_;
        for (auto& [path, node] : entries_)
            node->synced = node->bytes.size();
        changes_.clear();
    }
}

bool SimDisk::rot(const std::string& ending) {
    for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry) {
        Node& node = *entry->second;
        if (node.synced == 0 || !entry->first.native().ends_with(ending)) continue;
        node.bytes[chance_.below(node.synced)] ^= 1U << chance_.below(8);
        return true;
    }
    return false;
}

std::unique_ptr<files::File> SimDisk::make(const fs::path& file, files::ReadBy) {
    if (entries_.contains(file)) refuse(EEXIST);
    const auto node = std::make_shared<Node>();
    change([file, node](Entries& entries) { entries[file] = node; });
    node->written = ++writes_;
    failed_ = false;
    return std::make_unique<File>(*this, node);
}

void SimDisk::append(const fs::path& file, files::Bytes bytes) {
    if (!entries_.contains(file)) {
        const auto node = std::make_shared<Node>();
        change([file, node](Entries& entries) { entries[file] = node; });
    }
    std::size_t taken = 0;
    write(*entries_.at(file), bytes, taken);
}

std::vector<std::uint8_t> SimDisk::read(const fs::path& file) {
    operation(false);
    const auto found = entries_.find(file);
    if (found == entries_.end()) refuse(ENOENT);
    return found->second->bytes;
}

bool SimDisk::exists(const fs::path& path) {
    return path == path.root_path() || entries_.contains(path);
}

std::vector<fs::path> SimDisk::list(const fs::path& folder) {
    std::vector<fs::path> paths;
    for (const auto& [path, node] : entries_)
        if (path.parent_path() == folder) paths.push_back(path);
    return paths;
}

fs::file_time_type SimDisk::written_at(const fs::path& path) {
    return fs::file_time_type(fs::file_time_type::duration(entries_.at(path)->written));
}

void SimDisk::make_folder(const fs::path& folder) {
    for (fs::path above; const fs::path& part : folder) {
        above /= part;
        if (entries_.contains(above)) continue;
        const auto node = std::make_shared<Node>(Node{.folder = true});
        node->written = ++writes_;
        change([above, node](Entries& entries) { entries[above] = node; });
    }
}

void SimDisk::rename(const fs::path& from, const fs::path& to) {
    if (!entries_.contains(from)) refuse(ENOENT);
    change([from, to](Entries& entries) {
        Entries moved;
        for (const auto& [path, node] : entries) {
            if (path == from)
                moved[to] = node;
            else if (is_below(path, from))
                moved[to.native() + path.native().substr(from.native().size())] = node;
            else
                moved[path] = node;
        }
        entries = std::move(moved);
    });
}

void SimDisk::remove(const fs::path& path) {
    if (!list(path).empty()) refuse(ENOTEMPTY);
    change([path](Entries& entries) { entries.erase(path); });
}

void SimDisk::remove_all(const fs::path& path) {
    change([path](Entries& entries) {
        std::erase_if(entries,
                      [&](const auto& entry) { return entry.first == path || is_below(entry.first, path); });
    });
}

void SimDisk::sync_folder(const fs::path&) {
    operation(false);
    for (const auto& change : changes_)
        change(on_disk_);
    changes_.clear();
}

} // namespace windlass::sim
