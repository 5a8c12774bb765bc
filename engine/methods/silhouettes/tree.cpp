#include "engine/methods/silhouettes/tree.h"

#include "engine/methods/silhouettes/crowd.h"
#include "engine/methods/silhouettes/leaf_blade.h"
#include "engine/methods/silhouettes/line.h"
#include "engine/methods/silhouettes/sibling_style.h"
#include "engine/methods/silhouettes/styled_crowd.h"
#include "engine/methods/silhouettes/surface_fit.h"
#include "engine/plant/pipe_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace tractus::silhouette {

namespace {

constexpr std::uint32_t kSprayVariants = 8;

// Shares of the tree's height: a parent with the usual number of twigs, and twigs.
constexpr double kParent = 0.07;
constexpr double kLongestSpray = 0.055;
constexpr double kShortestSpray = 0.016;

using Space = Eigen::Affine3d; // From a plane (x, y, 0) to the plant.

Space in_space(Similarity const& way)
{
    double const flip = way.mirrors ? -1 : 1;
    Space space = Space::Identity();
    space.linear() << way.turn.x(), -flip * way.turn.y(), 0, way.turn.y(), flip * way.turn.x(), 0,
        0, 0, flip * way.turn.norm();
    Vec3 const from(way.from.x(), way.from.y(), 0);
    space.translation() = Vec3(way.to.x(), way.to.y(), 0) - space.linear() * from;
    return space;
}

class Grower {
public:
    Grower(Skeleton const& skeleton, TreeOptions const& options)
        : skeleton_(skeleton)
        , options_(options)
        , maker_(skeleton, options)
    {
        for (std::uint32_t level = 0; level < options.levels.size(); ++level)
            styled_.emplace_back(maker_, skeleton, options, level);
    }

    Tree run()
    {
        auto const& tree = skeleton_.systems[0];
        Vec2 const foot = tree.trunk.front();
        double const scale = options_.height_mm / std::max(drawn_height(skeleton_), 1e-9);
        Space space = Space::Identity();
        space.linear() << scale, 0, 0, 0, 0, -scale, 0, scale, 0;
        space.translation() = -(space.linear() * Vec3(foot.x(), foot.y(), 0));
        if (!skeleton_.surface.empty())
            fit_.emplace(maker_.surface_of(0), space);
        add_looks();
        if (tree.leaf)
            grow_leaf({ .space = space, .line = Line(stalk_of(*tree.leaf, tree.trunk)) },
                      *tree.leaf);
        else
            grow({ .system = 0, .space = space, .line = Line(tree.whole_trunk()) });
        apply_pipe_model(tree_.plant, 2.2, options_.tip_radius_of_height * options_.height_mm);
        for (auto& [level, places] : told_)
            tree_.arrangements.push_back(std::move(places));
        return std::move(tree_);
    }

private:
    // An axis to be made.
    struct Parent {
        std::size_t system = kNoSystem; // Whose trunk it is.
        Space space;
        Line line;
        std::vector<Vec2> crown {};
        std::string name {};
        SegmentId parent_segment = kNone;
        AxisId parent_axis = kNone;
        std::uint32_t level = 0;
        bool is_stroke = false; // Somebody drew its line.
    };

    void add_looks()
    {
        auto& plant = tree_.plant;
        plant.materials.push_back({ .name = "bark", .base_color = options_.bark_color });
        plant.materials.push_back({ .name = "leaf",
                                    .kind = Material::Kind::Leaf,
                                    .base_color = options_.leaf_color,
                                    .roughness = 0.6f,
                                    .translucency = 0.4f });
        for (std::uint32_t variant = 0; variant < kSprayVariants; ++variant)
            plant.organ_shapes.push_back(leaf_spray(options_.leaf, 1, variant));
        plant.organ_shapes.push_back(spray_twig(0));
    }

    // The options of a level; beyond those that are given the last one's go on.
    std::size_t options_of(std::uint32_t level) const
    {
        return std::min<std::size_t>(level, options_.levels.size() - 1);
    }

    LevelOptions const& level_options(std::uint32_t level) const
    {
        return options_.levels[options_of(level)];
    }

    // Depth first: an axis comes after its parent.
    void grow(Parent const& parent)
    {
        std::optional<Crowd> own;
        Crowd const* crowd = nullptr;
        // What was drawn of a branch says more than a style does.
        if (parent.system != kNoSystem && level_options(parent.level).style.is_set()
            && !skeleton_.systems[parent.system].is_of_own_outline
            && !skeleton_.systems[parent.system].is_in_siblings_style)
            crowd = styled_crowd(parent, own);
        else if (parent.system != kNoSystem)
            crowd = &crowd_of(parent.system, parent.level);
        auto const places = node_places(parent, crowd);
        auto const axis = add_axis(parent, places);
        bool const has_twigs
            = !crowd || (parent.level > 0 && !bears_leaves_alone(skeleton_.systems[parent.system]));
        if (has_twigs)
            add_sprays(parent, axis, places, crowd ? 0.5 : 0.0);
        if (!crowd)
            return;
        std::size_t node = 0;
        for (auto const& standing : crowd->branches) {
            while (node + 2 < places.size() && places[node + 1] < standing.u - 1e-9)
                ++node;
            grow_branch(parent, axis, standing, node);
        }
    }

    // Its stalk, and the leaf.
    void grow_leaf(Parent const& stalk, LeafBlade const& leaf)
    {
        auto const axis = add_axis(stalk, node_places(stalk, nullptr));
        Vec2 const way = leaf.tip - leaf.base;
        Vec2 const across = (leaf.mirrors ? -1 : 1) * Vec2(way.y(), -way.x());
        Vec3 const heading = stalk.space.linear() * Vec3(way.x(), way.y(), 0);
        Eigen::Matrix3d frame;
        frame.col(0) = (stalk.space.linear() * Vec3(across.x(), across.y(), 0)).normalized();
        frame.col(1) = heading.normalized();
        frame.col(2) = frame.col(0).cross(frame.col(1));
        auto const& [first, segments]
            = std::pair(tree_.plant.axes[axis].first_segment, tree_.plant.axes[axis].segment_count);
        tree_.plant.organs.push_back(
            { .shape = shape_of(leaf),
              .segment = first + segments - 1,
              .position_mm = stalk.space * Vec3(leaf.base.x(), leaf.base.y(), 0),
              .orientation = Quat(frame).normalized(),
              .scale = Vec3f::Constant(static_cast<float>(heading.norm())) });
        ++tree_.leaves;
    }

    // Leaves of one outline are organs of one shape.
    OrganShapeId shape_of(LeafBlade const& leaf)
    {
        auto& shapes = tree_.plant.organ_shapes;
        for (auto const& [outline, shape] : leaf_shapes_)
            if (outline == leaf.outline)
                return shape;
        leaf_shapes_.emplace_back(leaf.outline, static_cast<OrganShapeId>(shapes.size()));
        shapes.push_back(leaf_organ(leaf.outline, 1));
        return leaf_shapes_.back().second;
    }

    void grow_branch(Parent const& parent, AxisId axis, Standing const& standing,
                     std::size_t segment)
    {
        auto const& system = skeleton_.systems[parent.system];
        auto const& branch = system.branches[standing.branch];
        Space const own = space_of(parent, standing, branch);
        auto const name = parent.name.empty() ? standing.name : parent.name + "/" + standing.name;
        auto const parent_segment
            = tree_.plant.axes[axis].first_segment + static_cast<SegmentId>(segment);
        if (branch.leaf) {
            grow_leaf({ .space = own,
                        .line = Line(stalk_of(*branch.leaf, branch.line(17))),
                        .name = name,
                        .parent_segment = parent_segment,
                        .parent_axis = axis,
                        .level = parent.level + 1 },
                      *branch.leaf);
            return;
        }
        // A copy's own branches are its model's, seen through the way from there.
        auto const below = skeleton_.system_of[parent.system][standing.branch];
        auto const& model = branch.model ? system.branches[*branch.model] : branch;
        Space const to_model = branch.model ? own * in_space(branch.from_model) : own;
        grow({ .system = below,
               .space = to_model,
               .line = Line(maker_.line_of(model, below)),
               .crown = model.crown,
               .name = name,
               .parent_segment = parent_segment,
               .parent_axis = axis,
               .level = parent.level + 1,
               .is_stroke = !model.stroke.empty() });
    }

    // Where a branch stands, turned about its parent by so much of the angle that it has.
    static Space space_of(Parent const& parent, Standing const& standing, Branch const& branch,
                          double share)
    {
        Vec2 const base = standing.way.point(branch.path.curve.base);
        Vec2 const along = parent.line.direction(standing.u);
        double const reference = branch.path.side == Side::Right ? 0 : 180;
        double const turn_deg = standing.theta_deg - reference;
        double const shorter_deg = turn_deg - 360 * std::round(turn_deg / 360);
        Vec3 const pivot = parent.space * Vec3(base.x(), base.y(), 0);
        Vec3 const direction = (parent.space.linear() * Vec3(along.x(), along.y(), 0)).normalized();
        Eigen::AngleAxisd const turn(radians(share == 1 ? turn_deg : share * shorter_deg),
                                     direction);
        Space around = Space::Identity();
        around.linear() = turn.toRotationMatrix();
        around.translation() = pivot - around.linear() * pivot;
        return around * parent.space * in_space(standing.way);
    }

    // Branches on branches leave the plane in which their parent was fitted to a surface that was
    // drawn: they turn back towards it, and shrink, as far as they must.
    Space space_of(Parent const& parent, Standing const& standing, Branch const& branch) const
    {
        constexpr double kLarge = 0.8;
        Space const as_it_stands = space_of(parent, standing, branch, 1);
        if (!fit_ || parent.level == 0 || branch.is_stroke())
            return as_it_stands;
        Space best = as_it_stands;
        double largest = 0;
        for (double const share : { 1.0, 0.6, 0.3, 0.1 }) {
            Space const turned_back = space_of(parent, standing, branch, share);
            double const size = size_inside(turned_back, branch);
            if (size <= largest)
                continue;
            largest = size;
            best = turned_back;
            if (largest >= kLarge)
                break;
        }
        Vec2 const base = branch.path.curve.base;
        Vec3 const pivot = best * Vec3(base.x(), base.y(), 0);
        return Eigen::Translation3d(pivot) * Eigen::Scaling(largest) * Eigen::Translation3d(-pivot)
            * best;
    }

    double size_inside(Space const& space, Branch const& branch) const
    {
        std::vector<Vec3> places;
        for (std::size_t i = 0; i < branch.crown.size(); i += 3)
            places.emplace_back(space * Vec3(branch.crown[i].x(), branch.crown[i].y(), 0));
        Vec2 const base = branch.path.curve.base;
        return fit_->size_inside(places, space * Vec3(base.x(), base.y(), 0));
    }

    // Shares of the parent's length where it has nodes: its own, and where branches stand.
    std::vector<double> node_places(Parent const& parent, Crowd const* crowd) const
    {
        constexpr std::array kSegments { 16, 8, 4, 3 };
        constexpr int kStyled = 8; // At least: angles are those of an eighth.
        int own = kSegments[std::min<std::size_t>(parent.level, kSegments.size() - 1)];
        if (parent.level > 0 && level_options(parent.level - 1).style.is_set())
            own = std::max(own, kStyled);
        if (parent.is_stroke)
            own = kSegments[0];
        std::vector<double> places;
        for (int i = 0; i <= own; ++i)
            places.push_back(static_cast<double>(i) / own);
        if (crowd)
            for (auto const& branch : crowd->branches)
                places.push_back(std::clamp(branch.u, 0.002, 1.0));
        std::sort(places.begin(), places.end());
        std::vector<double> apart { 0 };
        for (auto const place : places)
            if (place > apart.back() + 1e-4)
                apart.push_back(place);
        return apart;
    }

    AxisId add_axis(Parent const& parent, std::vector<double> const& places)
    {
        auto& plant = tree_.plant;
        auto const id = static_cast<AxisId>(plant.axes.size());
        plant.axes.push_back({ .first_node = static_cast<NodeId>(plant.node_position_mm.size()),
                               .first_segment = static_cast<SegmentId>(plant.segment_count()),
                               .segment_count = static_cast<std::uint32_t>(places.size() - 1),
                               .parent_segment = parent.parent_segment,
                               .parent_axis = parent.parent_axis,
                               .order = parent.level });
        for (auto const place : places) {
            Vec2 const point = parent.line.at(place);
            plant.node_position_mm.emplace_back(parent.space * Vec3(point.x(), point.y(), 0));
            plant.node_radius_mm.push_back(0);
        }
        plant.segment_material.resize(plant.segment_count() + places.size() - 1, 0);
        tree_.axis_names.push_back(parent.name.empty() ? kTrunkName : parent.name);
        return id;
    }

    // How far it is from a place to the crown's edge.
    static double reach(std::vector<Vec2> const& crown, Vec2 const& from, Vec2 const& way)
    {
        double least = 1e300;
        for (std::size_t i = 0; i < crown.size(); ++i) {
            Vec2 const edge = crown[(i + 1) % crown.size()] - crown[i];
            double const over = cross(way, edge);
            double const far = cross(crown[i] - from, edge) / over;
            double const along = cross(crown[i] - from, way) / over;
            if (over != 0 && far > 0 && along >= 0 && along <= 1)
                least = std::min(least, far);
        }
        return least;
    }

    // Twigs of about one length, whatever bears them: more on a longer parent, from the share
    // `from` of its length on.
    void add_sprays(Parent const& parent, AxisId axis, std::vector<double> const& places,
                    double from)
    {
        constexpr double kBare = 0.15;
        constexpr double kSpiral_deg = 137.5;
        double const start = std::max(from, kBare);
        double const length = parent.line.length();
        double const height = options_.height_mm / unit_of(parent.space); // In the plane's unit.
        double const usual
            = static_cast<double>(options_.sprays) * (1 - start) * length / (kParent * height);
        auto const count = std::clamp<std::size_t>(static_cast<std::size_t>(usual),
                                                   options_.sprays / 3 + 1, 6 * options_.sprays);
        Random random({ .seed = options_.seed, .stream = 3, .substream = axis });
        double const first_deg = random.uniform(0, 360);
        std::size_t node = 0;
        for (std::size_t i = 0; i <= count; ++i) {
            double const u
                = start + (1 - start) * static_cast<double>(i) / static_cast<double>(count);
            while (node + 2 < places.size() && places[node + 1] < u)
                ++node;
            Vec2 const at = parent.line.at(u);
            Vec2 const along = parent.line.direction(u);
            double const lean = i == count ? 0 : radians(random.uniform(38, 58));
            double far = kLongestSpray * height;
            for (double const side : { 1.0, -1.0 })
                if (!parent.crown.empty())
                    far = std::min(far, 0.95 * reach(parent.crown, at, turned(along, side * lean)));
            add_spray({ parent, axis, node, at, along },
                      { lean, radians(first_deg + static_cast<double>(i) * kSpiral_deg),
                        std::max(far, kShortestSpray * height) },
                      random);
        }
    }

    // Millimetres of the plant to one of the plane.
    static double unit_of(Space const& space)
    {
        return std::cbrt(std::fabs(space.linear().determinant()));
    }

    struct SprayPlace {
        Parent const& parent;
        AxisId axis;
        std::size_t segment;
        Vec2 at;
        Vec2 along;
    };
    struct SprayWay {
        double lean;
        double around;
        double length; // In the plane's unit.
    };

    void add_spray(SprayPlace const& place, SprayWay const& way, Random& random)
    {
        auto const& space = place.parent.space;
        Vec3 const forward
            = (space.linear() * Vec3(place.along.x(), place.along.y(), 0)).normalized();
        Vec3 const across
            = (space.linear() * Vec3(-place.along.y(), place.along.x(), 0)).normalized();
        Vec3 const out
            = std::cos(way.around) * across + std::sin(way.around) * forward.cross(across);
        Vec3 const heading = (std::cos(way.lean) * forward + std::sin(way.lean) * out).normalized();
        Vec3 side = heading.cross(Vec3::UnitZ());
        side = side.norm() > 1e-3 ? Vec3(side.normalized()) : across;
        Eigen::Matrix3d frame;
        frame << side, heading, side.cross(heading);
        Vec3 const base = space * Vec3(place.at.x(), place.at.y(), 0);
        double length = way.length * unit_of(space);
        if (fit_)
            length *= fit_->size_inside(std::array { Vec3(base + length * heading) }, base);
        auto const size = static_cast<float>(length / kSprayLength_mm * random.uniform(0.85, 1.1));
        Organ organ { .shape = static_cast<OrganShapeId>(random.next_u32() % kSprayVariants),
                      .segment = tree_.plant.axes[place.axis].first_segment
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

    Crowd const& crowd_of(std::size_t system, std::uint32_t level)
    {
        auto const found = crowds_.find(system);
        if (found != crowds_.end())
            return found->second;
        auto& crowd = crowds_[system];
        auto options = level_options(level);
        // Somebody looked at it as closely as at a tree.
        if (skeleton_.systems[system].is_of_own_outline)
            options.added = std::max(options.added, level_options(0).added);
        crowd = maker_.make(system, options);
        tell(level, crowd);
        return crowd;
    }

    // In the style of its level; null: it bears none.
    Crowd const* styled_crowd(Parent const& parent, std::optional<Crowd>& own)
    {
        own = styled_[options_of(parent.level)].next(
            { .system = parent.system,
              .is_trunk = parent.level == 0,
              .line = parent.line,
              .number = static_cast<std::uint32_t>(tree_.plant.axes.size()) });
        if (!own)
            return nullptr;
        tell(parent.level, *own);
        return &*own;
    }

    void tell(std::uint32_t level, Crowd const& crowd)
    {
        if (!told_.contains(level))
            for (auto const& branch : crowd.branches)
                told_[level].push_back({ branch.name, { branch.u, branch.theta_deg } });
    }

    Skeleton const& skeleton_;
    TreeOptions const& options_;
    Tree tree_;
    std::vector<std::pair<std::vector<Vec2>, OrganShapeId>> leaf_shapes_;
    std::map<std::size_t, Crowd> crowds_;
    std::map<std::uint32_t, std::vector<PlacedBranch>> told_;
    std::optional<SurfaceFit> fit_; // No value: no surface was drawn.
    CrowdMaker maker_;
    std::vector<StyledCrowdMaker> styled_; // Of each level.
};

} // namespace

double drawn_height(Skeleton const& skeleton)
{
    auto const& tree = skeleton.systems[0];
    auto const box = box_of(tree.outline);
    Vec2 const foot = tree.trunk.front();
    return std::max(box.high.y(), foot.y()) - std::min(box.low.y(), foot.y());
}

Tree make_tree(Skeleton const& skeleton, TreeOptions const& options)
{
    return Grower(skeleton, options).run();
}

} // namespace tractus::silhouette
