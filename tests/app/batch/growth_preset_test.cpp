// Tests that growth presets do what their names say, measured by the directions of the tips of
// plants.
#include "engine/variation/growth_preset.h"

#include "app/files/resources.h"
#include "app/io/model_file.h"
#include "engine/scene/scene.h"
#include "engine/variation/growth.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>

namespace tractus::batch {
namespace {

// Posture of a plant, in the world frame.
struct Posture {
    Vec3 tips = Vec3::Zero(); // Mean direction of the last tenth of all axes.
    double height = 0;        // Height relative to that of the drawn plant.
    double sway = 0;          // Mean angle between axes and their drawn directions, in radians.
};

Vec3 end_direction(Plant const& plant, Axis const& axis)
{
    auto const nodes = plant.positions(axis);
    auto const from = nodes.size() - 1 - std::max<std::size_t>(1, nodes.size() / 10);
    return (nodes.back() - nodes[from]).normalized();
}

Posture posture(Plant const& plant, Plant const& drawn)
{
    Posture posture { .height = bounds(plant).max_mm.z() / bounds(drawn).max_mm.z() };
    auto const share = 1 / static_cast<double>(plant.axes.size());
    for (AxisId id = 0; id < plant.axes.size(); ++id) {
        Vec3 const end = end_direction(plant, plant.axes[id]);
        Vec3 const before = end_direction(drawn, drawn.axes[id]);
        posture.tips += share * end;
        posture.sway += share * std::atan2(end.cross(before).norm(), end.dot(before));
    }
    return posture;
}

// Fixture with one of the program's models, which can be grown with any growth preset.
class Presets : public testing::TestWithParam<std::string> {
protected:
    static Plant base()
    {
        auto edit = io::load_model_edit(files::find_resource("models/" + GetParam() + ".l").value())
                        .value();
        edit.seed = 1;
        return *scene::apply_edit({}, edit).value().base;
    }

    Posture of(std::string_view name) const
    {
        auto const plant
            = tractus::variation::grow({ .plant = base_,
                                         .parameters = variation::growth_preset(name).value(),
                                         .key = { .seed = 4 } })
                  .value();
        return posture(plant, base_);
    }

    Plant base_ = base();
    Posture drawn_ = posture(base_, base_);
};

TEST_P(Presets, WeepingTipsHang)
{
    auto const weeping = of("weeping");
    EXPECT_LT(weeping.tips.z(), -0.4);
    EXPECT_LT(weeping.tips.z(), drawn_.tips.z() - 0.35);
    EXPECT_GT(weeping.height, 0.7) << "the trunk still stands";
}

TEST_P(Presets, TowardsTheLightTipsStand)
{
    EXPECT_GT(of("towards the light").tips.z(), std::max(0.5, drawn_.tips.z() + 0.4));
}

TEST_P(Presets, WindLeansThemToItsSide)
{
    auto const hillside = of("windy hillside");
    auto const storm = of("storm-bent");
    EXPECT_GT(hillside.tips.x(), drawn_.tips.x() + 0.1);
    EXPECT_GT(storm.tips.x(), hillside.tips.x() + 0.3);
    EXPECT_GT(hillside.height, 0.7);
    EXPECT_GT(storm.height, 0.3);
}

TEST_P(Presets, GoFromTheTamestToTheWildest)
{
    EXPECT_LT(of("as drawn").sway, 1e-12);
    auto const calm = of("calm");
    auto const usual = of("usual");
    auto const winding = of("winding");
    auto const wild = of("wild");
    EXPECT_GT(calm.sway, radians(2));
    EXPECT_LT(calm.sway, radians(5));
    EXPECT_GT(usual.sway, 1.5 * calm.sway);
    EXPECT_LT(usual.sway, radians(15));
    EXPECT_GT(winding.sway, 1.5 * usual.sway);
    EXPECT_GT(wild.sway, 1.5 * winding.sway);
    // The presets "calm", "usual" and "winding" have no preferred direction.
    for (auto const& plant : { calm, usual, winding }) {
        EXPECT_LT((plant.tips - drawn_.tips).norm(), 0.1);
        EXPECT_GT(plant.height, 0.9);
    }
}

INSTANTIATE_TEST_SUITE_P(Models, Presets,
                         testing::Values("broadleaf", "birch", "shrub", "conifer", "magnolia"),
                         [](auto const& model) { return model.param; });

} // namespace
} // namespace tractus::batch
