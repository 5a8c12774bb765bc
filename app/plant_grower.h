#pragma once

#include "engine/base/result.h"
#include "engine/mesh/mesh.h"
#include "engine/scene/scene.h"

#include <memory>
#include <optional>

namespace tractus {

// A plant that somebody wants to see.
struct WantedPlant {
    std::shared_ptr<Scene const>
        scene;           // Shared with whoever shows it meanwhile; nobody changes it.
    SetGrowth growth {}; // In place of the scene's own.
};

// Grows plants on a thread of its own, for a window that goes on meanwhile. Only the newest wish
// counts: what is growing is finished, what still waits behind it is dropped.
//
// Everything here is called from one thread.
class PlantGrower {
public:
    PlantGrower();

    // Waits for what is being grown.
    ~PlantGrower();

    void grow(WantedPlant wanted);

    // A plant was wanted that take() has not given yet.
    bool is_growing() const;

    // The newest plant, if one has been finished since the last call. Fails like plan_growth().
    std::optional<Result<Mesh>> take();

    // Waits until the newest plant is there to be taken.
    void settle();

private:
    struct Shared;
    std::unique_ptr<Shared> shared_;
};

} // namespace tractus
