#include "tests/app/window/layout_fixture.h"

#include <gtest/gtest.h>

namespace tractus::window {

using namespace layout_tests;

TEST_F(LayoutTest, ShowsEveryCardOfTheStartPageWhole)
{
    for (auto const& size : sizes())
        for (std::size_t const recent : { 0u, 2u, 12u }) {
            SCOPED_TRACE(fmt::format("{}, {} recent", text_of(size), recent));
            show(
                { size.width, size.height }, size.scale,
                [&](Layout&, DrawingModel& model) {
                    model.start.emplace(recent);
                    if (recent == 2)
                        model.start->say("The drawing is kept as "
                                         "lombardy_poplar-2026-01-09-1403.tractus");
                },
                [&](DrawnFrame const& drawn, ImVec2 const& size_px) {
                    check_buttons(drawn, size_px);
                    EXPECT_GE(drawn.pictures.size(), size.height >= 560 ? 2u : 0u);
                    std::size_t whole = 0;
                    for (auto const& button : drawn.buttons)
                        whole += button.whole.panel.find("cards") != std::string::npos
                            && button.visible.height() > button.whole.height() - 1.5f;
                    EXPECT_GE(whole, 3u) << "the empty sheets are seen at once";
                });
        }
}

TEST_F(LayoutTest, ShowsAStudyWhole)
{
    for (auto const& size : sizes()) {
        SCOPED_TRACE(text_of(size));
        show(
            { size.width, size.height }, size.scale,
            [&](Layout&, DrawingModel& model) {
                model.start.emplace(0);
                model.start->show_study();
            },
            [&](DrawnFrame const& drawn, ImVec2 const& size_px) {
                ASSERT_GE(drawn.buttons.size(), 4u) << "of the head, and the study's own";
                ASSERT_EQ(drawn.pictures.size(), 11u);
                for (std::size_t i = 0; i < drawn.pictures.size(); ++i) {
                    auto const& picture = drawn.pictures[i];
                    EXPECT_GE(picture.left, 0) << text_of(picture);
                    EXPECT_LE(picture.right, size_px.x) << text_of(picture);
                    EXPECT_NEAR(picture.width(), picture.height(), 1) << "it is not cut";
                    EXPECT_GE(picture.width(), (i == 0 ? 140 : 32) * size.scale);
                    for (std::size_t j = 0; j < i; ++j)
                        EXPECT_FALSE(overlap(picture, drawn.pictures[j]));
                }
                auto const& accept = drawn.buttons.back();
                EXPECT_LE(accept.whole.right, size_px.x);
                if (size.height >= 450 && size.width >= 640) {
                    EXPECT_GE(accept.visible.height(), accept.whole.height() - 1.5f);
                }
            });
    }
}

TEST_F(LayoutTest, MovesASliderOfAStudyAndAcceptsIt)
{
    DrawingModel model;
    model.start.emplace(0);
    model.start->show_study();
    ImVec2 const slider { 650, 100 };
    work({ 800, 600 },
         { { slider },
           { slider, true },
           { { slider.x + 40, slider.y }, true },
           { { slider.x + 40, slider.y } },
           { slider, false, { {}, { { KeyPress::kEnter } }, {} } } },
         model);
    ASSERT_FALSE(model.start->slid.empty());
    EXPECT_EQ(model.start->slid.back().first, 0u);
    EXPECT_GT(model.start->slid.back().second, 0.4);
    EXPECT_EQ(model.start->accepted, 1);
    EXPECT_TRUE(model.start->chosen.empty());
}

static ImVec2 const kFirstCard { 110, 200 };

TEST_F(LayoutTest, PressesACardOnlyIfTheTouchStaysThere)
{
    DrawingModel model;
    model.start.emplace(12);
    std::vector<Moment> tap { { { 0, 0 } },         { { 0, 0 } },         { kFirstCard },
                              { kFirstCard, true }, { kFirstCard, true }, { kFirstCard },
                              { kFirstCard } };
    work({ 800, 600 }, tap, model);
    ASSERT_EQ(model.start->chosen.size(), 1u);
    EXPECT_EQ(model.start->chosen[0], std::pair(std::size_t { 0 }, std::size_t { 0 }));

    model.start->chosen.clear();
    std::vector<Moment> drag { { { 0, 0 } }, { { 0, 0 } }, { kFirstCard } };
    for (int i = 0; i <= 10; ++i)
        drag.push_back({ { kFirstCard.x, kFirstCard.y - 8 * static_cast<float>(i) }, true });
    drag.push_back({ { kFirstCard.x, kFirstCard.y - 80 } });
    drag.push_back({ { kFirstCard.x, kFirstCard.y - 80 } });
    work({ 800, 600 }, drag, model);
    EXPECT_TRUE(model.start->chosen.empty()) << "it has moved the page";
}

TEST_F(LayoutTest, PressesCardsByTheKeys)
{
    DrawingModel model;
    model.start.emplace(0);
    auto const press = [](char key) {
        return Moment { { 0, 0 }, false, { .mouse = {}, .presses = { { key } }, .held = {} } };
    };
    work({ 800, 600 },
         { { { 0, 0 } },
           press(KeyPress::kEnter),
           press(KeyPress::kDown),
           press(KeyPress::kDown),
           press(KeyPress::kRight),
           press(KeyPress::kEnter),
           press('K'),
           press('X') },
         model);
    ASSERT_EQ(model.start->chosen.size(), 2u);
    EXPECT_EQ(model.start->chosen[0], std::pair(std::size_t { 1 }, std::size_t { 1 }));
    EXPECT_EQ(model.start->chosen[1], std::pair(std::size_t { 0 }, std::size_t { 0 }));
}

} // namespace tractus::window
