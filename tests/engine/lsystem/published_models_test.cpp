#include "engine/lsystem/derivation/derive.h"
#include "engine/lsystem/fast_drawing/interpret.h"
#include "engine/lsystem/language/print.h"
#include "engine/lsystem/rewriting/homomorphism.h"
#include "tests/corpus.h"
#include "tests/engine/lsystem/corpus_model.h"
#include "tests/engine/lsystem/corpus_strings.h"
#include "tests/engine/lsystem/sha256.h"

#include <set>
#include <vector>

namespace tractus::lsystem {
namespace {

// The parameter is the folder of a published model for which the result of cpfg is known.
class PublishedModel : public ::testing::TestWithParam<std::string> { };

nlohmann::json entry_of(std::string const& folder)
{
    for (auto const& entry : read_json(corpus() / "lsystems" / "index.json"))
        if (entry["saved"] == folder)
            return entry;
    return {};
}

Result<Model> compile_entry(nlohmann::json const& entry)
{
    auto const folder = corpus() / "lsystems" / entry["saved"].get<std::string>();
    auto const name = std::filesystem::path(entry["path"].get<std::string>()).filename();
    return compile_file(folder / name,
                        entry["view"].is_string() ? entry["view"].get<std::string>() : "");
}

// Compiles a model without the files to which it refers.
Result<Model> compile_alone(nlohmann::json const& entry)
{
    auto const folder = corpus() / "lsystems" / entry["saved"].get<std::string>();
    ModelSource source;
    source.text
        = file_bytes(folder / std::filesystem::path(entry["path"].get<std::string>()).filename());
    return compile_model(source);
}

TEST_P(PublishedModel, GivesTheStringThatCpfgGives)
{
    REQUIRE_CORPUS();
    auto const entry = entry_of(GetParam());
    auto const model = compile_entry(entry);
    ASSERT_TRUE(model) << model.error().message;
    auto const string = derive(*model);
    ASSERT_TRUE(string) << string.error().message;
    auto const name
        = std::filesystem::path(entry["path"].get<std::string>()).stem().string() + ".expected.str";
    auto const expected = without_blanks(file_bytes(corpus() / "lsystems" / GetParam() / name));
    EXPECT_TRUE(same_strings(to_string(*model, *string), expected));
}

TEST_P(PublishedModel, DrawsWhatCpfgDraws)
{
    REQUIRE_CORPUS();
    auto const entry = entry_of(GetParam());
    // The reference for this model was drawn without its functions, which are in a file of their
    // own.
    auto const model = GetParam() == "10-manuals__11-CPFG__JumpingLamp" ? compile_alone(entry)
                                                                        : compile_entry(entry);
    ASSERT_TRUE(model) << model.error().message;
    auto const string = derive(*model);
    ASSERT_TRUE(string) << string.error().message;
    auto const drawn = apply_homomorphism(*model, *string);
    ASSERT_TRUE(drawn) << drawn.error().message;
    auto const counts = count_symbols(*model, *drawn);
    auto const segments = counts.find("F");
    EXPECT_EQ(segments == counts.end() ? 0 : segments->second,
              entry["homo"]["F"].get<std::size_t>());
    EXPECT_EQ(sha256(to_string(*model, *drawn)), entry["homo"]["sha256"].get<std::string>());
}

TEST_P(PublishedModel, BecomesASoundPlant)
{
    REQUIRE_CORPUS();
    auto const model = compile_entry(entry_of(GetParam()));
    ASSERT_TRUE(model) << model.error().message;
    auto const string = derive(*model);
    ASSERT_TRUE(string) << string.error().message;
    auto const plant = interpret(*model, *string);
    ASSERT_TRUE(plant) << plant.error().message;
    check_plant(*plant);
}

std::vector<std::string> published_models()
{
    return { "10-manuals__11-CPFG__BackgroundScene",
             "10-manuals__11-CPFG__ConcavePolygons",
             "10-manuals__11-CPFG__GeneralizedCylinder",
             "10-manuals__11-CPFG__JumpingLamp",
             "10-manuals__11-CPFG__Ring",
             "10-manuals__11-CPFG__Shedding",
             "10-manuals__11-CPFG__Tropisms",
             "11-CPFG__01-Introduction__01-quadratic-Koch",
             "11-CPFG__01-Introduction__02-snowflake-exercise",
             "11-CPFG__01-Introduction__04-compound",
             "11-CPFG__01-Introduction__07-fractal-ferns",
             "11-CPFG__01-Introduction__08-continuous-time",
             "11-CPFG__02-Mod-vis-3D__01-planation",
             "11-CPFG__02-Mod-vis-3D__02-decussate",
             "11-CPFG__02-Mod-vis-3D__06-comp-leaf-perspective",
             "11-CPFG__02-Mod-vis-3D__09-monopodial-spiral",
             "11-CPFG__04-Signaling__02-hormone-down",
             "11-CPFG__04-Signaling__03-signal-down",
             "11-CPFG__04-Signaling__04-florigen",
             "11-CPFG__04-Signaling__05-florigen-param",
             "11-CPFG__04-Signaling__10-mycelis-realistic",
             "11-CPFG__04-Signaling__13-mesotonic-1-signal" };
}

INSTANTIATE_TEST_SUITE_P(All, PublishedModel, ::testing::ValuesIn(published_models()),
                         [](auto const& tested) {
                             auto name = tested.param.substr(tested.param.rfind("__") + 2);
                             std::erase_if(name, [](unsigned char c) { return !std::isalnum(c); });
                             return name;
                         });

TEST(PublishedModels, AreAllComparedWithCpfg)
{
    REQUIRE_CORPUS();
    std::set<std::string> left;
    for (auto const& entry : read_json(corpus() / "lsystems" / "index.json"))
        left.insert(entry["saved"].get<std::string>());
    for (auto const& name : published_models())
        EXPECT_EQ(left.erase(name), 1u) << name;
    // The models left out draw random numbers. They have tests of their own below.
    EXPECT_EQ(left,
              std::set<std::string>(
                  { "10-manuals__11-CPFG__RandomMoss", "10-manuals__11-CPFG__WeepingBirch" }));
}

// Compiles one of two models that draw random numbers. The numbers of cpfg are different, so only
// results that do not depend on chance are compared.
Result<Model> compile_random(std::string const& folder, std::string const& name)
{
    return compile_file(corpus() / "lsystems" / folder / name);
}

TEST(RandomMoss, HasTheLanguageOfItsRules)
{
    REQUIRE_CORPUS();
    auto const model = compile_random("10-manuals__11-CPFG__RandomMoss", "plant.l");
    ASSERT_TRUE(model) << model.error().message;
    std::set<std::string> strings;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        auto const string = derive(*model, { .steps = {}, .seed = seed });
        ASSERT_TRUE(string) << string.error().message;
        auto const counts = count_symbols(*model, *string);
        // Each branch has one !, one comma and one turn. Each step replaces an F by three or five.
        EXPECT_EQ(counts.at("["), counts.at("]"));
        EXPECT_EQ(counts.at("["), counts.at("!"));
        EXPECT_EQ(counts.at("["), counts.at(","));
        EXPECT_EQ(counts.at("["), counts.at("+") + counts.at("-"));
        EXPECT_EQ(counts.at("F"), 1 + 2 * counts.at("["));
        EXPECT_GT(counts.at("F"), 243u);
        EXPECT_LT(counts.at("F"), 3125u);
        strings.insert(to_string(*model, *string));
    }
    EXPECT_EQ(strings.size(), 20u);
}

TEST(WeepingBirch, ConservesItsInternodes)
{
    REQUIRE_CORPUS();
    auto const model = compile_random("10-manuals__11-CPFG__WeepingBirch", "fractal.l");
    ASSERT_TRUE(model) << model.error().message;
    // The number of internodes to come is conserved until leaves begin: A(n) becomes one F, and two
    // A that share n - 1.
    for (int steps = 0; steps <= 5; ++steps) {
        auto const string = derive(*model, { .steps = steps, .seed = 1 });
        ASSERT_TRUE(string) << string.error().message;
        double total = 0;
        std::size_t parameter = 0;
        for (auto const id : string->kinds.span()) {
            auto const& kind = model->alphabet[id];
            if (kind.symbol == 'A')
                total += static_cast<double>(string->parameters[parameter]);
            total += kind.symbol == 'F';
            parameter += kind.parameter_count;
        }
        EXPECT_EQ(total, 22500) << steps;
    }
    auto const string = derive(*model);
    ASSERT_TRUE(string) << string.error().message;
    // The string derived by cpfg has 162,254 modules.
    EXPECT_NEAR(static_cast<double>(string->size()), 162254, 10000);
}

// In cpfg's models, warnings about the habits of other notations, or about chance without a seed,
// would be wrong.
TEST_P(PublishedModel, IsNotTakenForAnotherNotation)
{
    REQUIRE_CORPUS();
    auto const model = compile_entry(entry_of(GetParam()));
    ASSERT_TRUE(model) << model.error().message;
    for (auto const& warning : model->warnings)
        for (auto const* const sign : { "no effect", "is read as", "begins a comment", "seed" })
            EXPECT_EQ(warning.find(sign), std::string::npos) << warning;
}

} // namespace
} // namespace tractus::lsystem
