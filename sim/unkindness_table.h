#pragma once

#include "calib/toml_table.h"
#include "engine/base/result.h"
#include "sim/unkindness.h"

#include <cstdint>

namespace tractus::sim {

// Reads the table [unkind] of a hand file. What is left out is off:
//
//     hooks_mm = [0.5, 2]   # Each stroke ends in a hook between so long and so long.
//     dab_share = 0.35      # So many strokes follow a touch by mistake.
//     tremor_mm = 0.3       # Standard deviation of the pen's tremor, 8 to 12 Hz.
//     reports = "changes"   # The tablet is silent while nothing changes; or "all".
//     lost_share = 0.2      # So many of its reports are lost.
//     batch_ms = 15         # They come in batches, as over Bluetooth.
//     wrong_every_ms = 300  # Wrong height readings begin so often,
//     wrong_in_a_row = 10   # up to so many in a row; 10 if left out.
//     stall_every_ms = 700  # The computer stalls once in such a time,
//     stall_ms = 80         # for so long.
//
// Fails with a user error, naming the key.
Result<Unkindness> parse_unkindness(calib::TomlTable& table, std::uint64_t seed);

} // namespace tractus::sim
