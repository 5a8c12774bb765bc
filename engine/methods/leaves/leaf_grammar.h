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

// Where something stands in a grammar's text; both count from 1.
struct TextPlace {
    int line = 1;
    int column = 1;
};

// A face's attributes in the text's order: number of edges, translation coefficient, rotations
// about the face's x, y and z (degrees), length and width.
constexpr std::size_t kAttributes = 7;
using Attributes = std::array<double, kAttributes>;
constexpr std::size_t kEdgeCount = 0;
constexpr std::size_t kTranslation = 1;
constexpr std::size_t kTwist = 2;
constexpr std::size_t kBend = 3;
constexpr std::size_t kLength = 5;

// Values that overload attributes; empty expressions leave them as they are. There may be fewer
// than attributes.
using Fields = std::vector<Expression>;

struct Statement {
    std::size_t name = 0;
    Expression value;
};

// "[B(,,,,,2,)]E": a face, what overloads its attributes, what grows on it in turn, and the edge
// of its parent on which it grows.
struct Child {
    char face = 'A';
    Fields fields;
    std::vector<Child> children;
    EdgeLabel edge = EdgeLabel::Extremity;
    TextPlace place;
    TextPlace edge_place;
};

struct Growing {
    Fields fields; // Fields of the parent's face.
    std::vector<Child> children;
};

// "OBC": parallel to the edge O, into B, which has it, and C.
struct Splitting {
    EdgeLabel edge = EdgeLabel::Origin;
    char near = 'A';
    char far = 'A';
};

// An edge of a kind of face: "B_C2".
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
    // The names of the face's own attributes, as the text numbers them; no value for one without.
    std::vector<std::optional<std::size_t>> formal;
    std::vector<Statement> always;
    Expression condition; // Empty: always met.
    std::vector<Statement> if_met;
    std::variant<Growing, Splitting, Gluing> kind;
};

// A leaf grammar (Peyrat, Terraz, Mérillou, Galin, "Generating vast varieties of realistic leaves
// with parametric 2Gmap L-systems", The Visual Computer 24, 2008).
struct Grammar {
    std::string name; // The file's name, for messages.
    std::map<char, Attributes> faces;
    NameTable names;
    std::map<std::size_t, double> variables; // Values at the beginning.
    char axiom = 'A';
    Fields axiom_fields;
    std::vector<Rule> rules;
    // The limb reaches the stalk: #base.
    bool has_base = false;
    // Faces whose edges no limb is fastened to: #bare.
    std::set<char> bare;
    // Faces whose length is a share of the way from where they start to the outline: #reach.
    std::set<char> reaching;
    // The margin between vein tips, in the frame of the stalk's end: #outline and #margin.
    HalfOutline outline;
    // The left half where it differs from the right one, its x to the left: #left. None: it mirrors
    // the right half.
    std::vector<HalfOutline::Point> left;
    // Properties of the adult leaf: #steps, #size. 0: the text says nothing.
    int steps = 0;
    double size_mm = 0; // The blade's length.
    // sRGB, 0 to 1: #young and #old.
    Vec3 young { 0.36, 0.54, 0.22 };
    Vec3 old { 0.72, 0.50, 0.16 };

    // The left half with the margin that both halves have.
    HalfOutline left_outline() const
    {
        auto half = outline;
        if (!left.empty())
            half.points = left;
        return half;
    }
};

// Fails, as the user's fault, with file, line and column and one sentence. Any text is safe to
// give.
Result<Grammar> parse_grammar(std::string_view text, std::string const& name);

} // namespace tractus::leaf
