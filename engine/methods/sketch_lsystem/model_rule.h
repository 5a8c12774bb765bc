#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/lsystem/language/model.h"
#include "engine/methods/sketch_lsystem/axis_contract.h"
#include "engine/methods/sketch_lsystem/drawn_axis.h"
#include "engine/methods/sketch_lsystem/segment_lengths.h"
#include "engine/scene/plant_source.h"

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace tractus::sketch {

// A model in cpfg's language that takes the place of a rule. It keeps the contract of
// axis_contract.h; its text is stored with the values that it has without a stroke.
struct ModelRule {
    lsystem::ModelSource source { .name = {}, .view_name = {} };
    // Texts of the files that the model includes, by name.
    std::map<std::string, std::string> includes {};
    std::uint64_t seed = 1; // Seed of the model's random numbers, which affect only its laterals.

    bool is_set() const { return !source.text.empty(); }
    bool operator==(ModelRule const&) const = default;
};

// Largest number of segments of a model's axis.
constexpr int kMaxModelSegments = 1000;

// The lengths of a contract's segments on the desk, for a plant shown at `scale`: the numbers in
// the text, then further ones by the ratio of the last two, rounded to six digits. No length is
// below a fiftieth of the first.
SegmentLengths lengths_on_desk(AxisContract const& contract, double scale);

// Returns the model with the axis through these nodes written to its contract's spans; all other
// bytes of its text stay the same. Fails with a user error if the model does not keep the contract.
Result<lsystem::ModelSource> model_along(ModelRule const& model, std::span<Vec3 const> nodes_mm,
                                         double scale);

// A model's axis after rounding, and the positions of its nodes on the desk.
struct ModelAxis {
    DrawnAxis axis {};
    std::vector<Vec3> nodes_mm {};
};
Result<ModelAxis> axis_along(ModelRule const& model, std::span<Vec3 const> nodes_mm, double scale);

// Checks that a plant follows the drawn axis. Fails with a user error if the plant's first axis
// does not pass through these nodes, given in the plant's frame, because the model turns it by
// something other than the drawn turns. Each node may be off by a thousandth of its segment's
// length.
Result<void> check_follows(std::string const& name, Plant const& plant,
                           std::span<Vec3 const> nodes_mm);

// Lists what a model lacks to grow along a stroke, one sentence for each fault; empty if the model
// is suitable. A text that keeps the contract is also tested by growing it along a short stroke,
// with two seeds.
std::vector<std::string> missing_for_stroke(ModelRule const& model,
                                            scene::LoadOptions const& options);

} // namespace tractus::sketch
