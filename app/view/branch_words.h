#pragma once

#include "engine/plant/branch_address.h"

#include <string>

namespace tractus::view {

// Describe places on a plant for the user; numbers count from 1.

// "segment 6 of branch 2 at segment 4 of stem 1"; "40 % of a branch that is gone" for an axis with
// a key; "... of the plant 12 that was put on" in a part.
std::string place_in_words(SegmentAddress const& address);

// The axis on which the segment is: "branch 2 at segment 4 of stem 1", "stem 1"; "a branch" for an
// axis with a key.
std::string branch_in_words(SegmentAddress const& address);

} // namespace tractus::view
