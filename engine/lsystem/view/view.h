#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/lsystem/text/source_text.h"
#include "engine/lsystem/view/curve_file.h"
#include "engine/lsystem/view/environment_choice.h"
#include "engine/lsystem/view/surface_file.h"
#include "engine/plant/contour.h"
#include "engine/plant/material.h"
#include "engine/plant/organ_shape.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::lsystem {

// A tropism: a direction in cpfg's space (+y up) towards which the turtle's heading bends before
// each step.
struct Tropism {
    // Direction of the tropism; its length is the intensity, at most 1.
    Vec3 direction = Vec3::UnitY();
    // Angle between the heading that the tropism prefers and its direction: 0 along it, 90
    // perpendicular to it.
    double angle_deg = 0;
    double elasticity = 0;      // Initial elasticity of the tropism.
    double elasticity_step = 0; // Change of the elasticity by @Ti and @Td that give no step.
    // True: the tropism rolls the turtle about its heading instead of bending the heading.
    bool is_torque = false;
};

// A tabulated function y(x), for x from 0 to 1, from a function file of cpfg.
struct FunctionTable {
    std::string name;
    std::vector<double> values;

    // Returns the value at x, interpolated linearly between the samples. x is clamped to [0, 1].
    double at(double x) const;
};

// The shape of an organ, and the letter after ~ in the organ's symbol.
struct OrganDefinition {
    char letter = 'l';
    // Shape of the organ. Its lengths are in turtle units instead of millimetres; its material is a
    // turtle colour.
    OrganShape shape;
    // Grown leaves, one of which replaces the shape of each organ; usually empty.
    std::vector<OrganShape> leaves {};
};

// Contents of a view file (.v): the geometry and appearance of a model. Angles are in degrees,
// lengths in turtle units.
//
// Besides cpfg's statements there are seven additional ones, which cpfg reports and skips:
//   material: INDEX NAME kind=bark|stem|leaf|petal|solid color=R,G,B [roughness=] [translucency=]
//   [bark=KIND] [texture=FILE.png]
//     Defines a material. INDEX is the turtle's colour, as set by ; and ,. color is sRGB, 0 to 1.
//     texture names a PNG file in the model's folder, at most 16 MiB and 16 million pixels; it
//     replaces the colour, which becomes its mean. On a surface the picture's left and right edges
//     lie on the left and right boundaries, its lower edge on the base and its upper edge on the
//     tip (engine/mesh/surface_mesh.h); on a blade they lie on its bounding box, seen from above.
//     Pixels with alpha below one half are cut out. On stems the picture repeats around and along.
//     bark gives bark the pattern of a species: KIND is one of kBarkNames (engine/plant/bark.h) for
//     an old trunk, or one of them after young- for its limbs.
//   color: INDEX R,G,B [roughness=] [translucency=]
//     Defines a material by its colour only, unless material: has the index (color_files.h).
//   organ: LETTER NAME kind=blade|needle|disc|ball material=INDEX length= width= [petiole=]
//   [widest=]
//          [tip=] [base=] [lobes=] [lobe_count=] [fold=DEG] [curl=DEG]
//     Defines the shape that ~LETTER draws; lengths at scale 1. The other fields are described in
//     engine/plant/organ_shape.h.
//   leaf: LETTER GRAMMAR [variants=] [age=]
//     Replaces the blade of an organ defined above by one of 1 to 64 grown leaves, chosen at
//     random. The blade keeps the organ's length without petiole, and its fold and curl, but has
//     its own width. The organ's material, also defined above, gets the leaves' pictures. See
//     leaf_sheet.h.
//   calendar: LETTER evergreen
//   calendar: LETTER [opens=] [grown=] [turns=] [bare=]
//     Sets the season of an organ defined above, in months (engine/plant/organ_calendar.h).
//   radii: pipe EXPONENT TIP_RADIUS
//     Computes radii by the pipe model instead of the turtle's line width.
//   environment: light|space|terrain|water [KEY=NUMBER...]
//     Answers the model's ?E modules (environments.h); cpfg's environment files are not read.
struct View {
    double angle_increment_deg = 45;
    double line_width = 0.1;
    double line_width_step = 0;
    // Factor from line widths to turtle units: less than 1 if widths are in pixels.
    double width_unit = 1;
    double scale = 1;
    double scale_step = 1;      // Factor of @Di and @Dd without a parameter.
    bool draws_past_cut = true; // True: what follows a % in the string is drawn, too.
    int color = 0;
    int color_step = 1;
    // Direction of the single tropism of the older kind, whose elasticity _ sets.
    Vec3 tropism_direction = Vec3::UnitY();
    double elasticity = 0;
    double elasticity_step = 0;
    std::vector<Tropism> tropisms;
    std::vector<FunctionTable> functions; // Functions; func(1, x) evaluates the first.
    std::vector<CurveTable> curves;       // Curves; curveX(1, t) evaluates the first.
    std::map<int, Contour> contours;      // Contours, keyed by the number after @#.
    int contour_sides = 8;
    bool twist_of_cylinders = false; // True: generalised cylinders follow the turtle's rolls.
    std::map<char, BezierSurface> surfaces; // Surfaces, keyed by the letter after ~.
    std::map<int, Material> materials;      // Materials, keyed by turtle colour.
    std::vector<OrganDefinition> organs;
    EnvironmentChoice environment; // Environment that answers the model's ?E modules.
    bool pipe_model = false;
    double pipe_exponent = 2;
    double pipe_tip_radius = 0.05;
    std::vector<std::string> warnings;
};

// Reads a view file. Fails with a user error of the form "FILE:LINE:COLUMN: ...". `include` also
// provides the files that the view names. If one of these cannot be read, a warning says what
// happens instead.
Result<View> parse_view(std::string const& name, std::string_view text,
                        IncludeReader const& include);

} // namespace tractus::lsystem
