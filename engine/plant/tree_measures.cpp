#include "engine/plant/tree_measures.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tractus {

namespace {

// The segments of a plant as a tree; parents come before children.
struct Segments {
    std::vector<SegmentId> parent;
    std::vector<std::uint32_t> children; // Number of each segment's children.
    std::vector<double> length_mm;
    std::vector<double> diameter_mm; // Diameter at the lower end of each segment.
    std::vector<double> low_mm;      // Height of each lower end; `high_mm`: of each upper end.
    std::vector<double> high_mm;

    std::size_t size() const { return parent.size(); }
};

Segments segments_of(Plant const& plant)
{
    Segments segments;
    for (auto const& axis : plant.axes)
        for (std::uint32_t i = 0; i < axis.segment_count; ++i) {
            auto const segment = axis.first_segment + i;
            segments.parent.push_back(i == 0 ? axis.parent_segment : segment - 1);
            auto const node = axis.first_node + i;
            auto const& low = plant.node_position_mm[node];
            auto const& high = plant.node_position_mm[node + 1];
            segments.length_mm.push_back((high - low).norm());
            segments.diameter_mm.push_back(2.0 * plant.node_radius_mm[node]);
            segments.low_mm.push_back(low.z());
            segments.high_mm.push_back(high.z());
        }
    segments.children.resize(segments.size());
    for (auto const parent : segments.parent)
        if (parent != kNone)
            ++segments.children[parent];
    return segments;
}

std::vector<int> strahler_orders(Segments const& segments)
{
    std::vector<int> highest(segments.size());
    std::vector<int> count(segments.size());
    std::vector<int> orders(segments.size());
    for (std::size_t i = segments.size(); i-- > 0;) {
        orders[i] = count[i] == 0 ? 1 : highest[i] + (count[i] > 1 ? 1 : 0);
        if (auto const parent = segments.parent[i]; parent != kNone) {
            if (orders[i] > highest[parent])
                count[parent] = 0;
            count[parent] += orders[i] >= highest[parent] ? 1 : 0;
            highest[parent] = std::max(highest[parent], orders[i]);
        }
    }
    return orders;
}

// Returns the factor by which values grow from one stream order to the next, by least squares on
// their logarithms; 0 for fewer than three orders.
double ratio_between_orders(std::vector<double> const& values)
{
    constexpr std::size_t kFewest = 3;
    if (values.size() < kFewest)
        return 0;
    double const middle = (static_cast<double>(values.size()) - 1) / 2;
    double up = 0;
    double across = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        double const x = static_cast<double>(i) - middle;
        up += x * std::log(values[i]);
        across += x * x;
    }
    return std::exp(up / across);
}

// Measures the streams, which are chains of segments of the same order. The streams of the highest
// order are counted, but their length is ignored: they end at the ground, not at a confluence.
void measure_streams(Segments const& segments, TreeMeasures& measures)
{
    auto const orders = strahler_orders(segments);
    measures.strahler = *std::max_element(orders.begin(), orders.end());
    auto const count = static_cast<std::size_t>(measures.strahler);
    std::vector<double> streams(count);
    std::vector<double> lengths(count);
    for (std::size_t i = 0; i < segments.size(); ++i) {
        auto const parent = segments.parent[i];
        auto const order = static_cast<std::size_t>(orders[i] - 1);
        streams[order] += parent == kNone || orders[parent] != orders[i] ? 1 : 0;
        lengths[order] += segments.length_mm[i];
    }
    for (std::size_t i = 0; i < count; ++i)
        lengths[i] /= streams[i];
    lengths.pop_back();
    if (double const ratio = ratio_between_orders(streams); ratio > 0)
        measures.bifurcation_ratio = 1 / ratio;
    measures.length_ratio = ratio_between_orders(lengths);
}

// Returns the sum, over all forks, of the square of ln(sum of d_child^e / d^e); d: diameters.
double pipe_error(Segments const& segments, double e)
{
    std::vector<double> sums(segments.size());
    for (std::size_t i = 0; i < segments.size(); ++i)
        if (auto const parent = segments.parent[i];
            parent != kNone && segments.children[parent] > 1 && segments.diameter_mm[parent] > 0)
            sums[parent] += std::pow(segments.diameter_mm[i] / segments.diameter_mm[parent], e);
    double error = 0;
    for (auto const sum : sums)
        if (sum > 0)
            error += std::log(sum) * std::log(sum);
    return error;
}

// Finds the exponent that minimises pipe_error(), by golden-section search: there is only one
// minimum.
double fitted_pipe_exponent(Segments const& segments)
{
    constexpr double kGolden = 0.6180339887498949;
    constexpr double kEnough = 1e-3;
    double low = 0.5;
    double high = 6;
    if (pipe_error(segments, low) == 0)
        return 0;
    while (high - low > kEnough) {
        double const a = high - kGolden * (high - low);
        double const b = low + kGolden * (high - low);
        if (pipe_error(segments, a) < pipe_error(segments, b))
            high = b;
        else
            low = a;
    }
    return (low + high) / 2;
}

double breast_diameter_mm(Segments const& segments)
{
    constexpr double kBreastHeight_mm = 1300;
    double thickest = 0;
    for (std::size_t i = 0; i < segments.size(); ++i)
        if (segments.low_mm[i] <= kBreastHeight_mm && segments.high_mm[i] > kBreastHeight_mm)
            thickest = std::max(thickest, segments.diameter_mm[i]);
    return thickest > 0 ? thickest : segments.diameter_mm.front();
}

double crown_base_mm(Plant const& plant)
{
    std::vector<double> heights;
    for (auto const& organ : plant.organs)
        heights.push_back(organ.position_mm.z());
    if (heights.empty())
        for (auto const& axis : plant.axes)
            heights.push_back(plant.positions(axis).back().z());
    constexpr std::size_t kOneIn = 20;
    auto const low = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / kOneIn);
    std::nth_element(heights.begin(), low, heights.end());
    return *low;
}

} // namespace

TreeMeasures measure_tree(Plant const& plant)
{
    if (plant.segment_count() == 0)
        return {};
    auto const segments = segments_of(plant);
    TreeMeasures measures { .internodes = segments.size() };
    Bounds box;
    for (auto const& position_mm : plant.node_position_mm)
        box.add(position_mm);
    Vec3 const spread_mm = box.max_mm - box.min_mm;
    measures.height_mm = box.max_mm.z();
    measures.crown_width_mm = (spread_mm.x() + spread_mm.y()) / 2;
    measures.crown_base_mm = crown_base_mm(plant);
    measures.breast_diameter_mm = breast_diameter_mm(segments);
    if (measures.breast_diameter_mm > 0)
        measures.slenderness = measures.height_mm / measures.breast_diameter_mm;
    measure_streams(segments, measures);
    measures.pipe_exponent = fitted_pipe_exponent(segments);
    return measures;
}

} // namespace tractus
