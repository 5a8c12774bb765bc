#include "engine/lsystem/view/leaf_sheet.h"

#include "engine/lsystem/view/view.h"

#include <gtest/gtest.h>

namespace tractus::lsystem {
namespace {

// Returns a sheet with two leaves: a triangle, and a triangle twice as long. `size` is the number
// of bytes in its colour picture after the signature. Its normal picture has one byte more.
LeafSheet sheet_of(std::size_t size = 9)
{
    LeafSheet sheet;
    sheet.mean_color = { 0.25f, 0.5f, 0.125f };
    sheet.color = leaf_page("\x89PNG" + std::string(size, '\xFE'));
    sheet.normal = leaf_page("\x89PNG" + std::string(size + 1, '\0'));
    for (double const length : { 1.0, 2.0 })
        sheet.leaves.push_back(std::make_shared<CutLeaf const>(
            CutLeaf { .corners = { { 0, 0 }, { 0.3, 0.5 }, { 0, length } },
                      .triangles = { { 0, 1, 2 } },
                      .stem_in_picture = { 0.25, 0.5 },
                      .length_in_picture = 0.125 }));
    return sheet;
}

TEST(LeafSheet, IsReadAsItWasWritten)
{
    for (std::size_t const size : { 0u, 1u, 2u, 3u, 100u }) {
        auto const sheet = sheet_of(size);
        auto const read = parse_leaf_sheet("a.leaf-sheet", print_leaf_sheet(sheet));
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(read->color->bytes, sheet.color->bytes);
        EXPECT_EQ(read->normal->bytes, sheet.normal->bytes);
        EXPECT_EQ(read->mean_color, sheet.mean_color);
        ASSERT_EQ(read->leaves.size(), 2u);
        EXPECT_EQ(read->leaves[1]->corners, sheet.leaves[1]->corners);
        EXPECT_EQ(read->leaves[1]->triangles, sheet.leaves[1]->triangles);
        EXPECT_EQ(read->leaves[1]->in_picture({ 1, 1 }), Vec2(0.375, 0.375));
    }
}

TEST(LeafSheet, WritesBase64AsTheStandardHasIt)
{
    auto sheet = sheet_of();
    sheet.color = leaf_page("foob"); // The text is an example of RFC 4648, section 10.
    sheet.normal = leaf_page("fooba");
    auto const text = print_leaf_sheet(sheet);
    EXPECT_NE(text.find("color Zm9vYg==\nnormal Zm9vYmE=\n"), std::string::npos) << text;
}

TEST(LeafSheet, RefusesWhatIsNoSheetWithItsLine)
{
    auto const error_of = [](std::string const& from, std::string const& to) {
        auto text = print_leaf_sheet(sheet_of());
        text.replace(text.find(from), from.size(), to);
        auto const read = parse_leaf_sheet("a", text);
        return read ? "no error" : read.error().message;
    };
    EXPECT_EQ(error_of("mean 0.25", "mean"), "a:1: expected 3 numbers behind 'mean'");
    EXPECT_EQ(error_of("color ", "color !"), "a:2: expected a PNG file in base 64 behind 'color'");
    EXPECT_EQ(error_of("leaves 2", "leaves 1e9"), "a:4: expected 1 to 64 leaves");
    EXPECT_EQ(error_of("leaves 2", "leaves 3"), "a:14: expected 'leaf'");
    EXPECT_EQ(error_of("leaf 3", "leaf 1e9"),
              "a:5: expected 3 to 64 corners and 1 to 64 triangles");
    EXPECT_EQ(error_of("triangle 0 1 2", "triangle 0 1 3"),
              "a:9: a triangle names a corner that the leaf has not");
}

TEST(LeafSheet, SaysInItsNameWhatWasOrdered)
{
    auto const order = parse_leaf_sheet_name(leaf_sheet_name({ "maple", 5, 0.35 }));
    ASSERT_TRUE(order);
    EXPECT_EQ(order->grammar, "maple");
    EXPECT_EQ(order->variants, 5);
    EXPECT_EQ(order->age, 0.35);
    for (auto const* const other : { "maple.leaf", "maple 0 0.5.leaf-sheet",
                                     "maple 1e30 0.5.leaf-sheet", "maple 5.leaf-sheet" })
        EXPECT_FALSE(parse_leaf_sheet_name(other)) << other;
}

constexpr char const* kOrgan = "material: 2 leaf kind=leaf color=0.3,0.5,0.2\n"
                               "organ: l leaf kind=blade material=2 length=6 width=4 petiole=1\n";

Result<View> view_with(std::string const& statements, std::string* asked = nullptr)
{
    return parse_view("m.v", statements, [=](std::string const& name) -> Result<std::string> {
        if (asked)
            *asked = name;
        if (name.starts_with("maple"))
            return print_leaf_sheet(sheet_of());
        return fail(Fault::User, "there is no such leaf");
    });
}

TEST(LeafOfAView, StandsForAnOrgansBlade)
{
    std::string asked;
    auto const view = view_with(kOrgan + std::string("leaf: l maple variants=2 age=0.4\n"), &asked);
    ASSERT_TRUE(view) << view.error().message;
    EXPECT_EQ(asked, "maple 2 0.4.leaf-sheet");
    auto const& leaves = view->organs.at(0).leaves;
    ASSERT_EQ(leaves.size(), 2u);
    EXPECT_EQ(leaves[1].kind, OrganShape::Kind::Leaf);
    // The organ's blade is 5 long, and this leaf is twice as long as a blade.
    EXPECT_EQ(leaves[1].length_mm, 10);
    EXPECT_EQ(leaves[1].material, 2);
    auto const& material = view->materials.at(2);
    EXPECT_EQ(material.base_color, Vec3f(0.25f, 0.5f, 0.125f));
    EXPECT_EQ(material.textures.base_color->bytes, sheet_of().color->bytes);
    EXPECT_EQ(material.textures.alpha, MaterialTextures::Alpha::Mask);
}

TEST(LeafOfAView, SaysWhereItIsWrong)
{
    auto const error_of = [](std::string const& text) {
        auto const view = view_with(text);
        return view ? "no error" : view.error().message;
    };
    std::string const organ = kOrgan;
    EXPECT_EQ(error_of("leaf: l maple\n"),
              "m.v:1:1: there is no 'organ: l … kind=blade' above this line");
    EXPECT_EQ(error_of("organ: l leaf kind=blade material=2 length=6\nleaf: l maple\n"),
              "m.v:2:1: there is no 'material: 2' above this line");
    EXPECT_EQ(error_of(organ + "leaf: l mapel\n"), "m.v:3:1: no leaf for l: there is no such leaf");
    EXPECT_EQ(error_of(organ + "leaf: l\n"),
              "m.v:3:1: expected 'leaf: LETTER GRAMMAR [variants=] [age=]'");
    EXPECT_EQ(error_of(organ + "leaf: l maple variants=65\n"),
              "m.v:3:1: found variants=65, expected a whole number, 1 to 64");
    EXPECT_EQ(error_of(organ + "leaf: l maple age=2\n"), "m.v:3:1: found age=2, expected 0 to 1");
    EXPECT_EQ(error_of(organ + "leaf: l maple size=2\n"),
              "m.v:3:1: found 'size=2', expected variants= or age=");
}

TEST(CalendarOfAView, SaysWhenAnOrganIsThere)
{
    auto const view = view_with(kOrgan
                                + std::string("leaf: l maple variants=2\n"
                                              "calendar: l opens=4.5 bare=12\n"));
    ASSERT_TRUE(view) << view.error().message;
    OrganCalendar const expected { .opens = 4.5, .bare = 12 };
    EXPECT_EQ(view->organs.at(0).shape.calendar, expected);
    EXPECT_EQ(view->organs.at(0).leaves.at(1).calendar, expected) << "and its leaves'";
    auto const evergreen = view_with(kOrgan + std::string("calendar: l evergreen\n"));
    ASSERT_TRUE(evergreen) << evergreen.error().message;
    EXPECT_TRUE(evergreen->organs.at(0).shape.calendar.value().is_evergreen);
}

TEST(CalendarOfAView, SaysWhereItIsWrong)
{
    auto const error_of = [](std::string const& text) {
        auto const view = view_with(text);
        return view ? "no error" : view.error().message;
    };
    std::string const organ = kOrgan;
    EXPECT_EQ(error_of("calendar: l evergreen\n"),
              "m.v:1:1: there is no 'organ: l …' above this line");
    EXPECT_EQ(error_of(organ + "calendar: l closes=4\n"),
              "m.v:3:1: found 'closes=4', expected opens=, grown=, turns= or bare=");
    EXPECT_EQ(error_of(organ + "calendar: l opens=6\n"),
              "m.v:3:1: found the months 6, 5.5, 9, 11.3, expected them to ascend from 1 to 13");
    EXPECT_NE(error_of(organ + "calendar: l bare=nan\n"), "no error");
    EXPECT_NE(error_of(organ + "calendar: l\n"), "no error");
}

TEST(LeafSheet, SaysInItsNameHowFarAgesAreSpread)
{
    LeafOrder const order { .grammar = "oak", .variants = 4, .age = 0.82, .spread = 0.08 };
    EXPECT_EQ(leaf_sheet_name(order), "oak 4 0.82 0.08.leaf-sheet");
    EXPECT_EQ(parse_leaf_sheet_name(leaf_sheet_name(order)), order);
    for (auto const* const other :
         { "oak 4 2.leaf-sheet", "oak 4 0.5 nan.leaf-sheet", "oak 4 0.5 -1.leaf-sheet" })
        EXPECT_FALSE(parse_leaf_sheet_name(other)) << other;
}

} // namespace
} // namespace tractus::lsystem
