#pragma once

#include "engine/base/shared_vector.h"
#include "engine/plant/branch_address.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tractus::scene {

// Identifies a drawn item for the lifetime of its document. An id combines the number of the edit
// that made the item and the item's index among those that the edit made. 0 means no item.
using ItemId = std::uint64_t;

// Returns the id of item number `item` (from 0) of edit number `edit` (from 1). The ids of the
// first 2^29 edits are exact even in programs that read JSON numbers as doubles.
ItemId item_id(std::uint64_t edit, std::size_t item);

std::uint64_t edit_of_item(ItemId id);

// Returns the name of an item for display: "12" for the first item of edit 12, "12.2" for its
// second.
std::string name_of(ItemId id);

// Returns the names of items as a list, such as "3, 5 and 12.2".
std::string list_names(std::vector<ItemId> const& ids);

// A drawn item and its paths. The paths are stored as addresses, so that they can be found again
// after the plant has changed. Equal lists of paths share their elements.
template<typename T> struct Anchored {
    ItemId id = 0;
    T what {};
    SharedVector<PathAddress> at {};
};

} // namespace tractus::scene
