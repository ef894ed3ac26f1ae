#pragma once
// The bridge's orders to the forecastle: numbered, repeated back in time or not, taken back. Whether they
// are carried out is the assessment's business.

#include "server/exercise/faults/faults.hpp"

#include <vector>

namespace windlass::exercise {

/// "pay out port cable to 3 shackles in the pipe"; empty: it is in own words.
std::string order_words(BridgeOrderCode code, int side, double value);

/// All orders of a run, the oldest of more than kKept forgotten.
class BridgeOrders {
public:
    static constexpr std::size_t kKept = 200;

    /// When something happens.
    struct When {
        std::uint64_t tick = 0;
        double time = 0; ///< s
    };

    void give(const BridgeOrderGiven& given, const When& when, const EventLog& log);
    /// Takes a report for the repeat that it may be: of the order that it names, and of the same one given
    /// again.
    void hear(const ReportMade& report, const When& when, const EventLog& log);
    /// Calls what has not been repeated in time.
    void watch(const When& when, const EventLog& log);

    const std::vector<BridgeOrderView>& list() const { return orders_; }

    template <class Visitor, physics::StateOf<BridgeOrders> Self>
    friend void visit_state(Visitor& v, Self& self);

private:
    void change(BridgeOrderView& order, BridgeOrderState state, const When& when) const;
    BridgeOrderView* find(int number);

    int last_number_ = 0;
    std::vector<BridgeOrderView> orders_; ///< in their order
};

} // namespace windlass::exercise
