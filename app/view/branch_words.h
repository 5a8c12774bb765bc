#pragma once

#include "engine/plant/branch_address.h"

#include <string>

namespace tractus::view {

// Describe places on a plant for the user. Branches, segments and stems are counted from 1.

// Returns, for example, "segment 6 of branch 2 at segment 4 of stem 1"; for an axis that is
// addressed by a key, "40 % of a branch that is gone"; for a grafted part, "... of the plant 12
// that was put on".
std::string place_in_words(SegmentAddress const& address);

// Describes the axis of the segment, for example as "branch 2 at segment 4 of stem 1" or "stem 1".
// An axis that is addressed by a key is "a branch".
std::string branch_in_words(SegmentAddress const& address);

} // namespace tractus::view
