#pragma once

#include "engine/scene/edit_kind.h"

#include <cstdint>

namespace tractus::scene {

// Returns the edit with the id of its first item filled in, if it makes items and has no id yet.
// `number` is the number of the edit in its document, from 1. The items keep their ids even if the
// edit is later moved to another position.
Edit with_id(Edit const& edit, std::uint64_t number);

} // namespace tractus::scene
