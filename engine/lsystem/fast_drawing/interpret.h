#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/language/model.h"
#include "engine/lsystem/language/module_string.h"
#include "engine/lsystem/turtle/turtle_options.h"
#include "engine/plant/plant.h"

#include <string>
#include <vector>

namespace tractus::lsystem {

struct TurtlePlant {
    Plant plant;
    // Warnings, each once, about unsupported symbols and organs and about skipped steps.
    std::vector<std::string> warnings;
};

// Draws a string as a plant: the model's homomorphism rules rewrite each module, and the turtle
// interprets the result.
//
// The turtle starts at the plant's origin, heading up (+z), with its left to -x and its upper side
// towards the user (-y). This is cpfg's space (x right, y up, z to the viewer), rotated: cpfg's (x,
// y, z) is (x, -z, y) here. Vectors in models and view files are in cpfg's space.
//
// Symbols: F G step and draw; f g only step; + - turn left, right; & ^ pitch down, up; \ / roll
// left, right; | turn around; [ ] push, pop; ! # decrease, increase or set the line width, which is
// a diameter; ; , increase, decrease or set the colour; { . } polygon; ~X organ or surface; @v roll
// until the left vector is horizontal; @M(x,y,z) @R(h[,u]) set position, frame; @o @O ball, @c flat
// disc, @bo @bc circle drawn as a line; @D @Di @Dd set, multiply, divide the scale;
// ?(id[,s]) $ enter a sub-L-system s times as large, leave it; @Ts @Ti @Td elasticity of a tropism,
// _ that of the older kind, @Tf @Tp carry the sides; @Gs @Gc(rings) @Ge(rings) generalised
// cylinder, {(1) ... }(1) along a Hermite path, {(2) a closed one, {(3) {(4) B-splines, @Gt @Gr
// tangents, @# contour, @! sides; @PS @PC @PD surface from points of the turtle; % and @mc(1) end
// the drawing of the branch, % only in the string and only if the view says so; %(x,i) continues in
// the turtle's state where a %(x) was cut off. @L, @Tx, @; @, and @S only cause a warning: labels
// and textures are not drawn, back faces look like front faces, and models cannot run programs.
// Other symbols draw nothing. Reference: the CPFG User's Manual.
//
// Axes: consecutive segments form one axis. A segment drawn inside brackets, or after a step that
// draws nothing, begins a new axis, attached to the last segment. Steps of zero length draw
// nothing. Steps inside { } set vertices of the polygon, steps inside {(1) }(1) set control points;
// they draw nothing. A generalised cylinder is a separate axis whose nodes are the rings; with a
// contour the nodes have sections (NodeSection). The first segment after a control point has the
// colour of that point, the further segments that of the next control point.
//
// Radii are half the line width. A node has the width of the segment that starts there. The tip of
// an axis has the width that was set after its last segment, or that segment's width if none was
// set. With `radii: pipe` in the view, radii follow from the pipe model instead.
//
// Turtle colours select the materials of the view; a colour without a material is bark.
//
// Fails with a user error if a limit in the options is exceeded or if a loop in a homomorphism rule
// does not end.
Result<TurtlePlant> interpret_with_warnings(Model const& model, ModuleString const& string,
                                            TurtleOptions const& options = {});

// Draws a string like interpret_with_warnings() and discards the warnings.
Result<Plant> interpret(Model const& model, ModuleString const& string,
                        TurtleOptions const& options = {});

} // namespace tractus::lsystem
