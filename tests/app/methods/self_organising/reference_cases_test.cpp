// Compares grown trees with those of a program in another language that implements the same laws.

#include "app/methods/self_organising/case_file.h"
#include "engine/base/file.h"
#include "tests/app/commands/outcome.h"
#include "tests/corpus.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

namespace tractus::self_organising {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

void expect_as_reference(json const& grown, json const& expected)
{
    // Tolerance for positions: both programs round to nine decimals.
    constexpr double kPlace = 1.1e-9;
    EXPECT_EQ(grown["steps"], expected["steps"]);
    EXPECT_EQ(grown["strahler"], expected["strahler"]);
    EXPECT_NEAR(grown["total_length"].get<double>(), expected["total_length"].get<double>(), 1e-7);
    EXPECT_NEAR(grown["base_diameter"].get<double>(), expected["base_diameter"].get<double>(),
                kPlace);
    ASSERT_EQ(grown["nodes"].size(), expected["nodes"].size());
    for (std::size_t i = 0; i < grown["nodes"].size(); ++i) {
        auto const& node = grown["nodes"][i];
        auto const& reference = expected["nodes"][i];
        for (auto const* const key : { "parent", "order", "step" })
            ASSERT_EQ(node[key], reference[key]) << "node " << i;
        ASSERT_NEAR(node["diameter"].get<double>(), reference["diameter"].get<double>(), kPlace);
        for (std::size_t a = 0; a < 3; ++a)
            ASSERT_NEAR(node["at"][a].get<double>(), reference["at"][a].get<double>(), kPlace)
                << "node " << i;
    }
}

int expect_cases_as_reference(fs::path const& folder)
{
    int count = 0;
    for (auto const& entry : fs::directory_iterator(folder)) {
        SCOPED_TRACE(entry.path().string());
        ++count;
        auto const text = read_file(entry.path()).value();
        auto const outcome
            = commands::run({ "brush", "--case", entry.path().string(), "--report" });
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        auto const grown = json::parse(outcome.out, nullptr, false);
        EXPECT_FALSE(grown.is_discarded());
        if (!grown.is_discarded())
            expect_as_reference(grown, json::parse(text)["expected"]);
    }
    return count;
}

TEST(SelfOrganisingCases, GrowAsTheReferenceDoes)
{
    EXPECT_EQ(expect_cases_as_reference(shipped("self_organising")), 5);
}

TEST(SelfOrganisingCases, GrowAsTheReferenceDoesInAllCases)
{
    REQUIRE_CORPUS();
    EXPECT_GE(expect_cases_as_reference(corpus() / "self-organising"), 9);
}

TEST(SelfOrganisingCases, SayWhatIsWrong)
{
    auto const message = [](char const* text) {
        auto const read = parse_case(text, "tree.json");
        return read ? std::string() : read.error().message;
    };
    EXPECT_EQ(message("{\"steps\": 2}"), "");
    EXPECT_EQ(message("[]"),
              "tree.json: it is no case: expected JSON, {\"steps\": …, \"parameters\": {…}}");
    EXPECT_EQ(message("{\"steps\": 2.5}"), "tree.json: steps is 2.5, expected a whole number");
    EXPECT_EQ(message("{\"steps\": 1e300}"), "tree.json: steps is 1e+300, expected a whole number");
    EXPECT_EQ(message("{\"steps\": 2000}"),
              "tree.json: steps is 2000: give a number from 0 to 1000");
    EXPECT_EQ(message("{\"markers\": [[0, 0]]}"),
              "tree.json: markers[0] is no place: write [x, y, z]");
    EXPECT_EQ(message("{\"markers\": [[0, 0, 1e999]]}"),
              "tree.json: it is no case: expected JSON, {\"steps\": …, \"parameters\": {…}}");
    EXPECT_EQ(message("{\"parameters\": {\"vigour\": \"high\"}}"),
              "tree.json: parameters: vigour is no number");
    EXPECT_EQ(message("{\"parameters\": {\"environment\": \"dark\"}}"),
              "tree.json: environment is \"dark\": write \"space\" or \"light\"");
    EXPECT_EQ(message("{\"parameters\": {\"apical_control\": -1}}"),
              "tree.json: apical_control is -1: give a number from 0 to 1");
    EXPECT_NE(message("{\"parameters\": {\"lambda\": 1}}").find("lambda is unknown"),
              std::string::npos);
    EXPECT_EQ(message("{\"parameters\": []}"),
              "tree.json: parameters is no object: write {\"internode\": 1}");
}

} // namespace
} // namespace tractus::self_organising
