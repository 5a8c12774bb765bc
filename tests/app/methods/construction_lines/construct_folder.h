#pragma once

#include "tests/app/commands/outcome.h"
#include "tests/file_bytes.h"

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <unistd.h>

namespace tractus::lines {

namespace fs = std::filesystem;

// Fixture that runs `tractus construct` in an empty folder.
class ConstructFolder : public ::testing::Test {
protected:
    ConstructFolder()
    {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    ~ConstructFolder() override { fs::remove_all(folder_); }

    std::string path(std::string const& name) const { return (folder_ / name).string(); }

    // Returns the error message that `tractus construct` prints for an invalid sketch.
    std::string refusal(std::string const& text)
    {
        std::ofstream(folder_ / "wrong.json") << text;
        auto const outcome = commands::run({ "construct", path("wrong.json"), "-o", path("out") });
        EXPECT_EQ(outcome.exit_code, 1);
        EXPECT_EQ(outcome.out, "");
        EXPECT_FALSE(fs::exists(folder_ / "out"));
        auto const at = outcome.err.find("wrong.json: ");
        return at == std::string::npos ? outcome.err : outcome.err.substr(at + 12);
    }

    fs::path folder_
        = fs::temp_directory_path() / ("tractus_construct_command." + std::to_string(getpid()));
};

} // namespace tractus::lines
