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

// A model in cpfg's language that grows along a stroke in place of a rule. Its text keeps the
// contract of axis_contract.h and is stored as it is before a stroke fills it in.
struct ModelRule {
    lsystem::ModelSource source { .name = {}, .view_name = {} };
    // Texts of the files that the model includes, by file name.
    std::map<std::string, std::string> includes {};
    std::uint64_t seed = 1; // Seed of the model's random numbers, which affect only its laterals.

    bool is_set() const { return !source.text.empty(); }
    bool operator==(ModelRule const&) const = default;
};

// Maximum number of segments of an axis that a model grows along a stroke.
constexpr int kMaxModelSegments = 1000;

// The lengths of a model's segments on the desk, for a plant shown at `scale`. First come the
// numbers in the model's text, then further ones by the ratio of the last two, rounded to six
// digits. The further lengths end before one would be below a fiftieth of the first length.
SegmentLengths lengths_on_desk(AxisContract const& contract, double scale);

// Returns the model with the axis through these nodes filled into its text; all other bytes of the
// text stay the same. Fails with a user error if the text breaks the contract of axis_contract.h.
Result<lsystem::ModelSource> model_along(ModelRule const& model, std::span<Vec3 const> nodes_mm,
                                         double scale);

// The axis that a model grows along a stroke, after rounding, and the positions of its nodes on the
// desk.
struct ModelAxis {
    DrawnAxis axis {};
    std::vector<Vec3> nodes_mm {};
};
Result<ModelAxis> axis_along(ModelRule const& model, std::span<Vec3 const> nodes_mm, double scale);

// Checks that the first axis of a plant passes through the drawn nodes, given in the plant's frame.
// Each node may be off by a thousandth of the length of the segment that ends there. Fails with a
// user error for a plant that does not, because its model `name` also turns the axis by something
// other than the drawn turns.
Result<void> check_follows(std::string const& name, Plant const& plant,
                           std::span<Vec3 const> nodes_mm);

// Lists what a model lacks to grow along a stroke, one sentence for each fault; empty if the model
// is suitable. If its text keeps the contract of axis_contract.h, the model is also tested: it is
// grown along a short stroke, with two seeds.
std::vector<std::string> missing_for_stroke(ModelRule const& model,
                                            scene::LoadOptions const& options);

} // namespace tractus::sketch
