#include "app/methods/all_methods.h"
#include "app/tools/bent_plant.h"
#include "app/tools/branch_place.h"
#include "engine/plant/join_axes.h"
#include "engine/plant/plant_addresses.h"
#include "tests/app/methods/pairs/document_of_all_methods.h"
#include "tests/app/methods/pairs/plant_of_each_method.h"
#include "tests/app/session/small_session.h"

namespace tractus::methods {
namespace {

std::vector<scene::Edit> made(MethodOfPair const& method, scene::Scene const& before, double x_mm)
{
    Steps steps(before);
    method.make(steps, x_mm);
    return steps.edits();
}

// Returns the number of segments that a part has in the plant on which it was grafted.
std::size_t segments_of_part(scene::Scene const& scene, scene::ItemId part)
{
    std::size_t count = 0;
    for (SegmentId segment = 0; segment < scene.base->segment_count(); ++segment)
        count += part_of(scene.rest->addresses.address_of(*scene.base, segment)) == part;
    return count;
}

class Pairs : public session::SessionFolder {
protected:
    // Begins a session in which the guest plant is grafted on the host plant, with a stroke on the
    // guest.
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
            // After the host has changed, the guest must still be on it, with the guest's stroke.
            ASSERT_TRUE(session.append(std::vector<scene::Edit> { host.change(host_) }));
            auto const file = exported(drawn);
            EXPECT_TRUE(exported(session.scene()) != file);
            EXPECT_EQ(segments_of_part(session.scene(), guest_), segments_of_part(drawn, guest_));
            EXPECT_FALSE(session.scene().associations[0].what.is_orphaned);
            // After undoing, saving, opening and exporting, the document must be the same.
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

// If a guest's method supports parts, the guest can be changed on its host. Otherwise the change is
// refused with a message, and the guest can be taken off, changed and grafted again.
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
        if (guest.make != load_model) { // A change of a model always loads it for the active plant.
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
