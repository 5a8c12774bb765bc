#include "tests/app/commands/outcome.h"
#include "tests/corpus.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <unistd.h>
#include <vector>

// Compares the results for each sketch in tests/data/construction_lines with those of another
// program.

namespace tractus::lines {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

json read_json(fs::path const& path)
{
    std::ifstream file(path);
    return json::parse(file);
}

void expect_near(json const& found, json const& wanted, double tolerance, std::string const& what)
{
    if (wanted.is_number()) {
        EXPECT_NEAR(found.get<double>(), wanted.get<double>(), tolerance) << what;
        return;
    }
    ASSERT_EQ(found.size(), wanted.size()) << what;
    for (std::size_t i = 0; i < wanted.size(); ++i)
        expect_near(found[i], wanted[i], tolerance, what + " " + std::to_string(i));
}

void expect_report(json const& report, json const& wanted, std::string const& name)
{
    for (auto const* const key : { "stem_length", "lines", "d1", "d2", "node_x" })
        expect_near(report[key], wanted[key], 1e-7, name + " " + key);
    for (auto const& [key, values] : wanted["functions"].items()) {
        EXPECT_EQ(values.size(), 21U);
        expect_near(report["functions"][key], values, 1e-6, name + " " + key);
    }
    // The reported leaf tips are read from the plant. They are less exact, because the plant's text
    // has six digits and a bent stem is drawn in straight pieces.
    auto const& headings = wanted["functions"]["heading"];
    bool const straight
        = std::adjacent_find(headings.begin(), headings.end(), std::not_equal_to<>())
        == headings.end();
    expect_near(report["leaf_tips"], wanted["leaf_tips"],
                (straight ? 1e-3 : 3e-3) * wanted["stem_length"].get<double>(),
                name + " leaf_tips");
}

TEST(ConstructExpectedValues, ReportsAreWhatAnotherProgramComputed)
{
    auto const folder
        = fs::temp_directory_path() / ("tractus_construct_expected." + std::to_string(getpid()));
    int sketches = 0;
    for (auto const& entry : fs::directory_iterator(shipped("construction_lines"))) {
        auto const path = entry.path();
        if (path.stem().extension() == ".expected")
            continue;
        auto expected = path;
        expected.replace_extension(".expected.json");
        auto const outcome = commands::run(
            { "construct", path.string(), "-o", (folder / path.stem()).string(), "--report" });
        ASSERT_EQ(outcome.exit_code, 0) << path << outcome.err;
        expect_report(json::parse(outcome.out), read_json(expected), path.stem().string());
        ++sketches;
    }
    EXPECT_EQ(sketches, 21);
    fs::remove_all(folder);
}

} // namespace
} // namespace tractus::lines
