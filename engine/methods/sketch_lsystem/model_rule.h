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

// A model in cpfg's language that keeps the contract of axis_contract.h, in a rule's place. Texts
// as they are without a stroke.
struct ModelRule {
    lsystem::ModelSource source { .name = {}, .view_name = {} };
    std::map<std::string, std::string> includes {}; // What it includes, by name: the texts.
    std::uint64_t seed = 1;                         // Of its chance, which is the laterals'.

    bool is_set() const { return !source.text.empty(); }
    bool operator==(ModelRule const&) const = default;
};

// More segments no model's axis has.
constexpr int kMostModelSegments = 1000;

// The lengths of a contract's segments on the desk, where the plant is shown `scale` times as large
// as it is: the text's numbers, and the next ones by their last ratio, to six digits. None is
// shorter than a fiftieth of the first.
SegmentLengths lengths_on_desk(AxisContract const& contract, double scale);

// The model with the axis that is drawn through those nodes: its contract's places have its values,
// all else of its text stays byte for byte. Fails, as the user's fault, for a model that does not
// keep the contract.
Result<lsystem::ModelSource> model_along(ModelRule const& model, std::span<Vec3 const> nodes_mm,
                                         double scale);

// The axis as that text has it, and where its turtle has the nodes, on the desk.
struct ModelAxis {
    DrawnAxis axis {};
    std::vector<Vec3> nodes_mm {};
};
Result<ModelAxis> axis_along(ModelRule const& model, std::span<Vec3 const> nodes_mm, double scale);

// Refuses, as the user's fault, a plant whose first axis is not the one through those nodes, plant
// frame: something else turns it than what was drawn. Each may be off by a thousandth of its
// segment.
Result<void> check_follows(std::string const& name, Plant const& plant,
                           std::span<Vec3 const> nodes_mm);

// What a model lacks to be grown along a stroke: one sentence each; empty: nothing. Where its text
// lacks nothing it is grown along a stroke of a few segments, with two seeds.
std::vector<std::string> lacks_for_stroke(ModelRule const& model,
                                          scene::LoadOptions const& options);

} // namespace tractus::sketch
