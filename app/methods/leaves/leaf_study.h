#pragma once

#include "app/render/image.h"
#include "engine/base/result.h"
#include "engine/lsystem/view/leaf_word.h"
#include "engine/methods/leaves/leaf_grammar.h"

#include <vector>

namespace tractus::leaf {

// Age and damage of the leaves in a study.
struct LeafLook {
    double age = 0.5;  // Mean age of the leaves (LeafLife::age).
    double spread = 0; // Standard deviation of the leaves' ages (LeafOrder::spread).
    lsystem::LeafDamage damage {};
};

// Pictures of a leaf on paper, of the leaf's maps, and of the first leaves that a plant would have.
struct LeafStudy {
    render::Image leaf;
    render::Image relief;       // The leaf's normals, encoded as in glTF.
    render::Image roughness;    // The leaf's roughness; brighter is rougher.
    render::Image translucency; // The leaf's translucency; brighter lets more light through.
    render::Image below;        // The underside of the leaf.
    std::vector<render::Image> others;
};

// Grows and paints the leaves of a study. Fails with a user error if the grammar gives no number of
// steps or a leaf has no extent.
Result<LeafStudy> study_leaf(leaf::Grammar const& grammar, LeafLook const& look,
                             render::Color const& paper);

} // namespace tractus::leaf
