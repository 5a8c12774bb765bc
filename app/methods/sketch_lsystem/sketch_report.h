#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/language/model.h"
#include "engine/methods/sketch_lsystem/drawn_axis.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tractus::sketch {

// The axis drawn by the stroke, as input of a report.
struct ReportedAxis {
    DrawnAxis axis {};
    // The axis's nodes on the desk, as the model's turtle computes them.
    std::vector<Vec3> nodes_mm {};
    // Number of times that laterals may fork; no value if a model defines the laterals.
    std::optional<int> depth {};
};

// Report of a stroke grown by a rule or a model, as one line of JSON for other programs:
//
//   segments   number of the drawn axis's internodes
//   nodes      [[x, y, z], …]: base of the drawn axis and ends of its internodes, as computed by
//              the model's turtle, in millimetres on the desk; one more than segments
//   plane      [degrees, …]: direction of the bend before each segment
//   bend       [degrees, …]: angle of the bend before each segment
//   depth      how often laterals may fork; only for rules
//   counts     [{"F": 2, …}, …]: how often each letter occurs in the string after step 1, 2, …
//
// Fails if the model cannot be derived.
Result<std::string> print_report(ReportedAxis const& drawn, lsystem::Model const& model,
                                 std::uint64_t seed = 1);

} // namespace tractus::sketch
