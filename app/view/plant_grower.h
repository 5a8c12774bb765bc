#pragma once

#include "engine/base/newest_job.h"
#include "engine/base/result.h"
#include "engine/mesh/mesh.h"
#include "engine/scene/scene.h"
#include "engine/variation/individual.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

namespace tractus::view {

// A document's plants as the window wants to show them.
struct PlantRequest {
    std::shared_ptr<scene::Scene const> scene; // Scene to grow; immutable, shared with the window.
    scene::SetGrowth growth {};                // Growth of the active plant, in place of its own.
    bool along_ground = false; // Growth bends along the ground instead of into it; see ground.h.
};

// A request for `count` variations of the active plant, with this seed and the following ones.
struct VariationsRequest {
    PlantRequest like;
    std::size_t count = 0;
    variation::Individuality individuality {}; // How the variations differ in addition to growth.
};

// The segments of the active plant as grown, except roots, that are below the ground.
struct GrownUnderground {
    struct Line {
        Vec3f from_mm = Vec3f::Zero(); // Plant frame.
        Vec3f to_mm = Vec3f::Zero();
        bool by_growth = false; // True: strokes alone would leave this segment above the ground.

        bool operator==(Line const&) const = default;
    };
    std::vector<Line> lines {};
    std::size_t segments = 0; // Number of segments of the whole plant.
};

struct Variation {
    std::uint64_t seed = 0;
    mesh::Mesh mesh; // Coarse mesh for small pictures.
};

// Grows plants in the background while the window keeps running (NewestJob). A request is abandoned
// when a newer one replaces it or the window closes.
class PlantGrower {
public:
    PlantGrower();

    void grow(PlantRequest wanted) { plant_.want(std::move(wanted)); }

    // Requests variations; finished and pending ones of an earlier request are dropped.
    void vary(VariationsRequest wanted);

    // True while a requested plant has not been returned by take().
    bool is_growing() const { return plant_.is_busy(); }

    // The mesh of all visible plants in the active plant's frame, if it was finished since the last
    // call. Fails like plan_growth().
    std::optional<Result<mesh::Mesh>> take();

    // Parts below the ground of the plant that take() returned last.
    GrownUnderground const& underground() const { return underground_; }

    // Destroys a mesh that is no longer shown on another thread: for a large plant this takes
    // longer than a frame.
    void drop(std::unique_ptr<mesh::Mesh const> plant) { worn_out_.want(std::move(plant)); }

    // Variations finished since the last call, in the order of their seeds. Fails like
    // plan_growth(); no further ones follow then.
    Result<std::vector<Variation>> take_variations();

    // Waits until the newest plant and all variations can be taken and all dropped meshes are
    // destroyed.
    void settle();

private:
    struct GrownPlants {
        mesh::Mesh mesh;
        GrownUnderground underground;
    };
    struct VariationRequest {
        PlantRequest plant;
        variation::Individuality individuality;
        std::uint64_t wish = 0;
    };
    struct VariationResult {
        Result<Variation> variation;
        std::uint64_t wish = 0;
    };

    class SceneGrower;
    class VariationMaker;

    void request_next();
    void take_variation();

    NewestJob<PlantRequest, Result<GrownPlants>> plant_;
    GrownUnderground underground_;
    NewestJob<VariationRequest, VariationResult> variation_;
    NewestJob<std::unique_ptr<mesh::Mesh const>, bool> worn_out_;
    VariationsRequest variations_; // The variations still to come, including the one in progress.
    std::uint64_t wish_ = 0; // Number of the latest request; results of earlier ones are ignored.
    Result<std::vector<Variation>> varied_;
};

} // namespace tractus::view
