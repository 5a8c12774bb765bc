#include "app/tools/tool.h"
#include "engine/plant/join_axes.h"

namespace tractus {

Result<std::vector<Edit>> draw_in_order_edits(Stroke const& stroke, Scene const& scene)
{
    auto const& order = scene.rest->drawing_order;
    if (order.empty())
        return fail(Fault::User,
                    "the plant has no branches for a stroke to shape: load another model");
    // One association per stroke, so their number says whose turn it is; after the last axis the
    // trunk's turn comes again.
    auto const turn = order[scene.associations.size() % order.size()];
    return std::vector<Edit> {
        select_paths(scene, { segments_of(scene.base->axes[turn]) }),
        Associate { stroke, Propagation::Selected },
    };
}

} // namespace tractus
