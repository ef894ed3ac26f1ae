#pragma once
// The bridge's orders to the forecastle: numbered, repeated back in time or not, taken back. Whether they
// are carried out is the assessment's business.

#include "server/exercise/faults/faults.hpp"

#include <vector>

namespace windlass::exercise {

/// s from the order, by which it is to be repeated back and to be carried out; 0: that is not asked for.
struct OrderDeadlines {
    double repeat = 0, execute = 0;
};

/// What is usual for an order. A question is answered, not repeated.
OrderDeadlines usual_deadlines(BridgeOrderCode code);

/// e.g. "pay out port to 3 shackles".
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

    void give(const BridgeOrderGiven& given, const When& when, const FaultBook::Log& log);
    /// Takes a report for the repeat that it may be.
    void hear(const ReportMade& report, const When& when, const FaultBook::Log& log);
    /// Calls what has not been repeated in time.
    void watch(const When& when, const FaultBook::Log& log);

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
