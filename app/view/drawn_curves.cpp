#include "app/view/drawn_curves.h"

#include "app/view/branch_words.h"
#include "app/view/ink_line.h"

#include <algorithm>
#include <fmt/core.h>
#include <unordered_map>
#include <utility>

namespace tractus::view {

namespace {

constexpr float kCurveWidth_mm = 2.2f; // Width of curves that have no pressure.

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

// The strokes that shape branches. One that shapes several is several associations in a row.
std::vector<DrawnCurveView> stroke_curves(scene::Scene const& scene, KeptInk const& ink)
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

std::vector<DrawnCurveView> drawn_curves(scene::Scene const& scene, KeptInk const& ink,
                                         tools::DrawnCurveLists lists)
{
    std::vector<DrawnCurveView> curves;
    for (auto const list : lists)
        for (auto& drawn : list(scene))
            curves.push_back(listed_curve(std::move(drawn)));
    for (auto& curve : stroke_curves(scene, ink))
        curves.push_back(std::move(curve));
    std::ranges::stable_sort(curves, {}, &DrawnCurveView::edit);
    return curves;
}

} // namespace tractus::view
