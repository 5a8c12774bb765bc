#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"
#include "engine/scene/scene.h"

#include <memory>

namespace tractus::commands {

// A plant at ages from 0 to 1 (fully grown), for animations.
class AgeingPlant {
public:
    AgeingPlant() = default;
    AgeingPlant(AgeingPlant const&) = delete;
    AgeingPlant& operator=(AgeingPlant const&) = delete;
    virtual ~AgeingPlant() = default;

    // Returns the plant with all its parts; parts that have not grown yet have no size. Valid until
    // the next call.
    virtual Plant const& grow(double age) = 0;

    // Returns the plant with only those parts that exist at this age.
    virtual Plant parts(double age) = 0;
};

// Returns the active plant of a scene. It grows as scene::plan_growth() says and varies with the
// scene's seed. Fails like scene::plan_growth().
Result<std::unique_ptr<AgeingPlant>> varied_plant(scene::Scene const& scene, bool along_ground);

// Returns the active plant of a scene at successive ages. The ages of a self-organising tree are
// the years that it has lived; any other plant is that of varied_plant(). Fails like
// varied_plant(), or if the tree cannot be grown.
Result<std::unique_ptr<AgeingPlant>> plant_of_ages(scene::Scene const& scene,
                                                   scene::MakeLoadOptions const& options);

} // namespace tractus::commands
