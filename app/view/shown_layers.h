#pragma once

#include "app/tools/layer.h"
#include "app/tools/tool.h"
#include "app/view/window_model.h"
#include "engine/base/time.h"
#include "engine/scene/scene.h"

#include <memory>
#include <vector>

namespace tractus::view {

// Visibility of a document's layers over time. A layer that is shown for a while appears whenever
// its lines change, and then fades.
class ShownLayers {
public:
    // Sets the layers. The lines of the first scene that is shown do not count as a change.
    void set_layers(tools::Layers layers);

    // Updates the layers for a scene that is shown from now on, and for the selected tool.
    void show(scene::Scene const& scene, tools::Tool const& in_hand);

    // Advances the fading of layers by a time step.
    void pass(Duration step, tools::Tool const& in_hand);

    std::vector<ShownLayer> const& seen() const { return seen_; }

    // Returns the opacity of lines at a time after their last change. It falls in a few steps
    // rather than smoothly, as the window redraws at each change of opacity.
    static double strength_after(Duration age);

private:
    struct Kept {
        tools::Layer const* layer = nullptr;
        std::vector<std::vector<Vec3f>> lines_mm {};
        // Time since the lines changed. Initially so long that the layer is invisible.
        Duration age = Duration::max() / 2;
        // State of the plant from which `lines_mm` was made; null if the lines must be made again.
        // Immutable; shared with the scene.
        std::shared_ptr<scene::PlantState const> of {};
    };
    static double strength_of(Kept const& kept, tools::Tool const& in_hand);
    void see(tools::Tool const& in_hand);

    std::vector<Kept> kept_;
    bool has_shown_ = false;
    std::vector<ShownLayer> seen_;
};

} // namespace tractus::view
