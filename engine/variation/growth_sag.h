#pragma once

#include "engine/plant/plant.h"
#include "engine/variation/growth_plan.h"

#include <span>
#include <stop_token>
#include <vector>

namespace tractus::variation {

// Lets grown plants sag under the weight of their branches: each joint gives way, about a level
// axis, by bending moment times length over bending stiffness, as a slender round rod of green wood
// does (density 1000 kg/m³, Young's modulus 6 GPa, about what Niklas, "Plant Biomechanics", 1992,
// gives), GrowthParameters::sag times as much. However soft, nothing sags farther than hanging
// down. What a joint bears is measured where it hangs in the end, in a few rounds; for bends up to
// some 30 degrees the result is the rod's equilibrium to about a per cent. Organs have no weight,
// and nothing twists.
class Sagger {
public:
    // `plan` must outlive the sagger.
    explicit Sagger(GrowthPlan const& plan)
        : plan_(plan)
    {
    }

    // Moves the nodes of a plant that was grown by the plan, and turns the frames of its bearing
    // segments (GrowthPlan::parent_frame) along. Ends early when `stop` asks for it; the plant is
    // good for nothing then.
    void sag(Plant& plant, std::span<Quat> parent_frame, std::stop_token const& stop = {});

private:
    struct Load {
        double mass_kg = 0;
        Vec3 moment = Vec3::Zero(); // Sum of mass times place, kg mm.
    };

    void find_loads(Plant const& plant);
    void bend(Plant& plant);
    void bend_axis(AxisId id, Plant& plant);

    GrowthPlan const& plan_;
    std::vector<Vec3> grown_mm_; // The nodes before they sag.
    std::vector<Quat> turn_;     // Per segment: how it has turned.
    std::vector<Load> load_;     // Per segment: it and all that it bears.
};

} // namespace tractus::variation
