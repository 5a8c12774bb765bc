#include "engine/scene/edit_words.h"
#include "engine/scene/make_edit_kind.h"

#include <fmt/core.h>

namespace tractus {

namespace {

void list(Fields& fields, Select& edit)
{
    fields.sparse_field("paths", &edit.paths);
    fields.sparse_field("at", &edit.at);
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
    for (auto const& at : edit.at) {
        auto path = scene.rest->addresses.find_path(*scene.base, at);
        if (!path)
            return fail(Fault::User, "a branch cannot be selected: the plant has none there");
        scene.selection.push_back(*std::move(path));
    }
    return scene;
}

std::string described(Select const& edit)
{
    auto const paths = edit.paths.size() + edit.at.size();
    if (paths == 0)
        return "selects nothing";
    std::size_t segments = 0;
    for (auto const& path : edit.at)
        segments += segment_count(path);
    for (auto const& path : edit.paths)
        segments += path.size();
    return fmt::format("selects {}, {}", counted(paths, "path"), counted(segments, "segment"));
}

} // namespace

Select select_paths(Scene const& scene, Selection const& paths)
{
    Select edit;
    for (auto const& path : paths)
        edit.at.push_back(scene.rest->addresses.address_of(*scene.base, path));
    return edit;
}

constexpr EditKind Select::kKind = make_edit_kind<Select, list, applied, described>("select");

} // namespace tractus
