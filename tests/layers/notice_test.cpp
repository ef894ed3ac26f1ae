// What is shipped or built on is named, with its licence: LICENSE, NOTICE. The build of the pages holds their
// npm packages against NOTICE (station/web/tools/licences.mjs).

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

namespace {

std::string text_of(const std::string& name) {
    std::ifstream in(std::string(WINDLASS_SOURCE_DIR) + "/" + name);
    EXPECT_TRUE(in) << name;
    return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Notice, NamesEveryLibraryOfPackagesTxt) {
    const std::string notice = text_of("NOTICE");
    std::istringstream packages(text_of("packages.txt"));
    int libraries = 0;
    for (std::string line; std::getline(packages, line);) {
        const std::string package = line.substr(0, line.find_first_of(" #"));
        if (!package.ends_with("-dev")) continue;
        ++libraries;
        EXPECT_THAT(notice, ::testing::HasSubstr(package + " ("));
    }
    EXPECT_GT(libraries, 10); // packages.txt was read
}

TEST(Notice, LicenceIsTheApacheLicense) {
    EXPECT_THAT(text_of("LICENSE"),
                ::testing::HasSubstr("Apache License\n                           Version 2.0"));
    EXPECT_THAT(text_of("NOTICE"), ::testing::HasSubstr("10.1371/journal.pone.0237563")); // the seed
}

} // namespace
