#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"
#include "engine/scene/scene.h"

#include <memory>

namespace tractus::commands {

// A plant at successive ages, from 0 to 1, for animations.
class AgeingPlant {
public:
    AgeingPlant() = default;
    AgeingPlant(AgeingPlant const&) = delete;
    AgeingPlant& operator=(AgeingPlant const&) = delete;
    virtual ~AgeingPlant() = default;

    // The plant with all its parts: what has not grown yet has no size. Valid until the next call.
    virtual Plant const& grow(double age) = 0;

    // The plant with only the parts that it has at an age.
    virtual Plant parts(double age) = 0;
};

// The active plant of a scene, which grows as its model says and varies with its seed. Fails like
// scene::plan_growth().
Result<std::unique_ptr<AgeingPlant>> varied_plant(scene::Scene const& scene, bool along_ground);

// The active plant of a scene at successive ages. For a self-organising tree as it has grown, these
// are the years that it has lived; any other plant is as for varied_plant(). Fails like
// varied_plant(), or if the tree cannot be grown.
Result<std::unique_ptr<AgeingPlant>> plant_of_ages(scene::Scene const& scene,
                                                   scene::MakeLoadOptions const& options);

} // namespace tractus::commands
