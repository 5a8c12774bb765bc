#pragma once

#include "app/tools/glyph.h"

namespace tractus::sketch {

// The rule of a SketchTool as the paper draws it (Ijiri, Owada, Igarashi 2006, figure 3): a parent,
// its ring of laterals, the top apex, and each of these with the ring after it. Handles set a
// lateral's angle and length (A), the twist of the rings from node to node (B) and the lateral's
// width (C); likewise the top's length (D), twist (E) and width (F); minus and plus the number of
// laterals.
extern tools::GlyphKind const kRuleGlyph;

} // namespace tractus::sketch
