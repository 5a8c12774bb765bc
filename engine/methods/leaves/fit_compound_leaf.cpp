#include "engine/methods/leaves/fit_compound_leaf.h"

#include "engine/methods/leaves/compound_rachis.h"
#include "engine/methods/leaves/fit_half_outline.h"
#include "engine/methods/leaves/flat_blade.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace tractus::leaf {

namespace {

// Rounds a number as the grammar's text has it.
double rounded_number(double value, double parts)
{
    return std::round(value * parts) / parts;
}

// Mean of the half outlines of all leaflets, right ones and the mirror images of left ones.
FlatLine mean_half_of(std::vector<FlatBlade> const& blades)
{
    constexpr std::size_t kSamples = 300;
    FlatLine mean(kSamples, Vec2::Zero());
    double count = 0;
    for (auto const& blade : blades)
        for (auto const* const half : { &blade.right, &blade.left }) {
            if (half->size() < 2)
                continue;
            auto const samples = evenly(*half, kSamples);
            for (std::size_t i = 0; i < kSamples; ++i)
                mean[i] += Vec2(std::abs(samples[i].x()), samples[i].y());
            ++count;
        }
    for (auto& at : mean)
        at /= count;
    mean.front() = Vec2::Zero();
    mean.back() = Vec2(0, 1);
    return mean;
}

void fit_blade(std::vector<FlatBlade> const& blades, LeafFit& fit)
{
    double mean_mm = 0;
    for (auto const& blade : blades)
        mean_mm += blade.size_mm / double(blades.size());
    // The tremor of a mean is smaller than that of a single leaflet.
    double const tremor = fit.tremor_mm / mean_mm / std::sqrt(double(blades.size()));
    double const window = std::max(0.03, 3 / mean_mm);
    auto half = fit_half_outline(mean_half_of(blades), std::max(tremor, 0.002), window);
    half.front().at = Vec2::Zero();
    half.back().at = Vec2(0, 1);
    constexpr double kPlaces = 1e4;
    for (auto& point : half)
        point.at = { std::max(0.0, rounded_number(point.at.x(), kPlaces)),
                     rounded_number(point.at.y(), kPlaces) };
    fit.leaf.right = std::move(half);
}

// Gives the leaf the veins of the leaflet in which most were drawn. Leaflets have no main veins
// besides their midribs.
void take_veins(RecognisedLeaf const& drawn, std::vector<LeafFit> const& fits, LeafFit& fit)
{
    auto const knots = [](LeafFit const& each) { return each.leaf.mains[0].knots.size(); };
    auto const& best = *std::ranges::max_element(fits, {}, knots);
    auto& leaf = fit.leaf;
    leaf.mains = { best.leaf.mains[0] };
    leaf.side_curve_deg = best.leaf.side_curve_deg;
    leaf.side_curve_at_tip_deg = best.leaf.side_curve_at_tip_deg;
    // A midrib that was not drawn counts as a part of its outline.
    for (auto const& each : fits)
        for (auto const& vein : each.veins)
            if (drawn.roles[vein.stroke] != StrokeRole::Outline)
                fit.veins.push_back(vein);
    std::ranges::sort(fit.veins, {}, &LeafFit::Vein::stroke);
}

void round_leaflet(DrawnLeaf::Leaflet& leaflet)
{
    constexpr double kLengths = 1e4;
    constexpr double kAngles = 1e2;
    leaflet.piece = rounded_number(leaflet.piece, kLengths);
    leaflet.turn_deg = rounded_number(leaflet.turn_deg, kAngles);
    leaflet.angle_deg = rounded_number(leaflet.angle_deg, kAngles);
    leaflet.stalk = rounded_number(leaflet.stalk, kLengths);
    leaflet.size = rounded_number(leaflet.size, kLengths);
}

} // namespace

Result<LeafFit> fit_compound_leaf(RecognisedLeaf const& drawn)
{
    if (drawn.leaflets.size() > kMaxLeaflets)
        return fail(Fault::User,
                    fmt::format("there are {} leaflets: draw at most {}", drawn.leaflets.size(),
                                kMaxLeaflets));
    std::vector<FlatBlade> blades;
    std::vector<LeafFit> fits;
    LeafFit fit;
    for (auto const& leaflet : drawn.leaflets) {
        blades.push_back(TRY(lay_flat(leaflet)));
        fits.push_back(TRY(fit_leaf(leaflet)));
        fit.tremor_mm += fits.back().tremor_mm / double(drawn.leaflets.size());
        fit.leaf.size_mm = std::max(fit.leaf.size_mm, rounded_number(blades.back().size_mm, 10));
    }
    fit_blade(blades, fit);
    take_veins(drawn, fits, fit);
    std::vector<BladePlace> places;
    for (auto const& blade : blades)
        places.push_back(blade.place);
    auto rachis = measure_rachis(drawn, places, fit.leaf);
    fit.leaf.leaflets = std::move(rachis.leaflets);
    fit.leaf.end = rachis.end;
    for (auto& leaflet : fit.leaf.leaflets)
        round_leaflet(leaflet);
    round_leaflet(fit.leaf.end);
    fit.leaf.stalk = fit.leaf.leaflets.front().piece;
    fit.leaflets = std::move(rachis.outlines);
    fit.place = rachis.place;
    return fit;
}

} // namespace tractus::leaf
