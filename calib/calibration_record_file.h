#pragma once

#include "calib/calibration_record.h"
#include "calib/toml_table.h"
#include "engine/base/result.h"

#include <string>

namespace tractus::calib {

// A rig's calibration record in its file: the table [calibration] with one table for each
// procedure that was done.

// Fails as the user's fault, naming file, line and key.
Result<CalibrationRecord> parse_calibration_record(TomlTable& table);

// The tables as text; parse_calibration_record() gives the same record back. Empty for an empty
// record.
std::string print_calibration_record(CalibrationRecord const& record);

} // namespace tractus::calib
