#include "engine/variation/growth_bundle.h"

#include "engine/base/check.h"
#include "engine/variation/deviation.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace tractus::variation {

namespace {

constexpr std::size_t kWidth = 4; // Number of lanes in a Four.

template<typename Quats> FourQuats four_quats(Quats const& quats, std::size_t lane)
{
    return { load_four(&quats.w[lane]), load_four(&quats.x[lane]), load_four(&quats.y[lane]),
             load_four(&quats.z[lane]) };
}

template<typename Vectors> FourVectors four_vectors(Vectors const& vectors, std::size_t lane)
{
    return { load_four(&vectors.x[lane]), load_four(&vectors.y[lane]),
             load_four(&vectors.z[lane]) };
}

template<typename Quats> void set(Quats& quats, std::size_t lane, Quat const& q)
{
    quats.w[lane] = q.w();
    quats.x[lane] = q.x();
    quats.y[lane] = q.y();
    quats.z[lane] = q.z();
}

template<typename Vectors> void set(Vectors& vectors, std::size_t lane, Vec3 const& v)
{
    vectors.x[lane] = v.x();
    vectors.y[lane] = v.y();
    vectors.z[lane] = v.z();
}

} // namespace

GrowthBundle::GrowthBundle(GrowthPlan const& plan, GrowthNoise const& noise, double age,
                           Grown const& grown)
    : plan_(plan)
    , noise_(noise)
    , age_(age)
    , grown_(grown)
    , is_stepped_(plan.parameters.delay_steps > 0 || plan.parameters.growth_zone_steps > 0)
    , is_pushed_(!plan.influence.is_none() && plan.parameters.indicator_gain != 0)
    , is_noisy_(plan.parameters.strength * plan.parameters.noise_rad != 0)
{
}

void GrowthBundle::grow(std::span<AxisId const> axes)
{
    CHECK(!axes.empty() && axes.size() <= kGrowthLanes);
    seat(axes);
    if (is_stepped_) {
        follow_tips(axes);
        return;
    }
    for (std::uint32_t first = 0; first < longest_; first += kStepsAtOnce) {
        auto const count = std::min(kStepsAtOnce, longest_ - first);
        follow_law(first, count);
        place(first, count);
    }
}

// Assigns the axes to the lanes, and finds the base position and rotation of each from its parent.
void GrowthBundle::seat(std::span<AxisId const> axes)
{
    longest_ = 0;
    for (std::size_t lane = 0; lane < kGrowthLanes; ++lane) {
        bool const is_left_over = lane >= axes.size();
        axis_[lane] = axes[is_left_over ? 0 : lane];
        auto const& axis = plan_.base.axes[axis_[lane]];
        auto const& from = plan_.axes[axis_[lane]];
        first_node_[lane] = axis.first_node;
        first_segment_[lane] = axis.first_segment;
        segment_count_[lane] = is_left_over ? 0 : axis.segment_count;
        longest_ = std::max(longest_, segment_count_[lane]);
        Quat turn = Quat::Identity();
        Vec3 position_mm = from.offset_mm;
        if (from.seat.parent != kNone) {
            auto const& grown = grown_.parent_frame[from.seat.parent];
            turn = grown * plan_.parent_frame[from.seat.parent].conjugate();
            position_mm = grown_.node_position_mm[from.seat.node];
            if (!from.offset_mm.isZero(0))
                position_mm += grown * from.offset_mm;
        }
        if (!is_left_over)
            grown_.node_position_mm[axis.first_node] = position_mm;
        set(turn_, lane, turn);
        set(position_mm_, lane, position_mm);
        left_mm_[lane] = age_ >= 1 ? std::numeric_limits<double>::infinity()
                                   : progress_of(axis_[lane]).along_mm;
        if (is_pushed_)
            set(everywhere_, lane, turn.conjugate() * plan_.influence.everywhere);
    }
    for (auto* const lanes : { &deviation_x_, &deviation_y_, &memory_x_, &memory_y_ })
        lanes->fill(0);
}

AxisProgress GrowthBundle::progress_of(AxisId axis) const
{
    double const length_mm = plan_.axis_length_mm[axis];
    if (age_ >= 1)
        return { length_mm, 1 };
    auto const& age = plan_.axes[axis].age;
    return { std::min(age.along_at_mm(age_), length_mm), maturity(age_, age.birth_at(length_mm)) };
}

// Returns the segment of a lane's axis with this number from its base, or the axis' first segment
// if the axis has fewer segments.
SegmentId GrowthBundle::segment(std::size_t lane, std::uint32_t number) const
{
    return first_segment_[lane] + (number < segment_count_[lane] ? number : 0);
}

void GrowthBundle::read_frames(std::uint32_t number)
{
    for (std::size_t lane = 0; lane < kGrowthLanes; ++lane)
        set(frame_, lane, plan_.segments[segment(lane, number)].frame);
}

void GrowthBundle::read_steps(std::uint32_t number)
{
    for (std::size_t lane = 0; lane < kGrowthLanes; ++lane) {
        auto const& step = plan_.steps[plan_.segments[segment(lane, number)].step];
        step_.deviation_kept[lane] = step.deviation_kept;
        step_.noise_push[lane] = step.noise_push;
        step_.noise_1[lane] = step.noise_1;
        step_.memory_kept[lane] = step.memory_kept;
        step_.memory_1[lane] = step.memory_1;
        step_.memory_2[lane] = step.memory_2;
        if (!is_pushed_)
            continue;
        step_.substep_kept[lane] = step.substep_kept;
        step_.substep_push[lane] = step.substep_push;
        step_.substeps[lane] = step.substeps;
    }
}

// Computes the deviations of `count` segments by the law without delay and maturation. This takes a
// few multiplications per segment, with the coefficients of GrowthPlan::steps.
void GrowthBundle::follow_law(std::uint32_t first, std::uint32_t count)
{
    if (is_noisy_)
        noise_.fill(axis_, first, std::span(drawn_).first(count));
    for (std::uint32_t i = 0; i < count; ++i) {
        read_steps(first + i);
        if (is_pushed_)
            push(first + i);
        else
            for (std::size_t lane = 0; lane < kGrowthLanes; ++lane) {
                deviation_x_[lane] *= step_.deviation_kept[lane];
                deviation_y_[lane] *= step_.deviation_kept[lane];
            }
        if (is_noisy_)
            add_noise(drawn_[i]);
        if (!plan_.circumnutation_rad.empty())
            for (std::size_t lane = 0; lane < kGrowthLanes; ++lane) {
                auto const& circling = plan_.circumnutation_rad[segment(lane, first + i)];
                deviation_x_[lane] += circling.x();
                deviation_y_[lane] += circling.y();
            }
        hold();
        deviations_x_[i] = deviation_x_;
        deviations_y_[i] = deviation_y_;
    }
}

void GrowthBundle::add_noise(StepNoiseLanes const& noise)
{
    auto const add = [&](Lanes& deviation, Lanes& memory, StepNoiseLanes::Component const& first,
                         StepNoiseLanes::Component const& second) {
        for (std::size_t i = 0; i < kGrowthLanes; ++i) {
            double const one = first[i];
            double const two = second[i];
            deviation[i] += step_.noise_push[i] * memory[i] + step_.noise_1[i] * one;
            memory[i] = step_.memory_kept[i] * memory[i] + step_.memory_1[i] * one
                + step_.memory_2[i] * two;
        }
    };
    add(deviation_x_, memory_x_, noise.first[0], noise.second[0]);
    add(deviation_y_, memory_y_, noise.first[1], noise.second[1]);
}

// Limits deviations to kMaxDeviation. They rarely exceed it, so the largest is checked first.
void GrowthBundle::hold()
{
    double most = 0;
    for (std::size_t i = 0; i < kGrowthLanes; ++i)
        most
            = std::max(most, deviation_x_[i] * deviation_x_[i] + deviation_y_[i] * deviation_y_[i]);
    if (most <= kMaxDeviation * kMaxDeviation) [[likely]]
        return;
    for (std::size_t i = 0; i < kGrowthLanes; ++i) {
        auto const d = held(Vec2(deviation_x_[i], deviation_y_[i]));
        deviation_x_[i] = d.x();
        deviation_y_[i] = d.y();
    }
}

// Finds the influence of the motion indicators on each axis' growing tip before the step to segment
// `number`, while the tip is in the previous segment.
void GrowthBundle::find_influence(std::uint32_t number)
{
    auto const before = number > 0 ? number - 1 : 0;
    read_frames(before);
    VectorLanes felt = everywhere_;
    if (!plan_.influence.local.empty())
        for (std::size_t lane = 0; lane < kGrowthLanes; ++lane) {
            Quat const turn(turn_.w[lane], turn_.x[lane], turn_.y[lane], turn_.z[lane]);
            Vec3 const local = turn.conjugate() * plan_.influence.local[segment(lane, before)];
            felt.x[lane] += local.x();
            felt.y[lane] += local.y();
            felt.z[lane] += local.z();
        }
    for (std::size_t i = 0; i < kGrowthLanes; i += kWidth) {
        auto const turned = turned_back(four_quats(frame_, i), four_vectors(felt, i));
        store(turned.x, &influence_.x[i]);
        store(turned.y, &influence_.y[i]);
        store(turned.z, &influence_.z[i]);
    }
}

void GrowthBundle::push(std::uint32_t number)
{
    find_influence(number);
    double const parts = *std::max_element(step_.substeps.begin(), step_.substeps.end());
    for (double part = 0; part < parts; ++part) {
        for (std::size_t i = 0; i < kGrowthLanes; i += kWidth) {
            auto const x = load_four(&deviation_x_[i]);
            auto const y = load_four(&deviation_y_[i]);
            auto const influence = four_vectors(influence_, i);
            auto const push = across(x, y, influence.x, influence.y, influence.z);
            auto const kept = load_four(&step_.substep_kept[i]);
            auto const pushed = load_four(&step_.substep_push[i]);
            auto const goes_on = part < load_four(&step_.substeps[i]);
            store(goes_on ? kept * x + pushed * push.x : x, &deviation_x_[i]);
            store(goes_on ? kept * y + pushed * push.y : y, &deviation_y_[i]);
        }
        hold();
    }
}

// Grows axes by the law with delay or maturation. SteppedTip computes each axis separately.
void GrowthBundle::follow_tips(std::span<AxisId const> axes)
{
    std::array<std::optional<AxisInfluence>, kGrowthLanes> influences;
    std::array<std::optional<SteppedTip>, kGrowthLanes> tips;
    for (std::size_t lane = 0; lane < axes.size(); ++lane) {
        influences[lane].emplace(plan_,
                                 Quat(turn_.w[lane], turn_.x[lane], turn_.y[lane], turn_.z[lane]));
        tips[lane].emplace(plan_, noise_, axes[lane], *influences[lane], progress_of(axes[lane]));
    }
    for (auto& deviations : deviations_x_)
        deviations.fill(0);
    for (auto& deviations : deviations_y_)
        deviations.fill(0);
    for (std::uint32_t first = 0; first < longest_; first += kStepsAtOnce) {
        for (std::size_t lane = 0; lane < axes.size(); ++lane) {
            if (first >= segment_count_[lane])
                continue;
            std::array<Vec2, kStepsAtOnce> deviations;
            auto const count = std::min(kStepsAtOnce, segment_count_[lane] - first);
            tips[lane]->advance(std::span(deviations).first(count));
            for (std::size_t i = 0; i < count; ++i) {
                deviations_x_[i][lane] = deviations[i].x();
                deviations_y_[i][lane] = deviations[i].y();
            }
        }
        place(first, std::min(kStepsAtOnce, longest_ - first));
    }
}

// Places the next `count` segments, from number `first` on: sets their nodes, and the frames for
// attached axes and organs.
void GrowthBundle::place(std::uint32_t first, std::uint32_t count)
{
    for (std::uint32_t number = 0; number < count; ++number) {
        read_frames(first + number);
        for (std::size_t lane = 0; lane < kGrowthLanes; ++lane)
            length_mm_[lane] = plan_.segments[segment(lane, first + number)].length_mm;
        for (std::size_t i = 0; i < kGrowthLanes; i += kWidth)
            place(i, load_four(&deviations_x_[number][i]), load_four(&deviations_y_[number][i]));
        write(first + number);
    }
}

// Moves the tips of four axes, in the lanes from `lane` on, along their next segment.
void GrowthBundle::place(std::size_t lane, Four const& dx, Four const& dy)
{
    auto const half = half_angle<Four>(dx * dx + dy * dy);
    FourQuats const deviated { half.cosine, Four {}, -half.sine_share * dy, half.sine_share * dx };
    auto const q = product(four_quats(turn_, lane), product(four_quats(frame_, lane), deviated));

    auto const left = load_four(&left_mm_[lane]);
    auto const whole = load_four(&length_mm_[lane]);
    auto const ended = left < whole ? left : whole;
    auto const length = ended > 0 ? ended : Four {};
    store(left - whole, &left_mm_[lane]);

    auto const position = four_vectors(position_mm_, lane);
    store(position.x + length * (1 - 2 * (q.y * q.y + q.z * q.z)), &position_mm_.x[lane]);
    store(position.y + length * (2 * (q.x * q.y + q.w * q.z)), &position_mm_.y[lane]);
    store(position.z + length * (2 * (q.x * q.z - q.w * q.y)), &position_mm_.z[lane]);

    auto const scale
        // Factor that normalises the quaternion q, which is nearly normalised, by one Newton step.
        = 1.5 - 0.5 * (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    store(scale * q.w, &turned_frame_.w[lane]);
    store(scale * q.x, &turned_frame_.x[lane]);
    store(scale * q.y, &turned_frame_.y[lane]);
    store(scale * q.z, &turned_frame_.z[lane]);
}

void GrowthBundle::write(std::uint32_t number)
{
    for (std::size_t lane = 0; lane < kGrowthLanes; ++lane) {
        if (number >= segment_count_[lane])
            continue;
        grown_.node_position_mm[first_node_[lane] + number + 1]
            = { position_mm_.x[lane], position_mm_.y[lane], position_mm_.z[lane] };
        auto const parent = plan_.segments[first_segment_[lane] + number].parent;
        if (parent != kNone)
            grown_.parent_frame[parent] = { turned_frame_.w[lane], turned_frame_.x[lane],
                                            turned_frame_.y[lane], turned_frame_.z[lane] };
    }
}

} // namespace tractus::variation
