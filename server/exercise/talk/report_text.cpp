#include "server/exercise/talk/report_text.hpp"

#include "words/words.hpp"

namespace windlass::exercise {

std::string report_text(const ReportMade& report) {
    const auto place = [](auto enumerator) { return static_cast<std::size_t>(enumerator); };
    const std::string said = words::report_text({.code = place(report.code),
                                                 .side = report.side,
                                                 .value = report.value,
                                                 .lead = report.lead,
                                                 .stay = place(report.stay),
                                                 .growing = place(report.growing),
                                                 .weight = place(report.weight),
                                                 .order_code = place(report.order_code),
                                                 .text = report.text});
    return "reported: " + said +
           (report.order_number > 0 ? ", to order " + std::to_string(report.order_number) : "");
}

} // namespace windlass::exercise
