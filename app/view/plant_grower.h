#pragma once

#include "engine/base/newest_job.h"
#include "engine/base/result.h"
#include "engine/mesh/mesh.h"
#include "engine/scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

namespace tractus::view {

// The plants of a document as somebody wants to see them.
struct WantedPlant {
    std::shared_ptr<scene::Scene const>
        scene;                  // Shared with whoever shows it meanwhile; nobody changes it.
    scene::SetGrowth growth {}; // Of the active plant, in place of its own.
};

// Variations of the active plant alone: `count` of them, of this seed and those that follow.
struct WantedVariations {
    WantedPlant like;
    std::size_t count = 0;
};

struct Variation {
    std::uint64_t seed = 0;
    mesh::Mesh mesh; // Coarse, to be seen small.
};

// Grows plants in the background, for a window that goes on meanwhile: see NewestJob. One that is
// not wanted any more, since a newer one is or the window closes, is given up.
class PlantGrower {
public:
    PlantGrower();

    void grow(WantedPlant wanted) { plant_.want(std::move(wanted)); }

    // Variations that have come, or are still to come, of an earlier wish are dropped.
    void vary(WantedVariations wanted);

    // A plant was wanted that take() has not given yet.
    bool is_growing() const { return plant_.is_busy(); }

    // All plants that are not hidden, in the active one's frame, if they have been finished since
    // the last call. Fails like plan_growth().
    std::optional<Result<mesh::Mesh>> take() { return plant_.take(); }

    // A plant that nobody looks at any more. A large one takes so long to go that a window would
    // miss a frame: it goes on a thread.
    void drop(std::unique_ptr<mesh::Mesh const> plant) { worn_out_.want(std::move(plant)); }

    // Those that have been finished since the last call, in the order of their seeds. Fails like
    // plan_growth(); then none follow.
    Result<std::vector<Variation>> take_variations();

    // Waits until the newest plant and all variations are there to be taken, and what was dropped
    // is gone.
    void settle();

private:
    struct WantedVariation {
        WantedPlant plant;
        std::uint64_t wish = 0;
    };
    struct MadeVariation {
        Result<Variation> variation;
        std::uint64_t wish = 0;
    };

    static MadeVariation make_variation(WantedVariation const& wanted, std::stop_token const& stop);
    void want_next();
    void take_variation();

    NewestJob<WantedPlant, Result<mesh::Mesh>> plant_;
    NewestJob<WantedVariation, MadeVariation> variation_;
    NewestJob<std::unique_ptr<mesh::Mesh const>, bool> worn_out_;
    WantedVariations variations_; // The next ones, and that which is being made.
    std::uint64_t wish_ = 0;      // Which of the wishes for variations counts.
    Result<std::vector<Variation>> varied_;
};

} // namespace tractus::view
