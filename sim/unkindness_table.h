#pragma once

#include "calib/toml_table.h"
#include "engine/base/result.h"
#include "sim/unkindness.h"

#include <cstdint>

namespace tractus::sim {

// Reads the table [unkind] of a gesture script. A fault whose keys are omitted does not occur:
//
//     hooks_mm = [0.5, 2]   # Least and greatest length of the hook that ends each stroke.
//     dab_share = 0.35      # Share of the strokes that follow a touch by mistake.
//     tremor_mm = 0.3       # Standard deviation of the pen's tremor, 8 to 12 Hz.
//     reports = "changes"   # "changes": the tablet is silent while nothing changes; or "all".
//     lost_share = 0.2      # Share of the tablet's reports that are lost.
//     batch_ms = 15         # Interval between batches of reports, as over Bluetooth.
//     wrong_every_ms = 300  # Interval between runs of wrong height readings.
//     wrong_in_a_row = 10   # Greatest length of such a run; default: 10.
//     stall_every_ms = 700  # Interval between stalls of the computer.
//     stall_ms = 80         # Length of a stall.
//
// Fails with a user error that names the key.
Result<Unkindness> parse_unkindness(calib::TomlTable& table, std::uint64_t seed);

} // namespace tractus::sim
