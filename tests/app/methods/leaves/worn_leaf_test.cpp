#include "app/batch/plant_file.h"
#include "app/batch/plant_group.h"
#include "app/batch/plant_season.h"
#include "app/document/document.h"
#include "app/methods/all_leaves.h"
#include "app/methods/leaves/leaf_library.h"
#include "app/methods/leaves/leaf_line_tool.h"
#include "engine/base/file.h"
#include "engine/methods/leaves/leaf_sketch_edits.h"
#include "tests/app/our_plant.h"
#include "tests/app/small_model.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace tractus::leaf {
namespace {

namespace fs = std::filesystem;

Stroke worn_outline(double half_width_mm)
{
    std::vector<Vec3> places;
    for (int i = 0; i <= 80; ++i) {
        double const t = i <= 40 ? i / 40.0 : (80 - i) / 40.0;
        double const side = i <= 40 ? 1 : -1;
        places.emplace_back(side * half_width_mm * std::sin(t * kPi), -40 + 80 * t, 120);
    }
    return stroke_through(places);
}

// Fixture with a tree and, beside it, a leaf that was drawn by its outline.
class WornLeaf : public testing::Test {
protected:
    WornLeaf()
        : document_(our_plant("broadleaf"), document::Document::Working::AtOnce,
                    batch::following_edits)
        , tree_(scene().state.active)
    {
        draw(worn_outline(20));
        leaf_ = scene().state.active;
    }

    scene::Scene const& scene()
    {
        snapshot_ = document_.newest();
        return snapshot_->scene;
    }

    void draw(Stroke const& stroke)
    {
        document_.draw({ stroke, LeafLineTool {} });
        for (auto const& drawn : document_.take_finished_strokes())
            EXPECT_EQ(drawn.refusal, "");
    }

    void draw_vein(double side = 1)
    {
        draw(stroke_through({ { 0, -5, 120 }, { side * 12, 8, 120 } }));
    }

    void make(std::vector<scene::Edit> edits)
    {
        document_.make({ [edits = std::move(edits)](
                             scene::Scene const&) -> Result<document::StepRequest::Change> {
            return document::StepRequest::Change { edits, "made" };
        } });
    }

    void put_on(methods::Foliage const& foliage)
    {
        auto edits = methods::foliage_edits(scene(), tree_, foliage);
        ASSERT_TRUE(edits) << edits.error().message;
        make(*std::move(edits));
    }

    // Returns the bytes of a .glb file of the tree alone, without the drawn leaf.
    std::string tree()
    {
        auto shown = scene();
        std::erase_if(shown.plants, [&](auto const& plant) { return plant->drawn->id != tree_; });
        auto const path = fs::temp_directory_path() / fmt::format("worn-{}.glb", ::getpid());
        EXPECT_TRUE(batch::write_plant_file(batch::shown_plants(shown).value(), "tree", path));
        auto const bytes = read_text_file(path, std::size_t { 1 } << 30);
        fs::remove(path);
        return bytes.value();
    }

    std::shared_ptr<document::Snapshot const> snapshot_;
    document::Document document_;
    scene::ItemId tree_ = 0;
    scene::ItemId leaf_ = 0;
};

TEST_F(WornLeaf, FollowsItsDrawingAsIfItWerePutOnAfterwards)
{
    put_on({ .drawn = leaf_ });
    auto const before = tree();
    draw_vein();
    auto const followed = tree();
    EXPECT_NE(followed, before);
    document_.undo();
    EXPECT_EQ(tree(), before) << "one step";
    document_.redo();
    EXPECT_EQ(tree(), followed);

    document::Document other(our_plant("broadleaf"), document::Document::Working::AtOnce);
    other.draw({ worn_outline(20), LeafLineTool {} });
    other.draw({ stroke_through({ { 0, -5, 120 }, { 12, 8, 120 } }), LeafLineTool {} });
    auto const drawn = other.newest()->scene;
    auto const edits = methods::foliage_edits(drawn, tree_, { .drawn = leaf_ });
    ASSERT_TRUE(edits) << edits.error().message;
    auto const afterwards = scene::apply_edits(drawn, *edits).value();
    auto const& name = afterwards.state.plants[0]->leaves;
    ASSERT_EQ(scene().state.plants[0]->leaves, name);
    EXPECT_EQ(lsystem::print_leaf_sheet(*scene().state.leaf_sheets.at(name)),
              lsystem::print_leaf_sheet(*afterwards.state.leaf_sheets.at(name)));
    EXPECT_EQ(scene().state.leaf_sheets.size(), 1u) << "that of the earlier drawing is gone";
}

TEST_F(WornLeaf, FollowsItsNumbersAndKeepsHowItIsWorn)
{
    put_on({ .drawn = leaf_, .age = 0.6, .damage = { .spots = 0.25, .larvae = 2 } });
    auto const before = tree();
    make({ leaf::FormLeaf { leaf_, { .teeth = 9 } } });
    EXPECT_NE(tree(), before);
    auto const worn = methods::chosen_foliage(scene().state, tree_);
    ASSERT_TRUE(worn);
    EXPECT_EQ(worn->drawn, leaf_);
    EXPECT_EQ(worn->age, 0.6);
    EXPECT_EQ(worn->damage, (lsystem::LeafDamage { .spots = 0.25, .larvae = 2 }));
}

TEST_F(WornLeaf, StaysWhenItsDrawingIsRemoved)
{
    put_on({ .drawn = leaf_ });
    auto const before = tree();
    make({ scene::RemovePlant { leaf_ } });
    EXPECT_EQ(tree(), before);
    auto const worn = methods::chosen_foliage(scene().state, tree_);
    ASSERT_TRUE(worn);
    EXPECT_EQ(worn->drawn, 0u);
    EXPECT_TRUE(methods::grammar_of(scene().state, *worn)) << "its text is kept";
    document_.undo();
    make({ scene::ActivatePlant { leaf_ } });
    draw_vein();
    EXPECT_NE(tree(), before) << "it follows again";
}

TEST_F(WornLeaf, FollowsInTheSeason)
{
    put_on({ .drawn = leaf_ });
    make(batch::season_edits(scene(), scene::Season { .month = 10.5 }).value());
    auto const before = tree();
    draw_vein();
    EXPECT_NE(tree(), before);
    auto const missing = scene::missing_leaves(*scene().plants[0]->foliated, *scene().state.season,
                                               scene().state.leaf_sheets);
    EXPECT_TRUE(missing.empty());
    EXPECT_EQ(scene().state.leaf_sheets.size(), 2u) << "grown-up and old ones, of this drawing";
}

// In older sessions, a tree wears a drawn leaf by the text of a file, not by reference to the
// drawing.
TEST_F(WornLeaf, StaysAsItIsWhereItIsWornFromAFile)
{
    auto const file = fs::temp_directory_path() / fmt::format("drawn-leaf{}.leaf", ::getpid());
    ASSERT_TRUE(write_file(file, methods::drawn_leaves(scene().state).at(0).text));
    put_on({ .leaves = file.string() });
    fs::remove(file);
    auto const before = tree();
    draw_vein();
    EXPECT_EQ(tree(), before);
}

TEST_F(WornLeaf, WearsNoLeavesItself)
{
    auto const edits = methods::foliage_edits(scene(), leaf_, { .drawn = leaf_ });
    ASSERT_FALSE(edits);
    EXPECT_EQ(edits.error().message,
              "a drawn leaf wears no leaves itself: choose the plant that shall have them");
}

TEST(LeafWord, SaysWhatIsDoneToLeaves)
{
    lsystem::LeafWord const wanted { "my+own.leaf", { .spots = 0.25, .mines = 2, .withered = 1 } };
    EXPECT_EQ(lsystem::leaf_word(wanted), "my+own.leaf+spots=0.25+mines=2+withered=1");
    EXPECT_EQ(lsystem::parse_leaf_word(lsystem::leaf_word(wanted)), wanted);
    EXPECT_EQ(lsystem::leaf_word({ "oak", {} }), "oak");
    EXPECT_TRUE(lsystem::check_leaf_name("my+own.leaf"));
    for (auto const* const name : { "a+b", "a+spots=2", "a+spots=x", "a+spots=", "oak+rust=1" })
        EXPECT_EQ(lsystem::parse_leaf_word(name).grammar, name);
    auto const wrong = own_leaf_path("oak+spots=3");
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().message,
              "a leaf's damage: found spots=3, expected spots (0 to 1), mildew (0 to 1), "
              "mines (0 to 20), larvae (0 to 20), withered (0 to 1)");
}

double share_of_paper(render::Image const& image, render::Color const& paper)
{
    return static_cast<double>(std::ranges::count(image.pixels(), paper))
        / static_cast<double>(image.pixels().size());
}

TEST(LeafStudy, ShowsALeafWithItsDamage)
{
    render::Color const paper { 250, 250, 248, 255 };
    auto const grammar = load_own_leaf_grammar("oak").value();
    auto const whole = study_leaf(grammar, {}, paper).value();
    auto const eaten = study_leaf(grammar, { .damage = { .larvae = 8 } }, paper).value();
    EXPECT_EQ(whole.others.size(), 6u);
    EXPECT_GT(share_of_paper(eaten.leaf, paper), share_of_paper(whole.leaf, paper) + 0.01);
    auto const white = study_leaf(grammar, { .damage = { .mildew = 1 } }, paper).value();
    EXPECT_NE(white.leaf, whole.leaf);
    // The number of background-coloured pixels stays nearly equal: mildew only at the edge may be
    // as white as the background.
    EXPECT_NEAR(share_of_paper(white.leaf, paper), share_of_paper(whole.leaf, paper), 0.002);
    EXPECT_NE(whole.others[0], whole.others[1]);
    EXPECT_EQ(study_leaf(grammar, {}, paper).value().leaf, whole.leaf);
}

} // namespace
} // namespace tractus::leaf
