#include "app/methods/silhouettes/outline_meaning.h"
#include "app/methods/silhouettes/outline_previewer.h"
#include "app/methods/silhouettes/outline_tool.h"
#include "app/methods/silhouettes/touched_crown.h"
#include "app/render/image.h"
#include "engine/base/random.h"
#include "engine/methods/silhouettes/plane.h"
#include "engine/scene/paper.h"
#include "engine/scene/picture_ground.h"
#include "tests/app/small_model.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <sstream>
#include <vector>

namespace tractus::silhouette {
namespace {

using silhouette::DrawTree;

constexpr int kWidth = 480;
constexpr int kHeight = 320;
// Width of the sheet: two pixels per millimetre, with the middle at (0, 0).
constexpr double kSheet_mm = 240;

// Returns the radius of a crown with five lobes in the direction `angle`, in pixels with y upwards.
double crown_radius(double size, double angle)
{
    return size * (1 + 0.1 * std::cos(5 * angle));
}

struct PaintedTree {
    Vec2 foot;
    double height;

    double size() const { return 0.34 * height; }
    Vec2 middle() const { return foot + Vec2(0, 0.64 * height); }
    bool has_crown_at(Vec2 const& pixel) const
    {
        Vec2 const off = pixel - middle();
        return off.norm() < crown_radius(size(), std::atan2(off.y(), off.x()));
    }
};

// Returns a picture of trees with rough foliage before sky and level grass.
render::Image painted(std::vector<PaintedTree> const& trees)
{
    render::Image image(kWidth, kHeight);
    Random random({ .seed = 7, .stream = 1, .substream = 0 });
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            Vec2 const at(x + 0.5, kHeight - y - 0.5);
            double const up = at.y() / kHeight;
            Vec3 color(0.62, 0.66, 0.36);
            if (up > 0.5)
                color = Vec3(0.62, 0.74, 0.9) + (up - 0.5) * Vec3(0.2, 0.16, 0.1);
            double rough = 0.03;
            for (auto const& tree : trees) {
                if (std::fabs(at.x() - tree.foot.x()) < 0.02 * tree.height && at.y() > tree.foot.y()
                    && at.y() < tree.middle().y())
                    color = { 0.36, 0.27, 0.2 };
                if (tree.has_crown_at(at)) {
                    color = { 0.24, 0.38, 0.16 };
                    rough = 0.22;
                }
            }
            double const light = random.uniform(-rough, rough);
            Vec3f const shown = (color + light * Vec3::Ones()).cast<float>();
            image.at(x, y) = render::color_from(shown);
        }
    return image;
}

Vec2 sheet_of(Vec2 const& pixel)
{
    return (pixel - Vec2(kWidth, kHeight) / 2) * (kSheet_mm / kWidth);
}

Vec2 pixel_of(Vec2 const& sheet_mm)
{
    return sheet_mm * (kWidth / kSheet_mm) + Vec2(kWidth, kHeight) / 2;
}

scene::Scene with_photo(std::vector<PaintedTree> const& trees, scene::PicturePlace place = {})
{
    place.width_mm = kSheet_mm;
    std::ostringstream file;
    EXPECT_TRUE(render::write_png(file, painted(trees)));
    return scene::apply_edit({}, scene::LayPicture { "photo.png", file.str(), place }).value();
}

Stroke touch_at(Vec2 const& sheet_mm)
{
    return stroke_through(
        { { sheet_mm.x(), sheet_mm.y(), 80 }, { sheet_mm.x() + 0.2, sheet_mm.y(), 80 } });
}

// Returns the number of pixels inside both the outline and the tree's crown, as a share of those
// inside either.
double likeness(std::vector<Vec2> const& outline_px, PaintedTree const& tree)
{
    double both = 0;
    double either = 0;
    for (int y = 0; y < kHeight; y += 2)
        for (int x = 0; x < kWidth; x += 2) {
            Vec2 const at(x + 0.5, y + 0.5);
            bool const one = silhouette::is_inside(outline_px, at);
            bool const other = tree.has_crown_at(at);
            both += one && other;
            either += one || other;
        }
    return both / std::max(either, 1.0);
}

std::vector<Vec2> pixels_of(Stroke const& stroke)
{
    std::vector<Vec2> points;
    for (auto const& tip : stroke.tips)
        points.push_back(pixel_of(tip.position_mm.head<2>()));
    return points;
}

PaintedTree const kNear { { 130, 60 }, 210 };
PaintedTree const kFar { { 350, 110 }, 105 };

TEST(TouchedCrown, IsTheOneThatThePictureShows)
{
    auto const scene = with_photo({ kNear, kFar });
    for (auto const& tree : { kNear, kFar })
        for (Vec2 const& off : { Vec2(0, 10), Vec2(-20, 0), Vec2(15, -10) }) {
            auto const outline
                = outline_touched(*scene.state.picture, touch_at(sheet_of(tree.middle() + off)));
            ASSERT_TRUE(outline) << outline.error().message;
            EXPECT_GT(likeness(pixels_of(*outline), tree), 0.85) << off.transpose();
            EXPECT_TRUE(silhouette::is_closed_stroke(pixels_of(*outline)));
        }
}

TEST(TouchedCrown, GoesWithThePicture)
{
    auto const plain = with_photo({ kNear });
    auto const turned = with_photo({ kNear }, { .x_mm = 12, .y_mm = -7, .turn_deg = 30 });
    auto const way
        = [](Vec2 const& at) -> Vec2 { return Vec2(12, -7) + silhouette::turned(at, radians(30)); };
    Vec2 const middle_mm = sheet_of(kNear.middle());
    auto const one = outline_touched(*plain.state.picture, touch_at(middle_mm)).value();
    auto const other = outline_touched(*turned.state.picture, touch_at(way(middle_mm))).value();
    ASSERT_EQ(one.tips.size(), other.tips.size());
    for (std::size_t i = 0; i < one.tips.size(); ++i)
        EXPECT_LT(
            (way(one.tips[i].position_mm.head<2>()) - other.tips[i].position_mm.head<2>()).norm(),
            0.01);
}

TEST(TouchedCrown, RefusesSkyGroundAndWhatIsBeside)
{
    auto const scene = with_photo({ kNear });
    for (Vec2 const& pixel : { Vec2(300, 290), Vec2(300, 30) }) {
        auto const outline = outline_touched(*scene.state.picture, touch_at(sheet_of(pixel)));
        ASSERT_FALSE(outline);
        EXPECT_NE(outline.error().message.find("no crown stands out there"), std::string::npos);
    }
    auto const beside = outline_touched(*scene.state.picture, touch_at({ 200, 0 }));
    ASSERT_FALSE(beside);
    EXPECT_NE(beside.error().message.find("beside the picture"), std::string::npos);
}

Result<DrawTree> drawn(Stroke const& stroke, scene::Scene const& scene)
{
    return drawn_tree(OutlineTool {}, stroke, scene);
}

scene::Scene after(scene::Scene const& scene, Stroke const& stroke)
{
    auto const edit = drawn(stroke, scene);
    EXPECT_TRUE(edit) << edit.error().message;
    return edit ? scene::apply_edit(scene, *edit).value() : scene;
}

Stroke trunk_of(PaintedTree const& tree)
{
    Vec2 const foot = sheet_of(tree.foot);
    Vec2 const top = sheet_of(tree.middle());
    return stroke_through({ { foot.x(), foot.y(), 80 }, { top.x(), top.y(), 80 } });
}

// A touch on a crown in the picture must have the same effect as drawing the crown's outline.
TEST(OutlineTool, TakesTheCrownThatATouchLiesIn)
{
    auto const picture = with_photo({ kNear });
    auto const stem = after(picture, trunk_of(kNear));
    auto const touch = touch_at(sheet_of(kNear.middle() + Vec2(30, 20)));
    auto const edit = drawn(touch, stem).value();
    EXPECT_EQ(edit.part, DrawTree::Part::Outline);
    EXPECT_EQ(edit.plant, stem.state.active);
    auto const tree = scene::apply_edit(stem, edit).value();
    EXPECT_GT(tree.base->axes.size(), 20U);
    EXPECT_FALSE(drawn(stroke_through({ { 0, 0, 80 } }), small_scene())) << "there is no picture";
    // The crown's outline must be shown before the pen is lifted.
    tools::Tool const tool = OutlineTool {};
    std::vector<TipSample> const ink(touch.tips.begin(), touch.tips.end());
    EXPECT_GT(
        outline_previewer()->show({ std::make_shared<scene::Scene const>(stem), tool, ink }).size(),
        10U);
}

// Both trees are 9 m tall; the far one is twice as far away. The horizon is in the middle of the
// picture.
TEST(OutlineTool, StandsTreesOnThePicturesGround)
{
    auto scene = with_photo({ kNear, kFar });
    auto const place = scene.state.picture->place;
    scene::PictureGround const ground { .horizon = 0,
                                        .measured = scene::PictureGround::Measured {
                                            .foot = scene::on_picture(place, sheet_of(kNear.foot)),
                                            .top = scene::on_picture(
                                                place, sheet_of(kNear.foot) + Vec2(0, 105)),
                                            .height_m = 9 } };
    scene = scene::apply_edit(scene, scene::SetPictureGround { ground }).value();
    scene = after(scene, trunk_of(kNear));
    scene = after(scene, touch_at(sheet_of(kNear.middle())));
    auto const near_mm = bounds(*scene.base);
    auto const near_at_mm = scene.drawn->stands_at_mm;
    scene = after(scene, trunk_of(kFar));
    ASSERT_EQ(scene.plants.size(), 2U);
    scene = after(scene, touch_at(sheet_of(kFar.middle())));
    ASSERT_EQ(scene.plants.size(), 2U);
    auto const far_mm = bounds(*scene.base);
    // The crown ends at 0.98 of the tree's height, and the axes end slightly below that.
    EXPECT_NEAR(near_mm.max_mm.z(), 8600, 450);
    EXPECT_NEAR(far_mm.max_mm.z(), 8600, 450);
    double const scale = scene.placement.scale;
    Vec3 const apart_m = (scene.drawn->stands_at_mm - near_at_mm) / scale / 1000;
    // The trees' bases are 100 and 50 pixels below the horizon. The near tree, of 9 m, is 210
    // pixels high, so the camera's height is 100/210 of 9 m.
    double const camera_m = 9 * 100.0 / 210;
    EXPECT_NEAR(apart_m.x(), camera_m * ((350 - 240) / 50.0 - (130 - 240) / 100.0), 0.05);
    EXPECT_NEAR(apart_m.y(), camera_m * kWidth * (1 / 50.0 - 1 / 100.0), 0.1);
    // Later lines on the far tree must use the scale of the picture at that tree, as when it was
    // drawn.
    auto const paper = scene::paper_of(scene.state);
    EXPECT_NEAR(paper.unit, 2, 1e-6);
    Vec2 const top_mm = sheet_of(kFar.foot + Vec2(0, kFar.height));
    EXPECT_NEAR(paper.world_of_sheet(top_mm).z() / scale / 1000, 9, 0.01);
    EXPECT_LT((paper.sheet_of_world(paper.world_of_sheet(top_mm)) - top_mm).norm(), 1e-9);
}

TEST(OutlineTool, RefusesATreeAboveTheHorizon)
{
    auto scene = with_photo({ kNear });
    scene = scene::apply_edit(
                scene,
                scene::SetPictureGround {
                    { .horizon = 0,
                      .measured = scene::PictureGround::Measured { { 0, -0.2 }, { 0, 0.1 }, 5 } } })
                .value();
    auto const edit = drawn(stroke_through({ { 0, 20, 80 }, { 1, 40, 80 }, { 0, 60, 80 } }), scene);
    ASSERT_FALSE(edit);
    EXPECT_NE(edit.error().message.find("horizon"), std::string::npos);
}

} // namespace
} // namespace tractus::silhouette
