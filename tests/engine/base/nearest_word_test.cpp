#include "engine/base/nearest_word.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace tractus {
namespace {

std::vector<std::string> const kTrees { "birch", "broadleaf", "conifer", "daisy", "palm" };

TEST(NearestWord, ForgivesALetterInsertedLeftOutReplacedOrSwapped)
{
    for (auto const* const typed : { "brich", "birh", "birtch", "birck", "BIRCH" })
        EXPECT_EQ(nearest_word(typed, kTrees), "birch") << typed;
    EXPECT_EQ(nearest_word("broadlaef", kTrees), "broadleaf");
    EXPECT_EQ(nearest_word("brodlef", kTrees), "broadleaf");
}

TEST(NearestWord, IsNoneWhereMoreThanAThirdIsWrong)
{
    for (auto const* const typed : { "oak", "p1a2l3m", "", "confrrre" })
        EXPECT_EQ(nearest_word(typed, kTrees), std::nullopt) << typed;
    EXPECT_EQ(nearest_word(std::string(1000, 'b'), kTrees), std::nullopt);
    EXPECT_EQ(nearest_word("birch", {}), std::nullopt);
}

TEST(NearestWord, TakesTheFirstOfEquals)
{
    EXPECT_EQ(nearest_word("cat", std::vector<std::string> { "dog", "bat", "car" }), "bat");
}

TEST(NearestWord, EndsASentence)
{
    EXPECT_EQ(did_you_mean("brich", kTrees), " (did you mean birch?)");
    EXPECT_EQ(did_you_mean("oak", kTrees), "");
}

} // namespace
} // namespace tractus
