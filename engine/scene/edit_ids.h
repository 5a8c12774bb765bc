#pragma once

#include "engine/scene/edit_kind.h"

#include <cstdint>

namespace tractus::scene {

// Returns the edit, which is number `number` (from 1) of a document, with the id of its first item
// filled in, if it makes items and has no id yet. Its items then keep their ids even if the edit is
// moved.
Edit with_id(Edit const& edit, std::uint64_t number);

} // namespace tractus::scene
