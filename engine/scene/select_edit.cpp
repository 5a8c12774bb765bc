#include "engine/scene/edit_words.h"
#include "engine/scene/make_edit_kind.h"

#include <fmt/core.h>
#include <utility>
#include <vector>

namespace tractus::scene {

namespace {

void list(Fields& fields, Select& edit)
{
    fields.sparse_field("paths", &edit.paths);
    fields.sparse_field("at", &edit.at);
}

// Returns the addresses of paths that are given by their segments.
Result<std::vector<PathAddress>> places_of(variation::Selection const& paths, BasePlant const& base)
{
    std::vector<PathAddress> at;
    for (auto const& path : paths) {
        for (auto const segment : path)
            if (segment >= base.plant->segment_count())
                return fail(Fault::User,
                            fmt::format("segment {} cannot be selected: the plant has {}", segment,
                                        base.plant->segment_count()));
        if (!path.empty())
            at.push_back(base.rest->addresses.address_of(*base.plant, path));
    }
    return at;
}

Result<DocumentState> applied(DocumentState state, Select const& edit, SceneBuilder& builder)
{
    auto at = edit.at;
    if (!edit.paths.empty()) {
        auto const base = TRY(builder.active_base(state));
        at = TRY(places_of(edit.paths, *base));
    }
    change_active(state, [&](PlantState& plant) { plant.selection = std::move(at); });
    return state;
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
    if (segments == 0)
        return fmt::format("selects {}", counted(paths, "path"));
    return fmt::format("selects {}, {}", counted(paths, "path"), counted(segments, "segment"));
}

} // namespace

Select select_paths(BuiltPlant const& plant, variation::Selection const& paths)
{
    Select edit;
    for (auto const& path : paths)
        edit.at.push_back(plant.rest->addresses.address_of(*plant.base, path));
    return edit;
}

constexpr EditKind Select::kKind = make_edit_kind<Select, list, applied, described>("select");

} // namespace tractus::scene
