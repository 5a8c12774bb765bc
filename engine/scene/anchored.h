#pragma once

#include "engine/base/shared_vector.h"
#include "engine/plant/branch_address.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tractus::scene {

// What identifies something that was drawn for as long as its document is there: the edit that made
// it, and which of that edit's items it is. Never 0, which stands for none.
using ItemId = std::uint64_t;

// The id of an edit's first item, of its second, and so on: `item` counts from 0. Edits count from
// 1; below 2^29 of them, ids are exact in every program that reads JSON.
ItemId item_id(std::uint64_t edit, std::size_t item);

std::uint64_t edit_of_item(ItemId id);

// "12" for the first item of edit 12, "12.2" for its second.
std::string name_of(ItemId id);

// "3, 5 and 12.2".
std::string list_names(std::vector<ItemId> const& ids);

// Something that was drawn for places on a plant, by which they are found again in a plant that has
// changed. Paths that are alike share their elements.
template<typename T> struct Anchored {
    ItemId id = 0;
    T what {};
    SharedVector<PathAddress> at {};
};

} // namespace tractus::scene
