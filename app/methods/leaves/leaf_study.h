#pragma once

#include "app/render/image.h"
#include "engine/base/result.h"
#include "engine/lsystem/view/leaf_word.h"
#include "engine/methods/leaves/leaf_grammar.h"

#include <vector>

namespace tractus::leaf {

// Age and damage of the leaves in a study.
struct LeafLook {
    double age = 0.5;  // Mean age, as in LeafLife.
    double spread = 0; // Spread of the leaves' ages (LeafOrder).
    lsystem::LeafDamage damage {};
};

// Pictures of a leaf on paper, of its maps, and of the first leaves that a plant would have.
struct LeafStudy {
    render::Image leaf;
    render::Image relief;       // The leaf's normals, encoded as in glTF.
    render::Image roughness;    // The leaf's roughness; brighter is rougher.
    render::Image translucency; // The leaf's translucency; brighter lets more light through.
    render::Image below;        // The leaf's underside.
    std::vector<render::Image> others;
};

// Grows and paints the leaves of a study. Fails like grow_leaf(), and with a user error if the leaf
// has no extent.
Result<LeafStudy> study_leaf(leaf::Grammar const& grammar, LeafLook const& look,
                             render::Color const& paper);

} // namespace tractus::leaf
