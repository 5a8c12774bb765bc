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
    std::vector<std::string> warnings; // Symbols and organs we lack, steps left out: once each.
};

// Draws a string: runs the turtle over it, each module first rewritten by the model's homomorphism
// rules, and collects what it draws in a plant.
//
// The turtle starts at the plant's origin, heading up (+z), its left to -x, its upper side towards
// the user (-y). This is cpfg's space (x right, y up, z to the viewer) turned so that y is up:
// cpfg's (x, y, z) is our (x, -z, y). Vectors in models and view files are in cpfg's space.
//
// Symbols: F G step and draw, f g step; + - turn left, right; & ^ pitch down, up; \ / roll left,
// right; | turn round; [ ] push, pop; ! # line width (a diameter) down, up, or set; ; , colour up,
// down, or set; { . } polygon; ~X organ or surface; @v roll until the left is horizontal;
// @M(x,y,z) @R(h[,u]) set position, frame; @o @O ball, @c flat disc, @bo @bc circles as thick as
// the line; @D @Di @Dd scale set, times, divided; ?(id[,s]) $ into and out of a sub-L-system, s
// times as large; @Ts @Ti @Td elasticity of a tropism, _ that of the older one, @Tf @Tp carry the
// sides; @Gs @Gc(rings) @Ge(rings) generalised cylinder, {(1) … }(1) along a Hermite path, {(2) a
// closed one, {(3) {(4) B-splines, @Gt @Gr tangents, @# contour, @! sides; @PS @PC @PD surface of
// the turtle's points; % and @mc(1) end the drawing of the branch, % only in the string and where
// the view says so; %(x,i) goes on as the turtle was where a %(x) has cut that off. @L, @Tx, @; @,
// and @S warn once: labels and textures are not drawn, back faces look as the front, and a model
// runs no programs. Other symbols draw nothing. How cpfg has them: the CPFG User's Manual.
//
// Axes: segments drawn one after another are one axis. What is drawn inside brackets, and after a
// step that draws nothing, begins an axis of its own that stands on the last segment. Steps of no
// length draw nothing. Inside { } steps set the polygon's vertices, inside {(1) }(1) control
// points, and draw nothing. A generalised cylinder is an axis of its own, its rings are nodes; with
// a contour they have sections (NodeSection). Behind a control point the first ring's segment has
// the colour set there, all others up to the next point have that point's.
//
// Radii are half the line width: at each node of the segment that starts there, at an axis' tip
// what its last segment has or what is set behind it. With `radii: pipe` in the view they follow
// from the pipe model.
//
// Fails, as the user's fault, beyond the limits in the options and when the homomorphism does not
// end.
//
// Materials are the view's, by turtle colour; a colour that has none is bark.
Result<TurtlePlant> interpret_with_warnings(Model const& model, ModuleString const& string,
                                            TurtleOptions const& options = {});

// Interprets likewise, and drops the warnings.
Result<Plant> interpret(Model const& model, ModuleString const& string,
                        TurtleOptions const& options = {});

} // namespace tractus::lsystem
