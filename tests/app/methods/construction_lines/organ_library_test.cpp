#include "app/methods/construction_lines/organ_library.h"

#include "app/methods/all_organs.h"
#include "engine/base/file.h"
#include "engine/mesh/make_mesh.h"
#include "engine/methods/construction_lines/bring_organ.h"
#include "tests/app/controllers/live_window_devices.h"
#include "tests/app/methods/construction_lines/construct_folder.h"
#include "tests/app/methods/construction_lines/drawn_frond.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <unistd.h>

namespace tractus::lines {
namespace {

using namespace line_tests;
namespace fs = std::filesystem;

// Each organ of the library must have a surface of the stated length and some width, upright on its
// base.
TEST(OrganLibrary, OursAreLeaves)
{
    auto const kinds = methods::organ_kinds();
    EXPECT_GE(kinds.size(), 5U);
    for (auto const& [name, file] : kinds) {
        auto const plant = methods::plant_of_organ(file);
        ASSERT_TRUE(plant) << name << ": " << plant.error().message;
        auto const mesh = mesh::make_mesh(*plant);
        ASSERT_EQ(mesh.organs.size(), 1U);
        auto const turned = mesh.organs[0].instances.at(0).rotation;
        Vec3f low = Vec3f::Constant(1e9F);
        Vec3f high = -low;
        for (auto const& at_mm : mesh.organs[0].prototype.positions_mm) {
            Vec3f const point = turned * at_mm;
            low = low.cwiseMin(point);
            high = high.cwiseMax(point);
        }
        EXPECT_GT(high.z() - low.z(), 30) << name;
        EXPECT_GT(low.z(), -0.2F * high.z()) << name << " goes up from its base";
        EXPECT_GT(high.x() - low.x(), 0.05F * high.z()) << name;
        EXPECT_NEAR(high.x(), -low.x(), 0.02F * high.z()) << name << " is symmetric";
        EXPECT_EQ(own_organ_path(name).value(), file);
    }
    auto const none = own_organ_path("oak-leaf");
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().message.find("or one of bell, heart,"), std::string::npos)
        << none.error().message;
}

class OrganChoices : public ::testing::Test {
protected:
    OrganChoices()
    {
        fs::create_directories(folder_);
        draw_frond(document_);
    }
    ~OrganChoices() override { fs::remove_all(folder_); }

    controllers::LiveWindow window() { return window(document_.newest()->scene); }
    controllers::LiveWindow window(scene::Scene const& scene)
    {
        auto options = controllers::live_options();
        options.scene = scene;
        options.leaves = folder_ / "leaves";
        options.cache = folder_ / "cache";
        auto window = controllers::LiveWindow::create(controllers::drawing_devices(false),
                                                      std::move(options))
                          .value();
        controllers::advance_to_end(window);
        return window;
    }

    // Returns the title of each card, with the text about what choosing the card does.
    static std::vector<std::string> cards(controllers::LiveWindow& window)
    {
        std::vector<std::string> titles;
        window.perform(view::OpenLeaves {});
        for (auto const& group : window.start_page()->state().groups)
            for (auto const& card : group.cards)
                titles.push_back(card.title + (card.detail.empty() ? "" : ": " + card.detail));
        window.start_page()->leave();
        window.advance({});
        return titles;
    }
    static bool offers(controllers::LiveWindow& window, std::string const& card)
    {
        auto const titles = cards(window);
        return std::ranges::find(titles, card) != titles.end();
    }

    static void choose(controllers::LiveWindow& window, std::string const& title)
    {
        window.perform(view::OpenLeaves {});
        auto const& groups = window.start_page()->state().groups;
        for (std::size_t group = 0; group < groups.size(); ++group)
            for (std::size_t card = 0; card < groups[group].cards.size(); ++card)
                if (groups[group].cards[card].title == title) {
                    window.start_page()->choose(group, card);
                    window.advance({});
                    window.settle();
                    return;
                }
        ADD_FAILURE() << "there is no card " << title;
    }
    static PenSketch const& sketch(controllers::LiveWindow const& window)
    {
        return *active_pen_sketch(window.scene().state);
    }

    fs::path folder_ = fs::temp_directory_path() / fmt::format("tractus_organs_{}", ::getpid());
    document::Document document_ { scene::Scene {}, document::Document::Working::AtOnce };
};

TEST_F(OrganChoices, ALeafOfOursComesToThePlant)
{
    auto window = this->window();
    choose(window, "Heart");
    EXPECT_EQ(window.state().status, "The plant bears the leaf, whose lines are beside it");
    ASSERT_EQ(sketch(window).organs.size(), 1U);
    auto const& bought = window.scene().base->organ_shapes;
    EXPECT_TRUE(std::ranges::any_of(
        bought, [](OrganShape const& shape) { return shape.kind == OrganShape::Kind::Surface; }));
    choose(window, "Petal");
    EXPECT_EQ(window.state().status,
              "The topmost layer bears the leaf: Layer's organ gives it to others");
    EXPECT_EQ(sketch(window).organs.size(), 2U);
    window.perform(view::Undo {});
    window.settle();
    EXPECT_EQ(sketch(window).organs.size(), 1U);
}

// A drawn leaf must be available in another drawing through the user's library.
TEST_F(OrganChoices, ADrawnLeafIsKeptAndBroughtToAnother)
{
    auto empty = window();
    EXPECT_FALSE(offers(empty, "drawn-leaf: In three views"));
    std::vector<Vec3> edge;
    for (int i = 0; i <= 20; ++i)
        edge.emplace_back(60 + 32 * i / 20.0 * (1 - i / 20.0), 2 * i, 50);
    document_.draw(
        { stroke_through(edge),
          tools::parse_tool(methods::all_methods().tools, "line_organ", "edge").value() });
    auto window = this->window();
    EXPECT_TRUE(offers(window, "Your leaf in three views: Choosing it keeps it among yours"));
    choose(window, "Your leaf in three views");
    EXPECT_NE(window.state().status.find("kept as drawn-leaf.organ"), std::string::npos)
        << window.state().status;
    ASSERT_TRUE(fs::exists(folder_ / "leaves" / "drawn-leaf.organ"));
    choose(window, "Your leaf in three views");
    EXPECT_FALSE(fs::exists(folder_ / "leaves" / "drawn-leaf-2.organ")) << "it is there already";
    EXPECT_TRUE(offers(empty, "drawn-leaf: In three views"));
    choose(empty, "drawn-leaf");
    ASSERT_EQ(sketch(empty).organs.size(), 1U);
    auto const kept = print_organ(organ_file(sketch(window).organs[0]).value());
    EXPECT_EQ(print_organ(load_organ(folder_ / "leaves" / "drawn-leaf.organ").value()), kept);
}

// A plant without construction lines must be offered grown leaves, such as "Oak", but no organs of
// the library.
TEST_F(OrganChoices, OnlyPlantsOfLinesBearThem)
{
    auto window = this->window(small_scene());
    EXPECT_FALSE(offers(window, "Heart"));
    EXPECT_TRUE(offers(window, "Oak"));
    auto const refused = methods::organ_edits(small_scene(), own_organ_path("heart").value());
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("has no construction lines"), std::string::npos);
}

} // namespace
} // namespace tractus::lines
