#include "engine/methods/construction_lines/recognise_stems.h"

#include "engine/methods/construction_lines/capture_line.h"
#include "tests/engine/methods/construction_lines/illustrator.h"
#include "tests/engine/methods/construction_lines/sketches.h"

#include <gtest/gtest.h>
#include <optional>
#include <random>

namespace tractus::lines {
namespace {

using Says = StemRecogniser::Says;

// Returns a recogniser that knows two vertical stems of 200 mm, 100 mm apart.
StemRecogniser two_stems()
{
    StemRecogniser recogniser;
    recogniser.add(line({ Vec2(0, 0), Vec2(0, 200) }));
    recogniser.add(line({ Vec2(100, 0), Vec2(100, 200) }), Says::AnotherStem);
    return recogniser;
}

TEST(StemRecogniser, GivesLinesToTheNearestStem)
{
    auto recogniser = two_stems();
    auto const& across = recogniser.add(line({ Vec2(70, 80), Vec2(100, 60), Vec2(130, 80) }));
    EXPECT_EQ(across.line.role, Role::Inclination);
    EXPECT_EQ(across.stem, 1U);
    auto const& between = recogniser.add(line({ Vec2(40, 0), Vec2(40, 200) }));
    EXPECT_EQ(between.line.role, Role::Right);
    EXPECT_EQ(between.stem, 0U);
    auto const& odd = recogniser.add(line({ Vec2(120, 100), Vec2(130, 110) }));
    EXPECT_EQ(odd.line.role, Role::Unsure);
    EXPECT_EQ(odd.stem, 1U);
    auto const stems = recogniser.stems();
    EXPECT_EQ(stems[0].sketch.right[0], Vec2(40, 0));
    EXPECT_TRUE(stems[0].sketch.inclinations.empty());
    EXPECT_EQ(recogniser.inclination_strokes(1), std::vector<std::size_t> { 2 });
}

// Two lines are drawn between the stems, both nearer to the same stem. The first line belongs to
// that stem. The second line belongs to the other stem, which has no line on this side yet.
TEST(StemRecogniser, GivesABoundaryToTheStemThatHasNoneThere)
{
    auto recogniser = two_stems();
    recogniser.add(line({ Vec2(45, 0), Vec2(45, 200) }));
    auto const& second = recogniser.add(line({ Vec2(48, 200), Vec2(40, 0) }));
    EXPECT_EQ(second.line.role, Role::Right) << "drawn again, since it lies on the first";
    EXPECT_EQ(second.line.replaces, std::optional<std::size_t>(2));
    auto const& other = recogniser.add(line({ Vec2(30, 0), Vec2(20, 100), Vec2(30, 200) }));
    EXPECT_EQ(other.line.role, Role::Left);
    EXPECT_EQ(other.stem, 1U);
}

TEST(StemRecogniser, AStemThatBeginsOnAnotherStandsOnIt)
{
    auto recogniser = two_stems();
    auto const parent_of = [&](Vec2 const& foot, Vec2 const& top) {
        return recogniser.add(line({ foot, top }), Says::AnotherStem).parent;
    };
    EXPECT_EQ(parent_of({ 103, 80 }, { 190, 160 }), std::optional<std::size_t>(1));
    EXPECT_EQ(parent_of({ 2, 203 }, { -40, 280 }), std::optional<std::size_t>(0)) << "its top";
    EXPECT_EQ(parent_of({ 150, 123 }, { 220, 123 }), std::optional<std::size_t>(2)) << "a lateral";
    EXPECT_EQ(parent_of({ 20, 80 }, { 60, 160 }), std::nullopt) << "too far off";
    EXPECT_EQ(parent_of({ 2, 3 }, { -60, 100 }), std::nullopt) << "at a foot, as in a clump";
}

TEST(StemRecogniser, AStemDrawnAgainKeepsItsPlace)
{
    auto recogniser = two_stems();
    recogniser.add(line({ Vec2(100, 100), Vec2(170, 180) }), Says::AnotherStem);
    auto const& again = recogniser.add(line({ Vec2(102, 101), Vec2(173, 177) }));
    EXPECT_EQ(again.line.role, Role::Stem);
    EXPECT_EQ(again.stem, 2U);
    EXPECT_EQ(again.parent, std::optional<std::size_t>(1));
    EXPECT_EQ(again.line.replaces, std::optional<std::size_t>(2));
}

struct MeantLine {
    Illustrator::Meant line;
    std::size_t stem = 0;
};

// Returns the lines of two sketches side by side, which may overlap slightly. The order is random,
// except that each stem precedes its own lines.
std::vector<MeantLine> two_sketches(unsigned seed)
{
    std::mt19937 random(seed);
    auto const between = [&](double least, double most) {
        return least + (most - least) * static_cast<double>(random() % 100'001) / 100'000.0;
    };
    Illustrator first(2 * seed);
    Illustrator second(2 * seed + 1);
    double const apart_mm
        = between(0.95, 1.5) * (first.width_mm(Role::Right) + second.width_mm(Role::Left)) + 5;
    double const higher_mm = between(-15, 15);
    auto const one = first.draw();
    auto const other = second.draw();
    std::vector<MeantLine> all;
    std::size_t i = 0;
    std::size_t k = 0;
    while (i < one.size() || k < other.size()) {
        bool const is_first
            = k == other.size() || (i < one.size() && (i == 0 || random() % 2 == 0));
        all.push_back({ is_first ? one[i++] : other[k++], is_first ? 0U : 1U });
        if (!is_first)
            for (auto& point : all.back().line.stroke)
                point += Vec3(apart_mm, higher_mm, 0);
    }
    return all;
}

TEST(StemRecogniser, KnowsTheStrokesOfSimulatedSketchesOfTwoStems)
{
    constexpr int kSketches = 200;
    int strokes = 0;
    int right_strokes = 0;
    int right_sketches = 0;
    for (unsigned seed = 0; seed < kSketches; ++seed) {
        StemRecogniser recogniser;
        bool right = true;
        for (auto const& [meant, stem] : two_sketches(seed)) {
            bool const is_second
                = meant.role == Role::Stem && stem == 1 && recogniser.stems().size() == 1;
            auto const& found = recogniser.add(capture_line(meant.stroke),
                                               is_second ? Says::AnotherStem : Says::Nothing);
            bool const known = found.line.role == meant.role && found.stem == stem;
            ++strokes;
            right_strokes += known ? 1 : 0;
            right = right && known;
        }
        right_sketches += right ? 1 : 0;
    }
    RecordProperty("strokes", strokes);
    RecordProperty("right_strokes", right_strokes);
    RecordProperty("right_sketches", right_sketches);
    EXPECT_GE(right_strokes, 0.99 * strokes) << "of " << strokes;
    EXPECT_GE(right_sketches, 0.95 * kSketches);
}

} // namespace
} // namespace tractus::lines
