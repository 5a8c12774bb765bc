#include "app/tools/tool.h"

namespace tractus {

Result<std::vector<Edit>> draw_edits(Tool const& tool, Stroke const& stroke, Scene const& scene)
{
    if (scene.selection.empty())
        return fail(Fault::User,
                    "nothing is selected for the stroke to shape: select a branch first");
    return std::vector<Edit> { Associate { stroke, tool.propagation, tool.fit } };
}

} // namespace tractus
