#include "engine/base/random.h"
#include "engine/methods/silhouettes/inferred_trees.h"
#include "engine/methods/silhouettes/line.h"
#include "engine/methods/silhouettes/outlined_tree.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <utility>

namespace tractus::silhouette {

namespace {

bool same_ink(Stroke const& one, Stroke const& other)
{
    return one.tips.id() == other.tips.id();
}

bool same_on_branches(std::vector<DrawnOnBranch> const& one,
                      std::vector<DrawnOnBranch> const& other)
{
    return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                      [](DrawnOnBranch const& a, DrawnOnBranch const& b) {
                          return a.id == b.id && a.branch == b.branch && a.style_to == b.style_to
                              && a.is_leaf == b.is_leaf && a.of_bump == b.of_bump
                              && same_ink(a.stroke, b.stroke);
                      });
}

bool same_touches(std::vector<DrawnTouch> const& one, std::vector<DrawnTouch> const& other)
{
    return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                      [](DrawnTouch const& a, DrawnTouch const& b) {
                          return a.id == b.id && a.branch == b.branch && a.kind == b.kind
                              && same_ink(a.stroke, b.stroke);
                      });
}

bool same_crown_lines(OutlinedTree const& one, OutlinedTree const& other)
{
    return one.ground_mm == other.ground_mm
        && std::equal(one.crown_lines.begin(), one.crown_lines.end(), other.crown_lines.begin(),
                      other.crown_lines.end(),
                      [](DrawnCrownLine const& a, DrawnCrownLine const& b) {
                          return a.id == b.id && same_ink(a.stroke, b.stroke);
                      });
}

bool same(OutlinedTree const& one, OutlinedTree const& other)
{
    return same_ink(one.trunk, other.trunk) && same_ink(one.outline, other.outline)
        && std::equal(one.branches.begin(), one.branches.end(), other.branches.begin(),
                      other.branches.end(),
                      [](DrawnBranch const& a, DrawnBranch const& b) {
                          return a.id == b.id && same_ink(a.stroke, b.stroke);
                      })
        && one.names == other.names && one.form == other.form && one.scale == other.scale
        && same_on_branches(one.own_outlines, other.own_outlines)
        && same_on_branches(one.own_branches, other.own_branches) && one.styles == other.styles
        && same_touches(one.touches, other.touches) && one.is_leaf == other.is_leaf
        && one.trunk_goes_on_mm == other.trunk_goes_on_mm && same_crown_lines(one, other);
}

Result<void> check_scale(double scale)
{
    if (!(scale > 0 && std::isfinite(scale)))
        return fail(Fault::User,
                    fmt::format("a tree cannot be shown {} times as large as it is", scale));
    return {};
}

constexpr double kShortestTrunk_mm = 5;

// A stem along the trunk, without branches.
Result<Plant> bare_stem(std::vector<Vec2> const& trunk, double scale)
{
    constexpr std::size_t kNodes = 17;
    // Radius of the stem at its foot, as a share of the stem's length.
    constexpr double kThickest = 0.02;
    double const length_mm = length_of(trunk);
    if (length_mm < kShortestTrunk_mm)
        return fail(Fault::User,
                    fmt::format("the trunk is shorter than {:g} mm: draw it from the foot upwards",
                                kShortestTrunk_mm));
    Plant plant;
    plant.materials.push_back({ .name = "bark", .base_color = TreeOptions {}.bark_color });
    plant.axes.push_back({ .segment_count = kNodes - 1 });
    plant.segment_material.resize(kNodes - 1, 0);
    auto const nodes = resampled_line(trunk, kNodes);
    for (std::size_t i = 0; i < kNodes; ++i) {
        Vec2 const up = (nodes[i] - nodes[0]) / scale;
        double const tapered = 1 - 0.8 * static_cast<double>(i) / (kNodes - 1);
        plant.node_position_mm.emplace_back(up.x(), 0, up.y());
        plant.node_radius_mm.push_back(static_cast<float>(tapered * kThickest * length_mm / scale));
    }
    return plant;
}

scene::BuiltSource built_of(Skeleton const& skeleton, OutlinedTree const& tree)
{
    auto made = make_tree(skeleton, tree_options(tree.form, drawn_height(skeleton) / tree.scale));
    scene::BuiltSource built { std::move(made.plant), skeleton.systems[0].notes };
    for (auto const& name : made.axis_names)
        built.axis_keys.push_back(axis_key(name));
    return built;
}

// Returns the tree with another seed, which varies only what the drawing leaves open.
OutlinedTree varied(OutlinedTree tree, scene::SourceVariation const& variation)
{
    constexpr std::uint32_t kStream = 0x7472;
    Random random({ variation.seed ^ tree.form.seed, kStream + variation.stream, variation.plant });
    tree.form.seed = random.next_u64();
    // The cache would not help, because members of a collection are not versions of one tree.
    tree.inferred.reset();
    return tree;
}

} // namespace

Result<scene::BuiltSource> build_tree(OutlinedTree const& tree, scene::LoadOptions const&)
{
    TRY(check_form(tree.form));
    TRY(check_scale(tree.scale));
    auto const drawing = TRY(drawing_of(tree));
    if (drawing.outline.empty() && !drawing.trunk.empty())
        return scene::BuiltSource { .plant = TRY(bare_stem(drawing.trunk, tree.scale)),
                                    .axis_keys = { axis_key(kTrunkName) } };
    if (drawing.is_leaf)
        return built_of(TRY(infer_skeleton(drawing, options_of(tree))), tree);
    return built_of(TRY(inferred(tree))->skeleton, tree);
}
constexpr scene::SourceKind OutlinedTree::kKind {
    .word = "outlined_tree",
    .build =
        [](void const* drawn, scene::LoadOptions const& options) {
            return build_tree(*static_cast<OutlinedTree const*>(drawn), options);
        },
    .same =
        [](void const* one, void const* other) {
            return same(*static_cast<OutlinedTree const*>(one),
                        *static_cast<OutlinedTree const*>(other));
        },
    .vary = [](void const* drawn,
               scene::SourceVariation const& variation) -> std::shared_ptr<void const> {
        return std::make_shared<OutlinedTree const>(
            varied(*static_cast<OutlinedTree const*>(drawn), variation));
    },
};

} // namespace tractus::silhouette
