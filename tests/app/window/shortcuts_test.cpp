#include "app/methods/all_methods.h"
#include "app/tools/erase_tool.h"
#include "app/tools/select_tool.h"
#include "app/window/refusal_note.h"
#include "app/window/shortcuts.h"
#include "tests/app/window/small_state.h"

#include <gtest/gtest.h>

namespace tractus::window {

namespace {

// A window model that records the requests it receives.
class AskedModel : public view::WindowModel {
public:
    AskedModel()
    {
        state_.is_live = true;
        state_.tools = methods::all_methods().tools;
    }

    void advance(Duration) override { }
    view::WindowState const& state() const override { return state_; }
    void perform(view::WindowCommand const& command) override { asked.push_back(command); }

    template<typename Command> bool was_last_asked_for() const
    {
        return !asked.empty() && std::holds_alternative<Command>(asked.back());
    }

    std::vector<view::WindowCommand> asked;

private:
    view::WindowState state_ = small_state();
};

class Shortcuts : public testing::Test {
protected:
    void press(char key, bool with_control = false, bool with_shift = false)
    {
        take_shortcut({ key, with_control, with_shift }, model, workspace, ring);
    }

    AskedModel model;
    Workspace workspace;
    ToolRing ring;
};

TEST_F(Shortcuts, UndoAndRedoNeedControl)
{
    press('Z');
    EXPECT_TRUE(model.asked.empty());
    press('Z', true);
    EXPECT_TRUE(model.was_last_asked_for<view::Undo>());
    press('Z', true, true);
    EXPECT_TRUE(model.was_last_asked_for<view::Redo>());
}

TEST_F(Shortcuts, AnotherOneIsForTheKeyAloneAndAnotherDrawingForControl)
{
    press('N');
    EXPECT_TRUE(model.was_last_asked_for<view::NextVariation>());
    press('N', true);
    EXPECT_TRUE(model.was_last_asked_for<view::OpenStartPage>());
}

TEST_F(Shortcuts, ToolsAreForAKeyAlone)
{
    press('E', true);
    EXPECT_TRUE(model.asked.empty());
    press('E');
    ASSERT_TRUE(model.was_last_asked_for<view::ChooseTool>());
    EXPECT_TRUE(std::get<view::ChooseTool>(model.asked.back()).tool.get<tools::EraseTool>());
    press('C');
    EXPECT_TRUE(std::get<view::ChooseTool>(model.asked.back()).tool.get<tools::SelectTool>());
}

TEST_F(Shortcuts, PressedTwiceInAFrameTheFullScreenStaysOff)
{
    press('F');
    ASSERT_TRUE(workspace.requested_full_screen);
    EXPECT_TRUE(workspace.requested_full_screen->is_on);
    press('F');
    EXPECT_FALSE(workspace.requested_full_screen->is_on);
}

TEST_F(Shortcuts, EscapeClosesOneThingAfterTheOther)
{
    workspace.filled_display = 0;
    press('?');
    ASSERT_TRUE(workspace.keys_are_listed);
    press(KeyPress::kEscape);
    EXPECT_FALSE(workspace.keys_are_listed);
    EXPECT_FALSE(workspace.requested_full_screen);
    press(KeyPress::kEscape);
    ASSERT_TRUE(workspace.requested_full_screen);
    EXPECT_FALSE(workspace.requested_full_screen->is_on);
    EXPECT_FALSE(workspace.is_close_requested);
    press(KeyPress::kEscape);
    EXPECT_TRUE(workspace.is_close_requested);
}

TEST_F(Shortcuts, NothingThatIsPressedAfterwardsKeepsTheWindowOpen)
{
    press('Q');
    press('V');
    EXPECT_TRUE(workspace.is_close_requested);
}

TEST_F(Shortcuts, InTheCalibrationEscapeLeadsBack)
{
    take_calibration_shortcut({ KeyPress::kEscape }, model, workspace);
    EXPECT_TRUE(model.was_last_asked_for<view::CloseCalibration>());
    EXPECT_FALSE(workspace.is_close_requested);
    take_calibration_shortcut({ 'N' }, model, workspace);
    EXPECT_EQ(model.asked.size(), 1u);
    take_calibration_shortcut({ 'Q' }, model, workspace);
    EXPECT_TRUE(workspace.is_close_requested);
}

TEST(Status, BeginsWithACapitalUnlessItBeginsWithAName)
{
    EXPECT_EQ(as_sentence("there is no branch here"), "There is no branch here");
    EXPECT_EQ(as_sentence("w.tractus is in use"), "w.tractus is in use");
    EXPECT_EQ(as_sentence("/home is full"), "/home is full");
    EXPECT_EQ(as_sentence("3 branches"), "3 branches");
    EXPECT_EQ(as_sentence(""), "");
}

} // namespace

} // namespace tractus::window
