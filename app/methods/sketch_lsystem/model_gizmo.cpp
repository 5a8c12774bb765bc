#include "app/methods/sketch_lsystem/model_gizmo.h"

#include "engine/methods/sketch_lsystem/grow_edit.h"
#include "engine/plant/join_axes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <string>

namespace tractus::sketch {

namespace {

// A short, slightly curved stroke along which the model of a preset is grown.
Stroke short_stroke()
{
    constexpr int kTips = 60;
    constexpr double kLength_mm = 150;
    constexpr double kBow_mm = 14;
    Stroke stroke;
    for (int i = 0; i <= kTips; ++i) {
        double const share = static_cast<double>(i) / kTips;
        stroke.tips.push_back(
            { .position_mm = { kBow_mm * std::sin(kPi * share), 0, kLength_mm * share },
              .touching = true });
    }
    return stroke;
}

// Projects points of a plant to a front view in the gizmo's frame.
class FrontView {
public:
    explicit FrontView(Plant const& plant)
    {
        // Largest extent of the plant in the gizmo's frame, which is 2 wide.
        constexpr double kFits = 1.8;
        auto const box = bounds(plant);
        Vec3 const size_mm = box.max_mm - box.min_mm;
        scale_ = kFits / std::max({ size_mm.x(), size_mm.z(), 1.0 });
        middle_mm_ = (box.min_mm + box.max_mm) / 2;
    }

    Vec2 seen(Vec3 const& point_mm) const
    {
        Vec3 const from_middle = scale_ * (point_mm - middle_mm_);
        return { from_middle.x(), from_middle.z() };
    }

private:
    double scale_ = 1;
    Vec3 middle_mm_ = Vec3::Zero();
};

tools::Gizmo draw_model(sketch::ModelRule const& model)
{
    constexpr std::size_t kMaxLines = 200;
    tools::Gizmo gizmo;
    gizmo.hint = "A plant of this model";
    sketch::GrowAlongStroke edit;
    edit.stroke = short_stroke();
    edit.model = model;
    auto const built = sketch::build_sketch(edit, {});
    if (!built)
        return gizmo;
    auto const& plant = built->plant;
    FrontView const view(plant);
    auto order = axes_in_drawing_order(plant);
    order.resize(std::min(order.size(), kMaxLines));
    // Reversed, so that the trunk is drawn last and thus above all branches.
    std::reverse(order.begin(), order.end());
    for (auto const id : order) {
        tools::Gizmo::Line line;
        for (auto const& node_mm : plant.positions(plant.axes[id]))
            line.points.push_back(view.seen(node_mm));
        bool const is_drawn = id == 0;
        line.width = is_drawn ? 0.04 : 0.012;
        line.color = is_drawn ? tools::LayerStyle::Color::Grey : tools::LayerStyle::Color::Green;
        gizmo.lines.push_back(std::move(line));
    }
    return gizmo;
}

} // namespace

tools::Gizmo show_model(sketch::ModelRule const& model)
{
    static std::mutex mutex;
    static std::map<std::string, tools::Gizmo> drawn;
    std::lock_guard const lock(mutex);
    auto const found = drawn.find(model.source.name);
    if (found != drawn.end())
        return found->second;
    return drawn.emplace(model.source.name, draw_model(model)).first->second;
}

} // namespace tractus::sketch
