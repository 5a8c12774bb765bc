#include "engine/variation/limb.h"

#include "engine/stroke/frame_rotation.h"
#include "engine/stroke/frames.h"
#include "engine/variation/limb_curve.h"
#include "engine/variation/limb_pattern.h"
#include "engine/variation/limb_twigs.h"
#include "engine/variation/stroke_laying.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tractus::variation {

namespace {

// Distance before and after a point over which the limb's direction is measured, as a share of the
// limb's length. Single samples are too noisy.
constexpr double kDirectionReach = 1 / kMinLimbSegments;

constexpr double kThinnerThanBearer = 0.85;

// Share of a limb's length, from its base, over which the pen is still being pressed down.
constexpr double kPressedDown = 0.1;

class LimbMaker {
public:
    LimbMaker(Plant const& plant, RestShape const& rest, std::span<LimbPoint const> points,
              LimbAttachment const& seat)
        : plant_(plant)
        , rest_(rest)
        , curve_(points, seat)
        , seat_(seat)
        , id_(pattern_for_limb(plant, rest, seat.order, curve_.length_mm()))
        , pattern_(plant.axes[id_])
    {
        double const length_mm = rest.axis_length_mm[id_];
        ratio_ = length_mm > 0 ? curve_.length_mm() / length_mm : 1;
        scale_ = ratio_ < 1 ? ratio_ : std::sqrt(ratio_);
        double const width_mm = width_at(0);
        if (seat.radius_mm > 0 && width_mm > 2 * kThinnerThanBearer * seat.radius_mm)
            thinner_ = 2 * kThinnerThanBearer * seat.radius_mm / width_mm;
    }

    Plant make()
    {
        limb_.materials = plant_.materials;
        limb_.organ_shapes = plant_.organ_shapes;
        limb_.contours = plant_.contours;
        stations_ = limb_stations(limb_nodes(plant_, rest_, id_, ratio_), curve_.drawn_from());
        add_stem();
        LimbTwigs twigs(plant_, rest_, id_, scale_);
        for (std::size_t i = 1; i < stations_.size(); ++i)
            for (auto const& node : stations_[i].bears)
                twigs.add(limb_, { static_cast<SegmentId>(i - 1), frames_[i] }, node);
        return std::move(limb_);
    }

private:
    double width_at(double share) const
    {
        double const width_mm = curve_.at(share).width_mm;
        return share < kPressedDown ? std::max(width_mm, curve_.at(kPressedDown).width_mm)
                                    : width_mm;
    }

    // Returns the pattern's segment at a share of the pattern's length, and the position on that
    // segment, from 0 at its base to 1 at its tip.
    std::pair<SegmentId, double> pattern_at(double share) const
    {
        auto const* const ends_mm = rest_.end_mm.data() + pattern_.first_segment;
        double const at_mm = share * rest_.axis_length_mm[id_];
        auto const found = std::lower_bound(ends_mm, ends_mm + pattern_.segment_count - 1, at_mm);
        auto const segment = pattern_.first_segment + static_cast<SegmentId>(found - ends_mm);
        double const length_mm = rest_.length_mm[segment];
        double const part = length_mm > 0 ? 1 - (rest_.end_mm[segment] - at_mm) / length_mm : 1;
        return { segment, std::clamp(part, 0.0, 1.0) };
    }

    NodeId pattern_node(SegmentId segment) const
    {
        return pattern_.first_node + (segment - pattern_.first_segment);
    }

    // Returns the pattern's radius at a share of its length, divided by the radius at its base; at
    // most 1.
    double taper_at(double share) const
    {
        auto const radius = [&](NodeId node) { return double(plant_.node_radius_mm[node]); };
        double const base_mm = radius(pattern_.first_node);
        if (base_mm <= 0)
            return 1;
        auto const [segment, part] = pattern_at(share);
        auto const node = pattern_node(segment);
        return std::min(1.0, ((1 - part) * radius(node) + part * radius(node + 1)) / base_mm);
    }

    void add_node(Vec3 const& place_mm, double radius_mm)
    {
        limb_.node_position_mm.push_back(place_mm);
        limb_.node_radius_mm.push_back(static_cast<float>(radius_mm));
    }

    // Computes rotation-minimising frames along the limb. The normal of the first frame leans
    // towards the direction of the parent axis.
    void find_frames()
    {
        Vec3 before = curve_.direction(0, kDirectionReach);
        Quat frame = rotation_of({ before, normal_towards(before, seat_.direction) });
        for (auto const& station : stations_) {
            Vec3 const direction = curve_.direction(station.share, kDirectionReach);
            frame = parallel_transport(frame, before, direction);
            before = direction;
            frames_.push_back(frame);
        }
        roll_as_pattern();
    }

    // Rolls the limb's frames so that at its middle the same side faces up as on the pattern. Does
    // nothing if one of the two is upright there.
    void roll_as_pattern()
    {
        auto const& pattern = rest_.frame[pattern_at(0.5).first];
        auto const& limb = frames_[frames_.size() / 2];
        if (is_upright(tangent_of(pattern)) || is_upright(tangent_of(limb)))
            return;
        auto const angle_of_up = [](Quat const& frame) {
            Vec3 const up = frame.conjugate() * Vec3::UnitZ();
            return std::atan2(up.z(), up.y());
        };
        Quat const roll(Eigen::AngleAxisd(angle_of_up(limb) - angle_of_up(pattern), Vec3::UnitX()));
        for (auto& frame : frames_)
            frame = frame * roll;
    }

    void add_stem()
    {
        find_frames();
        for (std::size_t i = 0; i < stations_.size(); ++i) {
            double const share = stations_[i].share;
            add_node(curve_.at(share).place_mm, thinner_ * width_at(share) / 2 * taper_at(share));
            auto const segment = pattern_at(share).first;
            if (i > 0)
                limb_.segment_material.push_back(plant_.segment_material[segment]);
            add_turned_section(limb_, plant_, pattern_node(segment),
                               frames_[i] * rest_.frame[segment].conjugate());
        }
        Axis stem;
        stem.segment_count = static_cast<std::uint32_t>(stations_.size() - 1);
        limb_.axes.push_back(stem);
    }

    Plant const& plant_;
    RestShape const& rest_;
    LimbCurve curve_;
    LimbAttachment const& seat_;
    AxisId id_; // Axis of plant_ that is the limb's pattern.
    Axis const& pattern_;
    double ratio_ = 1;   // Length of the limb divided by that of the pattern.
    double scale_ = 1;   // Factor on the size of twigs and organs.
    double thinner_ = 1; // Factor on the drawn width that makes the limb thinner than its parent.
    Plant limb_;
    std::vector<LimbStation> stations_;
    std::vector<Quat> frames_; // Frame at each station.
};

} // namespace

Plant make_limb(Plant const& plant, RestShape const& rest, std::span<LimbPoint const> points,
                LimbAttachment const& seat)
{
    return LimbMaker(plant, rest, points, seat).make();
}

} // namespace tractus::variation
