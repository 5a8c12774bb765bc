#include "app/window/collection_view.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace tractus::window {
namespace {

// Returns the height of each plant in pixels if `count` plants, of width `shape` times their
// height, are shown in `columns`.
double plant_px(std::size_t count, std::size_t columns, ImVec2 const& size_px, double shape)
{
    auto const rows = (count + columns - 1) / columns;
    return std::min(static_cast<double>(size_px.y) / static_cast<double>(rows),
                    static_cast<double>(size_px.x) / static_cast<double>(columns) / shape);
}

TEST(SheetColumns, ShowPlantsAsLargeAsAnyNumberOfColumns)
{
    for (float const width_px : { 300.F, 700.F, 1280.F, 3440.F })
        for (float const height_px : { 240.F, 620.F, 1300.F })
            for (double const shape : { 0.2, 0.6, 1.0, 2.5, 5.0 })
                for (std::size_t const count : { 1U, 5U, 12U }) {
                    ImVec2 const size_px(width_px, height_px);
                    auto const columns = sheet_columns(count, size_px, shape);
                    ASSERT_GE(columns, 1U);
                    ASSERT_LE(columns, count);
                    for (std::size_t other = 1; other <= count; ++other)
                        EXPECT_GE(plant_px(count, columns, size_px, shape),
                                  plant_px(count, other, size_px, shape) * (1 - 1e-9))
                            << width_px << " x " << height_px << ", " << shape;
                }
}

TEST(SheetColumns, FollowTheShapeOfTheRoomAndOfThePlants)
{
    EXPECT_EQ(sheet_columns(12, { 1600, 400 }, 0.25), 12U) << "poplars in one row";
    EXPECT_EQ(sheet_columns(12, { 400, 1600 }, 4), 1U) << "hedges below each other";
    EXPECT_EQ(sheet_columns(12, { 1200, 900 }, 1), 4U);
}

} // namespace
} // namespace tractus::window
