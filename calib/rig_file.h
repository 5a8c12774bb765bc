#pragma once

#include "calib/rig.h"
#include "engine/base/result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace tractus::calib {

// A rig in a file (.rig.toml): TOML with the units in its keys, angles in degrees. Print a rig to
// see all keys with what they mean; these may be left out: sample_times ("as_arrived"
// then, as in files of before it was there), tablet.surface_mm, tablet.rotation_deg,
// tablet.travel_shear, height.max_age_ms, [pen] and [calibration].

// The rig that `text` describes. Fails as the user's fault, naming `file` and the line, for what is
// not TOML, a missing, unknown or wrong key, and a version later than this program's.
Result<Rig> parse_rig(std::string_view text, std::string const& file);

// The text for a rig. parse_rig() gives the same rig back, to the last bit.
std::string print_rig(Rig const& rig);

// Reads a rig from a file. Fails like read_text_file() and parse_rig().
Result<Rig> load_rig(std::filesystem::path const& path);

// Writes the file at once or not at all; the one that was there is kept beside it, with ".bak"
// behind its name. The text is read back first: a rig that nobody could read, or that has no height
// for a reading in its calibrated range, is not written, and the sentence says why. Fails like
// write_file() besides.
Result<void> save_rig(Rig const& rig, std::filesystem::path const& path);

} // namespace tractus::calib
