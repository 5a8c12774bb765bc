#include "engine/lsystem/turtle/plant_rules.h"
#include "tests/engine/lsystem/small_model.h"
#include "tests/engine/plant/small_plant.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <vector>

namespace tractus::lsystem {
namespace {

// Returns a sorted row for each segment: its two ends, the radius at its base, and the radius at
// the tip of an axis.
std::vector<std::array<double, 8>> segments(Plant const& plant)
{
    std::vector<std::array<double, 8>> result;
    for (SegmentId i = 0; i < plant.segment_count(); ++i) {
        auto const [base, tip] = nodes_of(plant, i);
        auto const& from = plant.node_position_mm[base];
        auto const& to = plant.node_position_mm[tip];
        result.push_back({ from.x(), from.y(), from.z(), to.x(), to.y(), to.z(),
                           static_cast<double>(plant.node_radius_mm[base]),
                           static_cast<double>(plant.node_radius_mm[tip]) });
    }
    std::sort(result.begin(), result.end(), [](auto const& a, auto const& b) {
        for (std::size_t i = 0; i < a.size(); ++i)
            if (std::abs(a[i] - b[i]) > 1e-3)
                return a[i] < b[i];
        return false;
    });
    return result;
}

void expect_comes_back(Plant const& plant)
{
    auto const model = compiled(rules_of_plant(plant));
    EXPECT_TRUE(model.warnings.empty()) << model.warnings.front();
    auto const string = derive(model);
    ASSERT_TRUE(string) << string.error().message;
    auto const drawn = interpret(model, *string);
    ASSERT_TRUE(drawn) << drawn.error().message;
    check_plant(*drawn);
    ASSERT_EQ(drawn->axes.size(), plant.axes.size());
    auto const found = segments(*drawn);
    auto const expected = segments(plant);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        for (std::size_t k = 0; k < found[i].size(); ++k)
            EXPECT_NEAR(found[i][k], expected[i][k], 1e-4) << i << ' ' << k;
}

TEST(PlantRules, DrawThePlant)
{
    expect_comes_back(small_plant());
}

TEST(PlantRules, DrawWhatAModelDraws)
{
    expect_comes_back(drawn("!(2)F(3)[+(50)!(1)F(2)[&(20)F(1)]-(10)F(2)][-(60)/(30)F(2)][^F(1)]"
                            "\\(20)&(5)!(1.5)F(3)[/(90)&(40)F(2)F(1)]F(1)"));
    expect_comes_back(drawn("[F(2)][@M(5,0,3)F(2)[+F(1)]][@M(-5,1,0)^(30)F(1)]"));
}

TEST(PlantRules, DrawNothingOfNothing)
{
    auto const model = compiled(rules_of_plant({}));
    EXPECT_TRUE(derive(model));
}

} // namespace
} // namespace tractus::lsystem
