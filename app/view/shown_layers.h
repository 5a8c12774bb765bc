#pragma once

#include "app/tools/layer.h"
#include "app/tools/tool.h"
#include "app/view/window_model.h"
#include "engine/base/time.h"
#include "engine/scene/scene.h"

#include <memory>
#include <vector>

namespace tractus::view {

// Visibility of a document's layers over time. A layer shown for a while fades after each change of
// its lines and reappears at the next change.
class ShownLayers {
public:
    // Sets the layers. Their lines count as changed until a scene was shown.
    void set_layers(tools::Layers layers);

    // Updates the layers for the scene that is shown from now on.
    void show(scene::Scene const& scene, tools::Tool const& in_hand);

    // Advances the fading by a time step.
    void pass(Duration step, tools::Tool const& in_hand);

    std::vector<ShownLayer> const& seen() const { return seen_; }

    // Opacity of lines at an age since their last change. It falls in a few steps, as each change
    // makes the window redraw.
    static double strength_after(Duration age);

private:
    struct Kept {
        tools::Layer const* layer = nullptr;
        std::vector<std::vector<Vec3f>> lines_mm {};
        // Time since the lines changed; large at first, so that the layer is invisible.
        Duration age = Duration::max() / 2;
        // State of the plant from which `lines_mm` was made; null: to be made anew. Immutable;
        // shared with the scene.
        std::shared_ptr<scene::PlantState const> of {};
    };
    static double strength_of(Kept const& kept, tools::Tool const& in_hand);
    void see(tools::Tool const& in_hand);

    std::vector<Kept> kept_;
    bool has_shown_ = false;
    std::vector<ShownLayer> seen_;
};

} // namespace tractus::view
