#include "engine/variation/rest_shape.h"

#include "engine/plant/join_axes.h"
#include "engine/stroke/frame_rotation.h"

#include <mutex>
#include <optional>
#include <utility>

namespace tractus::variation {

namespace {

// Sine of the angle between a branch and its parent below which the branch continues the parent
// straight on. The parent's direction then cannot define a normal.
constexpr double kStraightOn = 0.05;

Vec3 first_normal(Vec3 const& direction, Quat const* parent)
{
    if (!parent)
        return normal_towards(direction, Vec3::UnitX());
    Vec3 const tangent = tangent_of(*parent);
    bool const straight_on = direction.cross(tangent).norm() < kStraightOn;
    return normal_towards(direction, straight_on ? normal_of(*parent) : tangent);
}

// Returns the direction of the first segment that has a length; +z if there is none.
Vec3 first_direction(std::span<Vec3 const> nodes)
{
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        Vec3 const step = nodes[i] - nodes[i - 1];
        if (double const length = step.norm(); length > 0)
            return step / length;
    }
    return Vec3::UnitZ();
}

void find_axis_shape(Plant const& plant, AxisId id, RestShape& shape)
{
    auto const& axis = plant.axes[id];
    auto const nodes = plant.positions(axis);
    auto const* const parent
        = axis.parent_segment == kNone ? nullptr : &shape.frame[axis.parent_segment];
    Vec3 before = first_direction(nodes);
    Quat frame = rotation_of({ before, first_normal(before, parent) });
    double sum_mm = 0;
    for (std::uint32_t i = 0; i < axis.segment_count; ++i) {
        Vec3 const step = nodes[i + 1] - nodes[i];
        double const length_mm = step.norm();
        if (length_mm > 0) {
            Vec3 const direction = step / length_mm;
            frame = parallel_transport(frame, before, direction);
            before = direction;
        }
        shape.frame[axis.first_segment + i] = frame;
        shape.length_mm[axis.first_segment + i] = length_mm;
        sum_mm += length_mm;
        shape.end_mm[axis.first_segment + i] = sum_mm;
    }
    shape.axis_length_mm[id] = sum_mm;
}

} // namespace

struct SharedRestShape::Found {
    std::shared_ptr<Plant const> plant;
    // Addresses of the plant, if they were given; otherwise they are made from the plant and
    // `keys`.
    std::optional<PlantAddresses> addresses;
    AxisKeys keys {};
    std::once_flag is_found {};
    RestShape shape {};
};

SharedRestShape::SharedRestShape(std::shared_ptr<Plant const> plant, AxisKeys keys)
    : found_(new Found { std::move(plant), std::nullopt, std::move(keys) })
{
}

SharedRestShape::SharedRestShape(std::shared_ptr<Plant const> plant, PlantAddresses addresses)
    : found_(new Found { std::move(plant), std::move(addresses) })
{
}

RestShape const& SharedRestShape::operator*() const
{
    static RestShape const nothing;
    if (!found_)
        return nothing;
    std::call_once(found_->is_found, [&found = *found_] {
        found.shape = found.addresses ? find_rest_shape(*found.plant, *std::move(found.addresses))
                                      : find_rest_shape(*found.plant, std::move(found.keys));
    });
    return found_->shape;
}

RestShape find_rest_shape(Plant const& plant, AxisKeys keys)
{
    return find_rest_shape(plant, PlantAddresses(plant, std::move(keys)));
}

RestShape find_rest_shape(Plant const& plant, PlantAddresses addresses)
{
    RestShape shape;
    shape.levels = find_axis_levels(plant);
    shape.frame.resize(plant.segment_count());
    shape.length_mm.resize(plant.segment_count());
    shape.end_mm.resize(plant.segment_count());
    shape.axis_length_mm.resize(plant.axes.size());
    for_each_level(shape.levels, [&](std::span<AxisId const> axes) {
        for (auto const id : axes)
            find_axis_shape(plant, id, shape);
    });
    shape.addresses = std::move(addresses);
    shape.drawing_order = axes_in_drawing_order(plant, shape.axis_length_mm);
    return shape;
}

} // namespace tractus::variation
