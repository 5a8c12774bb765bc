#include "engine/methods/silhouettes/measured_style.h"

#include "engine/methods/silhouettes/arrangement.h"
#include "engine/methods/silhouettes/positioned_laterals.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <span>
#include <utility>

namespace tractus::silhouette {

namespace {

constexpr std::size_t kMaxMeasuredLevels = 3;
// Minimum concentration (MeasuredLevel::divergence_sureness) of a significant divergence angle.
constexpr double kSureOfTurn = 0.5;
// Minimum number of children from which a parent's divergence angles show a direction of rotation.
constexpr std::size_t kMinOfTurns = 4;

// Running mean and standard deviation.
class Spread {
public:
    void add(double value)
    {
        ++count_;
        double const off = value - mean_;
        mean_ += off / static_cast<double>(count_);
        squares_ += off * (value - mean_);
    }
    std::size_t count() const { return count_; }
    double mean() const { return mean_; }
    double deviation() const
    {
        return count_ > 0 ? std::sqrt(squares_ / static_cast<double>(count_)) : 0;
    }

private:
    std::size_t count_ = 0;
    double mean_ = 0;
    double squares_ = 0;
};

// A least-squares straight line through points.
class Slope {
public:
    void add(double x, double y)
    {
        ++count_;
        x_ += x;
        y_ += y;
        xx_ += x * x;
        xy_ += x * y;
    }
    // Value of the line at x; constant if all points have the same x.
    double at(double x) const
    {
        double const n = static_cast<double>(std::max<std::size_t>(count_, 1));
        double const width = xx_ - x_ * x_ / n;
        double const slope = width > 1e-6 * n ? (xy_ - x_ * y_ / n) / width : 0;
        return y_ / n + slope * (x - x_ / n);
    }

private:
    std::size_t count_ = 0;
    double x_ = 0;
    double y_ = 0;
    double xx_ = 0;
    double xy_ = 0;
};

using Turn = std::complex<double>; // Unit complex number for an angle, or a sum of such numbers.

Turn turn_of(double angle_deg)
{
    return std::polar(1.0, radians(angle_deg));
}

// Coefficient of variation of the distances between children of one parent, over several parents,
// excluding differences between the parents.
class Unevenness {
public:
    void add(std::span<double const> places)
    {
        auto const steps = places.size() - 1;
        if (steps < 2 || !(places.back() > places.front()))
            return;
        double const mean = (places.back() - places.front()) / static_cast<double>(steps);
        for (std::size_t i = 1; i < places.size(); ++i) {
            double const off = (places[i] - places[i - 1]) / mean - 1;
            squares_ += off * off;
        }
        steps_ += steps;
    }
    double value() const
    {
        return steps_ > 0 ? std::sqrt(squares_ / static_cast<double>(steps_)) : 0;
    }

private:
    double squares_ = 0;
    std::size_t steps_ = 0;
};

// Collects statistics of the parents of one level.
class LevelMeter {
public:
    void add_bare() { ++bare_; }

    void add(std::span<PositionedLateral const> children)
    {
        counts_.add(static_cast<double>(children.size()));
        unbranched_.add(children.front().u);
        for (std::size_t i = 1; i < children.size(); ++i)
            gaps_.add(children[i].u - children[i - 1].u);
        for (std::size_t i = 0; i < children.size(); ++i) {
            // The index is used instead of the position: a few distant children would otherwise
            // dominate the fitted line.
            double const share = children.size() > 1
                ? static_cast<double>(i) / static_cast<double>(children.size() - 1)
                : 0.5;
            angle_.add(share, children[i].angle_deg);
            mean_angle_.add(children[i].angle_deg);
            angles_.emplace_back(share, children[i].angle_deg);
        }
        add_lengths(children);
        auto const nodes = nodes_of(children);
        std::vector<double> node_places;
        std::vector<double> places;
        for (auto const& child : children)
            places.push_back(child.u);
        for (auto const& node : nodes) {
            node_sizes_.add(static_cast<double>(node.children.size()));
            node_places.push_back(node.u);
        }
        of_children_.add(places);
        of_nodes_.add(node_places);
        if (children.size() >= kMinOfTurns)
            add_turns(nodes);
    }

    // Statistics of the level; no value if there are no children.
    std::optional<MeasuredLevel> level() const
    {
        if (counts_.count() == 0)
            return std::nullopt;
        MeasuredLevel level { .parents = counts_.count(), .children = angles_.size() };
        auto& style = level.style;
        style.children = counts_.mean();
        style.children_deviation = counts_.deviation();
        style.bare = static_cast<double>(bare_) / static_cast<double>(bare_ + counts_.count());
        style.unbranched = unbranched_.mean();
        style.spacing = gaps_.mean();
        style.spacing_deviation = gaps_.deviation();
        level.mean_angle_deg = mean_angle_.mean();
        set_angles(style);
        for (std::size_t third = 0; third < lengths_.size(); ++third)
            level.lengths[third] = lengths_[third].mean();
        level.node_size = node_sizes_.mean();
        set_pattern(level);
        style.unevenness = (node_size(level.pattern) > 1 ? of_nodes_ : of_children_).value();
        return level;
    }

private:
    void add_lengths(std::span<PositionedLateral const> children)
    {
        double const first = children.front().u;
        double const width = std::max(children.back().u - first, 1e-9);
        for (auto const& child : children) {
            auto const third = static_cast<std::size_t>(3 * (child.u - first) / width);
            lengths_[std::min<std::size_t>(third, 2)].add(child.length);
        }
    }

    void add_turns(std::vector<NodeOfChildren> const& nodes)
    {
        Turn single {};
        for (std::size_t i = 1; i < nodes.size(); ++i) {
            single += turn_of(nodes[i].children.front().azimuth_deg
                              - nodes[i - 1].children.front().azimuth_deg);
            // Sums for opposite pairs, with doubled angles, because the order within a pair is
            // arbitrary.
            Turn one {};
            Turn other {};
            for (auto const& child : nodes[i - 1].children)
                one += turn_of(2 * child.azimuth_deg);
            for (auto const& child : nodes[i].children)
                other += turn_of(2 * child.azimuth_deg);
            if (std::abs(one) > 0 && std::abs(other) > 0)
                doubled_ += other / std::abs(other) * std::conj(one / std::abs(one));
            ++turns_;
        }
        // Left and right spirals count as the same.
        single_ += single.imag() < 0 ? std::conj(single) : single;
    }

    void set_angles(BranchStyle& style) const
    {
        style.first_angle_deg = std::clamp(angle_.at(0), kMinAngle_deg, kMaxAngle_deg);
        style.last_angle_deg = std::clamp(angle_.at(1), kMinAngle_deg, kMaxAngle_deg);
        Spread off;
        for (auto const& [share, angle_deg] : angles_)
            off.add(angle_deg - style.angle_at_deg(share));
        style.angle_deviation_deg = off.deviation();
    }

    void set_pattern(MeasuredLevel& level) const
    {
        if (turns_ == 0)
            return;
        auto const n = static_cast<double>(turns_);
        bool const is_paired = level.node_size >= 1.5;
        auto const mean = (is_paired ? doubled_ : single_) / n;
        double const turn_deg = std::fabs(degrees(std::arg(mean)));
        level.divergence_deg = is_paired ? turn_deg / 2 : turn_deg;
        level.divergence_sureness = std::abs(mean);
        if (level.node_size >= 2.5)
            level.pattern = Pattern::whorls_of(
                std::min(static_cast<int>(std::lround(level.node_size)), kMaxWhorl));
        else if (level.divergence_sureness < kSureOfTurn || (!is_paired && turn_deg < 100))
            level.pattern = Pattern::Even;
        else if (is_paired)
            level.pattern = level.divergence_deg < 45 ? Pattern::Horizontal : Pattern::Decussate;
        else
            level.pattern = turn_deg > 162 ? Pattern::TwoRows : Pattern::Spiral;
    }

    std::size_t bare_ = 0;
    Spread counts_;
    Spread unbranched_;
    Spread gaps_;
    Spread node_sizes_;
    Slope angle_;
    Spread mean_angle_;
    // Branching angles, each with the child's share of the distance from the first child to the
    // last.
    std::vector<std::pair<double, double>> angles_;
    std::array<Spread, 3> lengths_ {};
    Unevenness of_children_;
    Unevenness of_nodes_;
    Turn single_ {};
    Turn doubled_ {};
    std::size_t turns_ = 0;
};

std::optional<MeasuredLevel> measure_level(Plant const& plant,
                                           std::vector<std::vector<AxisId>> const& children,
                                           std::uint32_t order)
{
    LevelMeter meter;
    for (AxisId id = 0; id < plant.axes.size(); ++id) {
        auto const& axis = plant.axes[id];
        if (axis.order != order || !(axis_length_mm(plant, axis) > 0))
            continue;
        auto const standing = children_of(plant, id, children[id]);
        if (standing.empty())
            meter.add_bare();
        else
            meter.add(standing);
    }
    return meter.level();
}

bool is_leaf(Plant const& plant, OrganShape const& shape)
{
    return plant.materials[shape.material].kind == Material::Kind::Leaf;
}

void measure_leaves(Plant const& plant, MeasuredStyle& style)
{
    std::size_t leaves = 0;
    std::size_t sprays = 0;
    Spread width;
    std::vector<AxisId> parents;
    for (auto const& organ : plant.organs) {
        auto const& shape = plant.organ_shapes[organ.shape];
        if (!is_leaf(plant, shape) || !(shape.length_mm > 0 && organ.scale.y() > 0))
            continue;
        if (!shape.spray.empty()) {
            ++sprays;
            leaves += shape.spray.size();
            width.add(shape.spray.front().width_mm / shape.spray.front().length_mm);
            continue;
        }
        ++leaves;
        width.add(shape.width_mm * organ.scale.x() / (shape.length_mm * organ.scale.y()));
        if (organ.segment != kNone)
            parents.push_back(axis_of(plant, organ.segment));
    }
    std::sort(parents.begin(), parents.end());
    auto const twigs
        = static_cast<std::size_t>(std::unique(parents.begin(), parents.end()) - parents.begin())
        + sprays;
    style.has_sprays = sprays > 0;
    style.leaf_width = width.mean();
    if (twigs > 0)
        style.leaves_per_twig = static_cast<double>(leaves) / static_cast<double>(twigs);
}

} // namespace

Result<MeasuredStyle> measure_style(Plant const& plant)
{
    std::vector<std::vector<AxisId>> children(plant.axes.size());
    MeasuredStyle style;
    for (AxisId id = 0; id < plant.axes.size(); ++id) {
        auto const& axis = plant.axes[id];
        if (axis.parent_axis == kNone)
            continue;
        children[axis.parent_axis].push_back(id);
        style.orders = std::max(style.orders, static_cast<int>(axis.order));
    }
    for (std::uint32_t order = 0; order < kMaxMeasuredLevels; ++order) {
        auto level = measure_level(plant, children, order);
        if (!level)
            break;
        style.levels.push_back(*level);
    }
    if (style.levels.empty())
        return fail(Fault::User, "the plant has no branches: a style is measured on one that has");
    measure_leaves(plant, style);
    return style;
}

// Clamps the values of a style to the ranges that check_form() allows.
static BranchStyle within_limits(BranchStyle style)
{
    style.children = std::min(style.children, kMaxChildren);
    style.children_deviation = std::min(style.children_deviation, kMaxChildren);
    style.bare = std::min(style.bare, kMaxBare);
    style.unevenness = std::min(style.unevenness, kMaxUneven);
    style.spacing_deviation = std::min(style.spacing_deviation, 1.0);
    return style;
}

TreeForm form_of(MeasuredStyle const& style)
{
    TreeForm form;
    auto const measured = static_cast<int>(style.levels.size());
    int const without_twigs = style.has_sprays ? style.orders : style.orders - 1;
    form.levels = std::clamp(without_twigs, 1, measured);
    for (std::size_t i = 0; i < form.patterns.size(); ++i) {
        auto const& level = style.levels[std::min(i, style.levels.size() - 1)];
        form.patterns[i] = level.pattern;
        if (i < static_cast<std::size_t>(form.levels))
            form.styles[i] = within_limits(level.style);
    }
    // The trunk is the only parent of the first level, so no parent there can be without children.
    form.styles[0].bare = 0;
    while (form.levels > 1 && styled_branches(form) > kMaxStyled)
        form.styles[static_cast<std::size_t>(--form.levels)] = {};
    if (style.leaves_per_twig > 0) {
        form.leaves = static_cast<int>(std::clamp(std::round(style.leaves_per_twig), 1.0, 500.0));
        form.leaf_width = std::clamp(style.leaf_width, 0.01, 2.0);
    }
    return form;
}

} // namespace tractus::silhouette
