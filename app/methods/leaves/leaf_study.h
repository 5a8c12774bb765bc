#pragma once

#include "app/render/image.h"
#include "engine/base/result.h"
#include "engine/lsystem/view/leaf_word.h"
#include "engine/methods/leaves/leaf_grammar.h"

#include <vector>

namespace tractus::leaf {

// How leaves are looked at.
struct LeafLook {
    double age = 0.5;  // As of LeafLife,
    double spread = 0; // and how far leaves differ in it (LeafOrder).
    lsystem::LeafDamage damage {};
};

// A leaf on paper with its maps, and the first ones of those that a plant would have.
struct LeafStudy {
    render::Image leaf;
    render::Image relief;       // Its normals, as glTF has them,
    render::Image roughness;    // brighter: rougher,
    render::Image translucency; // brighter: more light comes through,
    render::Image below;        // and its other side.
    std::vector<render::Image> others;
};

// Paints it. Fails like grow_leaf(), and, as the user's fault, where the leaf has no extent.
Result<LeafStudy> study_leaf(leaf::Grammar const& grammar, LeafLook const& look,
                             render::Color const& paper);

} // namespace tractus::leaf
