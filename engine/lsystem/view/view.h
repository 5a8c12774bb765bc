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

// A direction that bends the turtle's heading before each step. In the turtle's frame (+y up).
struct Tropism {
    Vec3 direction = Vec3::UnitY(); // Its length is the intensity, at most 1.
    double angle_deg = 0;           // 0 towards the direction, 90 perpendicular to it.
    double elasticity = 0;          // Initial.
    double elasticity_step = 0;     // Change by @Ti and @Td.
    bool is_torque = false;         // Twists about the heading instead of bending it.
};

// A table of a curve y(x) over x from 0 to 1, from a function file of cpfg's.
struct FunctionTable {
    std::string name;
    std::vector<double> values;

    // Linear between the samples; x is clamped to [0, 1].
    double at(double x) const;
};

// An organ shape and the symbol that places it: ~ and the letter.
struct OrganDefinition {
    char letter = 'l';
    // Lengths in turtle units, not millimetres; material as a turtle colour index.
    OrganShape shape;
    // Grown leaves, of which each organ has one, instead of the shape; mostly none.
    std::vector<OrganShape> leaves {};
};

// Geometry that a view file (.v) describes. Angles in degrees, lengths in turtle units.
//
// Besides cpfg's statements there are seven of our own, which cpfg reports and skips:
//   material: INDEX NAME kind=bark|stem|leaf|petal|solid color=R,G,B [roughness=] [translucency=]
//   [texture=FILE.png]
//     INDEX is the turtle's colour, as ; and , set it. color is sRGB, 0 to 1. texture names a PNG
//     file in the model's folder, at most 16 MiB and 16 million pixels, whose picture stands for
//     the colour: that is the picture's mean then. On a surface its left and right edges are on
//     the left and right boundaries, its lower edge on the base and its upper one on the tip
//     (engine/mesh/surface_mesh.h), on blades likewise on their box, seen from above. What is
//     less than half there is not there. On stems it is repeated, around and along.
//   color: INDEX R,G,B [roughness=] [translucency=]
//     A material by its colour alone, where no material: has the index (color_files.h).
//   organ: LETTER NAME kind=blade|needle|disc|ball material=INDEX length= width= [petiole=]
//   [widest=]
//          [tip=] [base=] [lobes=] [lobe_count=] [fold=DEG] [curl=DEG]
//     drawn by ~LETTER; lengths at scale 1. See engine/plant/organ_shape.h for the others.
//   leaf: LETTER GRAMMAR [variants=] [age=]
//     makes the blade of an organ: above a grown leaf: one of 1 to 64 different ones, by chance.
//     Its blade is as long as the organ's without the petiole, its width is its own; fold and curl
//     stay the organ's. The organ's material, from above too, gets the leaves' pictures. See
//     leaf_sheet.h.
//   calendar: LETTER evergreen
//   calendar: LETTER [opens=] [grown=] [turns=] [bare=]
//     the year of an organ: above, in months (engine/plant/organ_calendar.h).
//   radii: pipe EXPONENT TIP_RADIUS
//     radii by the pipe model instead of the turtle's line width.
//   environment: light|space|terrain|water [KEY=NUMBER…]
//     answers the model's ?E modules (environments.h); cpfg's files of environments are not read.
struct View {
    double angle_increment_deg = 45;
    double line_width = 0.1;
    double line_width_step = 0;
    double width_unit = 1; // Meaning of a width of 1: less where widths are pixels.
    double scale = 1;
    double scale_step = 1;      // Step of @Di and @Dd without a parameter.
    bool draws_past_cut = true; // Draws what follows a % in the string.
    int color = 0;
    int color_step = 1;
    Vec3 tropism_direction = Vec3::UnitY(); // The older, single tropism; _ sets its elasticity.
    double elasticity = 0;
    double elasticity_step = 0;
    std::vector<Tropism> tropisms;
    std::vector<FunctionTable> functions; // func(1, x) is the first.
    std::vector<CurveTable> curves;       // curveX(1, t) is the first.
    std::map<int, Contour> contours;      // Keyed by the number that @# names.
    int contour_sides = 8;
    bool twist_of_cylinders = false;        // Generalised cylinders turn with the turtle's rolls.
    std::map<char, BezierSurface> surfaces; // Keyed by the letter that ~ names.
    std::map<int, Material> materials;      // Keyed by turtle colour.
    std::vector<OrganDefinition> organs;
    EnvironmentChoice environment; // Answers the model's ?E modules.
    bool pipe_model = false;
    double pipe_exponent = 2;
    double pipe_tip_radius = 0.05;
    std::vector<std::string> warnings;
};

// Reads a view file. Fails, as the user's fault, with "FILE:LINE:COLUMN: …". `include` gives the
// files that it names too; one that cannot be read is a warning, which says what happens instead.
Result<View> parse_view(std::string const& name, std::string_view text,
                        IncludeReader const& include);

} // namespace tractus::lsystem
