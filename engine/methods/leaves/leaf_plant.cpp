#include "engine/methods/leaves/leaf.h"
#include "engine/methods/leaves/leaf_lines.h"
#include "engine/methods/leaves/leaf_sketch.h"
#include "engine/methods/leaves/leaf_triangles.h"
#include "engine/methods/leaves/print_grammar.h"
#include "engine/plant/branch_address.h"
#include "engine/scene/document_state.h"
#include "engine/stroke/polyline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <utility>

// This file builds the plant of a leaf sketch: polygons on a stalk or, if the lines do not form a
// leaf yet, a stem along each line.
namespace tractus::leaf {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

constexpr MaterialId kStalk = 0;
constexpr MaterialId kVeins = 1;
constexpr MaterialId kLimb = 2;

// Converts paper coordinates (x, y, depth) to the plant's frame.
class PaperToPlant {
public:
    PaperToPlant(Vec2 const& foot_mm, double scale)
        : foot_mm_(foot_mm)
        , scale_(scale)
    {
    }

    Vec3 operator()(Vec3 const& place) const
    {
        return Vec3(place.x() - foot_mm_.x(), -place.z(), place.y() - foot_mm_.y()) / scale_;
    }

private:
    Vec2 foot_mm_;
    double scale_;
};

void add_axis(scene::BuiltSource& built, std::span<Vec3 const> nodes, double radius,
              std::string_view name)
{
    auto& plant = built.plant;
    plant.axes.push_back({ .first_node = static_cast<NodeId>(plant.node_position_mm.size()),
                           .first_segment = static_cast<SegmentId>(plant.segment_count()),
                           .segment_count = static_cast<std::uint32_t>(nodes.size() - 1) });
    plant.node_position_mm.insert(plant.node_position_mm.end(), nodes.begin(), nodes.end());
    plant.node_radius_mm.resize(plant.node_position_mm.size(), static_cast<float>(radius));
    plant.segment_material.resize(plant.segment_count() + nodes.size() - 1, kStalk);
    built.axis_keys.push_back(axis_key(name));
}

std::vector<Material> materials()
{
    return { { .name = "stalk",
               .kind = Material::Kind::Stem,
               .base_color = { 0.5f, 0.58f, 0.3f },
               .roughness = 0.6f },
             { .name = "veins",
               .kind = Material::Kind::Petal,
               .base_color = { 0.66f, 0.74f, 0.42f },
               .roughness = 0.6f,
               .translucency = 0.2f },
             { .name = "limb",
               .kind = Material::Kind::Petal,
               .base_color = { 0.28f, 0.47f, 0.17f },
               .roughness = 0.55f,
               .translucency = 0.4f } };
}

struct DerivedLeaf {
    Grammar grammar;
    std::optional<Leaf> leaf {}; // The derived leaf; always set. It refers to `grammar`.
    LeafTriangles triangles {};
};

Result<std::unique_ptr<DerivedLeaf const>> derived(LeafSketch const& sketch, DrawnLeaf const& drawn)
{
    auto made = std::make_unique<DerivedLeaf>(
        DerivedLeaf { TRY(parse_grammar(print_grammar(drawn, "drawn"), "the drawn leaf")) });
    auto const& grammar = made->grammar;
    auto& leaf = made->leaf;
    leaf = TRY(Leaf::begin(grammar,
                           { .final_step = grammar.steps,
                             .seed = sketch.seed.value_or(1),
                             .variation = sketch.seed ? sketch.spread : 0 }));
    while (leaf->step() < grammar.steps)
        TRY(leaf->derive());
    TRY(leaf->fill());
    made->triangles = triangles_of(*leaf);
    return made;
}

// Returns the position in space of the leaf's vertex that is nearest to a place in the flat leaf.
Vec3 vertex_at(LeafTriangles const& leaf, Vec2 const& flat)
{
    auto const nearest = std::ranges::min_element(
        leaf.flat, {}, [&](Vec2 const& each) { return (each - flat).squaredNorm(); });
    return leaf.positions[static_cast<std::size_t>(nearest - leaf.flat.begin())];
}

// Returns a frame whose y axis points along the leaf and whose z axis points out of its upper side.
Eigen::Matrix3d frame_of(Vec3 const& along, Vec3 const& up)
{
    Vec3 const y = along.normalized();
    Vec3 const z = (up - up.dot(y) * y).normalized();
    Eigen::Matrix3d frame;
    frame << y.cross(z), y, z;
    return frame;
}

void add_triangles(Plant& plant, std::span<Triangle const> triangles,
                   std::span<Vec3 const> positions_mm, MaterialId material)
{
    for (auto const& [a, b, c] : triangles) {
        Vec3 const area
            = (positions_mm[b] - positions_mm[a]).cross(positions_mm[c] - positions_mm[a]);
        if (!(area.norm() > 0))
            continue;
        plant.polygons.push_back(
            { .first_vertex = static_cast<std::uint32_t>(plant.polygon_vertices_mm.size()),
              .vertex_count = 3,
              .segment = 0,
              .material = material });
        for (auto const corner : { a, b, c })
            plant.polygon_vertices_mm.push_back(positions_mm[corner]);
    }
}

// Maps a grown leaf to its drawing, so that its blade extends from the drawn base to the drawn tip.
class LeafToPaper {
public:
    LeafToPaper(BladePlace const& place, DrawnLeaf const& drawn, LeafTriangles const& leaf)
        : place_(place)
        , size_mm_(drawn.size_mm)
        , base_(vertex_at(leaf, { 0, drawn.stalk }))
    {
        // The rachis of a compound leaf is flat, and its leaflets are anywhere.
        if (drawn.is_compound())
            base_ = Vec3(0, drawn.stalk, 0);
        Vec3 const tip = drawn.is_compound() ? Vec3(base_ + Vec3::UnitY())
                                             : vertex_at(leaf, { 0, drawn.stalk + 1 });
        turn_ = frame_of(place.tip_mm - place.base_mm, place.normal)
            * frame_of(tip - base_, Vec3::UnitZ()).transpose();
    }

    Vec3 const& base() const { return base_; }

    Vec3 operator()(Vec3 const& at) const
    {
        return place_.base_mm + size_mm_ * (turn_ * (at - base_));
    }

private:
    BladePlace place_;
    double size_mm_;
    Vec3 base_;
    Eigen::Matrix3d turn_;
};

Result<scene::BuiltSource> leaf_plant(LeafSketch const& sketch, DrawnLeaf const& drawn)
{
    auto const made = TRY(derived(sketch, drawn));
    auto const& leaf = made->triangles;
    LeafToPaper const to_paper(sketch.seen->fit.place, drawn, leaf);
    PaperToPlant const to_plant(TRY(foot_of(sketch)), sketch.scale);
    auto const placed = [&](Vec3 const& at) { return to_plant(to_paper(at)); };
    scene::BuiltSource built;
    built.plant.materials = materials();
    double const radius_mm = 0.5 * drawn.width * drawn.size_mm / sketch.scale;
    std::array const stalk { placed(vertex_at(leaf, Vec2::Zero())), placed(to_paper.base()) };
    add_axis(built, stalk, radius_mm, "stalk");
    std::vector<Vec3> positions_mm;
    for (auto const& at : leaf.positions)
        positions_mm.push_back(placed(at));
    add_triangles(built.plant, leaf.veins, positions_mm, kVeins);
    add_triangles(built.plant, leaf.limb, positions_mm, kLimb);
    return built;
}

Result<scene::BuiltSource> stems_along(LeafSketch const& sketch)
{
    constexpr double kRadius_mm = 0.4; // Radius, on the paper, of the stems that stand for lines.
    constexpr std::size_t kMaxNodes = 65;
    auto const drawing = TRY(drawing_of(sketch));
    PaperToPlant const to_plant(TRY(foot_of(sketch)), sketch.scale);
    scene::BuiltSource built;
    built.plant.materials = { materials()[kStalk] };
    for (std::size_t i = 0; i < sketch.lines.size(); ++i) {
        auto const& line = drawing.strokes[i];
        std::size_t const nodes = std::min(line.size(), kMaxNodes);
        std::vector<Vec3> points;
        for (std::size_t n = 0; n < nodes; ++n)
            points.push_back(to_plant(line[n * (line.size() - 1) / (nodes - 1)]));
        add_axis(built, points, kRadius_mm / sketch.scale, scene::name_of(sketch.lines[i].id));
    }
    return built;
}

} // namespace

Result<scene::BuiltSource> build_leaf(LeafSketch const& sketch, scene::LoadOptions const&)
{
    TRY(check_form(sketch.form));
    if (!(sketch.scale > 0 && std::isfinite(sketch.scale)))
        return fail(Fault::User,
                    fmt::format("a leaf cannot be shown {} times as large as it is", sketch.scale));
    if (auto const drawn = adjusted_leaf(sketch))
        return leaf_plant(sketch, *drawn);
    return stems_along(sketch);
}

Result<std::vector<std::vector<Vec3>>> lines_of_leaf(LeafSketch const& sketch)
{
    TRY(check_form(sketch.form));
    auto const drawn = adjusted_leaf(sketch);
    if (!drawn)
        return fail(Fault::User, "the lines are no leaf yet");
    auto const made = TRY(derived(sketch, *drawn));
    auto const& leaf = *made->leaf;
    auto const& triangles = made->triangles;
    LeafToPaper const to_paper(sketch.seen->fit.place, *drawn, triangles);
    std::vector<std::vector<Vec3>> lines(1);
    // The border begins at the first face, the stalk, whose first edge is free.
    Dart const start = 0;
    for (auto const dart : leaf.map().border(start))
        lines[0].push_back(to_paper(leaf.map().position_of(dart)));
    lines[0].push_back(lines[0].front());
    for (auto const& vein : leaf.veins())
        lines.push_back(
            { to_paper(vertex_at(triangles, vein.from)), to_paper(vertex_at(triangles, vein.to)) });
    return lines;
}

} // namespace tractus::leaf
