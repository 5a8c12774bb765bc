#pragma once

#include "engine/plant/plant.h"
#include "engine/variation/growth_plan.h"

#include <span>
#include <stop_token>
#include <vector>

namespace tractus::variation {

// Makes grown plants sag under the weight of their branches: each joint bends about a horizontal
// axis by bending moment times length over flexural stiffness, like a slender round rod of green
// wood (density 1000 kg/m³, Young's modulus 6 GPa, about the values of Niklas, "Plant
// Biomechanics", 1992), multiplied by GrowthParameters::sag. A branch never sags beyond hanging
// straight down. Loads are evaluated in the deformed position, in four iterations; for bends up to
// about 30 degrees the result is within about one per cent of the rod's equilibrium. Organs have no
// weight, and there is no torsion.
class SagSimulator {
public:
    // `plan` must outlive the simulator.
    explicit SagSimulator(GrowthPlan const& plan)
        : plan_(plan)
    {
    }

    // Moves the nodes of a plant grown from the plan, and rotates the frames of its segments with
    // attachments (GrowthPlan::parent_frame). Returns early, with an unusable plant, if `stop` is
    // requested.
    void sag(Plant& plant, std::span<Quat> parent_frame, std::stop_token const& stop = {});

private:
    struct Load {
        double mass_kg = 0;
        Vec3 moment = Vec3::Zero(); // Sum of mass times position, in kg mm.
    };

    void find_loads(Plant const& plant);
    void bend(Plant& plant);
    void bend_axis(AxisId id, Plant& plant);

    GrowthPlan const& plan_;
    std::vector<Vec3> grown_mm_; // Node positions before sagging.
    std::vector<Quat> turn_;     // Rotation of each segment by sagging.
    // Load of each segment: that of the segment itself and of its descendants.
    std::vector<Load> load_;
};

} // namespace tractus::variation
