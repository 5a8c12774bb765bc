#include "engine/lsystem/rewriting/homomorphism.h"
#include "tests/engine/lsystem/small_model.h"

#include <atomic>
#include <fstream>
#include <gtest/gtest.h>
#include <string>

namespace tractus::lsystem {
namespace {

// Returns a time limit that counts as exceeded when it is asked for the third time, so that no test
// depends on a clock.
TimeLimit soon()
{
    // Number of queries, which the copies of the function share.
    auto const asked = std::make_shared<std::atomic<int>>(0);
    return { [asked] { return ++*asked >= 3; }, 60 };
}

std::string error_of(std::string const& axiom_and_rules, DeriveOptions const& options,
                     int steps = 1)
{
    auto const string = derive(compiled(with_header(axiom_and_rules, steps)), options);
    if (string)
        return "no error";
    EXPECT_EQ(string.error().fault, Fault::User);
    return string.error().message;
}

std::string error_of_time(std::string const& axiom_and_rules, int steps = 1)
{
    DeriveOptions options;
    options.limits.time = soon();
    return error_of(axiom_and_rules, options, steps);
}

TEST(TimeLimit, EndsLoopsInRulesAndBlocks)
{
    auto const message = [](char const* where) {
        return "model.l: " + std::string(where)
            + " was not done when 60 s had passed; derive fewer steps, or raise the limit of time";
    };
    EXPECT_EQ(error_of_time("Axiom: A\nA : {x=1; while (x) {x=1;}} 1 --> B"), message("step 1"));
    EXPECT_EQ(error_of_time("Start: {x=1; do {x=1;} while (x);}\nAxiom: A"), message("the start"));
    EXPECT_EQ(error_of_time("EndEach: {x=1; while (x) {x=1;}}\nAxiom: A", 5), message("step 1"));
    // Each loop is short. Only the sum of all loops exceeds the limit.
    EXPECT_EQ(error_of_time("Axiom: A(30)\ndecomposition\nmaximum depth: 100\n"
                            "A(n) : {i=0; while (i<1000) {i=i+1;}} n>0 --> A(n-1)A(n-1)"),
              message("step 1"));
}

TEST(TimeLimit, EndsRulesThatLeaveNothing)
{
    EXPECT_EQ(error_of_time("Axiom: A(60)\ndecomposition\nmaximum depth: 100\n"
                            "A(n) : n>0 --> A(n-1)A(n-1)\nA(n) --> *"),
              "model.l: step 1 was not done when 60 s had passed; derive fewer steps, or raise "
              "the limit of time");
    auto const model = compiled(with_header("Axiom: A(60)\nhomomorphism\nmaximum depth: 100\n"
                                            "A(n) : n>0 --> A(n-1)A(n-1)\nA(n) --> *"));
    auto const drawn_string = apply_homomorphism(model, *derive(model), { {}, soon() });
    ASSERT_FALSE(drawn_string);
    EXPECT_EQ(drawn_string.error().message,
              "model.l: the homomorphism was not done when 60 s had passed; derive fewer steps, "
              "or raise the limit of time");
}

TEST(TimeLimit, EndsAModelThatOnlyTakesManySteps)
{
    EXPECT_NE(error_of_time("Axiom: A\nA --> B\nB --> A", 1'000'000'000).find("was not done"),
              std::string::npos);
    EXPECT_NE(error_of_time("Axiom: A\nA : {x=Q;} 1 --> A", 1'000'000'000).find("was not done"),
              std::string::npos);
    EXPECT_NE(error_of_time("Axiom: AB\nA > B --> A", 1'000'000'000).find("was not done"),
              std::string::npos);
}

TEST(TimeLimit, EndsParallelAndSubLSystemsToo)
{
    std::string const loop = "{i=0; while (i<100) {i=i+1;}} 1 --> A(i)A(i)";
    EXPECT_NE(error_of_time("Axiom: A(0)\nA(x) : " + loop, 25).find("was not done"),
              std::string::npos);
    DeriveOptions options;
    options.limits.time = soon();
    auto const model = compiled(with_header("Axiom: ?(2)A$")
                                + "Lsystem: 2\nA : {x=1; while (x) {x=1;}} 1 --> B\nendlsystem\n");
    auto const string = derive(model, options);
    ASSERT_FALSE(string);
    EXPECT_NE(string.error().message.find("step 1 was not done"), std::string::npos);
}

TEST(MemoryLimit, NamesTheStepThatNeedsMore)
{
    DeriveOptions options;
    options.limits.max_memory_bytes = std::size_t { 8 } << 20;
    auto const needs_more = [&](std::string const& rules) {
        auto const message = error_of(rules, options, 60);
        return message.find("needs more than 8 MB of memory") != std::string::npos
            && message.find("model.l: step ") == 0;
    };
    EXPECT_TRUE(needs_more("Axiom: F\nF --> FF"));
    EXPECT_TRUE(needs_more("Axiom: F(1,2,3)\nF(x,y,z) --> F(y,z,x)F(z,x,y)"));
    EXPECT_TRUE(needs_more("Axiom: F(1)\nF(x) : x>0 --> F(x+1)F(x)"));
    EXPECT_TRUE(needs_more("Axiom: AF\nA < F --> FF\nF --> FF"));
    EXPECT_TRUE(needs_more("Axiom: F(1)\nF(x) --> F(x)\ndecomposition\nF(x) --> F(x)F(x)"));
    EXPECT_TRUE(needs_more("Start: {n=0;}\nAxiom: F(1)\nF(x) : {n=n+1;} 1 --> F(n)F(n)"));
}

TEST(MemoryLimit, StopsOneModuleThatBecomesMany)
{
    DeriveOptions options;
    options.limits.max_memory_bytes = std::size_t { 8 } << 20;
    EXPECT_EQ(error_of("Axiom: A(50)\ndecomposition\nmaximum depth: 100\n"
                       "A(n) : n>0 --> A(n-1)A(n-1)",
                       options),
              "model.l: step 1 needs more than 8 MB of memory; derive fewer steps or raise the "
              "limit of memory");
}

// A limit must stop endless recursion of homomorphism rules within a single module.
TEST(DrawingLimits, HoldWithinOneModule)
{
    auto const model = compiled(with_header("Axiom: A\nhomomorphism\nmaximum depth: 100000\n"
                                            "A --> F A A",
                                            0));
    auto const string = derive(model);
    ASSERT_TRUE(string);
    auto const message = [&](TurtleOptions const& options) {
        auto const plant = interpret(model, *string, options);
        return plant ? std::string("no error") : plant.error().message;
    };
    EXPECT_EQ(message({ .max_modules = 100'000 }),
              "model.l: the homomorphism makes more than 100000 modules; derive fewer steps or "
              "raise the limit");
    EXPECT_EQ(message({ .max_parts = 50'000 }),
              "model.l: the plant has more than 50000 segments, organs and polygons; derive fewer "
              "steps");
    EXPECT_EQ(message({ .max_memory_bytes = std::size_t { 8 } << 20 }),
              "model.l: the plant needs more than 8 MB; derive fewer steps or raise the limit of "
              "memory");
    EXPECT_EQ(message({ .time = soon() }),
              "model.l: the homomorphism was not done when 60 s had passed; derive fewer steps, or "
              "raise the limit of time");
}

// Returns the value of a line in /proc/self/status in bytes; 0 if it cannot be read.
std::size_t status_bytes(std::string const& key)
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.compare(0, key.size(), key) == 0)
            return std::stoul(line.substr(key.size())) << 10;
    return 0;
}

// All memory used for drawing must count, including arrays that grow by copying.
TEST(DrawingLimits, HoldForTheMemoryOfTheProcess)
{
    constexpr std::size_t kLimit = std::size_t { 160 } << 20;
    auto const model = compiled(with_header("Axiom: A\nhomomorphism\nmaximum depth: 100000\n"
                                            "A --> F A A",
                                            0));
    auto const string = derive(model);
    ASSERT_TRUE(string);
    // Resets the peak memory of this process.
    std::ofstream("/proc/self/clear_refs") << 5 << std::flush;
    auto const before = status_bytes("VmRSS:");
    if (before == 0 || status_bytes("VmHWM:") > before + (before >> 4) + (kLimit >> 4))
        GTEST_SKIP() << "the system does not tell the peak of the memory from here on";
    auto const plant
        = interpret(model, *string, { .max_parts = 1'000'000'000, .max_memory_bytes = kLimit });
    ASSERT_FALSE(plant);
    EXPECT_NE(plant.error().message.find("needs more than 160 MB"), std::string::npos);
    EXPECT_LE(status_bytes("VmHWM:"), before + kLimit + (kLimit >> 3));
    // Drawing must not end long before the limit: at least a quarter of it must be used.
    EXPECT_GE(status_bytes("VmHWM:"), before + (kLimit >> 2));
}

TEST(DrawingLimits, HoldForWhatIsPlanned)
{
    auto const model = compiled(with_header("Axiom: F\nF --> FF", 18));
    auto const string = derive(model);
    ASSERT_TRUE(string);
    EXPECT_TRUE(interpret(model, *string, {}));
    auto const plant = interpret(model, *string, { .max_memory_bytes = std::size_t { 2 } << 20 });
    ASSERT_FALSE(plant);
    EXPECT_NE(plant.error().message.find("needs more than 2 MB"), std::string::npos);
}

// The rules produce no new modules, so only the memory of the rules themselves counts.
TEST(MemoryLimit, CountsRulesThatRewriteEachOthersModules)
{
    DeriveOptions options;
    options.limits.max_memory_bytes = std::size_t { 8 } << 20;
    std::string const wide(1000, 'C');
    EXPECT_EQ(error_of("Axiom: A(1)\ndecomposition\nmaximum depth: 1000000\nA(n) --> A(n+1)" + wide,
                       options),
              "model.l: in step 1 rules that rewrite each other's modules need more than 8 MB; "
              "lower the maximum depth, or raise the limit of memory");
    auto const model = compiled(
        with_header("Axiom: A\nhomomorphism\nmaximum depth: 1000000\nA --> A" + wide, 0));
    auto const plant
        = interpret(model, *derive(model), { .max_memory_bytes = std::size_t { 8 } << 20 });
    ASSERT_FALSE(plant);
    EXPECT_NE(plant.error().message.find("need more than 8 MB"), std::string::npos);
}

} // namespace
} // namespace tractus::lsystem
