#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/language/model.h"
#include "engine/methods/sketch_lsystem/drawn_axis.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tractus::sketch {

// A drawn axis as a report gives it.
struct ReportedAxis {
    DrawnAxis axis {};
    std::vector<Vec3> nodes_mm {}; // As the model's turtle has them, on the desk.
    std::optional<int> depth {};   // No value: the laterals are a model's own.
};

// Returns what a stroke and a rule, or a model in its place, amount to, as one line of JSON for
// other programs:
//
//   segments   how many internodes the drawn axis has
//   nodes      [[x, y, z], …]: its base and the ends of its internodes as the model's turtle has
//   them,
//              millimetres on the desk, one more than segments
//   plane      [degrees, …]: before each segment, in which plane it bends,
//   bend       [degrees, …]: and by how much
//   depth      how often laterals may fork; not of a model
//   counts     [{"F": 2, …}, …]: how often each letter stands in the string after step 1, 2, …
//
// Fails like derive().
Result<std::string> print_report(ReportedAxis const& drawn, lsystem::Model const& model,
                                 std::uint64_t seed = 1);

} // namespace tractus::sketch
