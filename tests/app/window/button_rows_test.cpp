#include "app/window/button_rows.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <vector>

namespace tractus::window {
namespace {

constexpr ButtonGaps kGaps { 10, 30 };

std::vector<std::size_t> ends_of(std::vector<ButtonRow> const& rows)
{
    std::vector<std::size_t> ends;
    for (auto const& row : rows)
        ends.push_back(row.end);
    return ends;
}

float width_of(ButtonRow const& row, std::vector<ButtonWidth> const& buttons, std::size_t begin)
{
    float width = 0;
    for (auto i = begin; i < row.end; ++i)
        width += row.width(buttons[i]) + (i > begin ? row.gap_before(buttons[i], kGaps) : 0);
    return width;
}

TEST(ButtonRows, AreOneWhereAllFitsNarrower)
{
    std::vector<ButtonWidth> const buttons { { 100, 50, true }, { 100, 50 }, { 100, 50, true } };
    auto const wide = button_rows(buttons, kGaps, 340);
    EXPECT_EQ(ends_of(wide), (std::vector<std::size_t> { 3 }));
    EXPECT_FLOAT_EQ(wide[0].ease, 1);
    auto const narrow = button_rows(buttons, kGaps, 170);
    EXPECT_EQ(ends_of(narrow), (std::vector<std::size_t> { 3 }));
    EXPECT_FLOAT_EQ(width_of(narrow[0], buttons, 0), 170);
}

TEST(ButtonRows, KeepGroupsTogether)
{
    std::vector<ButtonWidth> const buttons {
        { 100, 60, true }, { 100, 60 }, { 100, 60, true }, { 100, 60 }
    };
    EXPECT_EQ(ends_of(button_rows(buttons, kGaps, 250)), (std::vector<std::size_t> { 2, 4 }));
}

TEST(ButtonRows, DivideAGroupThatIsWiderThanARow)
{
    std::vector<ButtonWidth> const buttons { { 100, 60, true }, { 100, 60 }, { 100, 60 } };
    EXPECT_EQ(ends_of(button_rows(buttons, kGaps, 130)), (std::vector<std::size_t> { 2, 3 }));
    EXPECT_EQ(ends_of(button_rows(buttons, kGaps, 20)), (std::vector<std::size_t> { 1, 2, 3 }));
}

RC_GTEST_PROP(ButtonRows, HoldEachButtonOnceAndNoneOutside, ())
{
    auto const room = static_cast<float>(*rc::gen::inRange(120, 2000));
    std::vector<ButtonWidth> buttons;
    for (auto const usual : *rc::gen::container<std::vector<int>>(rc::gen::inRange(60, 320)))
        buttons.push_back({ static_cast<float>(usual),
                            std::min(40.0f + static_cast<float>(usual) / 4, 55.0f),
                            usual % 3 == 0 });
    std::size_t begin = 0;
    for (auto const& row : button_rows(buttons, kGaps, room)) {
        RC_ASSERT(row.end > begin);
        RC_ASSERT(width_of(row, buttons, begin) <= room * 1.0001f);
        begin = row.end;
    }
    RC_ASSERT(begin == buttons.size());
}

} // namespace
} // namespace tractus::window
