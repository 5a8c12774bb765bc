#include "app/window/pen_pointer.h"

#include <cfloat>
#include <gtest/gtest.h>

namespace tractus::window {

namespace {

Bounds tablet_volume()
{
    Bounds volume;
    volume.add({ -100, -50, 0 });
    volume.add({ 100, 50, 300 });
    return volume;
}

} // namespace

// Fixture with ImGui but without a window, to observe the mouse input that ImGui receives.
class PenPointerTest : public testing::Test {
protected:
    PenPointerTest()
        : area_(fit_pen_area(tablet_volume(), { 0, 0 }, { 1000, 800 }))
    {
        ImGui::CreateContext();
        auto& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = { 1000, 800 };
        io.Fonts->AddFontDefault();
        io.Fonts->Build();
        state_.is_live = true;
    }
    ~PenPointerTest() override { ImGui::DestroyContext(); }

    void frame(std::vector<view::PenView> path, float step_s = 1.0f / 60)
    {
        state_.pen_path = std::move(path);
        ImGui::GetIO().DeltaTime = step_s;
        pen_.feed(state_, area_, step_s);
        state_.pen_path.clear();
        ImGui::NewFrame();
        ImGui::EndFrame();
    }

    PenArea area_;
    view::WindowState state_;
    PenPointer pen_;
};

namespace {

view::PenView pen_at(float x_mm, float y_mm, bool touching = false, bool pressing = false)
{
    return {
        .in_range = true, .touching = touching, .tip_mm = { x_mm, y_mm, 100 }, .pressing = pressing
    };
}

} // namespace

TEST(PenArea, KeepsTheAspectAndTurnsYAround)
{
    auto const area = fit_pen_area(tablet_volume(), { 0, 0 }, { 1000, 800 });
    EXPECT_DOUBLE_EQ(area.px_per_mm, 5);
    auto const corner = area.to_px({ -100, 50 });
    EXPECT_FLOAT_EQ(corner.x, 0);
    EXPECT_FLOAT_EQ(corner.y, 150) << "in the middle of the window's height";
    EXPECT_LT((area.to_mm(area.to_px({ 12, -34 })) - Vec2(12, -34)).norm(), 1e-4);
    EXPECT_FLOAT_EQ(area.left_px(), 0);
    EXPECT_FLOAT_EQ(area.right_px(), 1000);
    auto const airy = fit_pen_area(tablet_volume(), { 100, 0 }, { 1000, 800 }, 2);
    EXPECT_DOUBLE_EQ(airy.px_per_mm, 2.5);
    EXPECT_FLOAT_EQ(airy.left_px(), 350);
}

TEST_F(PenPointerTest, IsTheMouseWhereThePenIs)
{
    frame({ pen_at(0, 0) });
    EXPECT_TRUE(pen_.leads());
    EXPECT_FLOAT_EQ(ImGui::GetIO().MousePos.x, 500);
    EXPECT_FLOAT_EQ(ImGui::GetIO().MousePos.y, 400);
    EXPECT_FALSE(ImGui::IsMouseDown(ImGuiMouseButton_Left));
    frame({ pen_at(20, 10, true, true) });
    EXPECT_FLOAT_EQ(ImGui::GetIO().MousePos.x, 600);
    EXPECT_TRUE(ImGui::IsMouseDown(ImGuiMouseButton_Left));
    frame({ {} });
    EXPECT_FALSE(pen_.leads());
    EXPECT_FALSE(ImGui::IsMouseDown(ImGuiMouseButton_Left));
}

TEST_F(PenPointerTest, PointsAtNothingWhileItDraws)
{
    frame({ pen_at(0, 0, true, false) });
    EXPECT_EQ(ImGui::GetIO().MousePos.x, -FLT_MAX);
    EXPECT_FALSE(ImGui::IsMouseDown(ImGuiMouseButton_Left));
}

TEST_F(PenPointerTest, ShowsATapThatIsShorterThanAFrame)
{
    frame({ pen_at(0, 0), pen_at(0, 0, true, true), pen_at(0, 0), pen_at(5, 0) });
    EXPECT_TRUE(ImGui::IsMouseDown(ImGuiMouseButton_Left));
    EXPECT_TRUE(pen_.has_more());
    frame({});
    EXPECT_FALSE(ImGui::IsMouseDown(ImGuiMouseButton_Left));
    EXPECT_TRUE(pen_.has_more());
    frame({});
    EXPECT_FALSE(pen_.has_more());
    EXPECT_FLOAT_EQ(pen_.place_px().x, 525);
}

TEST_F(PenPointerTest, AsksForTheRingWithItsButton)
{
    auto held = pen_at(0, 0);
    held.barrel = true;
    frame({ held });
    EXPECT_TRUE(pen_.requests_tool_ring());
    frame({ held });
    EXPECT_FALSE(pen_.requests_tool_ring()) << "once";
    frame({ pen_at(0, 0) });
    EXPECT_TRUE(pen_.has_released_barrel());
}

TEST_F(PenPointerTest, AsksForTheRingWhenATouchRests)
{
    auto const touch = pen_at(0, 0, true, false);
    frame({ touch });
    int frames = 1;
    while (frames < 100 && !pen_.requests_tool_ring()) {
        frame({ touch });
        ++frames;
    }
    EXPECT_NEAR(frames / 60.0, PenPointer::kLongPress_s, 0.05);
    frame({ touch });
    EXPECT_FALSE(pen_.requests_tool_ring()) << "once";
}

TEST_F(PenPointerTest, TakesASurfaceThatRisesForDrawing)
{
    auto touch = pen_at(0, 0, true, false);
    for (int i = 0; i < 100; ++i) {
        touch.tip_mm.z() += 0.2f;
        frame({ touch });
        EXPECT_FALSE(pen_.requests_tool_ring());
    }
}

TEST_F(PenPointerTest, LeavesTheMouseToThoseWhoHaveNoTablet)
{
    state_.mouse_draws = true;
    ImGui::GetIO().MousePos = { 7, 8 };
    frame({ pen_at(0, 0, true, true) });
    EXPECT_FALSE(pen_.leads());
    EXPECT_FLOAT_EQ(ImGui::GetIO().MousePos.x, 7);
}

} // namespace tractus::window
