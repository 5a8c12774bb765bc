#include "app/methods/all_organs.h"

#include "app/methods/construction_lines/organ_library.h"
#include "engine/lsystem/view/view_texture.h"
#include "engine/methods/construction_lines/bring_organ.h"
#include "engine/methods/construction_lines/line_edits.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace tractus::methods {

namespace fs = std::filesystem;

std::vector<OrganKind> organ_kinds()
{
    std::vector<OrganKind> kinds;
    for (auto const& name : lines::organ_names())
        if (auto path = lines::own_organ_path(name))
            kinds.push_back({ name, *std::move(path) });
    return kinds;
}

bool is_organ_file(fs::path const& file)
{
    return file.extension() == lines::kOrganEnding;
}

std::vector<DrawnOrgan> drawn_organs(scene::DocumentState const& state)
{
    std::vector<DrawnOrgan> drawn;
    for (auto const& plant : state.plants)
        if (auto const* const sketch = lines::pen_sketch(*plant))
            for (auto const& organ : sketch->organs)
                if (auto const file = lines::organ_file(organ); file && !organ.sketch)
                    drawn.push_back({ plant->id, lines::print_organ(*file) });
    return drawn;
}

bool takes_organs(scene::DocumentState const& state)
{
    return lines::active_pen_sketch(state) != nullptr;
}

Result<std::vector<scene::Edit>> organ_edits(scene::Scene const& scene, fs::path const& file)
{
    auto const* const sketch = lines::active_pen_sketch(scene.state);
    if (!sketch)
        return fail(Fault::User,
                    "the plant that takes what is drawn has no construction lines, which leaves in "
                    "three views belong to: choose one that has");
    auto const organ = TRY(lines::load_organ(file));
    auto const sheet = lines::sheet_of(*scene::active_plant(scene.state), scene.state.scale);
    return std::vector<scene::Edit> { lines::BringOrgan {
        .plant = scene.state.active,
        .at_mm = lines::place_beside(*sketch, sheet, organ),
        .text = lines::print_organ(organ) } };
}

std::string describe_organ(scene::DocumentState const& after)
{
    auto const* const sketch = lines::active_pen_sketch(after);
    return sketch && sketch->organs.size() > 1
        ? "The topmost layer bears the leaf: Layer's organ gives it to others"
        : "The plant bears the leaf, whose lines are beside it";
}

Result<Plant> plant_of_organ(fs::path const& file)
{
    auto const organ = TRY(lines::load_organ(file));
    auto const surface = TRY(lines::surface_of(organ));
    constexpr double kLength_mm = 100;
    Plant plant;
    auto const color = surface.color.value_or(lines::rgb_of(lines::OrganColor::Leaf));
    plant.materials.push_back({ .name = "leaf",
                                .kind = Material::Kind::Leaf,
                                .base_color = color.cast<float>(),
                                .roughness = 0.5F,
                                .translucency = 0.45F });
    if (surface.picture)
        TRY(lsystem::put_texture(plant.materials.back(), *surface.picture));
    plant.organ_shapes.push_back(
        { .kind = OrganShape::Kind::Surface, .length_mm = kLength_mm, .patches = surface.patches });
    double lowest_mm = 0; // Negative if edges of the blade extend behind its base.
    for (auto const& patch : surface.patches)
        for (auto const& point : patch.control)
            lowest_mm = std::min(lowest_mm, point.y());
    plant.organs.push_back({ .position_mm = { 0, 0, -lowest_mm },
                             // Turns the organ so that its length axis points upwards.
                             .orientation = Quat(Eigen::AngleAxisd(kPi / 2, Vec3::UnitX())) });
    return plant;
}

} // namespace tractus::methods
