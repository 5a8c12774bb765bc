#pragma once

#include "engine/base/result.h"
#include "engine/stroke/stroke.h"

#include <span>
#include <string>
#include <vector>

namespace tractus {

// Reads the strokes of an Open Brush or Tilt Brush sketch (.tilt: a header of sixteen bytes and a
// zip archive whose data.sketch contains the strokes, as documented by the developers of these
// programs). The strokes are converted to the world frame: up stays up, decimetres become
// millimetres, and the centre of the bottom of the sketch's bounding box is moved to the origin on
// the desk. Brushes, colours and layers are not read. Strokes with fewer than two distinct points
// are left out; tips without a time are placed 10 ms apart.
//
// Fails, in a sentence that begins with `name`, if the file is not such a sketch, is truncated or
// inconsistent, or contains more than 64 MB of strokes. Safe for arbitrary bytes.
Result<std::vector<Stroke>> read_tilt(std::string const& name, std::span<std::byte const> bytes);

} // namespace tractus
