#include "app/batch/collection.h"
#include "app/batch/collection_sheet.h"

#include <gtest/gtest.h>

namespace tractus::batch {
namespace {

std::vector<PlantPlace> places(std::size_t count, Shard shard, Stand stand = Stand::Scatter)
{
    auto how = variation::kPlantsOfOneBed;
    how.age = 0; // The plants' ages come from the range of ages alone.
    return place_plants({ .individuality = how,
                          .ages = { 0.25, 0.75 },
                          .seed = 7,
                          .count = count,
                          .shard = shard,
                          .stand = stand },
                        100);
}

TEST(Collection, ItsPartsAreTheWhole)
{
    for (std::size_t const count : { 1u, 7u, 100u })
        for (std::size_t const parts : { 1u, 3u, 8u }) {
            auto const whole = places(count, {});
            ASSERT_EQ(whole.size(), count);
            std::size_t next = 0;
            for (std::size_t number = 1; number <= parts; ++number)
                for (auto const& place : places(count, { number, parts })) {
                    ASSERT_LT(next, count);
                    EXPECT_EQ(place.index, whole[next].index);
                    EXPECT_EQ(place.age, whole[next].age);
                    EXPECT_EQ(place.position_mm, whole[next].position_mm);
                    EXPECT_EQ(place.rotation_rad, whole[next].rotation_rad);
                    ++next;
                }
            EXPECT_EQ(next, count) << parts;
        }
}

TEST(Collection, PartsDifferByOnePlantAtMost)
{
    for (std::size_t number = 1; number <= 8; ++number) {
        auto const size = places(1003, { number, 8 }).size();
        EXPECT_GE(size, 125u);
        EXPECT_LE(size, 126u);
    }
}

TEST(Collection, ScatteredPlantsKeepTheirDistanceAndAges)
{
    auto const all = places(200, {});
    double youngest = 1;
    double oldest = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        youngest = std::min(youngest, all[i].age);
        oldest = std::max(oldest, all[i].age);
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GT((all[i].position_mm - all[j].position_mm).norm(), 29.9);
    }
    EXPECT_GE(youngest, 0.25);
    EXPECT_LT(youngest, 0.27);
    EXPECT_LT(oldest, 0.75);
    EXPECT_GT(oldest, 0.73);
}

TEST(Collection, InAGridPlantsStandInRowsAndFaceAnyWay)
{
    auto const all = places(60, {}, Stand::Grid);
    EXPECT_EQ(all[1].position_mm, Vec3(100, 0, 0));
    EXPECT_EQ(all[9].position_mm, Vec3(0, -100, 0));
    double least = 7;
    double most = 0;
    for (auto const& place : all) {
        least = std::min(least, place.rotation_rad);
        most = std::max(most, place.rotation_rad);
    }
    EXPECT_LT(least, 0.3);
    EXPECT_GT(most, 6);
    CollectionOptions one_way { .individuality = {}, .count = 5 };
    for (auto const& place : place_plants(one_way, 100))
        EXPECT_EQ(place.rotation_rad, 0);
}

TEST(Collection, ItsSheetShowsPlantsFromTheFirstToTheLast)
{
    EXPECT_EQ(sheet_plant(0, 1), 0u);
    for (std::size_t i = 0; i < kMaxSheetPlants; ++i)
        EXPECT_EQ(sheet_plant(i, kMaxSheetPlants), i); // The sheet shows every plant.
    EXPECT_EQ(sheet_plant(0, 1'000'000), 0u);
    EXPECT_EQ(sheet_plant(kMaxSheetPlants - 1, 1'000'000), 999'999u);
    for (std::size_t i = 1; i < kMaxSheetPlants; ++i) {
        auto const step = sheet_plant(i, 1'000'000) - sheet_plant(i - 1, 1'000'000);
        EXPECT_GE(step, 21276u);
        EXPECT_LE(step, 21277u);
    }
}

} // namespace
} // namespace tractus::batch
