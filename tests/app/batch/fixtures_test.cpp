#include "app/batch/session_plant.h"
#include "app/document/model_cost.h"
#include "app/files/resources.h"
#include "app/io/model_file.h"
#include "app/session/session_file.h"
#include "tests/app/replayed.h"

#include <cmath>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

// Tests with recordings and sessions written by earlier versions of the program, and with digests
// of their contents. tests/fixtures/README.md says how these files were made. They are never
// replaced, because later versions must give the same results.
namespace tractus::batch {
namespace {

namespace fs = std::filesystem;

fs::path fixture(std::string const& name)
{
    return fs::path(TRACTUS_FIXTURES) / name;
}

// A sum whose weights depend on the order, so that values in another order give another sum.
class Sum {
public:
    void add(double value) { value_ += value * (1 + static_cast<double>(count_++ % 97) / 97); }
    double value() const { return value_; }

private:
    std::size_t count_ = 0;
    double value_ = 0;
};

// Returns a digest of a plant: counts of its elements, and sums over positions and thicknesses.
std::vector<double> digest(Plant const& plant)
{
    Sum places;
    Sum radii;
    Sum organs;
    for (auto const& place_mm : plant.node_position_mm)
        for (auto const coordinate : place_mm)
            places.add(coordinate);
    for (auto const radius_mm : plant.node_radius_mm)
        radii.add(static_cast<double>(radius_mm));
    for (auto const& organ : plant.organs) {
        for (auto const coordinate : organ.position_mm)
            organs.add(static_cast<double>(coordinate));
        for (auto const coefficient : organ.orientation.coeffs())
            organs.add(static_cast<double>(coefficient));
    }
    return { static_cast<double>(plant.axes.size()),
             static_cast<double>(plant.node_position_mm.size()),
             static_cast<double>(plant.organs.size()),
             places.value(),
             radii.value(),
             organs.value() };
}

// Returns a digest of a scene: counts of its strokes and selected paths, and the digests of its
// plant as loaded, as shown, with the next seed, and then at age 0.5.
std::vector<double> digest(scene::Scene scene)
{
    std::vector<double> numbers { static_cast<double>(scene.associations.size()),
                                  static_cast<double>(scene.indicators.size()),
                                  static_cast<double>(scene.selection.size()) };
    auto const add = [&](Plant const& plant) {
        auto const of_plant = digest(plant);
        numbers.insert(numbers.end(), of_plant.begin(), of_plant.end());
    };
    add(*scene.base);
    add(shown_plant(scene).value());
    ++scene.growth.seed;
    add(shown_plant(scene).value());
    scene.growth.age = 0.5;
    add(shown_plant(scene).value());
    return numbers;
}

// Reads the expected digests from digests.txt: one line for each fixture, with its name and
// numbers.
std::map<std::string, std::vector<double>> expected_digests()
{
    std::map<std::string, std::vector<double>> digests;
    std::ifstream in(fixture("digests.txt"));
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string name;
        words >> name;
        for (double number = 0; words >> number;)
            digests[name].push_back(number);
    }
    return digests;
}

// Compares a scene's digest with the expected one. The comparison has a tolerance, since compilers
// and C libraries may differ in the last digits.
void expect_digest(std::string const& name, scene::Scene const& scene)
{
    auto const found = digest(scene);
    auto const line = fmt::format("{} {:.12g}", name, fmt::join(found, " "));
    auto const all = expected_digests();
    auto const expected = all.find(name);
    ASSERT_NE(expected, all.end()) << "digests.txt lacks\n" << line;
    ASSERT_EQ(found.size(), expected->second.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        ASSERT_NEAR(found[i], expected->second[i], 1e-7 * (1 + std::abs(found[i])))
            << "number " << i << " of\n"
            << line;
}

scene::Scene scene_of_log(fs::path const& log_path, fs::path const& model)
{
    auto const log = drivers::read_log(log_path).value();
    return replayed(log, {},
                    scene::apply_edit({}, io::load_plant_edit(model).value(),
                                      document::make_load_options())
                        .value())
        .scene;
}

TEST(Fixtures, EveryToolsLogGivesItsPlant)
{
    expect_digest("every_tool", scene_of_log(fixture("every_tool.tractus-log"), fixture("tree.l")));
}

class FixtureOfDemo : public testing::TestWithParam<char const*> { };

TEST_P(FixtureOfDemo, GivesItsPlant)
{
    auto const log = files::find_resource(fmt::format("demo/{}.tractus-log", GetParam())).value();
    expect_digest(GetParam(), scene_of_log(log, files::find_model(GetParam()).value()));
}

INSTANTIATE_TEST_SUITE_P(Fixtures, FixtureOfDemo,
                         testing::Values("broadleaf", "shrub", "conifer", "daisy"));

// Returns the path of a copy of a session. Reading the original could create files beside it.
fs::path copy_of(std::string const& name)
{
    auto const path
        = fs::temp_directory_path() / fmt::format("tractus_{}_{}.tractus", name, ::getpid());
    fs::copy_file(fixture(name + ".tractus"), path);
    return path;
}

TEST(Fixtures, TreesFromBeforeNodesWereWholeKeepTheirBranches)
{
    auto const path = copy_of("snapped_nodes");
    expect_digest("snapped_nodes", load_session_scene(path, methods::all_methods().edits).value());
    fs::remove(path);
}

class FixtureOfFormat : public testing::TestWithParam<int> { };

TEST_P(FixtureOfFormat, GivesItsPlantAndItsEdits)
{
    auto const name = fmt::format("format{}", GetParam());
    auto const path = copy_of(name);
    expect_digest(name, load_session_scene(path, methods::all_methods().edits).value());
    auto const contents = session::read_session(path, scene::core_edit_kinds());
    ASSERT_TRUE(contents) << contents.error().message;
    std::ifstream in(fixture(name + ".txt"));
    std::string line;
    for (auto const& made : contents->edits) {
        auto const said = fmt::format("{} {}", made.step, made.edit.describe());
        EXPECT_TRUE(std::getline(in, line) && said == line) << said;
    }
    EXPECT_FALSE(std::getline(in, line)) << "left: " << line;
    fs::remove(path);
}

INSTANTIATE_TEST_SUITE_P(Fixtures, FixtureOfFormat, testing::Values(1, 2, 3, 4));

} // namespace
} // namespace tractus::batch
