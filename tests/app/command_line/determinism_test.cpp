#include "tests/app/command_line/workshop.h"

namespace tractus {
namespace {

using Determinism = Workshop;

TEST_F(Determinism, TheHandDrawsTheSameTwice)
{
    record();
    auto const first = read("hand.tractus-log");
    run("rm hand.tractus-log");
    record();
    EXPECT_GT(first.size(), 10'000u);
    EXPECT_EQ(read("hand.tractus-log"), first);
}

TEST_F(Determinism, AReplayDependsOnItsSeedAlone)
{
    record();
    auto const replay = [&](std::string const& folder, std::string const& seed,
                            std::string const& before = "") {
        auto const outcome = run(
            before + " '" TRACTUS_PROGRAM "' replay hand.tractus-log --plant small.l --count 2 -o "
            + folder + " --seed " + seed);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return read(folder + "/collection.glb");
    };
    auto const first = replay("a", "5");
    EXPECT_GT(first.size(), 1'000u);
    EXPECT_EQ(replay("b", "5"), first);
    EXPECT_EQ(replay("c", "5", "taskset -c 0"), first) << "on one processor";
    EXPECT_EQ(read("a/varied.png"), read("b/varied.png"));
    EXPECT_NE(replay("d", "6"), first);
}

TEST_F(Determinism, GrowingGivesTheSameFilesTwice)
{
    for (std::string const ending : { "glb", "obj", "png" }) {
        run("mkdir -p all one");
        run("tractus grow shrub --seed 4 -n 3 -o all/tree." + ending);
        run("taskset -c 0 '" TRACTUS_PROGRAM "' grow shrub --seed 4 -n 3 -o one/tree." + ending);
        EXPECT_FALSE(read("all/tree." + ending).empty());
        EXPECT_TRUE(read("all/tree." + ending) == read("one/tree." + ending)) << ending;
    }
}

} // namespace
} // namespace tractus
