#pragma once
// A config folder of a test's own.

#include "server/config/config.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

namespace windlass::config::test {

namespace fs = std::filesystem;

inline const fs::path kConfig = WINDLASS_CONFIG_DIR; ///< the shipped one

/// A config folder of the test's own, with the shipped files in it, removed afterwards.
class ConfigFiles : public ::testing::Test {
protected:
    void SetUp() override {
        root_ = fs::temp_directory_path() / ("windlass-config-" + std::to_string(getpid()));
        fs::copy(kConfig, root_, fs::copy_options::recursive);
    }
    void TearDown() override { fs::remove_all(root_); }

    fs::path write(const std::string& name, const std::string& text) {
        fs::path file = root_ / name;
        std::ofstream(file) << text;
        return file;
    }

    /// What loading an exercise of this text is refused with; "" when it is accepted.
    std::string refusal(const std::string& text) {
        try {
            load_exercise(write("exercises/x.json", text));
            return "";
        } catch (const ConfigError& error) {
            return error.what();
        }
    }

    fs::path root_;
};

} // namespace windlass::config::test
