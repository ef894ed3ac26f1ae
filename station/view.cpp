#include "station/view.hpp"

#include "station/json_view.hpp"
#include "station/line_view.hpp"

#include <nlohmann/json.hpp>

#include <iostream>
#include <map>
#include <utility>

namespace windlass::station {

namespace {

using namespace std::chrono_literals;

class NoView : public View {
public:
    void note(const Picture&, const std::string&) override {}
    void update(const Picture&, Clock::time_point) override {}
};

/// What happens as it comes, and one line a second.
class ScrollingView : public View {
public:
    void update(const Picture& picture, Clock::time_point now) override {
        show_news(picture);
        if (now >= due_) {
            show(picture, now);
            due_ = now + 1s;
        }
    }

protected:
    virtual void show(const Event& event) = 0;
    virtual void show(const SeatEvent& event) = 0;
    virtual void show(const BridgeOrder& order) = 0;
    virtual void show(const Picture& picture, Clock::time_point now) = 0;

private:
    void show_news(const Picture& picture) {
        for (const Event& event : picture.events.after(read_.events))
            show(event);
        for (const std::size_t seat : {0U, 1U}) {
            for (const SeatEvent& event : picture.seat_events.at(seat).after(read_.seat_events.at(seat)))
                show(event);
            for (const SeatEvent& event : picture.instructions.at(seat).after(read_.instructions.at(seat)))
                show(event);
        }
        read_ = picture.logs_read();
        for (const BridgeOrder& order : picture.orders) {
            // An order goes through a few states, each told once.
            const auto key = std::pair{order.run(), order.number()};
            const auto [at, fresh] = orders_.try_emplace(key, order.state());
            if (fresh || std::exchange(at->second, order.state()) != order.state()) show(order);
        }
    }

    LogsRead read_;
    std::map<std::pair<std::uint64_t, std::int32_t>, BridgeOrderState> orders_;
    Clock::time_point due_{};
};

class LineView : public ScrollingView {
public:
    LineView(int side, Onlooker who) : side_{side}, who_{who} {}
    void note(const Picture&, const std::string& text) override { std::cout << "> " << text << std::endl; }

private:
    // A coach hears both; each onlooker is told of one.
    void show(const Event& event) override {
        if (who_ == Onlooker::instructor) std::cout << line(event) << std::endl;
    }
    void show(const SeatEvent& event) override {
        if (who_ == Onlooker::seat) std::cout << line(event) << std::endl;
    }
    void show(const BridgeOrder& order) override { std::cout << line(order) << std::endl; }
    void show(const Picture& picture, Clock::time_point now) override {
        std::cout << line(picture, side_, now, who_) << std::endl;
    }

    int side_;
    Onlooker who_;
};

class JsonView : public ScrollingView {
public:
    void note(const Picture& picture, const std::string& text) override {
        std::cout << nlohmann::json{{"note", text}, {"time", picture.status ? picture.status->time() : 0.0}}
                  << std::endl;
    }

private:
    void show(const Event& event) override { put("event", event); }
    void show(const SeatEvent& event) override { put("seat_event", event); }
    void show(const BridgeOrder& order) override { put("order", order); }
    void show(const Picture& picture, Clock::time_point now) override {
        std::cout << to_json(picture, now) << std::endl;
    }

    template <class Sample>
    static void put(const char* what, const Sample& sample) {
        std::cout << nlohmann::json{{what, to_json(sample)}} << std::endl;
    }
};

} // namespace

std::unique_ptr<View> make_view(const ViewOptions& options) {
    switch (options.kind) {
    case ViewKind::none:
        return std::make_unique<NoView>();
    case ViewKind::line:
        return std::make_unique<LineView>(options.side, options.who);
    case ViewKind::json:
        return std::make_unique<JsonView>();
    }
    return nullptr;
}

} // namespace windlass::station
