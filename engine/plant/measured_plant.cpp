#include "engine/plant/measured_plant.h"

#include "engine/base/check.h"
#include "engine/plant/pipe_model.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <vector>

namespace tractus {

namespace {

constexpr double kTipShare = 0.002; // Default radius of tips as a share of the plant's height.
constexpr double kLargest_mm = 1e7;

Result<void> check_nodes(std::string const& name, std::span<MeasuredNode const> nodes)
{
    auto const is_radius = [](std::optional<double> const& radius_mm) {
        return !radius_mm || (*radius_mm >= 0 && *radius_mm <= kLargest_mm);
    };
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        auto const& node = nodes[i];
        CHECK(node.below == kNone || node.below < i);
        if (!node.position_mm.allFinite() || !is_radius(node.radius_mm)
            || !is_radius(node.base_radius_mm))
            return fail(Fault::User,
                        fmt::format("{}: the position or the diameter of node {} is no length: "
                                    "export the plant again",
                                    name, i + 1));
    }
    return {};
}

class PlantBuilder {
public:
    explicit PlantBuilder(std::span<MeasuredNode const> nodes)
        : nodes_(nodes)
        , next_(nodes.size(), kNone)
        , laterals_(nodes.size())
        , radius_mm_(nodes.size())
        , segments_(nodes.size(), kNone)
    {
        for (std::uint32_t i = 0; i < nodes.size(); ++i) {
            auto const& node = nodes[i];
            bool const has_below = node.below != kNone;
            radius_mm_[i] = node.radius_mm.value_or(has_below ? radius_mm_[node.below] : 0);
            if (has_below && node.continues && next_[node.below] == kNone)
                next_[node.below] = i;
            else if (has_below)
                laterals_[node.below].push_back(i);
        }
    }

    MeasuredPlant build()
    {
        plant_.materials = { Material {} };
        for (std::uint32_t i = 0; i < nodes_.size(); ++i)
            if (nodes_[i].below == kNone)
                start_at(i, kNone, kNone);
        for (std::size_t i = 0; i < starts_.size(); ++i) // follow() appends to the list.
            follow(starts_[i]);
        return { .plant = std::move(plant_), .segments = std::move(segments_) };
    }

private:
    struct AxisStart {
        std::uint32_t from = 0; // First node of the axis; `to`: its second node.
        std::uint32_t to = 0;
        SegmentId parent_segment = kNone;
        AxisId parent_axis = kNone;
    };

    void start_at(std::uint32_t node, SegmentId segment, AxisId axis)
    {
        if (segment == kNone && next_[node] != kNone)
            starts_.push_back({ node, next_[node], segment, axis });
        for (auto const lateral : laterals_[node])
            starts_.push_back({ node, lateral, segment, axis });
    }

    void add_node(std::uint32_t node, double radius_mm)
    {
        plant_.node_position_mm.push_back(nodes_[node].position_mm);
        plant_.node_radius_mm.push_back(static_cast<float>(radius_mm));
    }

    void follow(AxisStart start) // By value: starts_, which holds it, grows meanwhile.
    {
        Axis axis { .first_node = static_cast<NodeId>(plant_.node_position_mm.size()),
                    .first_segment = static_cast<SegmentId>(plant_.segment_count()),
                    .parent_segment = start.parent_segment,
                    .parent_axis = start.parent_axis,
                    .order
                    = start.parent_axis == kNone ? 0 : plant_.axes[start.parent_axis].order + 1 };
        auto const id = static_cast<AxisId>(plant_.axes.size());
        bool const is_lateral = !nodes_[start.to].continues || start.parent_segment != kNone;
        add_node(start.from,
                 nodes_[start.to].base_radius_mm.value_or(is_lateral ? radius_mm_[start.to]
                                                                     : radius_mm_[start.from]));
        for (auto node = start.to; node != kNone; node = next_[node]) {
            add_node(node, radius_mm_[node]);
            plant_.segment_material.push_back(0);
            segments_[node] = axis.first_segment + axis.segment_count;
            start_at(node, segments_[node], id);
            ++axis.segment_count;
        }
        plant_.axes.push_back(axis);
    }

    std::span<MeasuredNode const> nodes_;
    std::vector<std::uint32_t> next_; // For each node, the next node on the same axis, or kNone.
    // For each node, the second nodes of the lateral axes that begin there, in ascending order.
    std::vector<std::vector<std::uint32_t>> laterals_;
    std::vector<double> radius_mm_;
    std::vector<SegmentId> segments_; // For each node, the segment that ends there, or kNone.
    std::vector<AxisStart> starts_;
    Plant plant_;
};

} // namespace

double millimetres_per_unit(Bounds const& units)
{
    constexpr double kMinInMillimetres = 100;
    return !units.empty() && (units.max_mm - units.min_mm).maxCoeff() < kMinInMillimetres ? 1000
                                                                                          : 1;
}

Result<void> check_size(std::string const& name, Bounds const& box_mm)
{
    constexpr double kFarthest_mm = 1e12;
    if (box_mm.empty())
        return {};
    double const extent_mm = (box_mm.max_mm - box_mm.min_mm).maxCoeff();
    if (!(extent_mm <= kLargest_mm))
        return fail(Fault::User,
                    fmt::format("{}: this plant is {:.3g} m large, expected at most 10 km: are its "
                                "lengths metres or millimetres?",
                                name, extent_mm / 1000));
    if (!(box_mm.max_mm.cwiseAbs().cwiseMax(box_mm.min_mm.cwiseAbs()).maxCoeff() <= kFarthest_mm))
        return fail(Fault::User,
                    fmt::format("{}: this plant is more than a million km away from the origin of "
                                "its file: move it nearer",
                                name));
    return {};
}

Result<MeasuredPlant> measured_plant_from_nodes(std::string const& name,
                                                std::span<MeasuredNode const> nodes)
{
    TRY(check_nodes(name, nodes));
    Bounds box;
    for (auto const& node : nodes)
        box.add(node.position_mm);
    TRY(check_size(name, box));
    auto measured = PlantBuilder(nodes).build();
    auto& plant = measured.plant;
    if (plant.axes.empty() || box.min_mm == box.max_mm)
        return fail(Fault::User,
                    fmt::format("{}: there is no branch in it: two positions, one above the other, "
                                "make one",
                                name));
    measured.base_mm = plant.node_position_mm.front();
    for (auto& position_mm : plant.node_position_mm)
        position_mm -= measured.base_mm;
    bool const has_radii
        = std::any_of(nodes.begin(), nodes.end(), [](auto const& node) { return node.radius_mm; });
    if (!has_radii) {
        Vec3 const extent_mm = box.max_mm - box.min_mm;
        apply_pipe_model(plant, 2,
                         kTipShare * std::max(extent_mm.z(), 1e-3 * extent_mm.maxCoeff()));
    }
    return measured;
}

Result<Plant> plant_from_nodes(std::string const& name, std::span<MeasuredNode const> nodes)
{
    return TRY(measured_plant_from_nodes(name, nodes)).plant;
}

} // namespace tractus
