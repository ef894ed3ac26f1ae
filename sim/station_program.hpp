#pragma once
// A station's program as pages have it, on the simulated network: the gateway's own sessions, topics as they
// are heard, and lever desk. What feed.cpp, exercise_desk.cpp and gateway.cpp do beside DDS is written again.

#include "sim/network.hpp"
#include "sim/page_checks.hpp"
#include "station/gateway/heard_topic.hpp"
#include "station/gateway/page_session.hpp"

#include <set>

namespace windlass::sim {

class StationProgram final : public gateway::PageHost {
public:
    /// A word that goes out on a page's levers, as the network is given it.
    using Written = std::function<void(gateway::LeverDesk::Page page, WindlassCommand& levers)>;

    struct Options {
        station::Seat seat = station::Seat::watcher;
        std::string name;         ///< under which its hand's words go out
        std::uint64_t number = 0; ///< of all programs, so that no two have the same writers
        Written written{};        ///< empty: no hand works there, and nothing goes out
        bool hears_truth = false; ///< whatever its seat may hear
        // What it leaves undone:
        bool tells_no_takings = false;    ///< to its pages, of another station that has their levers
        bool looks_at_no_takings = false; ///< so that their hands stay on these
    };

    StationProgram(World& world, Network& network, Options options);
    /// As if it were killed: nobody is told, and its hand is missed later.
    ~StationProgram() override;

    std::shared_ptr<gateway::PageSession> open_page(gateway::Transport& transport);
    /// Whether it reads that topic.
    bool reads(const wire::TopicInfo& topic) const;
    /// A sample has come.
    void hear(const ToldSample& sample);
    /// A word on levers counts, its own or another station's.
    void overhear(const Sent& sent);
    /// 20 times a second, as Gateway's.
    void tick();

    /// The channel's topic; nullptr: it has none of that number.
    const wire::TopicInfo* topic_of(std::uint32_t channel) const;
    /// How many samples it keeps of that channel's for who comes late.
    std::size_t kept(std::uint32_t channel) const;
    gateway::LeverDesk::Page holder(int side) const;
    /// Its writer of these levers, if it has spoken.
    std::optional<wire::WriterId> speaks_as(int side) const;

    // gateway::PageHost
    void log(const std::string&) override {}
    nlohmann::json hello(const gateway::PageSession& page) const override;
    void forget(gateway::PageSession& page) override { pages_.erase(&page); }
    bool sees_truth() const override { return station::has_truth(options_.seat); }
    void tell_given(const gateway::PageSession&, const std::string&) const override {}
    bool order_classroom(const wire::TopicInfo&, const nlohmann::json&, const std::string&) override {
        return false;
    }
    nlohmann::json look_at_forecastle(const std::string&, std::int64_t) override { not_here(); }
    void record(const std::string&, bool, const std::string&) override { not_here(); }
    std::string replay(const std::string&) override { not_here(); }
    void continue_live(gateway::PageSession&, const nlohmann::json&, const std::string&, double,
                       const std::string&) override {
        not_here();
    }
    void read_events(gateway::PageSession&, const nlohmann::json&, const std::string&) override {
        not_here();
    }
    void debrief(gateway::PageSession&, const nlohmann::json&, const std::string&) override { not_here(); }
    void ask_exercise_files(gateway::PageSession&, const nlohmann::json&, const nlohmann::json&) override {
        not_here();
    }

private:
    class Topics;
    class Desk;
    [[noreturn]] static void not_here();

    World& world_;
    Network& network_;
    const Options options_;
    const gateway::Role role_;
    std::unique_ptr<Topics> topics_;
    std::shared_ptr<Desk> desk_;
    std::set<gateway::PageSession*> pages_;
};

} // namespace windlass::sim
