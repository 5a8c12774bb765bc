#include "app/controllers/leaf_page.h"

#include "app/document/logged_step.h"
#include "tests/app/controllers/live_window_devices.h"
#include "tests/app/our_plant.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <utility>

namespace tractus::leaf {
namespace {

// Returns a window on a tree in which the strokes of the pen are already finished. Otherwise undo
// would remove these strokes instead of the leaves.
controllers::LiveWindow window_with_tree()
{
    auto options = controllers::live_options();
    options.scene = our_plant("broadleaf");
    auto window
        = controllers::LiveWindow::create(controllers::drawing_devices(false), std::move(options))
              .value();
    controllers::advance_to_end(window);
    return window;
}

// Returns the indices of the group and of the card with the given title.
std::pair<std::size_t, std::size_t> card_of(view::StartPageState const& page,
                                            std::string const& title)
{
    for (std::size_t group = 0; group < page.groups.size(); ++group) {
        auto const& cards = page.groups[group].cards;
        auto const found = std::ranges::find(cards, title, &view::StartCard::title);
        if (found != cards.end())
            return { group, static_cast<std::size_t>(found - cards.begin()) };
    }
    ADD_FAILURE() << "there is no card " << title;
    return { 0, 0 };
}

void choose(controllers::LiveWindow& window, std::string const& title)
{
    window.perform(view::OpenLeaves {});
    auto* const page = window.start_page();
    ASSERT_NE(page, nullptr);
    auto const [group, card] = card_of(page->state(), title);
    page->choose(group, card);
    window.advance({});
    window.settle();
}

TEST(LeafPage, PutsLeavesOnThePlantAsItShowsThem)
{
    auto window = window_with_tree();
    choose(window, "Maple");
    auto* const page = window.start_page();
    ASSERT_NE(page, nullptr);
    ASSERT_TRUE(page->state().study);
    auto const green = page->state().study->large.picture;
    ASSERT_NE(green, nullptr);
    page->slide(0, 0.9312);
    page->slide(2, 0.5);
    window.settle();
    EXPECT_NE(*page->state().study->large.picture, *green);
    EXPECT_EQ(page->state().study->sliders[0].text, "age 0.93");
    EXPECT_EQ(page->state().study->sliders[2].text, "spots 50 %");
    page->accept();
    window.advance({});
    window.settle();
    EXPECT_EQ(window.start_page(), nullptr);
    EXPECT_EQ(window.state().status, "The plant has leaves of maple");
    EXPECT_EQ(window.scene().drawn->leaves, "maple+spots=0.5 16 0.93.leaf-sheet");
    choose(window, "Maple");
    EXPECT_EQ(window.start_page()->state().study->sliders[0].value, 0.93) << "as it wears them";
    window.perform(view::Undo {});
    window.settle();
    EXPECT_EQ(window.scene().drawn->leaves, "");
}

TEST(LeafPage, SetsTheSeason)
{
    auto window = window_with_tree();
    choose(window, "Oak");
    auto* const page = window.start_page();
    ASSERT_NE(page, nullptr);
    page->slide(1, 10.5);
    EXPECT_EQ(page->state().study->sliders[1].text, "mid-October");
    page->accept();
    window.advance({});
    window.settle();
    ASSERT_TRUE(window.scene().state.season) << window.state().status;
    EXPECT_EQ(window.scene().state.season->month, 10.5);
}

TEST(LeafPage, GoesBackToTheCards)
{
    auto window = window_with_tree();
    choose(window, "Oak");
    window.start_page()->leave();
    window.advance({});
    ASSERT_NE(window.start_page(), nullptr);
    EXPECT_FALSE(window.start_page()->state().study);
    window.start_page()->leave();
    window.advance({});
    EXPECT_EQ(window.start_page(), nullptr);
    EXPECT_EQ(window.scene().drawn->leaves, "");
}

} // namespace
} // namespace tractus::leaf
