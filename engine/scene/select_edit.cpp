#include "engine/scene/edit_words.h"
#include "engine/scene/make_edit_kind.h"

#include <fmt/core.h>

namespace tractus {

namespace {

void list(Fields& fields, Select& edit)
{
    fields.field("paths", &edit.paths);
}

Result<Scene> applied(Scene scene, Select const& edit, LoadOptions const&)
{
    for (auto const& path : edit.paths)
        for (auto const segment : path)
            if (segment >= scene.base->segment_count())
                return fail(Fault::User,
                            fmt::format("segment {} cannot be selected: the plant has {}", segment,
                                        scene.base->segment_count()));
    scene.selection = edit.paths;
    return scene;
}

std::string described(Select const& edit)
{
    if (edit.paths.empty())
        return "selects nothing";
    std::size_t segments = 0;
    for (auto const& path : edit.paths)
        segments += path.size();
    return fmt::format("selects {}, {}", counted(edit.paths.size(), "path"),
                       counted(segments, "segment"));
}

} // namespace

constexpr EditKind Select::kKind = make_edit_kind<Select, list, applied, described>("select");

} // namespace tractus
