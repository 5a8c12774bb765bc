#include "engine/lsystem/derivation/derive.h"
#include "engine/lsystem/fast_drawing/interpret.h"
#include "engine/lsystem/language/print.h"
#include "engine/lsystem/rewriting/homomorphism.h"
#include "tests/corpus.h"
#include "tests/engine/lsystem/corpus_model.h"
#include "tests/engine/lsystem/sha256.h"
#include "tests/file_bytes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

namespace tractus::lsystem {
namespace {

nlohmann::json read_json(std::filesystem::path const& path)
{
    return nlohmann::json::parse(file_bytes(path));
}

std::string without_blanks(std::string text)
{
    std::erase_if(text, [](unsigned char c) { return std::isspace(c); });
    return text;
}

// Compares strings; numbers in parentheses may differ by 1e-5 of their value.
::testing::AssertionResult same_strings(std::string const& found, std::string const& expected)
{
    std::size_t i = 0;
    std::size_t k = 0;
    bool in_parentheses = false;
    while (i < found.size() && k < expected.size()) {
        bool const is_number = in_parentheses && found[i] != ',' && found[i] != ')';
        if (is_number) {
            std::size_t found_length = 0;
            std::size_t expected_length = 0;
            double const a = std::stod(found.substr(i, 40), &found_length);
            double const b = std::stod(expected.substr(k, 40), &expected_length);
            if (std::fabs(a - b) > 1e-5 * std::fabs(b))
                return ::testing::AssertionFailure()
                    << "at " << i << ": " << a << ", expected " << b;
            i += found_length;
            k += expected_length;
            continue;
        }
        if (found[i] != expected[k])
            return ::testing::AssertionFailure() << "at " << i << ": ..." << found.substr(i, 60)
                                                 << "\nexpected ..." << expected.substr(k, 60);
        in_parentheses = found[i] == '(' || (in_parentheses && found[i] != ')');
        ++i;
        ++k;
    }
    if (i != found.size() || k != expected.size())
        return ::testing::AssertionFailure()
            << "lengths " << found.size() << " and " << expected.size();
    return ::testing::AssertionSuccess();
}

// Parameter: the folder of a published model, for which the result of cpfg is known.
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

// Compiles a model without the files that it refers to.
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
    // The reference for this model was drawn without its functions, which are in a separate file.
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
    // Models that draw random numbers, which have separate tests below.
    EXPECT_EQ(left,
              std::set<std::string>(
                  { "10-manuals__11-CPFG__RandomMoss", "10-manuals__11-CPFG__WeepingBirch" }));
}

// Compiles one of two models whose random numbers differ from cpfg's, so only what does not depend
// on chance is compared.
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
        // Each branch has one !, one comma and one turn; each step replaces an F by 3 or 5.
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
    // Internodes are conserved until leaves begin: A(n) becomes one F and two A that share n - 1.
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
    // The result of cpfg has 162,254 modules.
    EXPECT_NEAR(static_cast<double>(string->size()), 162254, 10000);
}

// Parameter: a classical L-system with known counts and hashes after some numbers of steps.
class CountedSystem : public ::testing::TestWithParam<std::string> { };

// Compares non-parametric strings by hash, short parametric ones in full, and long ones by the sum
// of F.
void compare_strings(Model const& model, ModuleString const& string, nlohmann::json const& expected)
{
    auto text = to_string(model, string);
    if (expected.contains("sha256")) {
        EXPECT_EQ(sha256(text), expected["sha256"].get<std::string>());
    }
    if (expected.contains("string")) {
        std::erase(text, '@');
        std::replace(text.begin(), text.end(), 'v', '$');
        EXPECT_TRUE(same_strings(text, expected["string"].get<std::string>()));
    }
    if (expected.contains("sum_F_length")) {
        double sum = 0;
        std::size_t parameter = 0;
        for (auto const id : string.kinds.span()) {
            auto const& kind = model.alphabet[id];
            if (kind.symbol == 'F')
                sum += static_cast<double>(string.parameters[parameter]);
            parameter += kind.parameter_count;
        }
        auto const wanted = expected["sum_F_length"].get<double>();
        EXPECT_NEAR(sum, wanted, 1e-5 * wanted);
    }
}

// Compares the numbers of segments and polygons that the turtle draws of a string.
void compare_drawing(Model const& model, ModuleString const& string, nlohmann::json const& expected)
{
    if (!expected.contains("segments"))
        return;
    auto const plant = interpret(model, string);
    ASSERT_TRUE(plant) << plant.error().message;
    EXPECT_EQ(plant->segment_count(), expected["segments"].get<std::size_t>());
    EXPECT_EQ(plant->polygons.size(), expected["polygons"].get<std::size_t>());
}

TEST_P(CountedSystem, HasTheExactCountsAndString)
{
    auto const folder = shipped("lsystem_counts");
    auto const model = compile_file(folder / (GetParam() + ".l"));
    ASSERT_TRUE(model) << model.error().message;
    int compared = 0;
    auto const counted = read_json(folder / "counts.json");
    for (auto const& system : counted["systems"]) {
        if (system["id"] != GetParam())
            continue;
        for (auto const& [steps, expected] : system["after_n_steps"].items()) {
            auto const string = derive(*model, { .steps = std::stoi(steps), .seed = 1 });
            ASSERT_TRUE(string) << string.error().message;
            auto const counts = count_symbols(*model, *string);
            std::size_t modules = 0;
            for (auto const& [symbol, count] : counts) {
                modules += count;
                auto const name = symbol == "@v" ? "$" : symbol;
                EXPECT_EQ(count, expected["counts"].value(name, std::size_t { 0 }))
                    << symbol << " after " << steps;
            }
            EXPECT_EQ(modules, expected["modules"].get<std::size_t>()) << steps;
            compare_strings(*model, *string, expected);
            compare_drawing(*model, *string, expected);
            ++compared;
        }
    }
    EXPECT_GE(compared, 4);
}

std::vector<std::string> const kCountedSystems { "algae",
                                                 "koch_island",
                                                 "koch_island_17a",
                                                 "quad_snowflake_17b",
                                                 "koch_19b",
                                                 "koch_19d",
                                                 "koch_19f",
                                                 "gosper_quad",
                                                 "hilbert3d",
                                                 "peano",
                                                 "koch_snowflake",
                                                 "levy_c",
                                                 "bush_124b",
                                                 "bush_124d",
                                                 "bush_124f",
                                                 "bush3d_125",
                                                 "signal_acropetal",
                                                 "hogeweg_131b",
                                                 "hogeweg_131e",
                                                 "parametric_134",
                                                 "row_of_trees",
                                                 "row_of_trees_inc",
                                                 "sympodial_27a",
                                                 "anabaena_14",
                                                 "koch_islands_18",
                                                 "koch_19a",
                                                 "koch_19c",
                                                 "koch_19e",
                                                 "dragon_110a",
                                                 "sierpinski_110b",
                                                 "gosper_hex_111a",
                                                 "dragon_nodes",
                                                 "hilbert",
                                                 "fass_117a",
                                                 "fass_117b",
                                                 "bush_124a",
                                                 "bush_124c",
                                                 "bush_124e",
                                                 "flowering_126",
                                                 "signal_string",
                                                 "signal_basipetal",
                                                 "hogeweg_131a",
                                                 "hogeweg_131c",
                                                 "hogeweg_131d",
                                                 "row_of_trees_137b",
                                                 "anabaena_1102",
                                                 "monopodial_26a",
                                                 "ternary_28a",
                                                 "crocus",
                                                 "lychnis",
                                                 "capsella",
                                                 "mycelis",
                                                 "sunflower_41",
                                                 "cylinder_48",
                                                 "fern_53",
                                                 "lily_54",
                                                 "cordate_55",
                                                 "leaf_56b",
                                                 "rose_leaf_58",
                                                 "compound_511b",
                                                 "compound_512b" };

INSTANTIATE_TEST_SUITE_P(All, CountedSystem, ::testing::ValuesIn(kCountedSystems),
                         [](auto const& tested) { return tested.param; });

// Checks a linear relation between the numbers of symbols: coefficients by symbol, and the constant
// that the sum must equal.
void check_relation(std::map<std::string, std::size_t> const& counts,
                    nlohmann::json const& relation)
{
    long long sum = 0;
    for (auto const& [symbol, coefficient] : relation["coefficients"].items()) {
        auto const found = counts.find(symbol);
        if (found != counts.end())
            sum += coefficient.get<long long>() * static_cast<long long>(found->second);
    }
    EXPECT_EQ(sum, relation["sum"].get<long long>()) << relation.dump();
}

TEST(StochasticSystems, KeepTheirRelationsWhateverTheSeed)
{
    auto const folder = shipped("lsystem_counts");
    auto const listed = read_json(folder / "counts.json");
    ASSERT_FALSE(listed["stochastic"].empty());
    for (auto const& system : listed["stochastic"]) {
        auto const id = system["id"].get<std::string>();
        auto const model = compile_file(folder / (id + ".l"));
        ASSERT_TRUE(model) << id << ": " << model.error().message;
        std::set<std::string> strings;
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            SCOPED_TRACE(id + ", seed " + std::to_string(seed));
            auto const string = derive(*model, { .steps = 3, .seed = seed });
            ASSERT_TRUE(string) << string.error().message;
            auto const counts = count_symbols(*model, *string);
            for (auto const& relation : system["relations"])
                check_relation(counts, relation);
            strings.insert(to_string(*model, *string));
        }
        EXPECT_GT(strings.size(), 10u) << id;
    }
}

TEST(CountedSystems, AreAllCompared)
{
    std::set<std::string> left;
    auto const counted = read_json(shipped("lsystem_counts") / "counts.json");
    for (auto const& system : counted["systems"])
        left.insert(system["id"].get<std::string>());
    for (auto const& name : kCountedSystems)
        EXPECT_EQ(left.erase(name), 1u) << name;
    EXPECT_TRUE(left.empty()) << *left.begin();
}

} // namespace
} // namespace tractus::lsystem
