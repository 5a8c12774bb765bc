#include "engine/plant/branch_address.h"

#include "engine/plant/join_axes.h"
#include "tests/engine/variation/plants.h"

#include <gtest/gtest.h>

namespace tractus {
namespace {

TEST(BranchAddress, FindsEverySegmentAgain)
{
    auto plant = forking_tree(5, 3);
    add_axis(plant, straight({ 900, 0, 0 }, { 900, 0, 100 }, 4)); // A second stem.
    AddressIndex const index(plant);
    for (SegmentId segment = 0; segment < plant.segment_count(); ++segment)
        EXPECT_EQ(index.find_segment(plant, index.address_of(plant, segment)),
                  std::optional(segment));
}

TEST(BranchAddress, SaysTheWayFromTheRoot)
{
    auto const plant = hand_made_plant();
    AddressIndex const index(plant);
    EXPECT_EQ(index.address_of(plant, 3), (SegmentAddress { 0, 3 }));
    EXPECT_EQ(index.address_of(plant, 8), (SegmentAddress { 0, 1, 0, 0, 0, 1 }));
    EXPECT_EQ(segment_count({ { 0, 1 }, { 0, 3 } }), 3u);
    EXPECT_EQ(segment_count({ { 0, 1 }, { 0, 1, 0, 0, 0, 1 } }), 4u) << "1, 4, 7 and 8";
}

TEST(BranchAddress, HoldsWhenThePlantChangesElsewhere)
{
    auto const plant = hand_made_plant();
    std::vector<SegmentId> const path { 1, 4, 7, 8 };
    auto const address = AddressIndex(plant).address_of(plant, path);

    // A copy with a new branch low on the trunk, so that all numbers change.
    Plant changed;
    auto const trunk = add_axis(changed, straight({ 0, 0, 0 }, { 0, 0, 400 }, 4));
    add_axis(changed, straight({ 0, 0, 100 }, { 0, 90, 100 }, 5), trunk, 0);
    auto const right = add_axis(changed, straight({ 0, 0, 200 }, { 150, 0, 200 }, 3), trunk, 1);
    EXPECT_EQ(AddressIndex(changed).find_path(changed, address),
              std::nullopt); // The twig is not there yet.
    add_axis(changed, straight({ 50, 0, 200 }, { 50, 0, 260 }, 2), right,
             changed.axes[right].first_segment);
    EXPECT_EQ(AddressIndex(changed).find_path(changed, address),
              (std::vector<SegmentId> { 1, 9, 12, 13 }));
}

TEST(BranchAddress, FindsNothingOnAnEmptyPlantOrByAnEmptyAddress)
{
    EXPECT_EQ(AddressIndex().find_segment({}, { 0, 0 }), std::nullopt);
    auto const plant = hand_made_plant();
    AddressIndex const index(plant);
    EXPECT_EQ(index.find_segment(plant, {}), std::nullopt);
    EXPECT_EQ(index.find_segment(plant, { 0, 99 }), std::nullopt);
    EXPECT_EQ(index.find_segment(plant, { 1, 0 }), std::nullopt);
    EXPECT_EQ(index.find_segment(plant, { 0, 0, 0, 0 }), std::nullopt) << "it bears none there";
}

} // namespace
} // namespace tractus
