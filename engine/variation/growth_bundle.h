#pragma once

#include "engine/base/four.h"
#include "engine/plant/plant.h"
#include "engine/variation/growth_noise.h"
#include "engine/variation/growth_plan.h"
#include "engine/variation/growth_tip.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace tractus::variation {

// Grows several axes at once with SIMD instructions, one axis in each lane, since most axes are too
// short to fill the lanes with their own segments. Each axis grows bit for bit as it would alone.
//
// An object must be used by one thread only. It takes one or two kilobytes and is meant for the
// stack.
class GrowthBundle {
public:
    // Node positions and frames (GrowthPlan::parent_frame) of the grown plant. grow() writes those
    // of its axes and reads those of their parents.
    struct Grown {
        std::span<Vec3> node_position_mm;
        std::span<Quat> parent_frame;
    };

    // `plan` and `noise` must outlive the bundle.
    GrowthBundle(GrowthPlan const& plan, GrowthNoise const& noise, double age, Grown const& grown);

    // Grows 1 to kGrowthLanes axes; their parents must have been grown before.
    void grow(std::span<AxisId const> axes);

private:
    using Lanes = std::array<double, kGrowthLanes>;
    struct VectorLanes {
        Lanes x, y, z;
    };
    struct QuatLanes {
        Lanes w, x, y, z;
    };
    struct StepLanes {
        Lanes deviation_kept, noise_push, noise_1, memory_kept, memory_1, memory_2;
        Lanes substep_kept, substep_push, substeps;
    };
    static constexpr std::uint32_t kStepsAtOnce = 8;

    void seat(std::span<AxisId const> axes);
    SegmentId segment(std::size_t lane, std::uint32_t number) const;
    AxisProgress progress_of(AxisId axis) const;
    void read_frames(std::uint32_t number);
    void read_steps(std::uint32_t number);
    void follow_law(std::uint32_t first, std::uint32_t count);
    void find_influence(std::uint32_t number);
    void push(std::uint32_t number);
    void add_noise(StepNoiseLanes const& noise);
    void hold();
    void follow_tips(std::span<AxisId const> axes);
    void place(std::uint32_t first, std::uint32_t count);
    void place(std::size_t lane, Four const& dx, Four const& dy);
    void write(std::uint32_t number);

    GrowthPlan const& plan_;
    GrowthNoise const& noise_;
    double age_;
    Grown grown_;
    // True if the law has a delay or maturation, so that SteppedTip grows each axis step by step.
    bool is_stepped_;
    bool is_pushed_;
    bool is_noisy_;

    // Data of each lane's axis. Lanes without an axis of their own repeat the first axis and write
    // nothing.
    std::uint32_t longest_ = 0; // Greatest number of segments of a lane's axis.
    std::array<AxisId, kGrowthLanes> axis_ {};
    std::array<NodeId, kGrowthLanes> first_node_ {};
    std::array<SegmentId, kGrowthLanes> first_segment_ {};
    // Number of segments of each lane's axis; 0 for unused lanes.
    std::array<std::uint32_t, kGrowthLanes> segment_count_ {};

    alignas(64) QuatLanes turn_; // Rotation of each axis as a whole, inherited from its parent.
    VectorLanes position_mm_;    // Position of each axis' growing tip.
    Lanes left_mm_;              // Length of each axis at age_, minus the length already placed.
    // The influence that acts on the whole plant, in the coordinates of each axis.
    VectorLanes everywhere_;
    Lanes deviation_x_, deviation_y_;
    Lanes memory_x_, memory_y_;

    // The following describe each axis at its current segment.
    QuatLanes frame_;
    QuatLanes turned_frame_;
    VectorLanes influence_; // Influence at the segment, in the segment's frame.
    StepLanes step_;
    Lanes length_mm_;

    // Deviations of the next kStepsAtOnce segments of each axis, and the noise drawn for them.
    std::array<Lanes, kStepsAtOnce> deviations_x_, deviations_y_;
    std::array<StepNoiseLanes, kStepsAtOnce> drawn_;
};

} // namespace tractus::variation
