#include "engine/lsystem/derivation/environments.h"
#include "tests/engine/lsystem/small_model.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <span>
#include <string>
#include <vector>

namespace tractus::lsystem {
namespace {

// An environment that can be asked about modules ?E with five parameters at given positions.
class Asking {
public:
    explicit Asking(std::string const& choice)
    {
        auto const parsed = parse_environment(choice);
        EXPECT_TRUE(parsed) << parsed.error().message;
        environment_ = make_environment(*parsed);
    }

    std::vector<std::array<float, 5>> ask(int step, std::vector<Vec3> const& places,
                                          std::vector<float> const& second = {})
    {
        std::vector<std::array<float, 5>> parameters(places.size());
        std::vector<EnvironmentQuery> queries(places.size());
        for (std::size_t i = 0; i < places.size(); ++i) {
            parameters[i] = { 0, i < second.size() ? second[i] : 1, 0, 0, 0 };
            queries[i].position = places[i];
            queries[i].parameters = parameters[i];
        }
        auto const result = environment_(step, queries);
        EXPECT_TRUE(result) << result.error().message;
        return parameters;
    }

    std::string error(std::vector<Vec3> const& places)
    {
        std::vector<EnvironmentQuery> queries(places.size());
        for (std::size_t i = 0; i < places.size(); ++i)
            queries[i].position = places[i];
        auto const result = environment_(0, queries);
        return result ? "no error" : result.error().message;
    }

private:
    Environment environment_;
};

TEST(LightEnvironment, CastsShadeInAPyramidBelow)
{
    Asking light("light");
    auto const found = light.ask(0,
                                 { { 0.5, 3.5, 0.5 },
                                   { 0.5, 2.5, 0.5 },
                                   { 1.5, 2.5, 0.5 },
                                   { 2.5, 2.5, 0.5 },
                                   { 2.5, 1.5, 2.5 },
                                   { 0.5, 9.5, 0.5 } },
                                 { 1, 0, 0, 0, 0, 0 });
    EXPECT_FLOAT_EQ(found[0][0], 1); // A module is not shaded by itself.
    EXPECT_FLOAT_EQ(found[1][0], 0.9F);
    EXPECT_FLOAT_EQ(found[2][0], 0.9F);
    EXPECT_FLOAT_EQ(found[3][0], 1);
    EXPECT_FLOAT_EQ(found[4][0], 0.95F);
    EXPECT_FLOAT_EQ(found[5][0], 1);
    // The gradient points away from the shade, where there is more light.
    EXPECT_GT(found[3][2], 0.8F);
}

// The light must agree with its definition, the sum of the shades of all modules.
TEST(LightEnvironment, AgreesWithSummingEachShade)
{
    Asking light("light:cell=2 shade=0.05 decay=1.5 depth=4 full=3");
    std::vector<Vec3> places;
    std::vector<float> weights;
    for (int i = 0; i < 60; ++i) {
        places.emplace_back(10 * std::sin(i * 1.7), 5 + 4 * std::cos(i * 2.3),
                            6 * std::sin(i * 0.9));
        weights.push_back(static_cast<float>(i % 4));
    }
    auto const found = light.ask(0, places, weights);
    auto const cell = [](double x) { return static_cast<int>(std::floor(x / 2)); };
    for (std::size_t i = 0; i < places.size(); ++i) {
        double shade = 0;
        for (std::size_t k = 0; k < places.size(); ++k) {
            int const layer = cell(places[k].y()) - cell(places[i].y());
            bool const is_below = layer >= 0 && layer < 4
                && std::abs(cell(places[k].x()) - cell(places[i].x())) <= layer
                && std::abs(cell(places[k].z()) - cell(places[i].z())) <= layer;
            if (k != i && is_below)
                shade += 0.05 * weights[k] * std::pow(1.5, -layer);
        }
        EXPECT_NEAR(found[i][0], std::max(3 - shade, 0.0), 1e-5) << i;
    }
}

TEST(LightEnvironment, RefusesAGridThatWouldBeTooLarge)
{
    Asking light("light:cell=0.001");
    EXPECT_EQ(light.error({ { 0, 0, 0 }, { 1000, 1000, 1000 } }),
              "environment light: the plant spans more than 16777216 voxels; choose cell= larger "
              "than 0.001");
    EXPECT_EQ(light.error({ { NAN, 0, 0 }, { INFINITY, 0, 0 } }), "no error");
    EXPECT_EQ(light.error({}), "no error");
}

TEST(SpaceEnvironment, GivesABallToTheFirstThatAsks)
{
    Asking space("space:radius=1");
    auto const first = space.ask(0, { { 0, 0, 0 }, { 1.5, 0, 0 }, { 2, 0, 0 }, { 0, 0, 3 } });
    EXPECT_EQ(first[0][0], 1);
    EXPECT_EQ(first[1][0], 0);
    EXPECT_EQ(first[2][0], 1); // Balls that only touch do not overlap.
    EXPECT_EQ(first[3][0], 1);
    auto const later = space.ask(1, { { 0, 0.5, 0 }, { 0, 0, 0 }, { 0, 9, 0 }, { 0, 6.9, 0 } },
                                 { 1, 1, 2, 0.05F });
    EXPECT_EQ(later[0][0], 0); // In the previous step, the next module was given this place.
    EXPECT_EQ(later[1][0], 1); // The module keeps the place that it was given in the previous step.
    EXPECT_EQ(later[2][0], 1);
    EXPECT_EQ(later[3][0], 1);
    // Step 0 begins another derivation, in which all places are free again.
    EXPECT_EQ(space.ask(0, { { 0.5, 0, 0 } })[0][0], 1);
    EXPECT_EQ(space.ask(1, { { NAN, 0, 0 } })[0][0], 0);
}

TEST(TerrainEnvironment, MeasuresHeightAboveTheGround)
{
    Asking slope("terrain:slope=45");
    auto const found = slope.ask(0, { { 0, 2, 0 }, { 3, 2, 5 } });
    EXPECT_NEAR(found[0][0], 2, 1e-6);
    EXPECT_NEAR(found[1][0], -1, 1e-6);
    EXPECT_NEAR(found[1][1], -std::sqrt(0.5), 1e-6);
    EXPECT_NEAR(found[1][2], std::sqrt(0.5), 1e-6);
    Asking hills("terrain:hill=2,wave=8");
    auto const over = hills.ask(0, { { 0, 1, 0 }, { 4, 1, 0 }, { 2, 1, 0 } });
    EXPECT_NEAR(over[0][0], 1, 1e-6);
    EXPECT_NEAR(over[1][0], 3, 1e-6);
    EXPECT_NEAR(over[2][0], 2, 1e-6);
    EXPECT_GT(over[2][1], 0.5F);
}

TEST(WaterEnvironment, SharesAVoxelAndRunsDry)
{
    Asking water("water:uptake=0.4,diffusion=0");
    auto const first = water.ask(
        0, { { 0.2, -0.5, 0.2 }, { 0.8, -0.5, 0.2 }, { 5, -0.5, 0 }, { 0, 1, 0 } }, { 1, 3, 1, 1 });
    // The water is shared in proportion to the demands: 1 of 4 parts.
    EXPECT_FLOAT_EQ(first[0][0], 0.25F);
    EXPECT_FLOAT_EQ(first[1][0], 0.75F);
    EXPECT_FLOAT_EQ(first[2][0], 0.4F);
    EXPECT_FLOAT_EQ(first[3][0], 0);
    auto const later = water.ask(1, { { 0.2, -0.5, 0.2 }, { 1.2, -0.5, 0.2 } });
    EXPECT_FLOAT_EQ(later[0][0], 0);
    EXPECT_FLOAT_EQ(later[1][0], 0.4F);
    EXPECT_GT(later[1][2], 0); // The gradient points away from the dry voxel.
}

TEST(WaterEnvironment, SpreadsAndLosesNothing)
{
    Asking water("water:uptake=1,diffusion=0.15");
    Vec3 const place { 0.5, -20.5, 0.5 };
    EXPECT_FLOAT_EQ(water.ask(0, { place })[0][0], 1);
    double const again = water.ask(1, { place })[0][0];
    // The voxel gets back 0.9, since diffusion of 0.15 fills it from six neighbours.
    EXPECT_NEAR(again, 0.9, 1e-6);
    EXPECT_FLOAT_EQ(water.ask(2, { { 0.5, -1.5, 0.5 } })[0][0], 1);
    EXPECT_FLOAT_EQ(water.ask(0, { place })[0][0], 1);
}

TEST(Environments, AreChosenByTheView)
{
    std::string const rules = "Axiom: F?E(5)[+F(2)?E(5)]\nF --> F";
    auto const model = compiled(with_header(rules, 1), "environment: light cell=1 shade=0.5\n");
    EXPECT_EQ(model.view.environment.name, "light");
    EXPECT_EQ(to_string(model, *derive(model)), "F?E(1)[+F(2)?E(1)]");
    EXPECT_EQ(derived(rules), "F?E(5)[+F(2)?E(5)]");
    // An environment given in the options replaces that of the view.
    DeriveOptions options;
    options.environment = make_environment(*parse_environment("terrain"));
    EXPECT_EQ(to_string(model, *derive(model, options)).substr(0, 6), "F?E(1)");
    options.environment = [](int, std::span<EnvironmentQuery const>) -> Result<void> {
        return fail(Fault::User, "no answer");
    };
    auto const refused = derive(model, options);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message, "no answer");
}

// An environment is reset before each derivation.
TEST(Environments, GiveTheSamePlantEachTime)
{
    auto const model = compiled(with_header("Axiom: A?E(1,1)\nA > ?E(x,r) : x>0 --> "
                                            "F(2)[+(60)A?E(1,1)]-(20)A\nA > ?E(x,r) : x==0 --> X",
                                            9),
                                "environment: space\n");
    auto const first = to_string(model, *derive(model));
    EXPECT_EQ(to_string(model, *derive(model)), first);
    EXPECT_NE(first.find('X'), std::string::npos);
}

TEST(Environments, EndWhenTheTimeIsOver)
{
    for (std::string const name : { "light", "space", "water" }) {
        int looks = 0;
        TimeLimit const time { .is_over = [&] { return ++looks == 2; }, .seconds = 60 };
        auto const environment = make_environment(*parse_environment(name), time);
        std::vector<EnvironmentQuery> const queries(60'000);
        auto const result = environment(0, queries);
        ASSERT_FALSE(result) << name;
        EXPECT_EQ(result.error().message,
                  "environment " + name
                      + ": the answers were not there when 60 s had passed; derive fewer steps, or "
                        "raise the limit of time");
        EXPECT_EQ(looks, 2);
    }
}

TEST(Environments, SayWhichThereAre)
{
    auto const error = [](std::string const& text) {
        auto const choice = parse_environment(text);
        return choice ? "no error" : choice.error().message;
    };
    EXPECT_EQ(error("sun"),
              "there is no environment 'sun'; there are light, space, terrain and "
              "water");
    EXPECT_EQ(error("light:size=3"),
              "environment light: found 'size=3', expected one of cell=, "
              "shade=, decay=, depth=, full=");
    EXPECT_EQ(error("light:cell=0"),
              "environment light: found 'cell=0', expected a number of 1e-06 to 1e+09");
    EXPECT_EQ(error("water:diffusion=1"),
              "environment water: found 'diffusion=1', expected a number of 0 to 0.1667");
    EXPECT_EQ(error(""), "there is no environment ''; there are light, space, terrain and water");
    auto const model = compiled(with_header("Axiom: F"), "environment: fields.e\n");
    ASSERT_EQ(model.warnings.size(), 1u);
    EXPECT_NE(model.warnings[0].find("nothing is run that a model names"), std::string::npos);
    EXPECT_NE(compile_error(with_header("Axiom: A"), "environment: light cell=x\n")
                  .find("found 'cell=x'"),
              std::string::npos);
}

} // namespace
} // namespace tractus::lsystem
