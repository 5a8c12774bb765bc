#pragma once

#include "engine/plant/branch_address.h"

#include <string>

namespace tractus::view {

// Describe places on a plant for the user; numbers count from 1.

// For example "segment 6 of branch 2 at segment 4 of stem 1". For an axis that is addressed by a
// key: "40 % of a branch that is gone". In a part: "... of the plant 12 that was put on".
std::string place_in_words(SegmentAddress const& address);

// Describes the axis of the segment: "branch 2 at segment 4 of stem 1", "stem 1"; "a branch" for an
// axis that is addressed by a key.
std::string branch_in_words(SegmentAddress const& address);

} // namespace tractus::view
