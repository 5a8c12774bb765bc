#include "engine/methods/silhouettes/tree.h"

#include "engine/methods/silhouettes/branch_set.h"
#include "engine/methods/silhouettes/branch_space.h"
#include "engine/methods/silhouettes/leaf_blade.h"
#include "engine/methods/silhouettes/leaf_fill.h"
#include "engine/methods/silhouettes/line.h"
#include "engine/methods/silhouettes/sibling_style.h"
#include "engine/methods/silhouettes/spray_maker.h"
#include "engine/methods/silhouettes/styled_branch_set.h"
#include "engine/plant/bark_materials.h"
#include "engine/plant/pipe_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace tractus::silhouette {

namespace {

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
            sprays_.stay_inside(fit_.emplace(maker_.surface_of(0), space));
        add_looks();
        if (tree.leaf)
            grow_leaf({ .space = space, .line = Line(stalk_of(*tree.leaf, tree.trunk)) },
                      *tree.leaf);
        else
            grow({ .system = 0, .space = space, .line = Line(tree.whole_trunk()) });
        for (auto const& point : tree.outline) {
            Vec3 const place_mm = space * Vec3(point.x(), point.y(), 0);
            tree_.outline_mm.emplace_back(place_mm.x(), place_mm.z());
        }
        if (options_.leaves_reach_outline && !tree.leaf)
            fill_with_leaves(tree_, options_,
                             { std::move(may_stick_out_), fit_ ? &*fit_ : nullptr });
        apply_pipe_model(tree_.plant, 2.2, options_.tip_radius_of_height * options_.height_mm);
        put_on_bark();
        for (auto& [level, places] : told_)
            tree_.arrangements.push_back(std::move(places));
        return std::move(tree_);
    }

private:
    // An axis still to be added.
    struct Parent {
        std::size_t system = kNoSystem; // The system whose trunk is this axis.
        Space space;
        Line line;
        std::vector<Vec2> crown {};
        std::string name {};
        SegmentId parent_segment = kNone;
        AxisId parent_axis = kNone;
        std::uint32_t level = 0;
        bool is_stroke = false; // True if the axis follows a drawn stroke.
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
        sprays_.add_shapes();
    }

    // Gives each segment the bark of its girth.
    void put_on_bark()
    {
        auto& plant = tree_.plant;
        if (options_.bark == BarkKind::Furrowed)
            return;
        plant.materials[0].base_color = bark_color({ options_.bark, BarkAge::Old });
        auto const barks = add_bark(plant, 0, options_.bark);
        for (auto const& axis : plant.axes)
            for (std::uint32_t i = 0; i < axis.segment_count; ++i) {
                auto& material = plant.segment_material[axis.first_segment + i];
                if (material == 0)
                    material
                        = barks.at(2 * double { plant.node_radius_mm[axis.first_node + i + 1] });
            }
    }

    // Index of a level's options; the last entry applies to all deeper levels.
    std::size_t options_of(std::uint32_t level) const
    {
        return std::min<std::size_t>(level, options_.levels.size() - 1);
    }

    LevelOptions const& level_options(std::uint32_t level) const
    {
        return options_.levels[options_of(level)];
    }

    // Adds an axis and its descendants depth first, so that every axis comes after its parent.
    void grow(Parent const& parent)
    {
        std::optional<BranchSet> own;
        BranchSet const* branch_set = nullptr;
        // A level's style does not apply to a branch whose outline was drawn or that shares a style
        // with siblings.
        if (parent.system != kNoSystem && level_options(parent.level).style.is_set()
            && !skeleton_.systems[parent.system].is_of_own_outline
            && !skeleton_.systems[parent.system].is_in_siblings_style)
            branch_set = styled_branch_set(parent, own);
        else if (parent.system != kNoSystem)
            branch_set = &branch_set_of(parent.system, parent.level);
        auto const places = node_places(parent, branch_set);
        auto const axis = add_axis(parent, places);
        bool const has_twigs = !branch_set
            || (parent.level > 0 && !has_only_leaves(skeleton_.systems[parent.system]));
        if (has_twigs)
            sprays_.add({ parent.space, parent.line, parent.crown, axis }, places,
                        branch_set ? 0.5 : 0.0);
        if (!branch_set)
            return;
        std::size_t node = 0;
        for (auto const& standing : branch_set->branches) {
            while (node + 2 < places.size() && places[node + 1] < standing.u - 1e-9)
                ++node;
            grow_branch(parent, axis, standing, node);
        }
    }

    // Adds a leaf that ends a branch: its petiole as an axis and its blade as an organ.
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

    // The organ shape of a leaf; leaves with the same outline share one.
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

    void grow_branch(Parent const& parent, AxisId axis, PositionedBranch const& standing,
                     std::size_t segment)
    {
        auto const& system = skeleton_.systems[parent.system];
        auto const& branch = system.branches[standing.branch];
        ParentBranch const bearer { parent.space, parent.line };
        bool const is_fitted = fit_ && parent.level > 0 && !branch.is_stroke();
        Space const own = is_fitted ? space_under(*fit_, bearer, standing, branch)
                                    : space_of(bearer, standing, branch);
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
        // A copy has its model's branches, transformed to its own place.
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

    // Positions of an axis's nodes, as shares of its length: evenly spaced positions, and the
    // positions of its branches.
    std::vector<double> node_places(Parent const& parent, BranchSet const* branch_set) const
    {
        constexpr std::array kSegments { 16, 8, 4, 3 };
        // Minimum number of segments on a styled level, because angles are measured over an eighth
        // of the length.
        constexpr int kStyled = 8;
        int own = kSegments[std::min<std::size_t>(parent.level, kSegments.size() - 1)];
        if (parent.level > 0 && level_options(parent.level - 1).style.is_set())
            own = std::max(own, kStyled);
        if (parent.is_stroke)
            own = kSegments[0];
        std::vector<double> places;
        for (int i = 0; i <= own; ++i)
            places.push_back(static_cast<double>(i) / own);
        if (branch_set)
            for (auto const& branch : branch_set->branches)
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
        bool const is_drawn = parent.is_stroke
            || (parent.system != kNoSystem && skeleton_.systems[parent.system].is_of_own_outline);
        may_stick_out_.push_back(
            is_drawn || (parent.parent_axis != kNone && may_stick_out_[parent.parent_axis]));
        return id;
    }

    BranchSet const& branch_set_of(std::size_t system, std::uint32_t level)
    {
        auto const found = set_maker_.find(system);
        if (found != set_maker_.end())
            return found->second;
        auto& branch_set = set_maker_[system];
        auto options = level_options(level);
        // A crown with a drawn outline has as much detail as a tree, so it gets as many added
        // branches.
        if (skeleton_.systems[system].is_of_own_outline)
            options.added = std::max(options.added, level_options(0).added);
        branch_set = maker_.make(system, options);
        tell(level, branch_set);
        return branch_set;
    }

    // Branches placed by the style of the parent's level; null if the parent gets none.
    BranchSet const* styled_branch_set(Parent const& parent, std::optional<BranchSet>& own)
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

    void tell(std::uint32_t level, BranchSet const& branch_set)
    {
        if (!told_.contains(level))
            for (auto const& branch : branch_set.branches)
                told_[level].push_back({ branch.name, { branch.u, branch.theta_deg } });
    }

    Skeleton const& skeleton_;
    TreeOptions const& options_;
    Tree tree_;
    std::vector<std::pair<std::vector<Vec2>, OrganShapeId>> leaf_shapes_;
    std::map<std::size_t, BranchSet> set_maker_;
    std::map<std::uint32_t, std::vector<PlacedBranch>> told_;
    std::optional<SurfaceFit> fit_;   // The drawn crown surface; no value: not drawn.
    std::vector<bool> may_stick_out_; // For each axis: LeafFillLimits::may_stick_out.
    SprayMaker sprays_ { tree_, options_ };
    BranchSetMaker maker_;
    std::vector<StyledBranchSetMaker> styled_; // Makers of styled branches, one for each level.
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
