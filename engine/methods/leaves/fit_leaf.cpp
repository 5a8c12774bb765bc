#include "engine/methods/leaves/derived_outline.h"
#include "engine/methods/leaves/drawn_leaf.h"
#include "engine/methods/leaves/fit_compound_leaf.h"
#include "engine/methods/leaves/fit_half_outline.h"
#include "engine/methods/leaves/fit_veins.h"
#include "engine/methods/leaves/flat_blade.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tractus::leaf {

namespace {

// X coordinates, from left to right, at which a closed line crosses the height y.
std::vector<double> crossings(FlatLine const& ring, double y)
{
    std::vector<double> found;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        auto const& a = ring[i];
        auto const& b = ring[(i + 1) % ring.size()];
        if ((a.y() > y) != (b.y() > y))
            found.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
    std::ranges::sort(found);
    return found;
}

// Intervals in ascending order that do not overlap: alternately beginnings and ends.
using Intervals = std::vector<double>;

// Intervals in which a horizontal line at the height y is inside at least one closed line.
Intervals inside_at(std::vector<FlatLine> const& rings, double y)
{
    std::vector<std::pair<double, double>> all;
    for (auto const& ring : rings) {
        auto const found = crossings(ring, y);
        for (std::size_t i = 0; i + 1 < found.size(); i += 2)
            all.emplace_back(found[i], found[i + 1]);
    }
    std::ranges::sort(all);
    Intervals joined;
    for (auto const& [from, to] : all)
        if (!joined.empty() && from <= joined.back())
            joined.back() = std::max(joined.back(), to);
        else
            joined.insert(joined.end(), { from, to });
    return joined;
}

// Length of the overlap of two sets of intervals.
double common_length(Intervals const& a, Intervals const& b)
{
    double sum = 0;
    for (std::size_t i = 0; i + 1 < a.size(); i += 2)
        for (std::size_t j = 0; j + 1 < b.size(); j += 2)
            sum += std::max(0.0, std::min(a[i + 1], b[j + 1]) - std::max(a[i], b[j]));
    return sum;
}

// Rounds a value to a multiple of 1 / parts, as in the text of the leaf's grammar.
double rounded_to(double value, double parts)
{
    return std::round(value * parts) / parts;
}

FlatLine mirrored(FlatLine line)
{
    for (auto& at : line)
        at.x() = -at.x();
    return line;
}

// Moves a half outline sideways and closes it along the axis.
FlatLine moved_aside(FlatLine line, double by)
{
    for (auto& at : line)
        at.x() += by;
    line.emplace_back(0, line.back().y());
    line.emplace_back(0, line.front().y());
    return line;
}

DrawnLeaf::Half rounded_half(DrawnLeaf::Half half)
{
    constexpr double kPlaces = 1e4;
    half.front().at = Vec2::Zero();
    half.back().at = Vec2(0, 1);
    for (auto& point : half) {
        // A half outline must stay on its own side of the leaf's axis (HalfOutline).
        point.at.x() = std::max(0.0, rounded_to(point.at.x(), kPlaces));
        point.at.y() = rounded_to(point.at.y(), kPlaces);
    }
    return half;
}

// Fits a half outline to the mean of both halves if they hardly differ, otherwise one to each half.
void fit_outline(FlatBlade const& blade, LeafFit& fit)
{
    // Largest LeafFit::asymmetry at which the halves count as equal. The effect of tremor is added.
    constexpr double kEqual = 0.04;
    constexpr double kMaxAside_mm = 1;
    double const tremor = fit.tremor_mm / blade.size_mm;
    double const tolerance = std::max(1.05 * tremor, 0.0015);
    double const window = std::max(0.03, 3 / blade.size_mm);
    auto const left = mirrored(blade.left);
    auto& leaf = fit.leaf;
    if (!left.empty()) {
        // The halves are shifted sideways, because the midrib may be drawn slightly off the middle.
        double const aside = 0.5 * (std::abs(area_of(blade.right)) - std::abs(area_of(left)));
        double const shift
            = std::clamp(aside, -kMaxAside_mm / blade.size_mm, kMaxAside_mm / blade.size_mm);
        fit.asymmetry = 1 - overlap_of(moved_aside(blade.right, -shift), moved_aside(left, shift));
        double const by_tremor
            = 1.1 * tremor * length_of(blade.right) / std::abs(area_of(blade.right));
        if (auto const mean = mean_half(blade.right, left, window);
            mean && fit.asymmetry < kEqual + by_tremor) {
            leaf.right
                = rounded_half(fit_half_outline(*mean, std::max(0.75 * tremor, 0.0015), window));
            return;
        }
        leaf.left = rounded_half(fit_half_outline(left, tolerance, window));
    }
    leaf.right = rounded_half(fit_half_outline(blade.right, tolerance, window));
}

// Adds mirror images of the veins on the left of a leaf of which only one half was drawn. Does
// nothing if there are veins on the left already.
void mirror_veins(DrawnLeaf& leaf)
{
    auto const has_left = [](DrawnLeaf::Knot const& knot) { return knot.left_deg.has_value(); };
    auto& mains = leaf.mains;
    if (std::ranges::any_of(mains[0].knots, has_left)
        || std::ranges::any_of(mains, [](auto const& main) { return main.angle_deg < 0; }))
        return;
    for (auto& knot : mains[0].knots)
        knot.left_deg = knot.right_deg;
    for (std::size_t k = mains.size() - 1; k >= 1; --k) {
        auto other = mains[k];
        other.angle_deg = -other.angle_deg;
        other.curve_deg = -other.curve_deg;
        for (auto& knot : other.knots)
            std::swap(knot.left_deg, knot.right_deg);
        mains.push_back(std::move(other));
    }
}

Outline outline_of(DrawnLeaf const& leaf)
{
    Random random({});
    return { { .points = leaf.right },
             { .points = leaf.left.empty() ? leaf.right : leaf.left },
             { .width = 0, .point = 0 },
             random };
}

} // namespace

double overlap_of(FlatLine const& a, FlatLine const& b)
{
    return overlap_of(std::vector<FlatLine> { a }, std::vector<FlatLine> { b });
}

double overlap_of(std::vector<FlatLine> const& a, std::vector<FlatLine> const& b)
{
    constexpr int kRows = 600;
    Eigen::AlignedBox2d box;
    for (auto const* const rings : { &a, &b })
        for (auto const& ring : *rings)
            for (auto const& at : ring)
                box.extend(at);
    if (box.isEmpty())
        return 0;
    double common = 0;
    double all = 0;
    for (int row = 0; row < kRows; ++row) {
        double const y = box.min().y() + (row + 0.5) / kRows * box.sizes().y();
        auto const in_a = inside_at(a, y);
        auto const in_b = inside_at(b, y);
        double const both = common_length(in_a, in_b);
        common += both;
        all += common_length(in_a, in_a) + common_length(in_b, in_b) - both;
    }
    return all > 0 ? common / all : 0;
}

// Area of a closed line in space, which lies about in a plane.
static double area_mm2(std::vector<Vec3> const& ring)
{
    Vec3 twice_mm2 = Vec3::Zero();
    for (std::size_t i = 0; i < ring.size(); ++i)
        twice_mm2 += (ring[i] - ring[0]).cross(ring[(i + 1) % ring.size()] - ring[0]);
    return twice_mm2.norm() / 2;
}

Result<double> overlap_with_drawing(RecognisedLeaf const& drawn, LeafFit const& fit)
{
    // From this share on, the drawn area counts as completely covered: flattening a bent blade
    // changes its area a little.
    constexpr double kWhole = 0.9;
    if (fit.leaf.is_compound())
        return overlap_of(TRY(derived_leaflets(fit.leaf)), fit.leaflets);
    double const overlap = overlap_of(TRY(derived_outline(fit.leaf)), fit.outline);
    if (drawn.edge == RecognisedLeaf::Edge::OneHalf || drawn.outline.empty())
        return overlap;
    double const drawn_mm2 = area_mm2(drawn.outline);
    double const kept_mm2 = std::abs(area_of(fit.outline)) * fit.leaf.size_mm * fit.leaf.size_mm;
    return kept_mm2 < kWhole * drawn_mm2 ? overlap * kept_mm2 / drawn_mm2 : overlap;
}

Result<LeafFit> fit_leaf(RecognisedLeaf const& drawn)
{
    constexpr double kMinStalk = 0.02;
    // Length of the stalk if none is drawn, as a share of the blade's length.
    constexpr double kUsualStalk = 0.06;
    if (!drawn.leaflets.empty())
        return fit_compound_leaf(drawn);
    auto const blade = TRY(lay_flat(drawn));
    LeafFit fit;
    double const tremor = tremor_of(blade);
    fit.tremor_mm = tremor * blade.size_mm;
    fit.sweep_deg = blade.sweep_deg;
    fit.place = blade.place;
    auto& leaf = fit.leaf;
    leaf.size_mm = rounded_to(blade.size_mm, 10);
    leaf.stalk
        = blade.stalk > kMinStalk ? rounded_to(std::min(blade.stalk, 5.0), 1e3) : kUsualStalk;
    leaf.bend_deg = rounded_to(blade.bend_low_deg + blade.bend_high_deg, 10);
    leaf.droop_deg = rounded_to(2 * (blade.bend_high_deg - blade.bend_low_deg), 10);
    leaf.rise_deg = rounded_to(blade.rise_deg, 10);
    fit_outline(blade, fit);
    fit.outline = blade.right;
    auto const other = blade.left.empty() ? mirrored(blade.right) : blade.left;
    fit.outline.insert(fit.outline.end(), other.rbegin() + 1, other.rend() - 1);
    auto veins = TRY(fit_veins(drawn, blade, outline_of(leaf), tremor));
    leaf.mains = std::move(veins.mains);
    leaf.hub = veins.hub;
    if (drawn.edge == RecognisedLeaf::Edge::OneHalf)
        mirror_veins(leaf);
    leaf.side_curve_deg = veins.side_curve_deg;
    leaf.side_curve_at_tip_deg = veins.side_curve_at_tip_deg;
    fit.veins = std::move(veins.veins);
    std::ranges::sort(fit.veins, {}, &LeafFit::Vein::stroke);
    return fit;
}

} // namespace tractus::leaf
