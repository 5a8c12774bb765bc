#pragma once

#include "engine/base/result.h"
#include "engine/variation/association.h"
#include "engine/variation/stroke_shape.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tractus::variation {

// Keeps a plant's predefined shape up to date while associations are added, changed and removed.
// Only the affected axes and their descendants are recomputed, so that the plant can follow a
// stroke while it is drawn.
//
// Uses all threads of the calling task arena. Not thread-safe.
class StrokeShaper {
public:
    // `plant` and `rest` must outlive the shaper. The initial shape is the base plant's.
    StrokeShaper(Plant const& plant, RestShape const& rest);

    // Replaces the associations. Fails, and changes nothing, if one is invalid
    // (check_association()).
    Result<void> set(std::span<Association const> associations);

    PredefinedShape const& shape() const { return shape_; }

    // Moves the shape out; the shaper must not be used afterwards.
    PredefinedShape take_shape() && { return std::move(shape_); }

private:
    static constexpr std::uint32_t kNoStroke = kNone;

    // The associations that shape an axis: one that is propagated to the whole axis, and those
    // whose paths run along it.
    struct Source {
        std::uint32_t propagated = kNoStroke; // Number of the association propagated to the axis.
        // Index into joints_ of the axis' joints; kNone: no path runs along the axis.
        std::uint32_t joints = kNone;
        // 1 + the highest number of an association that affects the axis.
        std::uint32_t changed = 0;
    };

    Result<std::vector<StrokeShape>> shapes_of(std::span<Association const> associations,
                                               std::size_t first) const;
    void assign(std::uint32_t number);
    void assign_path(std::uint32_t number);
    void assign_descendants(std::uint32_t number);
    std::vector<bool> find_dirty(std::span<Source const> before, std::size_t unchanged) const;
    void lay(AxisId id);
    void lay_propagated(AxisId id, StrokeShape const& stroke, Quat const& turn,
                        std::span<Quat> frames) const;
    void lay_by_heading_along(AxisId id, StrokeShape const& stroke, Quat const& turn,
                              std::span<Quat> frames) const;
    Quat laid_along_path(std::uint32_t number, std::size_t in_path) const;
    bool is_laid(std::uint32_t stroke, std::size_t in_path) const;
    Vec2 heading_from(SegmentId segment, Vec2 const& otherwise) const;
    void lay_joints(AxisId id, Quat const& turn);
    Quat follow_joint(SegmentId segment, SegmentId below, Vec3 const& direction,
                      Quat const& turned) const;
    Quat turn_of_segment(SegmentId segment) const;

    Plant const& plant_;
    RestShape const& rest_;
    PredefinedShape shape_;
    std::vector<Association> associations_;
    // Prepared stroke of each association; has no curve and no joints for orphaned associations.
    std::vector<StrokeShape> strokes_;
    std::vector<Source> sources_; // For each axis, the associations that shape it.
    std::vector<std::vector<Joint>> joints_;
};

} // namespace tractus::variation
