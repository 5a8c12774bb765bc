#include "app/methods/sketch_lsystem/sketch_tool.h"
#include "engine/methods/sketch_lsystem/change_edits.h"
#include "tests/app/controllers/live_window_devices.h"

#include <gtest/gtest.h>

namespace tractus::controllers {
namespace {

scene::Scene sketched(sketch::SketchTool const& tool)
{
    auto const stroke = stroke_through({ { 0, 0, 0 }, { 10, 0, 100 }, { 10, 20, 200 } });
    return scene::apply_edits(scene::Scene {},
                              tools::Tool(tool).edits_for(stroke, scene::Scene {}).value())
        .value();
}

class LiveWindowFollow : public testing::Test {
protected:
    using Slider = view::ChangeGrowth::Slider;

    LiveWindowFollow()
    {
        auto options = live_options();
        options.scene = sketched(drawn_);
        window_.emplace(LiveWindow::create(drawing_devices(false), std::move(options)).value());
        window_->perform(view::ChooseTool { drawn_ });
        // A stroke of the devices' script that came later would be what Undo takes back.
        advance_to_end(*window_);
        settle();
    }

    void settle()
    {
        window_->settle();
        window_->advance(std::chrono::milliseconds(16));
        window_->settle();
    }

    std::size_t triangles() { return window_->state().plant->triangle_count(); }
    int laterals() { return sketch::newest_grown(*window_->scene().drawn)->sketch->rule.laterals; }

    sketch::SketchTool drawn_ { .laterals = 2 };
    std::optional<LiveWindow> window_;
};

TEST_F(LiveWindowFollow, ShowsWhatAHandleWouldDoAndDoesItWhenItIsLetGo)
{
    auto const before = triangles();
    auto const skeleton = window_->state().skeleton.size();
    sketch::SketchTool more = drawn_;
    more.laterals = 4;
    window_->perform(view::AdjustTool { more, Slider::Moving });
    settle();
    EXPECT_GT(triangles(), before);
    EXPECT_GT(window_->state().skeleton.size(), skeleton);
    EXPECT_EQ(laterals(), 2) << "nothing is done yet";
    EXPECT_EQ(window_->state().hand, tools::Tool(drawn_));

    // The slider is back at its initial value.
    window_->perform(view::AdjustTool { drawn_, Slider::Moving });
    settle();
    EXPECT_EQ(triangles(), before);
    EXPECT_EQ(window_->state().skeleton.size(), skeleton);

    window_->perform(view::AdjustTool { more, Slider::Released });
    settle();
    EXPECT_EQ(laterals(), 4);
    EXPECT_GT(triangles(), before);
    EXPECT_EQ(window_->state().hand, tools::Tool(more));
    EXPECT_EQ(window_->state().status, "What was drawn so follows");
}

// Undo must also restore the tool's settings, so that the next drag changes the plant again.
TEST_F(LiveWindowFollow, UndoGivesTheHandItsRuleBack)
{
    sketch::SketchTool more = drawn_;
    more.laterals = 4;
    window_->perform(view::AdjustTool { more, Slider::Released });
    settle();
    window_->perform(view::Undo {});
    settle();
    EXPECT_EQ(laterals(), 2);
    EXPECT_EQ(window_->state().hand, tools::Tool(drawn_));
    window_->perform(view::Redo {});
    settle();
    EXPECT_EQ(laterals(), 4);
    EXPECT_EQ(window_->state().hand, tools::Tool(more));
}

TEST_F(LiveWindowFollow, LeavesWhatWasDrawnOtherwise)
{
    sketch::SketchTool other { .laterals = 5 };
    window_->perform(view::ChooseTool { other });
    auto const before = triangles();
    sketch::SketchTool next = other;
    next.laterals = 7;
    window_->perform(view::AdjustTool { next, Slider::Moving });
    settle();
    EXPECT_EQ(triangles(), before);
    window_->perform(view::AdjustTool { next, Slider::Released });
    settle();
    EXPECT_EQ(laterals(), 2);
    EXPECT_EQ(window_->state().hand, tools::Tool(next));
    window_->perform(view::TakeLikeDrawn {});
    settle();
    EXPECT_EQ(window_->state().hand, tools::Tool(drawn_));
}

} // namespace
} // namespace tractus::controllers
