#pragma once

#include "tests/app/commands/outcome.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <unistd.h>
#include <vector>

namespace tractus::silhouette {

namespace fs = std::filesystem;
using nlohmann::json;

// Fixture that runs `tractus silhouette` in a folder whose only file is oak.json, the drawing of a
// crown.
class SilhouetteCommand : public ::testing::Test {
protected:
    SilhouetteCommand()
    {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        std::ofstream(folder_ / "oak.json") << crown();
    }
    ~SilhouetteCommand() override { fs::remove_all(folder_); }

    std::string path(std::string const& name) const { return (folder_ / name).string(); }

    // Returns the drawing of a trunk and a round crown with five lobes at its top.
    static json crown()
    {
        json drawing { { "trunk", { { 0, -90 }, { 0, 50 } } } };
        for (int i = 0; i < 240; ++i) {
            double const angle = i * 2 * 3.14159265358979 / 240;
            double const r = 70 + 14 * std::fabs(std::cos(2.5 * (angle - 1.5708)));
            drawing["outline"].push_back({ r * std::cos(angle), r * std::sin(angle) });
        }
        return drawing;
    }

    // Returns an outline around the crown's upper right lobe.
    static json part()
    {
        json stroke;
        for (int i = 0; i < 80; ++i) {
            double const angle = i * 2 * 3.14159265358979 / 80;
            double const r = 24 + 4 * std::cos(5 * angle);
            stroke.push_back({ 57 + r * std::cos(angle), 19 + r * std::sin(angle) });
        }
        return stroke;
    }

    std::string refusal(std::vector<std::string> const& arguments)
    {
        auto const outcome = commands::run(arguments);
        EXPECT_NE(outcome.exit_code, 0);
        EXPECT_EQ(outcome.out, "");
        return outcome.err;
    }

    fs::path folder_
        = fs::temp_directory_path() / ("tractus_silhouette_command." + std::to_string(getpid()));
};

} // namespace tractus::silhouette
