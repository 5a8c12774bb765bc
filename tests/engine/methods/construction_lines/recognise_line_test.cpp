#include "engine/methods/construction_lines/recognise_line.h"

#include "engine/methods/construction_lines/capture_line.h"
#include "tests/engine/methods/construction_lines/sketches.h"

#include <random>

namespace tractus::lines {
namespace {

std::vector<Vec3> line(std::vector<Vec2> const& points)
{
    std::vector<Vec3> result;
    for (auto const& point : points)
        result.emplace_back(point.x(), point.y(), 0);
    return result;
}

LineRecogniser with_stem()
{
    LineRecogniser recogniser;
    EXPECT_EQ(recogniser.add(line({ Vec2(0, 0), Vec2(0, 200) })).role, Role::Stem);
    return recogniser;
}

TEST(LineRecogniser, TellsLinesByHowTheyLieToTheStem)
{
    auto recogniser = with_stem();
    EXPECT_EQ(recogniser.add(line({ Vec2(40, 80), Vec2(0, 40), Vec2(-60, 100) })).role,
              Role::Inclination);
    EXPECT_EQ(recogniser.add(line({ Vec2(-50, 220), Vec2(-50, -10) })).role, Role::Left);
    EXPECT_EQ(recogniser.add(line({ Vec2(30, 0), Vec2(30, 210) })).role, Role::Right);
    EXPECT_EQ(recogniser.add(line({ Vec2(2, 150), Vec2(60, 190) })).role, Role::HalfInclination);
    auto const sketch = recogniser.sketch();
    EXPECT_EQ(sketch.stem.size(), 2U);
    EXPECT_EQ(sketch.left[0], Vec2(-50, 220));
    EXPECT_EQ(sketch.right[0], Vec2(30, 0));
    EXPECT_EQ(sketch.inclinations.size(), 2U);
}

TEST(LineRecogniser, ALineDrawnAgainTakesTheEarlierOnesPlace)
{
    auto recogniser = with_stem();
    recogniser.add(line({ Vec2(-50, 0), Vec2(-50, 200) }));
    recogniser.add(line({ Vec2(-60, 100), Vec2(0, 40), Vec2(40, 80) }));
    auto const& again = recogniser.add(line({ Vec2(42, 83), Vec2(2, 42), Vec2(-58, 104) }));
    EXPECT_EQ(again.role, Role::Inclination);
    EXPECT_EQ(again.replaces, std::optional<std::size_t>(2));
    EXPECT_EQ(recogniser.add(line({ Vec2(-90, 0), Vec2(-70, 200) })).replaces,
              std::optional<std::size_t>(1));
    EXPECT_EQ(recogniser.add(line({ Vec2(3, 2), Vec2(-2, 198) })).replaces,
              std::optional<std::size_t>(0));
    auto const sketch = recogniser.sketch();
    EXPECT_EQ(sketch.inclinations.size(), 1U);
    EXPECT_EQ(sketch.left[0], Vec2(-90, 0));
    EXPECT_EQ(sketch.stem[0], Vec3(3, 2, 0));
}

TEST(LineRecogniser, TwoHalvesAtOnePlaceAreOneLine)
{
    auto recogniser = with_stem();
    recogniser.add(line({ Vec2(-1, 50), Vec2(-60, 80) }));
    recogniser.add(line({ Vec2(60, 90), Vec2(-2, 54) }));
    recogniser.add(line({ Vec2(3, 150), Vec2(60, 190) }));
    auto sketch = recogniser.sketch();
    ASSERT_EQ(sketch.inclinations.size(), 2U);
    sketch.left = hand_sketch().left;
    sketch.right = hand_sketch().right;
    sketch.nodes_per_layer = { 3 };
    auto const result = measured(sketch);
    EXPECT_NEAR(result.inclinations[0].x, 0.255, 0.005);
    ASSERT_EQ(result.notes.size(), 1U);
    EXPECT_EQ(result.notes[0].substr(0, 39), "inclination line 2 has no half on the l");
}

TEST(LineRecogniser, CutsABoundarysEndThatReachesOverTheStem)
{
    auto recogniser = with_stem();
    EXPECT_EQ(
        recogniser.add(line({ Vec2(-40, 0), Vec2(-45, 100), Vec2(-2, 190), Vec2(4, 197) })).role,
        Role::Left);
    EXPECT_EQ(recogniser.sketch().left.back(), Vec2(-2, 190));
}

TEST(LineRecogniser, AsksWhatItDoesNotKnow)
{
    auto recogniser = with_stem();
    auto const dot = recogniser.add(line({ Vec2(80, 100), Vec2(90, 110) }));
    EXPECT_EQ(dot.role, Role::Unsure);
    EXPECT_EQ(dot.reason,
              "this line neither crosses the stem nor goes along it: draw an inclination "
              "line across it, or a boundary along at least half of it");
    auto const snake
        = recogniser.add(line({ Vec2(-30, 40), Vec2(30, 60), Vec2(-30, 80), Vec2(30, 99) }));
    EXPECT_EQ(snake.role, Role::Unsure);
    EXPECT_EQ(snake.reason.substr(0, 33), "this line crosses the stem 3 time");
    EXPECT_TRUE(recogniser.sketch().inclinations.empty());
}

// Sketches as a hand draws them. What the lines are meant as is known; how they are told apart is
// not.
class Illustrator {
public:
    explicit Illustrator(unsigned seed)
        : random_(seed)
    {
        height_mm_ = between(110, 260);
        bow_ = between(-0.9, 0.9);
        width_left_mm_ = between(25, 70);
        width_right_mm_ = between(25, 70);
        closing_ = between(0.2, 1);
        from_foot_ = chance(0.3);
        tremor_mm_ = between(0.3, 1);
    }

    struct Meant {
        Role role;
        std::vector<Vec3> stroke;
    };

    std::vector<Meant> draw()
    {
        std::vector<Meant> rest;
        if (chance(0.9))
            add_boundary(rest, Role::Left);
        if (chance(0.9) || rest.empty())
            add_boundary(rest, Role::Right);
        add_inclinations(rest);
        std::shuffle(rest.begin(), rest.end(), random_);
        if (chance(0.3)) { // A line that did not please is drawn again, later.
            auto const& earlier = rest[random_() % rest.size()];
            rest.push_back({ earlier.role, trembling(earlier.stroke) });
        }
        std::vector<Meant> all { { Role::Stem, trembling(stem()) } };
        for (auto& line : rest) {
            if (chance(0.5))
                std::reverse(line.stroke.begin(), line.stroke.end());
            all.push_back(line);
        }
        return all;
    }

private:
    double between(double least, double most)
    {
        return least + (most - least) * static_cast<double>(random_() % 100'001) / 100'000.0;
    }
    bool chance(double share) { return between(0, 1) < share; }

    // A place as far along the axis and as far beside it, the left above 0.
    Vec3 place(double t, double beside_mm) const
    {
        double const turn = bow_ * t;
        double const bent = std::fabs(bow_) < 1e-6 ? t : std::sin(turn) / bow_;
        double const drift = std::fabs(bow_) < 1e-6 ? 0 : (1 - std::cos(turn)) / bow_;
        return { height_mm_ * drift - beside_mm * std::cos(turn),
                 height_mm_ * bent + beside_mm * std::sin(turn), 0 };
    }

    std::vector<Vec3> stem() const
    {
        std::vector<Vec3> points;
        for (int i = 0; i <= 120; ++i)
            points.push_back(place(i / 120.0, 0));
        return points;
    }

    double width_mm(Role side, double t) const
    {
        double const wide_mm = side == Role::Left ? width_left_mm_ : -width_right_mm_;
        double const foot = from_foot_ ? std::sin(kPi / 2 * std::clamp(t / 0.2, 0.0, 1.0)) : 1;
        return wide_mm * foot * (1 - closing_ * t * t) * (0.75 + 0.25 * std::sin(3 * t));
    }

    void add_boundary(std::vector<Meant>& lines, Role side)
    {
        double const from = between(-0.05, 0.12);
        double const to = between(0.9, 1.08);
        std::vector<Vec3> points;
        for (int i = 0; i <= 100; ++i) {
            double const t = from + (to - from) * i / 100;
            points.push_back(place(t, width_mm(side, t)));
        }
        lines.push_back({ side, trembling(points) });
    }

    std::vector<Vec3> half(double t, Role side, double rise, double gap_mm)
    {
        std::vector<Vec3> points;
        double const reach_mm = width_mm(side, t) * between(0.85, 1.3);
        double const from_mm = side == Role::Left ? gap_mm : -gap_mm;
        for (int i = 0; i <= 40; ++i) {
            double const share = i / 40.0;
            points.push_back(place(t + rise * share, from_mm + (reach_mm - from_mm) * share));
        }
        return points;
    }

    void add_inclinations(std::vector<Meant>& lines)
    {
        int const count = static_cast<int>(random_() % 3) + 2;
        for (int i = 0; i < count; ++i) {
            double const t = 0.08 + 0.84 * (i + between(0.2, 0.8)) / count;
            double const rise = between(-0.1, 0.35);
            auto left = half(t, Role::Left, rise, 0);
            auto const right = half(t, Role::Right, rise * between(0.7, 1.3), 0);
            if (chance(0.12)) {
                lines.push_back({ Role::HalfInclination,
                                  trembling(half(t, chance(0.5) ? Role::Left : Role::Right, rise,
                                                 between(0, 2))) });
                continue;
            }
            std::reverse(left.begin(), left.end());
            left.insert(left.end(), right.begin() + 1, right.end());
            lines.push_back({ Role::Inclination, trembling(left) });
        }
    }

    std::vector<Vec3> trembling(std::vector<Vec3> points)
    {
        double phase = between(0, 6.28);
        double const step = between(0.3, 0.9);
        for (auto& point : points) {
            point += tremor_mm_ * Vec3(std::sin(phase), std::cos(1.3 * phase), 0);
            phase += step;
        }
        return points;
    }

    std::mt19937 random_;
    double height_mm_;
    double bow_;
    double width_left_mm_;
    double width_right_mm_;
    double closing_;
    bool from_foot_;
    double tremor_mm_;
};

TEST(LineRecogniser, KnowsTheStrokesOfSimulatedSketches)
{
    int strokes = 0;
    int right_strokes = 0;
    int right_sketches = 0;
    for (unsigned seed = 0; seed < 500; ++seed) {
        LineRecogniser recogniser;
        bool right = true;
        auto const drawn = Illustrator(seed).draw();
        for (auto const& [role, stroke] : drawn) {
            auto const& found = recogniser.add(capture_line(stroke));
            ++strokes;
            right_strokes += found.role == role ? 1 : 0;
            right = right && found.role == role;
        }
        right_sketches += right ? 1 : 0;
    }
    RecordProperty("strokes", strokes);
    RecordProperty("right_strokes", right_strokes);
    RecordProperty("right_sketches", right_sketches);
    EXPECT_GE(right_strokes, 0.99 * strokes) << "of " << strokes;
    EXPECT_GE(right_sketches, 0.97 * 500);
}

} // namespace
} // namespace tractus::lines
