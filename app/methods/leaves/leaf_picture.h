#pragma once

#include "app/render/image.h"
#include "engine/base/result.h"
#include "engine/methods/leaves/leaf_grammar.h"
#include "engine/methods/leaves/leaf_paint.h"

namespace tractus::leaf {

// A painted leaf as it lies on paper of that colour, in light from the upper left.
render::Image on_paper(leaf::LeafPicture const& picture, render::Color const& paper);

// A grown-up leaf of the grammar so, in a square of that side. Fails like grow_leaf(), and, as the
// user's fault, where the leaf has no extent.
Result<render::Image> picture_of_leaf(leaf::Grammar const& grammar, int side,
                                      render::Color const& paper);

} // namespace tractus::leaf
