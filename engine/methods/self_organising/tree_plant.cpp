#include "engine/methods/self_organising/tree_plant.h"

#include "engine/base/random.h"
#include "engine/methods/self_organising/wood.h"
#include "engine/plant/bark_materials.h"
#include "engine/plant/leaf_spray.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <unordered_set>
#include <utility>

namespace tractus::self_organising {

namespace {

constexpr std::uint32_t kLeafStream = 0x1EAF;
constexpr std::uint32_t kRootStream = 0x2007;
constexpr MaterialId kBark = 0;
constexpr MaterialId kTwig = 1;
constexpr MaterialId kLeaf = 2;
constexpr std::uint32_t kNeedleShapes = 4; // Different shapes of a shoot's needles.

class PlantMaker {
public:
    PlantMaker(GrowingTree const& tree, Habit const& habit, std::uint64_t seed)
        : tree_(tree)
        , habit_(habit)
        , seed_(seed)
        , laws_(growth_laws_in_year(habit, tree.step))
        , diameters_(shown_diameters(tree, habit))
        , pipe_widths_(tree.is_brushed ? diameters(tree, laws_) : std::vector<double>())
    {
    }

    TreePlant run()
    {
        add_materials();
        plant().root_flare = root_flare();
        segment_.assign(tree_.size(), kNone);
        axis_.assign(tree_.size(), kNone);
        if (tree_.links[0].main != kNone)
            add_axis(0, tree_.links[0].main);
        for (std::uint32_t i = 0; i < tree_.size(); ++i)
            for (auto const& lateral : tree_.laterals_of(i))
                if (lateral.node != kNone)
                    add_axis(i, lateral.node);
        name_axes();
        for (std::uint32_t i = 1; i < tree_.size(); ++i)
            if (segment_[i] != kNone && is_leafy(i))
                has_needle_shoots() ? add_needles(i) : add_leaves(i);
        return std::move(made_);
    }

private:
    Plant& plant() { return made_.plant; }

    // Ridges of the trunk, which appear as it becomes thicker.
    RootFlare root_flare() const
    {
        constexpr double kSmooth_mm = 60; // Diameter up to which a trunk is round.
        constexpr double kRidged_mm = 300;
        double const grown
            = std::clamp((diameters_[0] - kSmooth_mm) / (kRidged_mm - kSmooth_mm), 0.0, 1.0);
        Random random({ seed_, kRootStream });
        return { .ridges = static_cast<int>(habit_.ridges),
                 .depth = static_cast<float>(grown * std::min(0.35, 0.5 * habit_.flare)),
                 .turn = static_cast<float>(random.uniform(0, 2 * kPi)) };
    }

    void add_materials()
    {
        auto const color = [](double red, double green, double blue) {
            return Vec3(red, green, blue).cast<float>().eval();
        };
        auto const bark = color(habit_.bark_red, habit_.bark_green, habit_.bark_blue);
        auto const leaf = color(habit_.leaf_red, habit_.leaf_green, habit_.leaf_blue);
        plant().materials = {
            { .name = "bark", .base_color = bark },
            { .name = "twig",
              .base_color = Vec3f(0.55F * bark + 0.45F * Vec3f(0.3F, 0.22F, 0.14F)) },
            { .name = "leaf",
              .kind = Material::Kind::Leaf,
              .base_color = leaf,
              .roughness = 0.6F,
              .translucency = habit_.leaf_is_needle != 0 ? 0.1F : 0.45F },
        };
        barks_ = add_bark(plant(), kBark, bark_kind(habit_.bark).value_or(BarkKind::Furrowed));
        if (has_needle_shoots())
            add_needle_shapes();
        else
            add_leaf_shape();
    }

    bool has_needle_shoots() const { return habit_.shoot_needles > 0; }

    void add_leaf_shape()
    {
        bool const is_needle = habit_.leaf_is_needle != 0;
        OrganShape shape { .name = "leaf",
                           .kind = is_needle ? OrganShape::Kind::Needle : OrganShape::Kind::Blade,
                           .material = kLeaf,
                           .length_mm = habit_.leaf_mm,
                           .width_mm = habit_.leaf_width_mm,
                           .petiole_mm = is_needle ? 0 : habit_.petiole_mm };
        shape.calendar = OrganCalendar { .is_evergreen = habit_.leaf_is_evergreen != 0 };
        plant().organ_shapes.push_back(std::move(shape));
    }

    // The needles of an internode are one organ. At scale 1 its shapes lie along kSprayLength_mm.
    void add_needle_shapes()
    {
        for (std::uint32_t variant = 0; variant < kNeedleShapes; ++variant) {
            auto shape = leaf_spray({ .per_spray = static_cast<int>(habit_.shoot_needles),
                                      .length = habit_.leaf_mm / habit_.internode_mm,
                                      .width = habit_.leaf_width_mm / habit_.leaf_mm,
                                      .lean_deg = habit_.leaf_angle_deg,
                                      .first_share = 0 },
                                    kLeaf, variant);
            shape.name = fmt::format("needles {}", variant + 1);
            shape.calendar = OrganCalendar { .is_evergreen = habit_.leaf_is_evergreen != 0 };
            plant().organ_shapes.push_back(std::move(shape));
        }
    }

    MaterialId wood_material(std::uint32_t node) const
    {
        double const diameter_mm = diameters_[node];
        return diameter_mm <= kTwigWidths * habit_.twig_mm ? kTwig : barks_.at(diameter_mm);
    }

    // Adds an axis that starts at the node `below` and continues to `first`. Axes are added in the
    // order of their parent nodes, so a parent axis precedes its laterals.
    void add_axis(std::uint32_t below, std::uint32_t first)
    {
        auto const number = static_cast<AxisId>(plant().axes.size());
        Axis axis { .first_node = static_cast<NodeId>(plant().node_position_mm.size()),
                    .first_segment = static_cast<SegmentId>(plant().segment_count()),
                    .parent_segment = segment_[below],
                    .parent_axis = axis_[below] };
        if (axis.parent_axis != kNone)
            axis.order = plant().axes[axis.parent_axis].order + 1;
        // A lateral of the base is the foot of a separate stem (given_wood.h).
        bool const is_stem = below == 0 && first != tree_.links[0].main;
        auto const second = is_stem ? tree_.links[first].main : first;
        add_node(is_stem ? first : below, diameters_[second]);
        if (is_stem)
            axis_[first] = number;
        for (auto node = second; node != kNone; node = tree_.links[node].main) {
            auto const above = tree_.links[node].main;
            add_node(node, diameters_[above == kNone ? node : above]);
            segment_[node] = axis.first_segment + axis.segment_count;
            axis_[node] = number;
            plant().segment_material.push_back(wood_material(node));
            ++axis.segment_count;
        }
        plant().axes.push_back(axis);
    }

    void add_node(std::uint32_t node, double diameter_mm)
    {
        made_.tree_nodes.push_back(node);
        Vec3 const at_mm = tree_.places[node].position - tree_.places[0].position;
        plant().node_position_mm.push_back(at_mm);
        plant().node_radius_mm.push_back(static_cast<float>(
            diameter_mm / 2 * flare_at(habit_, tree_.links[node], at_mm.z(), diameters_[0])));
    }

    // Axes are named in the order in which they grew. If the 32-bit keys of two axes collide, the
    // older axis therefore keeps its key as the tree grows.
    void name_axes()
    {
        made_.keys.resize(plant().axes.size());
        for (std::uint32_t i = 1; i < tree_.size(); ++i)
            if (tree_.links[i].rank == 1 && axis_[i] != kNone)
                made_.keys[axis_[i]] = key_of(tree_.links[i].axis);
    }

    std::uint32_t key_of(std::uint64_t name)
    {
        for (;; name = name * 0xBF58476D1CE4E5B9U + 1) {
            auto const key = static_cast<std::uint32_t>(name ^ name >> 32);
            if (key != 0 && known_keys_.insert(key).second)
                return key;
        }
    }

    bool is_leafy(std::uint32_t node) const
    {
        constexpr double kRounding = 1.0001;
        if (tree_.step - tree_.links[node].step < habit_.leaf_years)
            return true;
        return tree_.is_brushed && habit_.leaf_years > 0
            && pipe_widths_[node] <= habit_.twig_mm * kRounding;
    }

    // Adds the needles of an internode, turned about it at random.
    void add_needles(std::uint32_t node)
    {
        auto const& links = tree_.links[node];
        auto const& place = tree_.places[node];
        Vec3 const from = tree_.places[links.parent].position;
        Vec3 const internode = place.position - from;
        double const length_mm = internode.norm();
        if (length_mm == 0)
            return;
        Random random({ seed_ ^ links.axis, kLeafStream, links.rank });
        auto const width = static_cast<float>(habit_.internode_mm / kSprayLength_mm);
        auto const length = static_cast<float>(length_mm / kSprayLength_mm);
        Vec3 const along = internode / length_mm;
        Vec3 right = turned(place.normal, along, random.uniform(0, 2 * kPi));
        right = (right - right.dot(along) * along).normalized();
        Mat3 frame;
        frame << right, along, right.cross(along);
        plant().organs.push_back(
            { .shape = static_cast<OrganShapeId>(random.uniform(0, kNeedleShapes)),
              .segment = segment_[node],
              .position_mm = from - tree_.places[0].position,
              .orientation = Quat(frame).normalized(),
              .scale = Vec3f(width, length, width) });
    }

    // Spreads leaves along an internode, each turned by the divergence angle of the axis.
    void add_leaves(std::uint32_t node)
    {
        auto const& links = tree_.links[node];
        auto const& place = tree_.places[node];
        Vec3 const internode = place.position - tree_.places[links.parent].position;
        Random random({ seed_ ^ links.axis, kLeafStream, links.rank });
        auto const count = static_cast<int>(habit_.leaves_at_node);
        double const divergence = laws_.divergence_deg.at(links.order);
        double const angle = radians(habit_.leaf_angle_deg);
        for (int k = 0; k < count; ++k) {
            double const back = (count - 1.0 - k) / count;
            double const number = double(links.rank) * count + k;
            double const around
                = radians(divergence * number + laws_.divergence_start_deg.at(links.order)
                          + random.uniform(-15, 15));
            Vec3 const axis = turned(place.normal, place.direction, around);
            Vec3 const out = turned(place.direction, axis, angle * random.uniform(0.85, 1.15));
            add_leaf(segment_[node], place.position - tree_.places[0].position - internode * back,
                     out, random.uniform(0.8, 1.1));
        }
    }

    void add_leaf(SegmentId segment, Vec3 const& at_mm, Vec3 const& out, double scale)
    {
        // The upper side of the leaf faces the sky.
        Vec3 right = right_of(out);
        Mat3 frame;
        frame.col(0) = right;
        frame.col(1) = out;
        frame.col(2) = right.cross(out);
        plant().organs.push_back({ .segment = segment,
                                   .position_mm = at_mm,
                                   .orientation = Quat(frame).normalized(),
                                   .scale = Vec3f::Constant(static_cast<float>(scale)) });
    }

    using Mat3 = Eigen::Matrix3d;
    // Wood up to this multiple of the twig diameter has the material of twigs.
    static constexpr double kTwigWidths = 2.5;

    GrowingTree const& tree_;
    Habit const& habit_;
    std::uint64_t seed_;
    Laws laws_;
    std::vector<double> diameters_;
    BarkMaterials barks_ {};
    std::vector<double> pipe_widths_; // Widths without rings; only of a brushed tree.
    std::vector<SegmentId> segment_;  // Segment that ends at each tree node.
    std::vector<AxisId> axis_;        // Plant axis of each tree node.
    std::unordered_set<std::uint32_t> known_keys_;
    TreePlant made_;
};

} // namespace

double flare_at(Habit const& habit, NodeLinks const& node, double height_mm,
                double base_diameter_mm)
{
    if (node.order > 0)
        return 1;
    double const reach_mm = std::max(base_diameter_mm, 1e-6);
    return 1 + habit.flare * std::exp(-std::max(height_mm, 0.0) / reach_mm);
}

TreePlant plant_of(GrowingTree const& tree, Habit const& habit, std::uint64_t seed)
{
    return PlantMaker(tree, habit, seed).run();
}

} // namespace tractus::self_organising
