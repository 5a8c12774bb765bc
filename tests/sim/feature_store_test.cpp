#include "sim/feature_store.h"

#include <gtest/gtest.h>

namespace tractus::sim {
namespace {

TEST(FeatureStore, GivesBackTheModeThatADriverHasSet)
{
    auto const answers = remember_features();
    std::vector const mode { std::byte { 2 }, std::byte { 2 } };
    EXPECT_TRUE(answers.set_feature(mode));
    EXPECT_EQ(answers.get_feature(2), mode);
}

TEST(FeatureStore, AnswersWithTheIdAloneBeforeAReportWasSet)
{
    auto const answers = remember_features();
    EXPECT_EQ(answers.get_feature(5), std::vector { std::byte { 5 } });
}

TEST(FeatureStore, IsEachDevicesOwn)
{
    auto const pen = remember_features();
    auto const other = remember_features();
    EXPECT_TRUE(pen.set_feature(std::vector { std::byte { 2 }, std::byte { 2 } }));
    EXPECT_EQ(other.get_feature(2), std::vector { std::byte { 2 } });
}

} // namespace
} // namespace tractus::sim
