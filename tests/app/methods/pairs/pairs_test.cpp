#include "app/methods/all_methods.h"
#include "app/tools/bent_plant.h"
#include "app/tools/branch_place.h"
#include "engine/methods/construction_lines/line_edits.h"
#include "engine/methods/leaves/leaf_sketch_edits.h"
#include "engine/methods/silhouettes/tree_edits.h"
#include "engine/methods/sketch_lsystem/change_edits.h"
#include "engine/plant/join_axes.h"
#include "engine/plant/plant_addresses.h"
#include "tests/app/methods/pairs/document_of_all_methods.h"
#include "tests/app/session/small_session.h"

#include <array>
#include <cmath>

namespace tractus::methods {
namespace {

// Edits that are applied one after the other, so that later ones can name what earlier ones made.
class Steps {
public:
    explicit Steps(scene::Scene scene)
        : scene_(std::move(scene))
    {
    }

    void add(scene::Edit const& edit)
    {
        auto next = scene::apply_edit(scene_, edit);
        ASSERT_TRUE(next) << next.error().message;
        scene_ = *std::move(next);
        edits_.push_back(edit);
    }

    scene::ItemId active() const { return scene_.state.active; }
    std::vector<scene::Edit> const& edits() const { return edits_; }

private:
    scene::Scene scene_;
    std::vector<scene::Edit> edits_;
};

Stroke paper_stroke(std::vector<Vec2> const& corners)
{
    std::vector<Vec3> places_mm;
    for (auto const& corner : corners)
        places_mm.emplace_back(corner.x(), corner.y(), 100);
    return stroke_through(places_mm);
}

void load_model(Steps& steps, double x_mm)
{
    auto model = small_model();
    model.drawn = scene::Drawn::Beside;
    model.stands_at_mm = { x_mm, 0, 0 };
    steps.add(model);
}

// The model has the same rules with longer internodes.
scene::Edit change_model(scene::ItemId)
{
    auto model = small_model();
    model.source.text.replace(model.source.text.find("F(10)"), 5, "F(13)");
    model.drawn = scene::Drawn::Keep;
    return model;
}

void grow_along_stroke(Steps& steps, double x_mm)
{
    sketch::GrowAlongStroke edit { .rule = { .shortest_mm = 8 } };
    edit.stroke = stroke_through({ { x_mm, 0, 0 }, { x_mm + 20, 10, 70 }, { x_mm, 20, 150 } });
    steps.add(edit);
}

scene::Edit change_rule(scene::ItemId plant)
{
    return sketch::ChangeSketch { plant, 0, { .laterals = 3, .shortest_mm = 8 } };
}

void draw_tree(Steps& steps, double x_mm)
{
    using silhouette::DrawTree;
    steps.add(DrawTree { .part = DrawTree::Part::Trunk,
                         .stroke = paper_stroke({ { x_mm, -60 }, { x_mm, 5 } }),
                         .stands_at_mm = { x_mm, 0, 0 } });
    std::vector<Vec2> crown;
    for (int i = 0; i <= 24; ++i) {
        double const angle = i * kPi / 12;
        double const lobes = 40 + 4 * std::cos(5 * angle);
        crown.emplace_back(x_mm + lobes * std::sin(angle), 10 - lobes * std::cos(angle));
    }
    steps.add(DrawTree {
        .part = DrawTree::Part::Outline, .stroke = paper_stroke(crown), .plant = steps.active() });
}

scene::Edit change_form(scene::ItemId plant)
{
    silhouette::TreeForm form;
    form.leaves = 3;
    return silhouette::FormTree { plant, form };
}

void draw_lines(Steps& steps, double x_mm)
{
    std::vector<std::vector<Vec2>> const lines { { { 0, -60 }, { 0, 60 } },
                                                 { { -30, -60 }, { -20, 70 } },
                                                 { { 40, -60 }, { 40, 70 } },
                                                 { { -50, -20 }, { 0, -40 }, { 60, -10 } },
                                                 { { -50, 60 }, { 0, 30 }, { 60, 70 } } };
    for (std::size_t i = 0; i < lines.size(); ++i) {
        auto moved = lines[i];
        for (auto& corner : moved)
            corner.x() += x_mm;
        steps.add(lines::AddLine { .plant = i == 0 ? 0 : steps.active(),
                                   .stroke = paper_stroke(moved),
                                   .nodes = 5,
                                   .stands_at_mm = { x_mm, 0, 0 } });
    }
}

scene::Edit change_pattern(scene::ItemId plant)
{
    return lines::SetLinePattern { plant, { .kind = lines::Pattern::Kind::Decussate } };
}

void draw_leaf(Steps& steps, double x_mm)
{
    std::vector<Vec2> outline;
    for (int i = 0; i <= 24; ++i) {
        double const angle = i * kPi / 12;
        outline.emplace_back(x_mm + 20 * std::sin(angle), -40 * std::cos(angle));
    }
    steps.add(
        leaf::AddLeafLine { .stroke = paper_stroke(outline), .stands_at_mm = { x_mm, 0, 0 } });
    steps.add(leaf::AddLeafLine { .plant = steps.active(),
                                  .stroke = paper_stroke({ { x_mm, -60 }, { x_mm, 39 } }) });
}

scene::Edit change_leaf(scene::ItemId plant)
{
    return leaf::FormLeaf { plant, { .bend_deg = 40 } };
}

struct MethodOfPair {
    char const* name;
    void (*make)(Steps& steps, double x_mm);
    scene::Edit (*change)(scene::ItemId plant);
};

constexpr std::array<MethodOfPair, 5> kMethods { {
    { "a model", load_model, change_model },
    { "a rule along a stroke", grow_along_stroke, change_rule },
    { "an outline", draw_tree, change_form },
    { "construction lines", draw_lines, change_pattern },
    { "a leaf", draw_leaf, change_leaf },
} };

std::vector<scene::Edit> made(MethodOfPair const& method, scene::Scene const& before, double x_mm)
{
    Steps steps(before);
    method.make(steps, x_mm);
    return steps.edits();
}

// The part's segments, in the plant that bears it.
std::size_t segments_of_part(scene::Scene const& scene, scene::ItemId part)
{
    std::size_t count = 0;
    for (SegmentId segment = 0; segment < scene.base->segment_count(); ++segment)
        count += part_of(scene.rest->addresses.address_of(*scene.base, segment)) == part;
    return count;
}

class Pairs : public session::SessionFolder {
protected:
    // A session with both plants, the guest on the host, and a stroke on the guest.
    Result<session::Session> begin(MethodOfPair const& host, MethodOfPair const& guest)
    {
        std::vector<scene::Edit> first { scene::SetScale { 0.1 } };
        auto const scene = scene::apply_edits({}, first).value();
        for (auto& edit : made(host, scene, 0))
            first.push_back(edit);
        auto session = TRY(session::Session::create(path(), { .plant = "pair", .program = "1" },
                                                    first, options_for_all_methods()));
        host_ = session.scene().state.active;
        TRY(session.append(made(guest, session.scene(), 120)));
        guest_ = session.scene().state.active;
        auto const& plant = *session.scene().plants.at(0);
        SegmentId const middle = plant.base->axes.at(0).segment_count / 2;
        auto const place
            = TRY(tools::branch_at(session.scene(), tools::BentPlant(plant).end_of(middle),
                                   Vec3::UnitZ(), tools::Grafting::Beside, guest_));
        auto const before = session.scene().plants.at(1)->base->segment_count();
        TRY(session.append(tools::graft_edits(session.scene(), place, guest_)));
        auto const& scene_now = session.scene();
        EXPECT_EQ(scene_now.plants.size(), 1u);
        EXPECT_EQ(segments_of_part(scene_now, guest_), before);
        auto const stem = in_part(part_prefix(guest_), { 0, 0 });
        auto const segment = scene_now.rest->addresses.find_segment(*scene_now.base, stem).value();
        auto const axis = scene_now.base->axes[axis_of(*scene_now.base, segment)];
        TRY(session.append(std::vector<scene::Edit> {
            scene::select_paths(scene_now, { segments_of(axis) }),
            scene::Associate { stroke_through({ { 0, 0, 0 }, { 10, 0, 30 }, { 60, 0, 60 } }) } }));
        return session;
    }

    scene::ItemId host_ = 0;
    scene::ItemId guest_ = 0;
};

TEST_F(Pairs, AreOnePlantWhateverMadeTheTwo)
{
    for (auto const& host : kMethods)
        for (auto const& guest : kMethods) {
            SCOPED_TRACE(std::string(guest.name) + " on " + host.name);
            std::filesystem::remove(path());
            auto opened = begin(host, guest);
            ASSERT_TRUE(opened) << opened.error().message;
            auto& session = *opened;
            auto const drawn = session.scene();
            ASSERT_EQ(drawn.associations.size(), 1u);
            EXPECT_FALSE(drawn.associations[0].what.is_orphaned);
            check_plant(*drawn.base);
            // The first is changed: the second stands on it still, with what was drawn on it.
            ASSERT_TRUE(session.append(std::vector<scene::Edit> { host.change(host_) }));
            auto const file = exported(drawn);
            EXPECT_TRUE(exported(session.scene()) != file);
            EXPECT_EQ(segments_of_part(session.scene(), guest_), segments_of_part(drawn, guest_));
            EXPECT_FALSE(session.scene().associations[0].what.is_orphaned);
            // Undone, saved, opened, exported.
            ASSERT_TRUE(session.undo());
            EXPECT_TRUE(session::same_scene(session.scene(), drawn));
            opened = tl::unexpected(Error {});
            opened = session::Session::open(path(), options_for_all_methods());
            ASSERT_TRUE(opened) << opened.error().message;
            EXPECT_TRUE(session::same_scene(opened->scene(), drawn));
            EXPECT_TRUE(exported(opened->scene()) == file);
            ASSERT_TRUE(opened->redo());
            EXPECT_EQ(segments_of_part(opened->scene(), guest_), segments_of_part(drawn, guest_));
        }
}

// A part is changed by its own method where that reaches parts; else it is refused in a sentence,
// and can be taken off, changed and put on again.
TEST_F(Pairs, TheSecondIsChangedAsAPartOrByItself)
{
    for (auto const& guest : kMethods) {
        SCOPED_TRACE(guest.name);
        std::filesystem::remove(path());
        auto opened = begin(kMethods[0], guest);
        ASSERT_TRUE(opened) << opened.error().message;
        auto const scene = opened->scene();
        bool const is_sketch = guest.make == grow_along_stroke;
        sketch::ChangeSketch const in_place { host_, guest_, { .laterals = 3, .shortest_mm = 8 } };
        EXPECT_EQ(scene::apply_edit(scene, in_place).has_value(), is_sketch);
        if (guest.make != load_model) { // A model is loaded for the plant that is active.
            EXPECT_FALSE(scene::apply_edit(scene, guest.change(guest_)));
        }
        auto const off
            = scene::apply_edit(scene, scene::TakeOffGraft { host_, guest_, { 120, 0, 0 } })
                  .value();
        ASSERT_EQ(off.plants.size(), 2u);
        EXPECT_EQ(off.associations.size(), 1u);
        auto const changed = scene::apply_edit(off, guest.change(off.state.active)).value();
        EXPECT_TRUE(exported(changed) != exported(off));
        auto const at = changed.plants[0]->rest->addresses.address_of(*changed.plants[0]->base, 2);
        auto const again
            = scene::apply_edit(changed, scene::GraftPlant { changed.state.active, host_, at })
                  .value();
        EXPECT_EQ(again.plants.size(), 1u);
        EXPECT_EQ(segments_of_part(again, changed.state.active), changed.base->segment_count());
    }
}

} // namespace
} // namespace tractus::methods
