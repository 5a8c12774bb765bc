#include "app/tools/selected_strokes.h"

namespace tractus {

Result<Items> selected_strokes(Scene const& scene)
{
    auto const numbers = selected_associations(scene);
    if (numbers.empty())
        return fail(Fault::User,
                    "no selected branch has a stroke that could be edited: select one that has "
                    "been drawn");
    Items all;
    for (auto const number : numbers)
        all.ids.push_back(scene.associations[number].id);
    return all;
}

Result<Items> newest_selected_stroke(Scene const& scene)
{
    return Items { { TRY(selected_strokes(scene)).ids.back() } };
}

} // namespace tractus
