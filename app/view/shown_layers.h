#pragma once

#include "app/tools/layer.h"
#include "app/tools/tool.h"
#include "app/view/window_model.h"
#include "engine/base/time.h"
#include "engine/scene/scene.h"

#include <memory>
#include <vector>

namespace tractus::view {

// The layers of a document as time goes by: those that are seen for a while fade after each change
// of their lines, and come back with the next.
class ShownLayers {
public:
    // They have changed as long as nothing was shown before.
    void set_layers(tools::Layers layers);

    // Of the scene that is shown from now on.
    void show(scene::Scene const& scene, tools::Tool const& in_hand);

    // Goes on by so much time.
    void pass(Duration step, tools::Tool const& in_hand);

    std::vector<ShownLayer> const& seen() const { return seen_; }

    // How strongly lines are seen so long after they have changed, in steps: whoever draws them
    // anew for each does so a few times.
    static double strength_after(Duration age);

private:
    struct Kept {
        tools::Layer const* layer = nullptr;
        std::vector<std::vector<Vec3f>> lines_mm {};
        Duration age = Duration::max() / 2; // Since they have changed; at first they are gone.
        std::shared_ptr<scene::PlantState const> of {}; // Shared with the scene; nobody changes it.
    };
    static double strength_of(Kept const& kept, tools::Tool const& in_hand);
    void see(tools::Tool const& in_hand);

    std::vector<Kept> kept_;
    bool has_shown_ = false;
    std::vector<ShownLayer> seen_;
};

} // namespace tractus::view
