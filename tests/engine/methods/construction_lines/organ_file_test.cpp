#include "engine/methods/construction_lines/organ_file.h"

#include "engine/methods/construction_lines/bring_organ.h"
#include "engine/methods/construction_lines/organ_edits.h"
#include "tests/engine/methods/construction_lines/drawn_sketch.h"

#include <cmath>
#include <string_view>

namespace tractus::lines {
namespace {

constexpr std::string_view kLeaf = "tractus-organ 1 -- of a test\n"
                                   "\n"
                                   "color #c05080\n"
                                   "left 0 0  -6 20  0 40 -- base to tip\n"
                                   "midrib 0 0  20 8  40 0\n";

std::string refusal(std::string_view text)
{
    auto const organ = parse_organ(text, "a.organ");
    return organ ? "it is read" : organ.error().message;
}

double length_of(OrganSurface const& surface)
{
    auto const& patches = surface.patches;
    return (patches[patches.size() - kAcross].control[12] + patches.back().control[15]).norm() / 2;
}

// Returns the maximum distance between two surfaces, each scaled to a length of 1.
double apart(OrganSurface const& one, OrganSurface const& other)
{
    double most = 0;
    EXPECT_EQ(one.patches.size(), other.patches.size());
    for (std::size_t i = 0; i < one.patches.size(); ++i)
        for (double const s : { 0.0, 0.5, 1.0 })
            for (double const t : { 0.0, 0.5, 1.0 }) {
                Vec3 const from = one.patches[i].at(s, t) / length_of(one);
                Vec3 const to = other.patches[i].at(s, t) / length_of(other);
                most = std::max(most, (from - to).norm());
            }
    return most;
}

TEST(OrganFile, SaysALeafInThreeViews)
{
    auto const organ = parse_organ(kLeaf, "a.organ").value();
    ASSERT_EQ(organ.views.left.size(), 3U);
    EXPECT_EQ(organ.views.left[1], Vec2(-6, 20));
    EXPECT_TRUE(organ.views.right.empty());
    EXPECT_EQ(organ.views.midrib.back(), Vec2(40, 0));
    ASSERT_TRUE(organ.color);
    EXPECT_NEAR(organ.color->x(), 0xc0 / 255.0, 1e-12);
    auto const printed = print_organ(organ);
    EXPECT_EQ(print_organ(parse_organ(printed, "a.organ").value()), printed);
    auto both = organ;
    both.views.right = { { 0, 0 }, { 6, 20 }, { 0, 40 } };
    EXPECT_LT(apart(surface_of(organ).value(), surface_of(both).value()), 1e-12)
        << "a side that is missing is the other one's mirror image";
}

// The smallest PNG file, a single green pixel, in base64.
constexpr std::string_view kPixel = "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGMwWK"
                                    "AAAAH0APGutUjJAAAAAElFTkSuQmCC";

TEST(OrganFile, HoldsAPicture)
{
    auto const text = std::string(kLeaf) + "picture " + std::string(kPixel) + "\n";
    auto const organ = parse_organ(text, "a.organ");
    ASSERT_TRUE(organ) << organ.error().message;
    ASSERT_TRUE(organ->picture);
    EXPECT_NE(print_organ(*organ).find(kPixel), std::string::npos);
    EXPECT_EQ(surface_of(*organ)->picture, organ->picture);

    auto drawing = whole_sketch();
    drawing.apply(BringOrgan { .plant = drawing.plant(), .at_mm = { 70, 0, 0 }, .text = text });
    auto const& brought = drawing.sketch().organs[0];
    EXPECT_EQ(brought.color, OrganColor::Picture);
    EXPECT_EQ(*surface_of(brought)->picture, *organ->picture);
    EXPECT_EQ(*organ_file(brought)->picture, *organ->picture);

    EXPECT_EQ(refusal(std::string(kLeaf) + "picture iVBO*\n"),
              "a.organ:6: the picture is no PNG file in base 64: leave the line out");
    EXPECT_EQ(refusal(std::string(kLeaf) + "picture Zm9v\n").substr(0, 11), "a.organ:6: ");
}

TEST(OrganFile, SaysWhatIsWrongAndWhere)
{
    EXPECT_EQ(refusal("lsystem: 1\n"),
              "a.organ:1: it is no leaf in three views: its first line is \"tractus-organ 1\"");
    EXPECT_EQ(refusal(""),
              "a.organ: the organ has no boundary: give left or right or both, each of "
              "two points or more");
    EXPECT_EQ(refusal("tractus-organ 1\nleft 0 0 1\n"),
              "a.organ:2: it has 3 numbers: give pairs of right and up for 2 to 2000 points");
    EXPECT_EQ(refusal("tractus-organ 1\nleft 0 0 1 x\n"),
              "a.organ:2: \"x\" is no place: give millimetres from -10000 to 10000");
    EXPECT_EQ(refusal("tractus-organ 1\nleft 0 0 1 nan\n"),
              "a.organ:2: \"nan\" is no place: give millimetres from -10000 to 10000");
    EXPECT_EQ(refusal("tractus-organ 1\ntop 0 0 1 1\n"),
              "a.organ:2: \"top\" is no part of a leaf: give left, right, midrib, section, color "
              "or picture");
    EXPECT_EQ(refusal("tractus-organ 1\n\ncolor red\n"),
              "a.organ:3: color of the organ is no colour: give \"#rrggbb\", such as \"#c05080\"");
    EXPECT_EQ(refusal("tractus-organ 1\nleft 0 0 1 1\nleft 0 0 1 1\n"),
              "a.organ:3: there is such a line above already: leave one out");
    EXPECT_EQ(refusal("tractus-organ 1\nleft 0 0 0 40\n"),
              "a.organ: the leaf would have no breadth: let its edge be a bow from base to tip");
    EXPECT_EQ(refusal("tractus-organ 1\nleft 0 0 -6 20 0 40\nright 0 40 6 20 0 0\n"), "it is read")
        << "in either direction";
    EXPECT_NE(
        refusal("tractus-organ 1\nleft 0 0 -1 20 0 40\nmidrib 0 0 5 1 3 0\n").find("turns back"),
        std::string::npos);
}

// An empty text must give the same error as a missing first line.
TEST(OrganFile, RefusesAnEmptyText)
{
    EXPECT_NE(refusal("\n").find("first line"), std::string::npos);
}

TEST(BringOrgan, DrawsTheLeafBesideThePlant)
{
    auto drawing = whole_sketch();
    auto const file = parse_organ(kLeaf, "a.organ").value();
    auto const sheet = sheet_of(*scene::active_plant(drawing.scene().state), {});
    auto const place = place_beside(drawing.sketch(), sheet, file);
    drawing.apply(
        BringOrgan { .plant = drawing.plant(), .at_mm = place, .text = std::string(kLeaf) });
    ASSERT_EQ(drawing.sketch().organs.size(), 1U);
    auto const& organ = drawing.sketch().organs[0];
    EXPECT_EQ(drawing.sketch().organ, organ.id) << "all layers bear the first one";
    EXPECT_EQ(organ.color, OrganColor::Pink) << "the nearest";
    ASSERT_EQ(organ.lines.size(), 2U);
    EXPECT_NE(organ.lines[0].line.id, organ.lines[1].line.id);
    // Lines drawn by pen are smoothed, so the corner in the middle of these lines is rounded.
    EXPECT_LT(apart(surface_of(organ).value(), surface_of(file).value()), 0.06);
    for (auto const& line : organ.lines)
        for (auto const& tip : line.line.stroke.tips) {
            EXPECT_LT(tip.position_mm.head<2>().cwiseAbs().maxCoeff(), 100.1);
            EXPECT_GT(std::fabs(tip.position_mm.x()), 20) << "beside the stem";
        }

    drawing.apply(
        BringOrgan { .plant = drawing.plant(), .at_mm = place, .text = std::string(kLeaf) });
    EXPECT_EQ(drawing.sketch().organ, drawing.sketch().organs[0].id);
    EXPECT_EQ(std::count_if(drawing.sketch().lines.begin(), drawing.sketch().lines.end(),
                            [&](SketchLine const& line) {
                                return line.organ == drawing.sketch().organs[1].id;
                            }),
              1)
        << "the topmost layer bears the second";
    auto const other = place_beside(drawing.sketch(), sheet, file);
    EXPECT_GT((other - place).norm(), 20) << "a third one would lie elsewhere";
    EXPECT_NE(drawing.refusal(BringOrgan { .plant = drawing.plant(), .text = "leaf" })
                  .find("the leaf:1: it is no leaf in three views"),
              std::string::npos);
}

// A curve drawn by hand must be the same after it is written and read again.
TEST(BringOrgan, GivesBackWhatWasKept)
{
    std::vector<Vec3> edge;
    for (int i = 0; i <= 20; ++i) {
        double const t = i / 20.0;
        edge.emplace_back(60 - 40 * t * (1 - t), 40 * t, 0);
    }
    auto drawing = whole_sketch();
    drawing.apply(DrawOrgan { .plant = drawing.plant(), .stroke = pen_stroke(edge) });
    auto const& drawn = drawing.sketch().organs[0];
    drawing.apply(
        DrawOrgan { .plant = drawing.plant(),
                    .organ = drawn.id,
                    .view = OrganView::Section,
                    .color = OrganColor::Violet,
                    .stroke = pen_stroke({ { 0, 80, 0 }, { 8, 74, 0 }, { 16, 80, 0 } }) });
    auto const kept = organ_file(drawing.sketch().organs[0]).value();
    auto const text = print_organ(kept);
    EXPECT_EQ(print_organ(parse_organ(text, "a.organ").value()), text);
    auto const as_drawn = surface_of(drawing.sketch().organs[0]).value();
    EXPECT_LT(apart(surface_of(parse_organ(text, "a.organ").value()).value(), as_drawn), 0.002);

    auto other = whole_sketch();
    other.apply(BringOrgan { .plant = other.plant(), .at_mm = { 70, 0, 0 }, .text = text });
    EXPECT_LT(apart(surface_of(other.sketch().organs[0]).value(), as_drawn), 0.01);
    EXPECT_EQ(other.sketch().organs[0].color, OrganColor::Violet);
    EXPECT_EQ(other.sketch().organs[0].lines.size(), 3U) << "both sides, and the section";
}

} // namespace
} // namespace tractus::lines
