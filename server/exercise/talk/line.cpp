#include "server/exercise/talk/line.hpp"

#include "server/exercise/talk/report_text.hpp"

namespace windlass::exercise {

void say(const ReportMade& report, const Talk& talk, const BridgeOrders::When& now, BridgeOrders& orders,
         const EventLog& log) {
    const std::string words = report_text(report);
    if (gets_through(report, talk)) {
        log("report.made", report.side, report.value, words);
        orders.hear(report, now, log);
        return;
    }
    log("report.not_heard", report.side, report.value, "no answer from the bridge; " + words);
    if (const std::string rung = bell(report); !rung.empty()) log("report.bell", -1, 0, rung);
}

void say(const BridgeOrderGiven& order, const Talk& talk, const BridgeOrders::When& now, BridgeOrders& orders,
         FaultBook& faults, const EventLog& log) {
    if (!gets_through(order, talk)) {
        const std::string words = order_words(order.code, order.side, order.value);
        log("order.not_heard", order.side, 0,
            "no answer from the forecastle; ordered: " + (words.empty() ? order.text : words));
        return;
    }
    BridgeOrderGiven heard = order;
    if (!talk.vhf) heard.text = kByHand;
    orders.give(heard, now, log);
    faults.hear(heard);
}

} // namespace windlass::exercise
