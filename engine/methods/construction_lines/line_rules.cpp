#include "engine/methods/construction_lines/line_rules.h"

#include "engine/methods/construction_lines/model_text.h"

#include <array>
#include <cstddef>
#include <fmt/format.h>
#include <string_view>
#include <utility>
#include <vector>

namespace tractus::lines {

namespace {

// A placeholder in the text of rules. Each rule is written only once; placeholders in <> stand for
// the text that differs between a single stem, several stems, and a stem whose organs are sketches.
struct RuleWord {
    std::string_view word;
    std::string_view one;      // Replacement for a single stem.
    std::string_view several;  // Replacement for several stems.
    std::string_view composed; // Replacement for a stem whose organs are sketches.
};
constexpr std::array<RuleWord, 9> kRuleWords { {
    { "<s>", "", "s, ", "" },         // Number of the stem, the first parameter of modules.
    { "<t>", "", ", t", "" },         // Number of the next stem attached to stem s.
    { "<low>", "", "low[s] + ", "" }, // Offset of the stem's inclination lines in at[] and nodes[].
    // Offset of the functions for the stem's heading and depth.
    { "<own>", "", "own[s] + ", "<offset> + " },
    // Offset of the functions for the stem's organs.
    { "<organs>", "", "organs[s] + ", "<offset> + " },
    { "<first>", "", "first[s] + ", "" },        // Offset of the stem's boundaries in azimuth[].
    { "<sides>", "SIDES", "sides[s]", "SIDES" }, // Number of the stem's boundaries.
    { "<ofs>", "", " of stem s", "" },
    // Share of the diameter that a stem loses towards its top.
    { "<taper>", "0.7", "taper[s]", "0.7" },
} };

// A placeholder in the text of rules for text that depends on whether layers bear different organs.
struct LayerWord {
    std::string_view word;
    std::string_view alike;
    std::string_view of_one;     // Replacement for a single stem with different organs.
    std::string_view of_several; // Replacement for several stems with different organs.
};
constexpr std::array<LayerWord, 5> kLayerWords { {
    { "<layer>", "", ", k", ", low[s] + k" }, // Layer of a node, as a parameter of its organs.
    { "<toplayer>", "", ", LAYERS - 1", ", low[s] + LAYERS - 1" },
    { "<z>", "", ", z", ", z" }, // Layer, as a parameter of organs within their own rules.
    { "<leaf>", "~l(LEN * ", "Q(z, ", "Q(s, z, " },
    { "<leaf h>", "~l(h)", "Q(z, h / LEN)", "Q(s, z, h / LEN)" },
} };

std::string filled_in(std::string text, Stems stems, bool by_layer)
{
    bool const several = stems == Stems::Several;
    for (auto const& [word, alike, of_one, of_several] : kLayerWords)
        replace_all(text, word, !by_layer ? alike : several ? of_several : of_one);
    for (auto const& [word, one, of_several, composed] : kRuleWords)
        replace_all(text, word, several ? of_several : stems == Stems::One ? one : composed);
    return text;
}

// Rules for the apex and, as homomorphism, for the stem. The turns of the stem's pieces add up to
// the value of the heading function, so the turtle's heading at each node is exactly along the
// stem.
constexpr std::string_view kApex
    = R"(/* The apex<ofs> at x, in layer k between the lines at[<low>k] and at[<low>k + 1], makes the layer's node j. It is
   the stem's node i. Above the topmost line the stem goes on to its end. */
A(<s>x, k, j, i<t>) : k < LAYERS && nodes[<low>k] == 0 --> A(<s>x, k + 1, 0, i<t>)
)";

// Rules for lateral stems. They must precede the rules that make nodes.
constexpr std::string_view kBearing = R"(/* Stem t stands on stem s below its next node y. */
A(s, x, k, j, i, t) :
    {
        y = 1;
        if (k <= LAYERS) { y = at[low[s] + k]; }
        if (j > 0) { y = y + (at[low[s] + k + 1] - y) * j / nodes[low[s] + k]; }
    }
    t < bears[s + 1] && foot[t] <= y
    --> S(s, x, foot[t])
        [&(func(own[s] + 2, foot[t]))+(func(own[t] + 1, 0) - func(own[s] + 1, foot[t]))
         ^(func(own[t] + 2, 0))A(t, 0, 0, 0, 0, bears[t])]
        A(s, foot[t], k, j, i, t + 1)
)";

constexpr std::string_view kApexNodes = R"(A(<s>x, k, j, i<t>) : k < LAYERS
    {
        y = at[<low>k] + (at[<low>k + 1] - at[<low>k]) * j / nodes[<low>k];
        m = k;
        n = j + 1;
        if (n >= nodes[<low>k]) { m = k + 1; n = 0; }
    }
    --> S(<s>x, y)B(<s>y, i<layer>)A(<s>y, m, n, i + 1<t>)
)";

constexpr std::string_view kTop
    = "A(x, k, j, i) : * --> S(x, at[LAYERS])B(at[LAYERS], i<toplayer>)S(at[LAYERS], 1)\n";

// Rules that draw several stems from their topmost inclination line to their top.
constexpr std::string_view kTopOfSeveral = R"(A(s, x, k, j, i, t) : k == LAYERS
    { y = at[low[s] + k]; }
    --> S(s, x, y)B(s, y, i<toplayer>)A(s, y, k + 1, 0, i + 1, t)
A(s, x, k, j, i, t) : * --> S(s, x, 1)
)";

constexpr std::string_view kStemPieces = R"(
homomorphism
maximum depth: 12
/* The stem<ofs> from x to y, in short pieces. */
S(<s>x, y) : y - x > DX --> S(<s>x, (x + y) / 2)S(<s>(x + y) / 2, y)
S(<s>x, y) : y > x
    { m = (x + y) / 2; }
    --> !(STEM * (1 - <taper> * m))
        &(func(<own>2, x))+(func(<own>1, m) - func(<own>1, x))^(func(<own>2, m))F(LEN * (y - x))
        &(func(<own>2, m))+(func(<own>1, y) - func(<own>1, m))^(func(<own>2, y))
S(<s>x, y) : * --> *
)";

constexpr std::string_view kDistichous = R"(/* An organ on the left and one on the right. */
B(<s>x, i<z>)<if> --> [+(func(<organs>3, x))/(ROLL)<leaf>func(<organs>5, x))][-(func(<organs>4, x))/(0 - ROLL)<leaf>func(<organs>6, x))]
)";

constexpr std::string_view kDecussate
    = R"(/* Pairs of organs: left and right, then behind and in front. */
B(<s>x, i<z>) : <and>floor(i / 2) * 2 == i
    --> [+(func(<organs>3, x))/(ROLL)<leaf>func(<organs>5, x))][/(180)+(func(<organs>4, x))/(ROLL)<leaf>func(<organs>6, x))]
B(<s>x, i<z>) : <any>
    { a = (func(<organs>3, x) + func(<organs>4, x)) / 2; h = LEN * (func(<organs>5, x) + func(<organs>6, x)) / 2; }
    --> [/(90)+(a)/(ROLL)<leaf h>][/(270)+(a)/(ROLL)<leaf h>]
)";

// The remainder of the division by 360 is computed with floor() because cpfg's % takes integers.
constexpr std::string_view kSpiral
    = R"(/* An organ t degrees around the stem from its left: a of the left's, b of the right's. */
B(<s>x, i<z>) : <any>
    { t = i * DIVERGENCE - 360 * floor(i * DIVERGENCE / 360); b = 1 - fabs(t / 180 - 1); a = 1 - b; }
    --> [/(t)+(a * func(<organs>3, x) + b * func(<organs>4, x))/(ROLL)<leaf>(a * func(<organs>5, x) + b * func(<organs>6, x)))]
)";

constexpr std::string_view kWhorled
    = R"(/* Organ j of a whorl, t degrees around the stem from its left: a of the left's, b of the
   right's. Every other whorl is turned by half the way from organ to organ. */
W(<s>x, i, j<z>) : <any>
    { t = (360 * j + 180 * (i - 2 * floor(i / 2))) / WHORL; b = 1 - fabs(t / 180 - 1); a = 1 - b; }
    --> /(t)+(a * func(<organs>3, x) + b * func(<organs>4, x))/(ROLL)<leaf>(a * func(<organs>5, x) + b * func(<organs>6, x)))
)";

// Rule for layers that bear plain leaves.
constexpr std::string_view kLeaves = "Q(<s>z, h) : organ[z] == 0 --> ~l(LEN * h)\n<leaves>";

// Rules for patterns whose sizes follow half-ellipses: the size of each organ is computed from its
// azimuth.
constexpr std::string_view kDecussateAround
    = R"(/* Pairs of organs: left and right, then behind and in front. */
B(<s>x, i<z>) : <and>floor(i / 2) * 2 == i
    --> [+(func(<organs>3, x))/(ROLL)<leaf>func(<organs>5, x))][/(180)+(func(<organs>4, x))/(ROLL)<leaf>func(<organs>6, x))]
B(<s>x, i<z>) : <any> --> [O(<s>x, 90<z>)][O(<s>x, 270<z>)]
)";

constexpr std::string_view kSpiralAround = R"(/* An organ i times the divergence around the stem. */
B(<s>x, i<z>) : <any> --> [O(<s>x, i * DIVERGENCE - 360 * floor(i * DIVERGENCE / 360)<z>)]
)";

constexpr std::string_view kWhorledAround
    = R"(/* Organ j of a whorl. Every other whorl is turned by half the way from organ to organ. */
W(<s>x, i, j<z>) : <any>
    { t = (360 * j + 180 * (i - 2 * floor(i / 2))) / WHORL; }
    --> O(<s>x, t<z>)
)";

// Rule that computes an organ's size from its azimuth like size_between() (around_stem.h).
constexpr std::string_view kAround
    = R"(/* An organ t degrees around the stem from its left: its angle has a of the left's, b of the right's. Its size
   lies between those of boundary k and the next one, m, which are "far" degrees apart; the organ stands u degrees
   behind k. Up to a right angle it is on a quarter of an ellipse between them, from half a turn on on two quarters
   with the mean as a half-axis in the middle, and else between both. Where a third boundary, p before them or n behind
   them, stands within half a turn it is drawn to the ellipse through the three. q and e are 1 / size ^ 2. */
O(<s>x, t<z>) : *
    {
        b = 1 - fabs(t / 180 - 1);
        a = 1 - b;
        u = t;
        if (u < azimuth[<first>0]) { u = u + 360; }
        k = 0;
        while (u >= azimuth[<first>k + 1]) { k = k + 1; }
        m = k + 1;
        if (m == <sides>) { m = 0; }
        n = m + 1;
        if (n == <sides>) { n = 0; }
        p = k - 1;
        if (p < 0) { p = <sides> - 1; }
        u = u - azimuth[<first>k];
        far = azimuth[<first>k + 1] - azimuth[<first>k];
        before = azimuth[<first>p + 1] - azimuth[<first>p];
        behind = azimuth[<first>m + 1] - azimuth[<first>m];
        g = func(<organs>8 + k, x);
        if (g < 0.000001) { g = 0.000001; }
        h = func(<organs>8 + m, x);
        if (h < 0.000001) { h = 0.000001; }
        q = cos(90 * u / far) ^ 2 / g ^ 2 + sin(90 * u / far) ^ 2 / h ^ 2;
        e = q;
        if (far + before < 180) {
            c = func(<organs>8 + p, x);
            if (c < 0.000001) { c = 0.000001; }
            c = sin(u) * sin(u - far) / (sin(before) * sin(far + before) * c ^ 2)
                - sin(u + before) * sin(u - far) / (sin(before) * sin(far) * g ^ 2)
                + sin(u + before) * sin(u) / (sin(far + before) * sin(far) * h ^ 2);
            w = (180 - far - before) / 60;
            if (w > 1) { w = 1; }
            e = e + w ^ 2 * (1 - u / far) * (c - q);
        }
        if (far + behind < 180) {
            c = func(<organs>8 + n, x);
            if (c < 0.000001) { c = 0.000001; }
            v = far - u;
            c = sin(v) * sin(v - far) / (sin(behind) * sin(far + behind) * c ^ 2)
                - sin(v + behind) * sin(v - far) / (sin(behind) * sin(far) * h ^ 2)
                + sin(v + behind) * sin(v) / (sin(far + behind) * sin(far) * g ^ 2);
            w = (180 - far - behind) / 60;
            if (w > 1) { w = 1; }
            e = e + w ^ 2 * u / far * (c - q);
        }
        v = g;
        w = h;
        if (g < h) { v = h; w = g; }
        if (e < 0.5 / v ^ 2) { e = 0.5 / v ^ 2; }
        if (e > 2 / w ^ 2) { e = 2 / w ^ 2; }
        c = far / 90 - 1;
        if (c < 0) { c = 0; }
        if (c > 1) { c = 1; }
        v = (g + h) / 2;
        u = u / far;
        if (u > 0.5) { g = h; u = 1 - u; }
        h = 1 / sqrt(cos(180 * u) ^ 2 / g ^ 2 + sin(180 * u) ^ 2 / v ^ 2);
        h = 1 / sqrt(e) + c * (h - 1 / sqrt(e));
    }
    --> /(t)+(a * func(<organs>3, x) + b * func(<organs>4, x))/(ROLL)<leaf>h)
)";

constexpr std::string_view kBare = R"(/* Nothing stands on the stem. */
B(<s>x, i<z>) : <any> --> *
)";

std::string whorl_rules(Pattern const& pattern, std::string_view of_each)
{
    std::string text = "B(<s>x, i<z>)<if> -->";
    for (int j = 0; j < pattern.whorl; ++j)
        text += fmt::format(" [W(<s>x, i, {}<z>)]", j);
    return text + "\n" + std::string(of_each);
}

// Returns the rules of one pattern. Their conditions are still placeholders (<and>, <any>).
std::string pattern_rules(Pattern const& pattern, Pattern::Sizes sizes)
{
    bool const is_linear = sizes == Pattern::Sizes::Linear;
    switch (pattern.kind) {
    case Pattern::Kind::Distichous:
        return std::string(kDistichous);
    case Pattern::Kind::Decussate:
        return std::string(is_linear ? kDecussate : kDecussateAround);
    case Pattern::Kind::Spiral:
    case Pattern::Kind::Alternate:
        return std::string(is_linear ? kSpiral : kSpiralAround);
    case Pattern::Kind::Whorled:
        return whorl_rules(pattern, is_linear ? kWhorled : kWhorledAround);
    case Pattern::Kind::Bare:
        break;
    }
    return std::string(kBare);
}

void set_condition(std::string& rules, std::string const& condition)
{
    replace_all(rules, "<if>", condition.empty() ? "" : " : " + condition);
    replace_all(rules, "<and>", condition.empty() ? "" : condition + " && ");
    replace_all(rules, "<any>", condition.empty() ? "*" : condition);
}

// Returns the rules of all patterns that layers have. The divergence angle and number of organs are
// macros for the first pattern and numbers for the others.
std::string organ_rules(std::vector<Pattern> const& patterns, Pattern::Sizes sizes)
{
    std::string text;
    bool is_around = false;
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        auto rules = pattern_rules(patterns[i], sizes);
        if (i > 0) {
            replace_all(rules, "DIVERGENCE", format_model_number(patterns[i].divergence_deg));
            replace_all(rules, "WHORL", std::to_string(patterns[i].whorl));
        }
        if (patterns.size() > 1)
            text += fmt::format("/* Of pattern {}, {}. */\n", i, name_of(patterns[i].kind));
        set_condition(rules, patterns.size() > 1 ? fmt::format("pattern[z] == {}", i) : "");
        text += rules;
        is_around = is_around || has_organs_all_around(patterns[i]);
    }
    if (sizes == Pattern::Sizes::HalfEllipses && is_around)
        text += kAround;
    return text;
}

} // namespace

std::string stem_rules(Pattern const& pattern, Stems stems, Pattern::Sizes sizes,
                       LayerTables const* layers)
{
    bool const several = stems == Stems::Several;
    std::string text(kApex);
    if (several)
        text += kBearing;
    text += kApexNodes;
    text += several ? kTopOfSeveral : kTop;
    auto organs = organ_rules(layers ? layers->patterns() : std::vector { pattern }, sizes);
    if (layers && !layers->rolls_deg().empty())
        replace_all(organs, "ROLL", "roll[z]");
    if (stems == Stems::Composed)
        text.append(organs).append("<calls>").append(kStemPieces);
    else
        text.append(kStemPieces).append(organs);
    if (layers)
        text += kLeaves;
    return filled_in(std::move(text), stems, layers != nullptr);
}

} // namespace tractus::lines
