#pragma once

#include "engine/scene/edit.h"

#include <string>

namespace tractus {

// What an edit does, for a person: a few words without a full stop.
std::string describe_edit(Edit const& edit);

} // namespace tractus
