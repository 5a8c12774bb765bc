#pragma once

#include "engine/lsystem/view/view_reader.h"

namespace tractus::lsystem {

// Readers of the statements that cpfg does not have. view.h describes these statements.
Result<void> read_material(ViewReader& reader, std::string_view value);
Result<void> read_color(ViewReader& reader, std::string_view value);
Result<void> read_organ(ViewReader& reader, std::string_view value);
Result<void> read_leaf(ViewReader& reader, std::string_view value);
Result<void> read_calendar(ViewReader& reader, std::string_view value);
Result<void> read_radii(ViewReader& reader, std::string_view value);

} // namespace tractus::lsystem
