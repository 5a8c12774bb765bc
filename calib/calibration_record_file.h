#pragma once

#include "calib/calibration_record.h"
#include "calib/toml_table.h"
#include "engine/base/result.h"

#include <string>

namespace tractus::calib {

// A rig's calibration record in the rig file: the table [calibration] with one table for each
// procedure performed.

// Parses the record. Fails with a user error naming file, line and key.
Result<CalibrationRecord> parse_calibration_record(TomlTable& table);

// Prints the record as TOML tables, from which parse_calibration_record() restores an equal record.
// Returns an empty text for an empty record.
std::string print_calibration_record(CalibrationRecord const& record);

} // namespace tractus::calib
