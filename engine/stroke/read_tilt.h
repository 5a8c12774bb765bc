#pragma once

#include "engine/base/result.h"
#include "engine/stroke/stroke.h"

#include <span>
#include <string>
#include <vector>

namespace tractus {

// The strokes of an Open Brush or Tilt Brush sketch (.tilt: a header of sixteen bytes and a zip
// archive, whose data.sketch holds the strokes as the programs' developers document it), in the
// world frame: what was up is up, the sketch's decimetres are millimetres, and the middle of the
// lowest points stands on the desk's origin. Brushes, colours and layers are not read. Strokes of
// fewer than two distinct points are left out; tips without time are 10 ms apart.
//
// Refuses, in a sentence that begins with `name`, what is no such file, is truncated, contradicts
// itself, or holds more than 64 MB of strokes. Any bytes are safe to give.
Result<std::vector<Stroke>> read_tilt(std::string const& name, std::span<std::byte const> bytes);

} // namespace tractus
