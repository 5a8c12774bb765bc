// Compares trees grown with each growth habit with measurements by foresters.

#include "app/methods/self_organising/habit_file.h"
#include "app/methods/self_organising/habit_text.h"
#include "engine/methods/self_organising/life.h"
#include "engine/methods/self_organising/tree_plant.h"
#include "engine/plant/tree_measures.h"
#include "tests/app/commands/outcome.h"
#include "tests/file_bytes.h"

#include <cstdint>
#include <filesystem>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

namespace tractus::self_organising {
namespace {

struct Range {
    double least = 0;
    double most = 0;
};

// Known ranges for old trees of one habit, where these are narrower than for trees in general.
struct Known {
    Range slenderness { 20, 110 };
    Range crown_width { 0.14, 1.3 }; // Width of the crown as a share of the tree's height.
    Range crown_length { 0.6, 1 };   // Length of the crown as a share of the tree's height.
    Range height_m { 6, 26 };
};

Known known_of(std::string const& name)
{
    static std::map<std::string, Known> const known {
        { "oak", { { 20, 35 }, { 0.7, 1.1 }, { 0.7, 1 }, { 14, 22 } } },
        { "spruce", { { 50, 90 }, { 0.3, 0.5 }, { 0.7, 1 }, { 16, 26 } } },
        { "fir", { { 50, 90 }, { 0.3, 0.5 }, { 0.7, 1 }, { 16, 26 } } },
        { "pine", { { 50, 90 }, { 0.3, 0.9 }, { 0.4, 0.8 }, { 14, 24 } } },
        { "larch", { { 50, 90 }, { 0.3, 0.8 }, { 0.6, 1 }, { 16, 26 } } },
        { "poplar", { { 20, 110 }, { 0.05, 0.2 }, { 0.7, 1 }, { 16, 30 } } },
        { "apple", { { 20, 110 }, { 0.8, 1.4 }, { 0.6, 1 }, { 4, 10 } } },
    };
    auto const found = known.find(name);
    return found == known.end() ? Known {} : found->second;
}

// Slenderness after 20 years: trees grown in the open are stout, as is a plane; all others are
// as slender as trees of a young forest.
Range slenderness_at_20(std::string const& name)
{
    return name == "oak" || name == "plane" || name == "willow" || name == "apple"
        ? Range { 30, 75 }
        : Range { 50, 90 };
}

void expect_within(double value, Range const& range, char const* what)
{
    EXPECT_GE(value, range.least) << what;
    EXPECT_LE(value, range.most) << what;
}

double leaf_area_index(Plant const& plant, Habit const& habit, TreeMeasures const& measures)
{
    double const blade_m2 = 0.65 * (habit.leaf_mm - habit.petiole_mm) * habit.leaf_width_mm * 1e-6;
    double const width_m = measures.crown_width_mm / 1000;
    return static_cast<double>(plant.organs.size()) * blade_m2 / (kPi / 4 * width_m * width_m);
}

void expect_old_tree(Plant const& plant, Habit const& habit)
{
    auto const measures = measure_tree(plant);
    auto const known = known_of(habit.name);
    expect_within(measures.height_mm / 1000, known.height_m, "height");
    expect_within(measures.slenderness, known.slenderness, "slenderness");
    expect_within(measures.crown_width_mm / measures.height_mm, known.crown_width, "crown width");
    expect_within(1 - measures.crown_base_mm / measures.height_mm, known.crown_length,
                  "crown length");
    expect_within(measures.strahler, { 6, 10 }, "Strahler's order");
    expect_within(measures.length_ratio, { 1.3, 3.5 }, "length ratio");
    if (habit.leaf_is_needle == 0)
        expect_within(leaf_area_index(plant, habit, measures), { 1.5, 6.5 }, "leaf area index");
}

TEST(Habits, GrowTreesOfTheirKind)
{
    auto const names = habit_names();
    ASSERT_EQ(names.size(), 16U);
    for (auto const& name : names) {
        auto const habit = load_habit(name).value();
        EXPECT_FALSE(habit.latin.empty()) << name;
        auto tree = plant_seed(Vec3::Zero());
        Surroundings surroundings;
        for (int year = 1; year <= 40; ++year) {
            ASSERT_TRUE(grow_year(tree, surroundings, habit)) << name;
            if (year != 10 && year != 20 && year != 40)
                continue;
            SCOPED_TRACE(name + ", " + std::to_string(year) + " years");
            auto const plant = plant_of(tree, habit, 1).plant;
            check_plant(plant);
            auto const measures = measure_tree(plant);
            // In young trees the rings hide the pipe model, which the wood below them follows.
            auto without_rings = habit;
            without_rings.ring_mm = 0;
            auto const piped = year == 40 ? plant : plant_of(tree, without_rings, 1).plant;
            expect_within(measure_tree(piped).pipe_exponent, { 1.8, 2.5 }, "pipe exponent");
            // Young trees have few branching orders, so their bifurcation ratio may be smaller,
            // or larger where whorls leave one long trunk.
            auto const least = year == 10 ? 2.3 : 2.6;
            auto const most = year < 40 && habit.whorl > 0 ? 8.5 : 7.2;
            expect_within(measures.bifurcation_ratio, { least, most }, "bifurcation ratio");
            EXPECT_GE(bounds(plant).min_mm.z(), -0.1 * measures.height_mm);
            if (year == 20)
                expect_within(measures.slenderness, slenderness_at_20(name), "slenderness");
            if (year == 40)
                expect_old_tree(plant, habit);
        }
    }
}

TEST(Habits, AnOakBearsAsManyLeavesAsOaksDo)
{
    auto const habit = load_habit("oak").value();
    auto const plant = plant_of(grow_without_brush(habit, 40, 1).value(), habit, 1).plant;
    expect_within(static_cast<double>(plant.organs.size()), { 100'000, 300'000 }, "leaves");
}

// Bark of each segment of the trunk from the ground on, of all but twigs.
std::vector<Bark> barks_of_trunk(Plant const& plant)
{
    std::vector<Bark> barks;
    auto const& trunk = plant.axes.front();
    for (auto i = trunk.first_segment; i < trunk.first_segment + trunk.segment_count; ++i) {
        auto const& material = plant.materials[plant.segment_material[i]];
        if (material.name != "twig")
            barks.push_back(material.bark);
    }
    return barks;
}

TEST(Habits, HaveTheBarkOfTheirKindWhichAgesWithTheGirth)
{
    for (auto const& name : habit_names()) {
        auto const habit = load_habit(name).value();
        EXPECT_EQ(habit.bark, name);
        auto const kind = bark_kind(habit.bark);
        ASSERT_TRUE(kind) << name;
        auto const young
            = barks_of_trunk(plant_of(grow_without_brush(habit, 6, 1).value(), habit, 1).plant);
        ASSERT_FALSE(young.empty()) << name;
        EXPECT_EQ(young.back(), (Bark { *kind, BarkAge::Young })) << name;
        auto const old
            = barks_of_trunk(plant_of(grow_without_brush(habit, 40, 1).value(), habit, 1).plant);
        EXPECT_EQ(old.front(), (Bark { *kind, BarkAge::Old })) << name;
        // Below the twigs at its end; an apple's are stout.
        EXPECT_NE(old.back().age, BarkAge::Old) << name;
        for (std::size_t i = 1; i < old.size(); ++i)
            EXPECT_LE(old[i].age, old[i - 1].age) << name;
    }
}

TEST(Habits, WithoutBarkLookAsTheyAlwaysDid)
{
    auto const habit = parse_habit("bark_red = 0.5", "old.habit").value();
    auto const plant = plant_of(grow_without_brush(habit, 6, 1).value(), habit, 1).plant;
    ASSERT_EQ(plant.materials.size(), 3U);
    for (auto const& material : plant.materials)
        EXPECT_EQ(material.bark.kind, BarkKind::Furrowed);
    EXPECT_EQ(plant.materials[0].base_color.x(), 0.5F);
}

TEST(Habits, TintTheBarkOfTheirKind)
{
    auto const habit = parse_habit("bark = \"oak\"\nbark_red = 0.3", "red.habit").value();
    EXPECT_EQ(habit.bark_red, 0.3);
    EXPECT_EQ(static_cast<float>(habit.bark_green),
              bark_color({ BarkKind::Oak, BarkAge::Old }).y());
    auto const plant = plant_of(grow_without_brush(habit, 6, 1).value(), habit, 1).plant;
    EXPECT_EQ(plant.materials[0].base_color.x(), 0.3F);
}

TEST(Habits, AreFoundByTheirNames)
{
    EXPECT_EQ(load_habit("Oak").value().name, "oak");
    EXPECT_EQ(load_habit("quercus robur").value().name, "oak");
    EXPECT_EQ(load_habit("Picea abies").value().name, "spruce");
    auto const unknown = load_habit("baobab");
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().message.find("there is no habit baobab: give the path of a .habit "
                                           "file, or one of alder, apple, ash, "),
              0U)
        << unknown.error().message;
}

TEST(Habits, FilesSayWhatIsWrong)
{
    auto const message = [](char const* text) {
        auto const habit = parse_habit(text, "my.habit");
        return habit ? std::string() : habit.error().message;
    };
    EXPECT_EQ(message(""), "");
    EXPECT_EQ(parse_habit("", "my.habit").value().name, "my");
    EXPECT_EQ(parse_habit("vigour = 1.5", "my.habit").value().vigour_old, 1.5);
    EXPECT_EQ(parse_habit("angle_deg = 20", "my.habit").value().lateral_angle_deg, 20);
    EXPECT_EQ(message("vigour = 90"), "my.habit: vigour is 90: give a number from 0 to 20");
    EXPECT_NE(message("vigor = 2").find("vigor"), std::string::npos);
    EXPECT_NE(message("vigour = \"high\"").find("my.habit:1: vigour"), std::string::npos);
    EXPECT_NE(message("bark = \"cork\"").find("my.habit:1: bark is 'cork'"), std::string::npos)
        << message("bark = \"cork\"");
    EXPECT_EQ(message("whorl = 1.5"), "my.habit: whorl is 1.5: give a whole number from 0 to 8");
}

// Widths of the pictures in a .glb file, in pixels.
std::set<std::uint32_t> picture_widths(std::string const& glb)
{
    constexpr std::string_view kPng = "\x89PNG";
    constexpr std::size_t kWidthAt = 16;
    std::set<std::uint32_t> widths;
    for (auto at = glb.find(kPng); at != std::string::npos; at = glb.find(kPng, at + 1)) {
        std::uint32_t width = 0;
        for (std::size_t i = 0; i < 4; ++i)
            width = width << 8 | static_cast<unsigned char>(glb.at(at + kWidthAt + i));
        widths.insert(width);
    }
    return widths;
}

TEST(GrowCommand, WritesTheBarkInTheSizeThatIsAskedFor)
{
    auto const folder
        = std::filesystem::temp_directory_path() / ("tractus-bark-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    auto const widths
        = [&](std::vector<std::string> const& more) {
              auto const file = (folder / "alder.glb").string();
              std::vector<std::string> arguments { "grow", "--habit", "alder", "--years",
                                                   "4",    "-o",      file };
              arguments.insert(arguments.end(), more.begin(), more.end());
              auto const outcome = commands::run(arguments);
              EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
              return picture_widths(file_bytes(file));
          };
    EXPECT_TRUE(widths({}).contains(512));
    EXPECT_FALSE(widths({}).contains(64));
    EXPECT_TRUE(widths({ "--bark-size", "64" }).contains(64));
    std::filesystem::remove_all(folder);
}

TEST(GrowCommand, ReportsATreeOfAHabit)
{
    auto const outcome
        = commands::run({ "grow", "--habit", "Betula pendula", "--years", "12", "--report" });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    auto const report = nlohmann::json::parse(outcome.out);
    EXPECT_GT(report["height_m"], 3);
    EXPECT_GT(report["organs"], 100);
    EXPECT_EQ(commands::run({ "grow", "--habit", "birch", "--years", "12", "--report" }).out,
              outcome.out);
    EXPECT_NE(
        commands::run({ "grow", "--habit", "birch", "--years", "12", "--report", "--seed", "2" })
            .out,
        outcome.out);
    EXPECT_NE(commands::run({ "grow", "--report" }).err.find("give a model or"), std::string::npos);
    EXPECT_EQ(commands::run({ "grow", "oak.mtg", "--habit", "oak", "--report" }).exit_code, 1);
    EXPECT_EQ(commands::run({ "grow", "--habit", "oak", "--years", "0", "--report" }).exit_code, 2);
}

} // namespace
} // namespace tractus::self_organising
