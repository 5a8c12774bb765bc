#include "app/document/draw.h"

#include "app/document/model_cost.h"

#include <utility>

namespace tractus::document {

Result<scene::Scene> scene_after(scene::Scene scene, std::vector<scene::Edit> const& edits)
{
    return scene::apply_edits(std::move(scene), edits, make_load_options());
}

std::string describe_result(tools::Tool const& tool, scene::Scene const& after)
{
    return tool.kind().describe ? tool.kind().describe(tool, after) : "";
}

DrawnStroke draw(Stroke stroke, tools::Tool const& tool, scene::Scene& scene)
{
    DrawnStroke drawn { std::move(stroke), tool };
    auto edits = tool.edits_for(drawn.stroke, scene);
    if (!edits) {
        drawn.refusal = edits.error().message;
        return drawn;
    }
    auto next = scene_after(scene, *edits);
    if (!next) {
        drawn.refusal = next.error().message;
        return drawn;
    }
    scene = *std::move(next);
    drawn.edits = *std::move(edits);
    drawn.message = describe_result(tool, scene);
    return drawn;
}

} // namespace tractus::document
