#include "app/files/resources.h"

#include <gtest/gtest.h>

namespace tractus::files {
namespace {

TEST(Resources, AreFoundInTheSourceTree)
{
    EXPECT_TRUE(std::filesystem::exists(find_resource("models/broadleaf.l").value()));
    auto const missing = find_resource("models/oak.l");
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().message.find("share/tractus/models/oak.l"), std::string::npos);
}

TEST(Resources, AModelIsAFileOrOneOfOurs)
{
    auto const ours = find_model("shrub").value();
    EXPECT_EQ(ours.filename(), "shrub.l");
    EXPECT_EQ(find_model(ours.string()).value(), ours);
    for (char const* const name : { "oak", "", ".", "../models/shrub" }) {
        auto const missing = find_model(name);
        ASSERT_FALSE(missing) << name;
        EXPECT_NE(missing.error().message.find("birch, broadleaf, calla, conifer, daisy"),
                  std::string::npos);
    }
}

} // namespace
} // namespace tractus::files
