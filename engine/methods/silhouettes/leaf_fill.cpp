#include "engine/methods/silhouettes/leaf_fill.h"

#include "engine/base/random.h"
#include "engine/methods/silhouettes/leaf_raster.h"
#include "engine/methods/silhouettes/spray_maker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <utility>

namespace tractus::silhouette {

namespace {

// Greatest share of a twig's leaf pixels that may be outside of the outline.
constexpr double kMayBeOut = 0.05;
constexpr double kFilled = 0.95; // Share of the outline's pixels at which filling ends.

Vec2 seen_from_front(Vec3 const& place_mm)
{
    return { place_mm.x(), place_mm.z() };
}

// Ends of segments as seen from the front, in square buckets, so that the nearest is found quickly.
class SeenNodes {
public:
    struct Node {
        Vec2 at_mm;
        AxisId axis;
        SegmentId segment;
    };

    SeenNodes(LeafRaster const& raster, double bucket_mm)
        : low_(raster.low_mm())
        , bucket_mm_(bucket_mm)
        , columns_(1 + static_cast<int>((raster.high_mm() - low_).x() / bucket_mm))
        , rows_(1 + static_cast<int>((raster.high_mm() - low_).y() / bucket_mm))
        , buckets_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_))
    {
    }

    void add(Node const& node)
    {
        buckets_[static_cast<std::size_t>(row(node.at_mm) * columns_ + column(node.at_mm))]
            .push_back(node);
        ++count_;
    }

    bool is_empty() const { return count_ == 0; }

    // The node nearest to a place, of equally near ones that which was added first within its
    // bucket. Null if there is none.
    Node const* nearest(Vec2 const& place_mm) const
    {
        Node const* best = nullptr;
        double least = 1e300;
        int const x = column(place_mm);
        int const y = row(place_mm);
        int const last = std::max(columns_, rows_);
        for (int ring = 0; ring <= last && least > (ring - 1) * bucket_mm_; ++ring)
            for (int j = y - ring; j <= y + ring; ++j)
                for (int i = x - ring; i <= x + ring;
                     i += j == y - ring || j == y + ring ? 1 : std::max(1, 2 * ring))
                    look_in(i, j, place_mm, best, least);
        return best;
    }

private:
    void look_in(int column, int row, Vec2 const& place_mm, Node const*& best, double& least) const
    {
        if (column < 0 || row < 0 || column >= columns_ || row >= rows_)
            return;
        for (auto const& node : buckets_[static_cast<std::size_t>(row * columns_ + column)]) {
            double const away = (node.at_mm - place_mm).norm();
            if (away < least) {
                least = away;
                best = &node;
            }
        }
    }

    int column(Vec2 const& at) const
    {
        return std::clamp(static_cast<int>((at.x() - low_.x()) / bucket_mm_), 0, columns_ - 1);
    }
    int row(Vec2 const& at) const
    {
        return std::clamp(static_cast<int>((at.y() - low_.y()) / bucket_mm_), 0, rows_ - 1);
    }

    Vec2 low_;
    double bucket_mm_;
    int columns_;
    int rows_;
    std::vector<std::vector<Node>> buckets_;
    std::size_t count_ = 0;
};

class LeafFiller {
public:
    LeafFiller(Tree& tree, TreeOptions const& options, LeafFillLimits const& limits)
        : tree_(tree)
        , options_(options)
        , limits_(limits)
        , raster_(tree.outline_mm)
        , longest_mm_(kLongestSpray * options.height_mm)
        , shortest_mm_(kShortestSpray * options.height_mm)
        , nodes_(raster_, longest_mm_)
        , bearers_(raster_, longest_mm_)
        , random_({ .seed = options.seed, .stream = kFillStream, .substream = 0 })
    {
    }

    void run()
    {
        trim();
        most_sprays_ = static_cast<std::size_t>(kMostAdded * static_cast<double>(tree_.sprays))
            + kAlwaysAdded;
        collect_nodes();
        if (nodes_.is_empty())
            return;
        if (!bearers_.is_empty())
            reach_gaps();
        constexpr int kPasses = 6;
        for (int pass = 0; pass < kPasses && !is_filled(); ++pass)
            cover_pixels();
    }

private:
    static constexpr std::uint32_t kFillStream = 0x1f11;
    static constexpr std::size_t kAlwaysAdded = 400;

    bool is_filled() const
    {
        return tree_.sprays >= most_sprays_ || raster_.coverage().inside >= kFilled;
    }

    OrganShape const& shape_of(Organ const& organ) const
    {
        return tree_.plant.organ_shapes[organ.shape];
    }

    // The spray, made as much smaller as its leaves need to stay inside; no value if it would
    // become too small.
    std::optional<Organ> fitted(Organ const& spray) const
    {
        constexpr double kSpread = 1.15; // Distance of leaves from a twig's base, in its lengths.
        double const length_mm = kSprayLength_mm * static_cast<double>(spray.scale.x());
        if (raster_.is_deeper_than(kSpread * length_mm, seen_from_front(spray.position_mm)))
            return spray;
        for (float const size : { 1.0f, 0.8f, 0.62f, 0.48f }) {
            auto smaller = spray;
            smaller.scale *= size;
            auto const pixels = raster_.count(shape_of(spray), smaller);
            if (static_cast<double>(pixels.outside) <= kMayBeOut * static_cast<double>(pixels.all))
                return smaller;
        }
        return std::nullopt;
    }

    bool may_stick_out(Organ const& organ) const
    {
        auto const& axes = tree_.plant.axes;
        auto const after = std::upper_bound(
            axes.begin(), axes.end(), organ.segment,
            [](SegmentId segment, Axis const& axis) { return segment < axis.first_segment; });
        return limits_.may_stick_out[static_cast<std::size_t>(after - axes.begin()) - 1];
    }

    // Draws all sprays, and shortens or removes those that stick out.
    void trim()
    {
        auto const organs = std::exchange(tree_.plant.organs, {});
        for (std::size_t i = 0; i < organs.size(); ++i) {
            bool const is_spray = organs[i].shape < kSprayVariants;
            if (!is_spray || may_stick_out(organs[i])) {
                tree_.plant.organs.push_back(organs[i]);
                if (organs[i].shape != kSprayVariants)
                    raster_.draw(shape_of(organs[i]), organs[i]);
                continue;
            }
            ++i; // The spray's twig follows it.
            --tree_.sprays;
            tree_.leaves -= static_cast<std::size_t>(options_.leaf.per_spray);
            if (auto const spray = fitted(organs[i - 1]))
                add(*spray);
        }
    }

    // Adds a spray and its twig.
    void add(Organ spray)
    {
        raster_.draw(shape_of(spray), spray);
        tree_.plant.organs.push_back(spray);
        spray.shape = kSprayVariants;
        tree_.plant.organs.push_back(spray);
        ++tree_.sprays;
        tree_.leaves += static_cast<std::size_t>(options_.leaf.per_spray);
    }

    void add_nodes_of(AxisId id)
    {
        auto const& axis = tree_.plant.axes[id];
        for (std::uint32_t i = 0; i < axis.segment_count; ++i) {
            Vec2 const at = seen_from_front(tree_.plant.node_position_mm[axis.first_node + i + 1]);
            if (!raster_.is_inside(at))
                continue;
            if (axis.order > 0 || has_only_trunk_)
                nodes_.add({ at, id, axis.first_segment + i });
            if (axis.order < deepest_)
                bearers_.add({ at, id, axis.first_segment + i });
        }
    }

    // Twigs are added to branches of the deeper levels; to the trunk only if there is nothing else.
    void collect_nodes()
    {
        auto const& axes = tree_.plant.axes;
        for (auto const& axis : axes)
            deepest_ = std::max(deepest_, axis.order);
        has_only_trunk_ = axes.size() == 1;
        for (AxisId id = 0; id < axes.size(); ++id)
            add_nodes_of(id);
    }

    struct Gap {
        Vec2 at_mm;
        double away_mm; // Distance to the nearest node.
    };

    // Adds branches to uncovered places that no twig reaches, the farthest first.
    void reach_gaps()
    {
        constexpr std::size_t kStep = 7; // Every seventh uncovered pixel is looked at.
        constexpr int kMostBranches = 500;
        double const reach_mm = 0.8 * longest_mm_;
        std::vector<Gap> gaps;
        auto const pixels = raster_.uncovered();
        for (std::size_t i = 0; i < pixels.size(); i += kStep) {
            Vec2 const at = raster_.place_of(pixels[i]);
            double const away = (nodes_.nearest(at)->at_mm - at).norm();
            if (away > reach_mm)
                gaps.push_back({ at, away });
        }
        for (int i = 0; i < kMostBranches; ++i) {
            auto const widest
                = std::max_element(gaps.begin(), gaps.end(), [](Gap const& one, Gap const& other) {
                      return one.away_mm < other.away_mm;
                  });
            if (widest == gaps.end() || widest->away_mm <= reach_mm)
                return;
            auto const added = branch_to(*widest);
            widest->away_mm = 0;
            for (auto const& node : added)
                for (auto& gap : gaps)
                    gap.away_mm = std::min(gap.away_mm, (gap.at_mm - node).norm());
        }
    }

    // Adds a branch to a gap, from the nearest node of an axis above the last level, so that the
    // tree keeps its number of levels. Returns its nodes as seen; none if it would leave the
    // outline.
    std::vector<Vec2> branch_to(Gap const& gap)
    {
        auto const from = *bearers_.nearest(gap.at_mm);
        Vec2 const to_gap = gap.at_mm - from.at_mm;
        auto const& plant = tree_.plant;
        auto const ends = nodes_of(plant, from.segment);
        Vec3 const base = plant.node_position_mm[ends.tip];
        Vec3 const before = plant.node_position_mm[ends.base];
        // The branch ends where its last twig reaches the gap.
        double const share = std::max(0.4, 1 - 0.5 * longest_mm_ / to_gap.norm());
        Vec2 const across = share * to_gap;
        Vec3 const way(across.x(), across.norm() * random_.uniform(-0.3, 0.3), across.y());
        Vec3 const along = (base - before).normalized() * way.norm();
        for (double const bend : { 0.35, 0.0 }) {
            Vec3 const control = base + bend * along + (0.5 - 0.5 * bend) * way;
            auto const points = curve(base, control, base + way);
            bool const stays = std::all_of(points.begin(), points.end(), [&](Vec3 const& point) {
                return raster_.is_inside(seen_from_front(point))
                    && (!limits_.surface || limits_.surface->holds(point));
            });
            if (stays)
                return add_axis(from, points);
        }
        return {};
    }

    std::vector<Vec3> curve(Vec3 const& base, Vec3 const& control, Vec3 const& tip) const
    {
        auto const pieces
            = static_cast<int>(std::clamp((tip - base).norm() / (0.35 * longest_mm_), 4.0, 24.0));
        std::vector<Vec3> points;
        for (int i = 0; i <= pieces; ++i) {
            double const t = static_cast<double>(i) / pieces;
            points.emplace_back((1 - t) * (1 - t) * base + 2 * t * (1 - t) * control + t * t * tip);
        }
        return points;
    }

    std::vector<Vec2> add_axis(SeenNodes::Node const& from, std::vector<Vec3> const& points)
    {
        auto& plant = tree_.plant;
        auto const id = static_cast<AxisId>(plant.axes.size());
        auto const segments = static_cast<std::uint32_t>(points.size() - 1);
        plant.axes.push_back({ .first_node = static_cast<NodeId>(plant.node_position_mm.size()),
                               .first_segment = static_cast<SegmentId>(plant.segment_count()),
                               .segment_count = segments,
                               .parent_segment = from.segment,
                               .parent_axis = from.axis,
                               .order = plant.axes[from.axis].order + 1 });
        std::vector<Vec2> seen;
        for (auto const& point : points) {
            plant.node_position_mm.push_back(point);
            plant.node_radius_mm.push_back(0);
            seen.push_back(seen_from_front(point));
        }
        plant.segment_material.resize(plant.segment_count() + segments, 0);
        auto const& parent = tree_.axis_names[from.axis];
        auto const name = fmt::format("e{}", branches_on_[from.axis]++);
        tree_.axis_names.push_back(parent == kTrunkName ? name : parent + "/" + name);
        add_nodes_of(id);
        return seen;
    }

    // Adds a twig towards each uncovered pixel, in random order.
    void cover_pixels()
    {
        auto pixels = raster_.uncovered();
        for (std::size_t i = pixels.size(); i > 1; --i)
            std::swap(pixels[i - 1], pixels[random_.next_u64() % i]);
        for (auto const pixel : pixels) {
            if (is_filled())
                return;
            if (raster_.is_uncovered(pixel))
                add_twig_to(raster_.place_of(pixel));
        }
    }

    // The node for a twig to this place: one that is about so far away in a random direction, or
    // the nearest if there is none.
    SeenNodes::Node const* node_for(Vec2 const& place_mm, double away_mm)
    {
        double const angle = random_.uniform(0, 2 * kPi);
        auto const* const node
            = nodes_.nearest(place_mm + away_mm * Vec2(std::cos(angle), std::sin(angle)));
        bool const is_near = (node->at_mm - place_mm).norm() < longest_mm_;
        return is_near ? node : nodes_.nearest(place_mm);
    }

    void add_twig_to(Vec2 const& place_mm)
    {
        // Least number of newly covered pixels for which a twig is worth while.
        constexpr std::size_t kLeastFresh = 3;
        constexpr double kMiddle = 0.62; // Where leaves are densest, as a share of a twig's length.
        auto const& node = *node_for(place_mm, kMiddle * longest_mm_ * random_.uniform(0.5, 1));
        Vec2 way = place_mm - node.at_mm;
        double const away_mm = way.norm();
        if (away_mm > longest_mm_)
            return;
        auto const ends = nodes_of(tree_.plant, node.segment);
        Vec3 const base = tree_.plant.node_position_mm[ends.tip];
        if (away_mm < 0.3 * shortest_mm_) {
            Vec3 const along = base - tree_.plant.node_position_mm[ends.base];
            way = turned(seen_from_front(along), radians(random_.uniform(-70, 70)));
        }
        if (way.norm() < 1e-9)
            return;
        way.normalize();
        double const tilt = radians(random_.uniform(-35, 35));
        Vec3 const heading(std::cos(tilt) * way.x(), std::sin(tilt), std::cos(tilt) * way.y());
        double length_mm = std::clamp(away_mm / kMiddle, 0.5 * longest_mm_, longest_mm_)
            * random_.uniform(0.9, 1.1);
        if (limits_.surface)
            length_mm *= limits_.surface->size_inside(
                std::array { Vec3(base + length_mm * heading) }, base);
        Organ const spray { .shape = static_cast<OrganShapeId>(random_.next_u32() % kSprayVariants),
                            .segment = node.segment,
                            .position_mm = base,
                            .orientation = Quat(spray_frame(heading, Vec3::UnitX())).normalized(),
                            .scale
                            = Vec3f::Constant(static_cast<float>(length_mm / kSprayLength_mm)) };
        auto const fitting = fitted(spray);
        if (fitting && raster_.count(shape_of(*fitting), *fitting).fresh >= kLeastFresh)
            add(*fitting);
    }

    Tree& tree_;
    TreeOptions const& options_;
    LeafFillLimits const& limits_;
    LeafRaster raster_;
    double longest_mm_; // Greatest and smallest length of a twig.
    double shortest_mm_;
    SeenNodes nodes_;   // Nodes of branches, which bear twigs.
    SeenNodes bearers_; // Nodes that bear added branches: of all axes but those of the last level.
    std::uint32_t deepest_ = 1; // Order of the axes of the last level.
    bool has_only_trunk_ = false;
    Random random_;
    std::size_t most_sprays_ = 0;
    std::map<AxisId, int> branches_on_; // Number of branches added to each axis.
};

} // namespace

void fill_with_leaves(Tree& tree, TreeOptions const& options, LeafFillLimits const& limits)
{
    if (tree.outline_mm.size() >= 3 && tree.sprays > 0)
        LeafFiller(tree, options, limits).run();
}

} // namespace tractus::silhouette
