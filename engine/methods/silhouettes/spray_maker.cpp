#include "engine/methods/silhouettes/spray_maker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace tractus::silhouette {

namespace {

// Length of a parent that gets TreeOptions::sprays twigs, as a share of the tree's height.
constexpr double kParent = 0.07;

} // namespace

Eigen::Matrix3d spray_frame(Vec3 const& heading, Vec3 const& fallback)
{
    Vec3 side = heading.cross(Vec3::UnitZ());
    side = side.norm() > 1e-3 ? Vec3(side.normalized()) : fallback;
    Eigen::Matrix3d frame;
    frame << side, heading, side.cross(heading);
    return frame;
}

void SprayMaker::add_shapes()
{
    auto& shapes = tree_.plant.organ_shapes;
    for (std::uint32_t variant = 0; variant < kSprayVariants; ++variant)
        shapes.push_back(leaf_spray(options_.leaf, 1, variant));
    shapes.push_back(spray_twig(0));
}

void SprayMaker::add(SprayParent const& parent, std::vector<double> const& places, double from)
{
    constexpr double kBare = 0.15;
    constexpr double kSpiral_deg = 137.5;
    double const start = std::max(from, kBare);
    double const length = parent.line.length();
    // Height of the tree in the plane's unit.
    double const height = options_.height_mm / unit_of(parent.space);
    double const usual
        = static_cast<double>(options_.sprays) * (1 - start) * length / (kParent * height);
    auto const count = std::clamp<std::size_t>(static_cast<std::size_t>(usual),
                                               options_.sprays / 3 + 1, 6 * options_.sprays);
    Random random({ .seed = options_.seed, .stream = 3, .substream = parent.axis });
    double const first_deg = random.uniform(0, 360);
    std::size_t node = 0;
    for (std::size_t i = 0; i <= count; ++i) {
        double const u = start + (1 - start) * static_cast<double>(i) / static_cast<double>(count);
        while (node + 2 < places.size() && places[node + 1] < u)
            ++node;
        Vec2 const at = parent.line.at(u);
        Vec2 const along = parent.line.direction(u);
        double const lean = i == count ? 0 : radians(random.uniform(38, 58));
        double far = kLongestSpray * height;
        for (double const side : { 1.0, -1.0 })
            if (auto const edge
                = ray_distance_to_outline(parent.crown, at, turned(along, side * lean)))
                far = std::min(far, 0.95 * *edge);
        add({ parent, node, at, along },
            { lean, radians(first_deg + static_cast<double>(i) * kSpiral_deg),
              std::max(far, kShortestSpray * height) },
            random);
    }
}

void SprayMaker::add(SprayPlace const& place, TwigDirection const& way, Random& random)
{
    auto const& space = place.parent.space;
    Vec3 const forward = (space.linear() * Vec3(place.along.x(), place.along.y(), 0)).normalized();
    Vec3 const across = (space.linear() * Vec3(-place.along.y(), place.along.x(), 0)).normalized();
    Vec3 const out = std::cos(way.around) * across + std::sin(way.around) * forward.cross(across);
    Vec3 const heading = (std::cos(way.lean) * forward + std::sin(way.lean) * out).normalized();
    auto const frame = spray_frame(heading, across);
    Vec3 const base = space * Vec3(place.at.x(), place.at.y(), 0);
    double length = way.length * unit_of(space);
    if (surface_)
        length *= surface_->size_inside(std::array { Vec3(base + length * heading) }, base);
    auto const size = static_cast<float>(length / kSprayLength_mm * random.uniform(0.85, 1.1));
    Organ organ { .shape = static_cast<OrganShapeId>(random.next_u32() % kSprayVariants),
                  .segment = tree_.plant.axes[place.parent.axis].first_segment
                      + static_cast<SegmentId>(place.segment),
                  .position_mm = base,
                  .orientation = Quat(frame).normalized(),
                  .scale = Vec3f::Constant(size) };
    tree_.plant.organs.push_back(organ);
    organ.shape = kSprayVariants;
    tree_.plant.organs.push_back(organ);
    ++tree_.sprays;
    tree_.leaves += static_cast<std::size_t>(options_.leaf.per_spray);
}

} // namespace tractus::silhouette
