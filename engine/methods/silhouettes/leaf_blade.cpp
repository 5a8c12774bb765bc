#include "engine/methods/silhouettes/leaf_blade.h"

#include "engine/methods/silhouettes/line.h"
#include "engine/methods/silhouettes/loops.h"
#include "engine/methods/silhouettes/triangulation.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace tractus::silhouette {

LeafBlade leaf_along(std::span<Vec2 const> outline, std::span<Vec2 const> line)
{
    constexpr std::size_t kPoints = 48;
    constexpr int kSteps = 64;
    Line const parent({ line.begin(), line.end() });
    LeafBlade leaf { .outline = resampled_outline(outline, kPoints), .base = line.front() };
    if (!is_inside(outline, leaf.base))
        for (int i = 1; i <= kSteps; ++i) {
            double const share = static_cast<double>(i) / kSteps;
            if (!is_inside(outline, parent.at(share)))
                continue;
            leaf.stalk = share;
            leaf.base = parent.at(share);
            break;
        }
    if (crosses_itself(leaf.outline))
        leaf.outline = largest_loop(leaf.outline).outline;
    leaf.tip = *std::max_element(
        leaf.outline.begin(), leaf.outline.end(), [&](Vec2 const& a, Vec2 const& b) {
            return (a - leaf.base).squaredNorm() < (b - leaf.base).squaredNorm();
        });
    Vec2 const way = leaf.tip - leaf.base;
    Similarity const to_frame { .from = leaf.base,
                                .turn = Vec2(way.y(), way.x()) / way.squaredNorm() };
    leaf.outline = to_frame.points(leaf.outline);
    if (signed_area(leaf.outline) < 0)
        std::reverse(leaf.outline.begin(), leaf.outline.end());
    return leaf;
}

LeafBlade moved(LeafBlade leaf, Similarity const& way)
{
    leaf.base = way.point(leaf.base);
    leaf.tip = way.point(leaf.tip);
    leaf.mirrors = leaf.mirrors != way.mirrors;
    return leaf;
}

std::vector<Vec2> stalk_of(LeafBlade const& leaf, std::span<Vec2 const> line)
{
    constexpr std::size_t kPoints = 9;
    constexpr double kMin = 0.02; // Minimum length of a petiole, as a share of the leaf's length.
    Line const parent({ line.begin(), line.end() });
    if (leaf.stalk * parent.length() <= kMin * (leaf.tip - leaf.base).norm())
        return { line.front(), line.front() + kMin * (leaf.tip - leaf.base) };
    std::vector<Vec2> stalk;
    for (std::size_t i = 0; i < kPoints; ++i)
        stalk.push_back(parent.at(leaf.stalk * static_cast<double>(i) / (kPoints - 1)));
    return stalk;
}

OrganShape leaf_organ(std::vector<Vec2> const& outline, MaterialId material)
{
    CutLeaf cut { .corners = outline, .triangles = {} };
    for (auto const& triangle : triangulate(outline))
        cut.triangles.push_back(triangle.corner);
    auto const box = box_of(outline);
    // The texture coordinates give only the blade's extent, which the shader needs to draw veins;
    // there is no texture.
    cut.stem_in_picture = { 0.5, 0 };
    cut.length_in_picture = -1;
    OrganShape shape { .name = "drawn leaf", .kind = OrganShape::Kind::Leaf, .material = material };
    shape.length_mm = box.high.y();
    shape.width_mm = box.high.x() - box.low.x();
    shape.fold_rad = 0;
    shape.curl_rad = 0;
    shape.cut = std::make_shared<CutLeaf const>(std::move(cut));
    return shape;
}

} // namespace tractus::silhouette
