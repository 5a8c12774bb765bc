#include "engine/plant/branch_address.h"

#include "engine/plant/join_axes.h"
#include "engine/plant/plant_addresses.h"
#include "tests/engine/variation/plants.h"

#include <gtest/gtest.h>

namespace tractus {
namespace {

TEST(BranchAddress, FindsEverySegmentAgain)
{
    auto plant = variation::forking_tree(5, 3);
    variation::add_axis(plant,
                        // The second stem of the plant.
                        variation::straight({ 900, 0, 0 }, { 900, 0, 100 }, 4));
    AddressIndex const index(plant);
    for (SegmentId segment = 0; segment < plant.segment_count(); ++segment)
        EXPECT_EQ(index.find_segment(plant, index.address_of(plant, segment)),
                  std::optional(segment));
}

TEST(BranchAddress, SaysTheWayFromTheRoot)
{
    auto const plant = variation::hand_made_plant();
    AddressIndex const index(plant);
    EXPECT_EQ(index.address_of(plant, 3), (SegmentAddress { 0, 3 }));
    EXPECT_EQ(index.address_of(plant, 8), (SegmentAddress { 0, 1, 0, 0, 0, 1 }));
    EXPECT_EQ(segment_count({ { 0, 1 }, { 0, 3 } }), 3u);
    EXPECT_EQ(segment_count({ { 0, 1 }, { 0, 1, 0, 0, 0, 1 } }), 4u) << "1, 4, 7 and 8";
}

TEST(BranchAddress, HoldsWhenThePlantChangesElsewhere)
{
    auto const plant = variation::hand_made_plant();
    std::vector<SegmentId> const path { 1, 4, 7, 8 };
    auto const address = AddressIndex(plant).address_of(plant, path);

    // A copy of the plant with a new branch low on the trunk, so that all segments have other
    // numbers.
    Plant changed;
    auto const trunk
        = variation::add_axis(changed, variation::straight({ 0, 0, 0 }, { 0, 0, 400 }, 4));
    variation::add_axis(changed, variation::straight({ 0, 0, 100 }, { 0, 90, 100 }, 5), trunk, 0);
    auto const right = variation::add_axis(
        changed, variation::straight({ 0, 0, 200 }, { 150, 0, 200 }, 3), trunk, 1);
    EXPECT_EQ(PlantAddresses(changed).find_path(changed, address),
              std::nullopt); // The twig does not exist yet.
    variation::add_axis(changed, variation::straight({ 50, 0, 200 }, { 50, 0, 260 }, 2), right,
                        changed.axes[right].first_segment);
    EXPECT_EQ(PlantAddresses(changed).find_path(changed, address),
              (std::vector<SegmentId> { 1, 9, 12, 13 }));
}

// A branch with a key must be found by it, whatever its position and number of segments are.
TEST(BranchAddress, FollowsTheKeyOfAnAxis)
{
    auto const plant = variation::hand_made_plant();
    std::vector<SegmentId> const path { 4, 5, 6 };
    AxisKeys keys(plant.axes.size(), 0);
    keys[axis_of(plant, 4)] = axis_key("right");
    AddressIndex const index(plant, keys);
    auto const address = index.address_of(plant, path);
    EXPECT_EQ(address.first.front(), kKeyedAxis);
    EXPECT_EQ(PlantAddresses(plant, keys).find_path(plant, address), path);
    for (SegmentId segment = 0; segment < plant.segment_count(); ++segment)
        EXPECT_EQ(index.find_segment(plant, index.address_of(plant, segment)),
                  std::optional(segment));

    Plant changed;
    auto const trunk
        = variation::add_axis(changed, variation::straight({ 0, 0, 0 }, { 0, 0, 400 }, 9));
    variation::add_axis(changed, variation::straight({ 0, 0, 100 }, { 0, 90, 100 }, 5), trunk, 0);
    auto const right = variation::add_axis(
        changed, variation::straight({ 0, 0, 300 }, { 150, 0, 200 }, 7), trunk, 6);
    AxisKeys changed_keys(changed.axes.size(), 0);
    changed_keys[right] = axis_key("right");
    auto const first = changed.axes[right].first_segment;
    auto const found = PlantAddresses(changed, changed_keys).find_path(changed, address);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->front(), first);
    EXPECT_EQ(found->back(), first + 6) << "the whole branch stays the whole";
    EXPECT_EQ(PlantAddresses(changed).find_path(changed, address), std::nullopt);
    changed_keys[trunk] = axis_key("right");
    EXPECT_EQ(PlantAddresses(changed, changed_keys).find_path(changed, address), std::nullopt)
        << "two of the same name have none";
}

TEST(BranchAddress, FindsNothingOnAnEmptyPlantOrByAnEmptyAddress)
{
    EXPECT_EQ(AddressIndex().find_segment({}, { 0, 0 }), std::nullopt);
    auto const plant = variation::hand_made_plant();
    AddressIndex const index(plant);
    EXPECT_EQ(index.find_segment(plant, {}), std::nullopt);
    EXPECT_EQ(index.find_segment(plant, { 0, 99 }), std::nullopt);
    EXPECT_EQ(index.find_segment(plant, { 1, 0 }), std::nullopt);
    EXPECT_EQ(index.find_segment(plant, { 0, 0, 0, 0 }), std::nullopt) << "it bears none there";
}

} // namespace
} // namespace tractus
