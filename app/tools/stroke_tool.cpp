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
    auto const last = scene.associations[numbers.back()].id;
    Items all;
    for (auto const number : numbers)
        all.ids.push_back(scene.associations[number].id);
    switch (kind) {
    case Tool::Kind::Oversketch:
        return std::vector<Edit> { Oversketch { { { last } }, stroke } };
    case Tool::Kind::Smooth:
        return std::vector<Edit> { SmoothStroke { all, 0 } };
    default:
        CHECK(kind == Tool::Kind::Delete);
        return std::vector<Edit> { DeleteStroke { { { last } } } };
    }
}

} // namespace tractus
