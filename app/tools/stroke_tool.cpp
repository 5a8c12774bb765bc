#include "app/tools/tool.h"
#include "engine/base/check.h"

namespace tractus {

Result<std::vector<Edit>> stroke_edits(Tool::Kind kind, Stroke const& stroke, Scene const& scene)
{
    auto const numbers = selected_associations(scene);
    if (numbers.empty())
        return fail(Fault::User,
                    "no selected branch has a stroke that could be edited: select one that has "
                    "been drawn");
    switch (kind) {
    case Tool::Kind::Oversketch:
        return std::vector<Edit> { Oversketch { { numbers.back() }, stroke } };
    case Tool::Kind::Smooth:
        return std::vector<Edit> { SmoothStroke { numbers, 0 } };
    default:
        CHECK(kind == Tool::Kind::Delete);
        return std::vector<Edit> { DeleteStroke { { numbers.back() } } };
    }
}

} // namespace tractus
