#include "app/tools/selected_strokes.h"

namespace tractus::tools {

Result<scene::Items> selected_strokes(scene::Scene const& scene)
{
    auto const numbers = scene::selected_associations(scene);
    if (numbers.empty())
        return fail(Fault::User,
                    "no selected branch has a stroke that could be edited: select one that has "
                    "been drawn");
    scene::Items all;
    for (auto const number : numbers)
        all.ids.push_back(scene.associations[number].id);
    return all;
}

Result<scene::Items> newest_selected_stroke(scene::Scene const& scene)
{
    return scene::Items { { TRY(selected_strokes(scene)).ids.back() } };
}

} // namespace tractus::tools
