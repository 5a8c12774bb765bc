#pragma once

#include "engine/base/result.h"
#include "engine/methods/leaves/leaf_expression.h"
#include "engine/methods/leaves/leaf_map.h"
#include "engine/methods/leaves/leaf_outline.h"

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tractus::leaf {

// Position in a grammar's text; line and column count from 1.
struct TextPlace {
    int line = 1;
    int column = 1;
};

// A face's attributes in the order of the text: number of edges, translation coefficient, rotations
// about the face's x, y and z (degrees), length and width.
constexpr std::size_t kAttributes = 7;
using Attributes = std::array<double, kAttributes>;
constexpr std::size_t kEdgeCount = 0;
constexpr std::size_t kTranslation = 1;
constexpr std::size_t kTwist = 2;
constexpr std::size_t kBend = 3;
constexpr std::size_t kLength = 5;

// Expressions that override a face's attributes, in their order; an empty expression leaves its
// attribute unchanged. The list can be shorter than that of the attributes.
using Fields = std::vector<Expression>;

struct Statement {
    std::size_t name = 0;
    Expression value;
};

// "[B(,,,,,2,)]E": a new face B, its attribute overrides, the faces that in turn grow on it, and
// the edge of the parent face on which it grows.
struct Child {
    char face = 'A';
    Fields fields;
    std::vector<Child> children;
    EdgeLabel edge = EdgeLabel::Extremity;
    TextPlace place;
    TextPlace edge_place;
};

struct Growing {
    Fields fields; // Attributes that the rule overrides in the parent face itself.
    std::vector<Child> children;
};

// "OBC": a face is split parallel to its edge O into a face B, which gets that edge, and a face C.
struct Splitting {
    EdgeLabel edge = EdgeLabel::Origin;
    char near = 'A';
    char far = 'A';
};

// An edge of a face type, such as "B_C2".
struct FaceEdge {
    char face = 'A';
    EdgeLabel edge = EdgeLabel::Origin;

    bool operator==(FaceEdge const&) const = default;
};

struct Gluing {
    FaceEdge first;
    FaceEdge second;
};

struct Rule {
    std::string name;
    TextPlace place;
    char face = 'A';
    // Names that the rule gives to the attributes of its face, by name index; no value for an
    // attribute without a name.
    std::vector<std::optional<std::size_t>> formal;
    std::vector<Statement> always;
    Expression condition; // Condition of the rule; empty: always true.
    std::vector<Statement> if_met;
    std::variant<Growing, Splitting, Gluing> kind;
};

// A leaf grammar (Peyrat, Terraz, Mérillou, Galin, "Generating vast varieties of realistic leaves
// with parametric 2Gmap L-systems", The Visual Computer 24, 2008).
struct Grammar {
    std::string name; // Name of the grammar's file, for messages.
    std::map<char, Attributes> faces;
    NameTable names;
    std::map<std::size_t, double> variables; // Initial values of variables, by name index.
    char axiom = 'A';
    Fields axiom_fields;
    std::vector<Rule> rules;
    // #base: the limb extends down to the petiole.
    bool has_base = false;
    // #bare: letters of the faces to whose edges no limb is attached.
    std::set<char> bare;
    // #reach: letters of the faces whose length is a share of the distance from their beginning to
    // the outline.
    std::set<char> reaching;
    // #outline and #margin: the right half of the margin between vein tips, in the frame of the
    // petiole's end.
    HalfOutline outline;
    // #left: points of the left half outline, with x positive to the left. Empty if it is the
    // mirror image of the right half.
    std::vector<HalfOutline::Point> left;
    // #steps and #size: number of derivation steps and size of the adult leaf; 0 if not given.
    int steps = 0;
    double size_mm = 0; // Length of the adult leaf's blade.
    // #young and #old: colours of a young and an old leaf, sRGB from 0 to 1.
    Vec3 young { 0.36, 0.54, 0.22 };
    Vec3 old { 0.72, 0.50, 0.16 };

    // The left half outline, with the margin shape (teeth or scallops) that both halves share.
    HalfOutline left_outline() const
    {
        auto half = outline;
        if (!left.empty())
            half.points = left;
        return half;
    }
};

// Parses a grammar. Fails with a user error of one sentence that gives file, line and column. Safe
// for arbitrary input.
Result<Grammar> parse_grammar(std::string_view text, std::string const& name);

} // namespace tractus::leaf
