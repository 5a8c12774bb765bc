#include "engine/scene/anchored.h"

#include <fmt/core.h>

namespace tractus::scene {

// Number of bits for the item's index in an id: an edit makes at most 2^24 items, more than any
// plant has branches.
static constexpr int kItemBits = 24;

ItemId item_id(std::uint64_t edit, std::size_t item)
{
    return (edit << kItemBits) | item;
}

std::uint64_t edit_of_item(ItemId id)
{
    return id >> kItemBits;
}

std::string name_of(ItemId id)
{
    auto const item = id & ((ItemId { 1 } << kItemBits) - 1);
    auto const edit = std::to_string(edit_of_item(id));
    return item == 0 ? edit : fmt::format("{}.{}", edit, item + 1);
}

std::string list_names(std::vector<ItemId> const& ids)
{
    std::string list;
    for (std::size_t i = 0; i < ids.size(); ++i)
        list += fmt::format("{}{}",
                            i == 0                   ? ""
                                : i + 1 < ids.size() ? ", "
                                                     : " and ",
                            name_of(ids[i]));
    return list;
}

} // namespace tractus::scene
