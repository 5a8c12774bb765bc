#pragma once

#include "engine/scene/edit_kind.h"

#include <cstdint>

namespace tractus::scene {

// The edit with an id for the first item that it makes, if it makes any and has none yet: that of
// edit `number` of a document, counted from 1. Then its items keep their ids wherever it goes.
Edit with_id(Edit const& edit, std::uint64_t number);

} // namespace tractus::scene
