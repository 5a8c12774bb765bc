#include "app/desktop/completion.h"
#include "tests/app/desktop/small_program.h"

#include <gtest/gtest.h>
#include <sstream>

namespace tractus::desktop {
namespace {

class Completing : public testing::Test, protected SmallProgram {
protected:
    // Returns the words offered for the words typed so far, the last of which is incomplete. If
    // names of files or folders are offered, too, the last element is ":files" or ":folders".
    std::vector<std::string> after(std::vector<std::string> const& typed)
    {
        std::istringstream lines(print_completion(complete(root, typed, { "birch", "shrub" })));
        std::vector<std::string> words;
        for (std::string line; std::getline(lines, line);)
            words.push_back(line.substr(0, line.find('\t')));
        return words;
    }

    using Words = std::vector<std::string>;
};

TEST_F(Completing, OffersCommandsButNotTheHiddenOne)
{
    EXPECT_EQ(after({ "" }), (Words { "grow", "water" }));
    EXPECT_EQ(after({}), (Words { "grow", "water" }));
    EXPECT_EQ(after({ "w" }), (Words { "water" }));
    EXPECT_EQ(after({ "water", "" }), (Words { "well", "little" }));
    EXPECT_EQ(after({ "--" }), (Words { "--help" }));
}

TEST_F(Completing, OffersTheOptionsOfTheCommandBefore)
{
    EXPECT_EQ(after({ "grow", "--d" }), (Words { "--device", "--dry" }));
    EXPECT_EQ(after({ "grow", "birch", "--dry", "--o" }), (Words { "--output" }));
    EXPECT_EQ(after({ "water", "well", "--w" }), (Words { "--warm" }));
    EXPECT_EQ(after({ "water", "--w" }), Words {});
    EXPECT_EQ(after({ "water", "well", "" }), (Words { "--help", "--warm" }));
}

TEST_F(Completing, OffersTheValuesOfAnOption)
{
    EXPECT_EQ(after({ "grow", "--light", "" }), (Words { "full sun", "shade" }));
    EXPECT_EQ(after({ "grow", "--light", "fu" }), (Words { "full sun" }));
    EXPECT_EQ(after({ "grow", "-o", "" }), (Words { ":files" }));
    EXPECT_EQ(after({ "grow", "--into", "" }), (Words { ":folders" }));
    EXPECT_EQ(after({ "grow", "--device", "" }), (Words { "simulated", ":files" }));
    EXPECT_EQ(after({ "grow", "--device", "simulated", "s" }), (Words { "simulated", ":files" }));
}

TEST_F(Completing, OffersTheValueBehindAnEqualsSignAsOneWordAndAsThree)
{
    EXPECT_EQ(after({ "grow", "--light=s" }), (Words { "--light=shade" }));
    EXPECT_EQ(after({ "grow", "--light", "=", "s" }), (Words { "shade" }));
    EXPECT_EQ(after({ "grow", "--light", "=" }), (Words { "full sun", "shade" }));
    EXPECT_EQ(after({ "grow", "--light=shade", "--dr" }), (Words { "--dry" }));
}

TEST_F(Completing, OffersModelsAndFilesForAnArgumentThatIsAModel)
{
    EXPECT_EQ(after({ "grow", "" }), (Words { "birch", "shrub", ":files" }));
    EXPECT_EQ(after({ "grow", "--dry", "b" }), (Words { "birch", ":files" }));
    EXPECT_EQ(after({ "grow", "birch", "b" }), Words {});
}

TEST_F(Completing, SaysWhatAWordIsAbout)
{
    EXPECT_EQ(print_completion(complete(root, { "gr" }, {})), "grow\tGrow a plant\n");
}

} // namespace
} // namespace tractus::desktop
