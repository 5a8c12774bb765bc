#pragma once

#include "calib/rig.h"
#include "engine/base/result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace tractus::calib {

// A rig in a file (.rig.toml): TOML with units in the keys and angles in degrees. A printed rig
// shows all keys with explanations. These may be omitted: sample_times (default "as_arrived", as in
// older files), tablet.surface_mm, tablet.rotation_deg, tablet.travel_shear, height.max_age_ms,
// [pen] and [calibration].

// Parses a rig. Fails with a user error naming `file` and the line, for invalid TOML, a
// missing, unknown or wrong key, and a version later than this program's.
Result<Rig> parse_rig(std::string_view text, std::string const& file);

// Prints a rig. parse_rig() restores an identical rig, to the last bit.
std::string print_rig(Rig const& rig);

// Reads a rig from a file. Fails like read_text_file() and parse_rig().
Result<Rig> load_rig(std::filesystem::path const& path);

// Writes the file atomically; a previous file is kept with ".bak" appended to its name. The text is
// read back first: a rig that cannot be read, or that has no height for a reading in its calibrated
// range, is not written, and the error says why. Also fails like write_file().
Result<void> save_rig(Rig const& rig, std::filesystem::path const& path);

} // namespace tractus::calib
