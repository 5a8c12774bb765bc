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

// The plants of a document in the form that the window wants to show.
struct PlantRequest {
    // Scene whose plants are grown. Immutable; shared with the window.
    std::shared_ptr<scene::Scene const> scene;
    scene::SetGrowth growth {}; // Growth of the active plant; replaces the growth in the scene.
    // True: plants bend along the ground instead of growing into it; see ground.h.
    bool along_ground = false;
};

// A request for `count` variations of the active plant. The first has the seed of `like.growth`,
// the others the seeds after it.
struct VariationsRequest {
    PlantRequest like;
    std::size_t count = 0;
    // Individual differences of the variations, in addition to growth.
    variation::Individuality individuality {};
};

// Segments of the grown active plant that are below the ground, except roots.
struct GrownUnderground {
    struct Line {
        Vec3f from_mm = Vec3f::Zero(); // Beginning of the segment, in the plant's frame.
        Vec3f to_mm = Vec3f::Zero();
        // True if growth takes the segment below the ground: strokes alone would leave it above.
        bool by_growth = false;

        bool operator==(Line const&) const = default;
    };
    std::vector<Line> lines {};
    std::size_t segments = 0; // Number of segments of the whole plant.
};

struct Variation {
    std::uint64_t seed = 0;
    mesh::Mesh mesh; // Coarse mesh for a small picture.
};

// Grows plants in the background while the window keeps running (NewestJob). A request is stopped
// when a newer one replaces it or when the window closes.
class PlantGrower {
public:
    PlantGrower();

    void grow(PlantRequest wanted) { plant_.want(std::move(wanted)); }

    // Requests variations. Variations of an earlier request that have not been taken are dropped.
    void vary(VariationsRequest wanted);

    // True if a plant was requested that take() has not returned yet.
    bool is_growing() const { return plant_.is_busy(); }

    // Returns the mesh of all visible plants, in the active plant's frame, if it was finished since
    // the last call. Fails like plan_growth().
    std::optional<Result<mesh::Mesh>> take();

    // Returns the parts below the ground of the active plant that take() returned last.
    GrownUnderground const& underground() const { return underground_; }

    // Destroys a mesh that is no longer shown, on another thread: destroying a large plant takes
    // longer than a frame.
    void drop(std::unique_ptr<mesh::Mesh const> plant) { worn_out_.want(std::move(plant)); }

    // Returns the variations finished since the last call, in the order of their seeds. Fails like
    // plan_growth(); after a failure no further variations follow.
    Result<std::vector<Variation>> take_variations();

    // Waits until the newest plant and all variations are finished and all dropped meshes are
    // destroyed. Plant and variations can then be taken.
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
    // The variations that are not finished yet, including the one in progress.
    VariationsRequest variations_;
    // Number of the latest request for variations; results of earlier requests are ignored.
    std::uint64_t wish_ = 0;
    Result<std::vector<Variation>> varied_;
};

} // namespace tractus::view
