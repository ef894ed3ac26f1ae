// docs/security.md says of the protection of messages what governance.xml demands.

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <string>

namespace {

using Settings = std::map<std::string, std::string>;

/// Every setting and its value: the two groups of each match.
Settings settings(const char* file, const std::regex& setting) {
    std::ifstream in(file);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    Settings found;
    for (std::sregex_iterator match(text.begin(), text.end(), setting), end; match != end; ++match)
        found[(*match)[1]] = (*match)[2];
    return found;
}

TEST(SecurityMd, SaysOfEachProtectionWhatGovernanceDemands) {
    const std::string names =
        "(\\w+_protection_kind|allow_unauthenticated_participants|enable_join_access_control)";
    const Settings demanded = settings(WINDLASS_GOVERNANCE, std::regex("<" + names + ">(\\w+)</"));
    const Settings said = settings(WINDLASS_SECURITY_MD, std::regex("\\| `" + names + "` \\| `(\\w+)` \\|"));
    EXPECT_EQ(demanded.size(), 7U);
    EXPECT_EQ(said, demanded);
}

} // namespace
