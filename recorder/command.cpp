#include "recorder/command.hpp"

#include <iostream>

namespace windlass::recorder {

void tell(const std::string& text) {
    std::cerr << "recorder: " << text << std::endl;
}

CLI::Validator number_in(double low, double high) {
    return {[low, high](std::string& text) -> std::string {
                double value = 0;
                if (CLI::detail::lexical_cast(text, value) && value >= low && value <= high) return {};
                return text + " is not allowed: " + CLI::detail::to_string(low) + ".." +
                       CLI::detail::to_string(high);
            },
            ""};
}

} // namespace windlass::recorder
