#include "engine/plant/pipe_model.h"

#include <cmath>

namespace tractus {

void apply_pipe_model(Plant& plant, double exponent, double tip_radius_mm)
{
    double const tip = std::pow(tip_radius_mm, exponent);
    // For each segment, the sum of r^exponent over its lateral axes.
    std::vector<double> borne(plant.segment_count());
    // A plant lists parents before children, so in reverse order every axis precedes its parent.
    for (auto axis = plant.axes.rbegin(); axis != plant.axes.rend(); ++axis) {
        double sum = 0;
        auto const set_radius = [&](std::size_t node) {
            plant.node_radius_mm[axis->first_node + node]
                = static_cast<float>(std::pow(sum, 1 / exponent));
        };
        for (std::size_t i = axis->segment_count; i-- > 0;) {
            sum += borne[axis->first_segment + i];
            if (i + 1 == axis->segment_count) {
                sum = sum > 0 ? sum : tip;
                set_radius(axis->segment_count);
            }
            set_radius(i);
        }
        if (axis->parent_segment != kNone)
            borne[axis->parent_segment] += sum;
    }
}

} // namespace tractus
