#pragma once

#include "app/render/image.h"
#include "engine/base/result.h"
#include "engine/methods/leaves/leaf_grammar.h"
#include "engine/methods/leaves/leaf_paint.h"

namespace tractus::leaf {

// Renders a painted leaf that lies on paper of the colour `paper`, lit from the upper left.
render::Image on_paper(leaf::LeafPicture const& picture, render::Color const& paper);

// Renders an adult leaf of the grammar on paper, in a square image of `side` pixels. Fails with a
// user error if the grammar gives no number of steps or the leaf has no extent.
Result<render::Image> picture_of_leaf(leaf::Grammar const& grammar, int side,
                                      render::Color const& paper);

} // namespace tractus::leaf
