#include "app/view/drawn_curves.h"

#include "app/tools/bent_plant.h"
#include "app/view/branch_words.h"
#include "app/view/ink_line.h"
#include "engine/plant/join_axes.h"
#include "engine/scene/limb_edits.h"

#include <algorithm>
#include <fmt/core.h>
#include <unordered_map>
#include <utility>

namespace tractus::view {

namespace {

constexpr float kCurveWidth_mm = 2.2f; // Width of curves for which no pressure is known.

std::string propagation_in_words(variation::Propagation propagation)
{
    switch (propagation) {
    case variation::Propagation::Descendants:
        return ", all it bears";
    case variation::Propagation::Both:
        return ", with all it bears";
    case variation::Propagation::Selected:
        break;
    }
    return "";
}

std::string stroke_name(variation::Propagation propagation, std::vector<PathAddress> const& paths)
{
    return fmt::format("Draw: {}{}",
                       paths.size() == 1 ? branch_in_words(paths.front().last)
                                         : fmt::format("{} branches", paths.size()),
                       propagation_in_words(propagation));
}

// Returns the curves of the strokes that shape branches. Associations of the same stroke are
// consecutive, so they are merged into one curve.
std::vector<DrawnCurveView> stroke_curves(scene::Scene const& scene, CachedInk const& ink)
{
    std::unordered_map<void const*, std::size_t> line_of;
    for (std::size_t i = 0; i < ink.strokes.size(); ++i)
        line_of.emplace(ink.strokes[i].id(), i);
    auto const selected = scene::selected_associations(scene);
    std::vector<DrawnCurveView> curves;
    void const* last = nullptr;
    for (auto const number : scene::shaping_numbers(scene)) {
        auto const& [id, association, at] = scene.associations[number];
        auto const* const tips = association.stroke.tips.id();
        auto const found = line_of.find(tips);
        if (found == line_of.end())
            continue;
        if (std::exchange(last, tips) != tips)
            curves.push_back({ .edit = scene::edit_of_item(id), .line = ink.lines[found->second] });
        auto& curve = curves.back();
        curve.paths.insert(curve.paths.end(), at.begin(), at.end());
        curve.is_selected |= std::ranges::binary_search(selected, number);
        curve.name = stroke_name(association.propagation, curve.paths);
    }
    return curves;
}

// Returns the curves of the strokes that became limbs, at the limbs' present places on the plant.
std::vector<DrawnCurveView> limb_curves(scene::Scene const& scene)
{
    auto const limbs = scene::limb_segments(scene);
    if (limbs.empty())
        return {};
    auto const& base = *scene.base;
    auto const& addresses = scene.rest->addresses;
    std::vector<bool> is_selected(base.segment_count());
    for (auto const& path : scene.selection)
        for (auto const segment : path)
            is_selected[segment] = true;
    tools::BentPlant const bent(scene);
    std::vector<DrawnCurveView> curves;
    for (auto const& [graft, first] : limbs) {
        auto const seat = addresses.find_segment(base, graft->at);
        if (!seat)
            continue;
        auto const& limb = *graft->limb;
        Vec3 const joint_mm
            = bent.begin_of(*seat) + limb.joint * (bent.end_of(*seat) - bent.begin_of(*seat));
        Quat const turn = bent.turn_of(*seat);
        double const scale = scene.placement.scale;
        auto& curve = curves.emplace_back();
        curve.edit = scene::edit_of_item(limb.id);
        curve.name = fmt::format("New limb: on {}", branch_in_words(graft->at));
        for (auto const& point : limb.points) {
            Vec3 const place_mm = joint_mm + scale * (turn * point.place_mm);
            curve.line.points.push_back({ place_mm.cast<float>(), kCurveWidth_mm });
        }
        curve.line = thinned(curve.line);
        auto const path = segments_of(base.axes[axis_of(base, first)]);
        curve.paths = { addresses.address_of(base, path) };
        curve.is_selected
            = std::ranges::any_of(path, [&](SegmentId segment) { return is_selected[segment]; });
    }
    return curves;
}

DrawnCurveView listed_curve(tools::DrawnCurve drawn)
{
    DrawnCurveView curve { .edit = drawn.edit, .name = std::move(drawn.name) };
    if (drawn.end == tools::DrawnCurve::End::Arrow)
        curve.line.look = tools::InkStyle::Look::Arrow;
    for (auto const& point_mm : drawn.points_mm)
        curve.line.points.push_back({ point_mm, kCurveWidth_mm });
    curve.line = thinned(curve.line);
    return curve;
}

} // namespace

std::vector<DrawnCurveView> drawn_curves(scene::Scene const& scene, CachedInk const& ink,
                                         tools::DrawnCurveLists lists)
{
    std::vector<DrawnCurveView> curves;
    for (auto const list : lists)
        for (auto& drawn : list(scene))
            curves.push_back(listed_curve(std::move(drawn)));
    for (auto& curve : stroke_curves(scene, ink))
        curves.push_back(std::move(curve));
    for (auto& curve : limb_curves(scene))
        curves.push_back(std::move(curve));
    std::ranges::stable_sort(curves, {}, &DrawnCurveView::edit);
    return curves;
}

} // namespace tractus::view
