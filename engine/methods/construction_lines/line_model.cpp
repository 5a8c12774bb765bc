#include "engine/methods/construction_lines/line_model.h"

#include "engine/methods/construction_lines/function_curves.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <string_view>

namespace tractus::lines {

namespace {

// A negative number must not run into the sign before it, where a macro is replaced.
std::string number(double value)
{
    auto const text = fmt::format("{:.6g}", value + 0.0);
    return text.front() == '-' ? "(" + text + ")" : text;
}

template<typename Values, typename Read> std::string list(Values const& values, Read const& read)
{
    std::string text;
    for (auto const& value : values)
        text += fmt::format("{}{:.6g}", text.empty() ? "" : ", ", read(value));
    return "{" + text + "}";
}

// Where the stem turns more than a little within a piece, pieces have to be shorter.
double longest_piece(DrawnStem const& stem)
{
    constexpr int kSteps = 100;
    constexpr double kCurved_deg = 2; // Within a hundredth of the stem.
    constexpr double kCorner_deg = 5;
    if (stem.sharpest_deg() > kCorner_deg)
        return kShortPiece;
    for (int i = 1; i <= kSteps; ++i) {
        auto const before = stem.course((i - 1.0) / kSteps);
        auto const after = stem.course(static_cast<double>(i) / kSteps);
        if (std::fabs(after.heading_deg - before.heading_deg) > kCurved_deg
            || std::fabs(after.pitch_deg - before.pitch_deg) > kCurved_deg)
            return kShortPiece;
    }
    return kLongPiece;
}

std::string definitions(Construction const& construction, Pattern const& pattern)
{
    double const length_cm = construction.stem.length_mm();
    bool const flat = pattern.kind == Pattern::Kind::Distichous;
    auto text = fmt::format(
        "#define LEN        {:.6g}    /* of the stem, cm */\n"
        "#define STEM       (LEN / 60)    /* the stem's diameter at its foot, cm */\n"
        "#define DX         {}    /* the longest piece the stem is drawn in, by LEN */\n"
        "#define ROLL       {}    /* of organs: 0 flat as in a frond, (-90) upper side up */\n"
        "#define LAYERS     {}\n",
        length_cm, longest_piece(construction.stem), flat ? "0" : "(-90)",
        construction.nodes_per_layer.size());
    if (pattern.kind == Pattern::Kind::Spiral || pattern.kind == Pattern::Kind::Alternate)
        text += fmt::format("#define DIVERGENCE {}    /* from organ to organ, degrees */\n",
                            number(pattern.divergence_deg));
    if (pattern.kind == Pattern::Kind::Whorled)
        text += fmt::format("#define WHORL      {}    /* how many organs stand at a node */\n",
                            pattern.whorl);
    return text;
}

std::string arrays(Construction const& construction)
{
    auto const& layers = construction.nodes_per_layer;
    return fmt::format(
        "define: {{ array at[{}] = {};\n"
        "          array nodes[{}] = {}; }}\n",
        construction.inclinations.size(),
        list(construction.inclinations, [](Inclination const& line) { return line.x; }),
        layers.size(), list(layers, [](int count) { return static_cast<double>(count); }));
}

// The apex and, in homomorphism, the stem: the pieces' turns add up to the heading function's, so
// at each node the turtle heads exactly along the stem.
constexpr std::string_view kStemRules = R"(Axiom: +(func(1, 0))^(func(2, 0))A(0, 0, 0, 0)

/* The apex at x, in layer k between the lines at[k] and at[k + 1], makes the layer's node j. It is
   the stem's node i. Above the topmost line the stem goes on to its end. */
A(x, k, j, i) : k < LAYERS && nodes[k] == 0 --> A(x, k + 1, 0, i)
A(x, k, j, i) : k < LAYERS
    {
        y = at[k] + (at[k + 1] - at[k]) * j / nodes[k];
        m = k;
        n = j + 1;
        if (n >= nodes[k]) { m = k + 1; n = 0; }
    }
    --> S(x, y)B(y, i)A(y, m, n, i + 1)
A(x, k, j, i) : * --> S(x, at[LAYERS])B(at[LAYERS], i)S(at[LAYERS], 1)

homomorphism
maximum depth: 12
/* The stem from x to y, in short pieces. */
S(x, y) : y - x > DX --> S(x, (x + y) / 2)S((x + y) / 2, y)
S(x, y) : y > x
    { m = (x + y) / 2; }
    --> !(STEM * (1 - 0.7 * m))
        &(func(2, x))+(func(1, m) - func(1, x))^(func(2, m))F(LEN * (y - x))
        &(func(2, m))+(func(1, y) - func(1, m))^(func(2, y))
S(x, y) : * --> *
)";

constexpr std::string_view kDistichous = R"(/* An organ on the left and one on the right. */
B(x, i) --> [+(func(3, x))/(ROLL)~l(LEN * func(5, x))][-(func(4, x))/(0 - ROLL)~l(LEN * func(6, x))]
)";

constexpr std::string_view kDecussate
    = R"(/* Pairs of organs: left and right, then behind and in front. */
B(x, i) : floor(i / 2) * 2 == i
    --> [+(func(3, x))/(ROLL)~l(LEN * func(5, x))][/(180)+(func(4, x))/(ROLL)~l(LEN * func(6, x))]
B(x, i) : *
    { a = (func(3, x) + func(4, x)) / 2; h = LEN * (func(5, x) + func(6, x)) / 2; }
    --> [/(90)+(a)/(ROLL)~l(h)][/(270)+(a)/(ROLL)~l(h)]
)";

// The remainder is written out: cpfg's % takes integers.
constexpr std::string_view kSpiral
    = R"(/* An organ t degrees around the stem from its left: a of the left's, b of the right's. */
B(x, i) : *
    { t = i * DIVERGENCE - 360 * floor(i * DIVERGENCE / 360); b = 1 - fabs(t / 180 - 1); a = 1 - b; }
    --> [/(t)+(a * func(3, x) + b * func(4, x))/(ROLL)~l(LEN * (a * func(5, x) + b * func(6, x)))]
)";

constexpr std::string_view kWhorled
    = R"(/* Organ j of a whorl, t degrees around the stem from its left: a of the left's, b of the
   right's. Every other whorl is turned by half the way from organ to organ. */
W(x, i, j) : *
    { t = (360 * j + 180 * (i - 2 * floor(i / 2))) / WHORL; b = 1 - fabs(t / 180 - 1); a = 1 - b; }
    --> /(t)+(a * func(3, x) + b * func(4, x))/(ROLL)~l(LEN * (a * func(5, x) + b * func(6, x)))
)";

constexpr std::string_view kBare = R"(/* Nothing stands on the stem. */
B(x, i) : * --> *
)";

std::string organ_rules(Pattern const& pattern)
{
    switch (pattern.kind) {
    case Pattern::Kind::Distichous:
        return std::string(kDistichous);
    case Pattern::Kind::Decussate:
        return std::string(kDecussate);
    case Pattern::Kind::Spiral:
    case Pattern::Kind::Alternate:
        return std::string(kSpiral);
    case Pattern::Kind::Bare:
        return std::string(kBare);
    case Pattern::Kind::Whorled:
        break;
    }
    std::string text = "B(x, i) -->";
    for (int j = 0; j < pattern.whorl; ++j)
        text += fmt::format(" [W(x, i, {})]", j);
    return text + "\n" + std::string(kWhorled);
}

std::string view_text(std::vector<FunctionCurve> const& curves, Pattern const& pattern,
                      std::string const& name)
{
    constexpr double kBroad = 0.4;
    constexpr double kSlender = 0.25; // Leaflets of a frond, side by side.
    std::string text = "angle increment: 45\n"
                       "initial line width: 1\n"
                       "initial color: 1\n";
    for (auto const& curve : curves)
        text += fmt::format("function: {}_{}.func {}\n", name, curve.name, kFunctionSamples);
    text += "material: 1 stem kind=stem color=0.36,0.46,0.20 roughness=0.7\n"
            "material: 2 leaf kind=leaf color=0.26,0.46,0.16 roughness=0.5 translucency=0.45\n";
    return text
        + fmt::format("organ: l leaf kind=blade material=2 length=1 width={} petiole=0 widest=0.4 "
                      "tip=0.8 base=0.5 fold=8 curl=0\n",
                      pattern.kind == Pattern::Kind::Distichous ? kSlender : kBroad);
}

// One for each node, and one more for each layer that has none.
std::size_t count_steps(Construction const& construction)
{
    auto const& layers = construction.nodes_per_layer;
    return construction.nodes.size()
        + static_cast<std::size_t>(std::count(layers.begin(), layers.end(), 0));
}

} // namespace

LineModel write_model(Construction const& construction, Pattern const& pattern,
                      std::string const& name)
{
    auto const curves = function_curves(construction);
    LineModel model;
    for (auto const& curve : curves)
        model.functions[fmt::format("{}_{}.func", name, curve.name)] = function_file(curve);
    model.source.name = name + ".l";
    model.source.view_name = name + ".v";
    model.source.view_text = view_text(curves, pattern, name);
    model.source.text = fmt::format(
        "/* A plant from construction lines, its organs {}. The functions of the place x on the "
        "stem,\n"
        "   0 to 1, are files that the view names: 1 the stem's heading, 2 its depth, 3 and 4 the\n"
        "   organs' angles on the left and the right, 5 and 6 their sizes; 7, the way to the next "
        "node,\n"
        "   is for other models. A step makes a node. */\n"
        "{}\n"
        "Lsystem: 1\n"
        "derivation length: {}\n"
        "{}{}{}endlsystem\n",
        name_of(pattern.kind), definitions(construction, pattern), count_steps(construction),
        arrays(construction), kStemRules, organ_rules(pattern));
    return model;
}

std::vector<Vec3> organ_tips(Construction const& construction, Plant const& plant)
{
    constexpr double kPlantScale = 10; // A millimetre becomes a centimetre.
    Vec3 const base = construction.stem.point(0);
    std::vector<Vec3> tips;
    for (auto const& organ : plant.organs) {
        double const length_mm
            = plant.organ_shapes[organ.shape].length_mm * static_cast<double>(organ.scale.y());
        Vec3 const tip_mm = organ.position_mm + organ.orientation * Vec3(0, length_mm, 0);
        tips.emplace_back(base + Vec3(tip_mm.x(), tip_mm.z(), -tip_mm.y()) / kPlantScale);
    }
    return tips;
}

} // namespace tractus::lines
