#include "engine/methods/construction_lines/line_rules.h"

#include <array>
#include <fmt/format.h>
#include <string_view>

namespace tractus::lines {

namespace {

// Rules are written once. What they say otherwise of a plant of several stems than of a single one
// stands for words in <>.
struct RuleWord {
    std::string_view word;
    std::string_view several; // In a plant of several stems,
    std::string_view one {};  // and of a single one.
};
constexpr std::array<RuleWord, 7> kRuleWords { {
    { "<s>", "s, " },         // The stem's number, the first parameter of modules.
    { "<t>", ", t" },         // The number of the next stem that it bears, the apex's last one.
    { "<low>", "low[s] + " }, // Where its lines begin in at[] and nodes[].
    { "<own>", "own[s] + " }, // Which functions are its heading and depth,
    { "<organs>", "organs[s] + " }, // and which those of its organs.
    { "<ofs>", " of stem s" },
    { "<taper>", "taper[s]", "0.7" }, // How much of its diameter a stem loses up to its top.
} };

std::string filled_in(std::string_view text, Stems stems)
{
    std::string result(text);
    for (auto const& [word, several, one] : kRuleWords)
        for (auto at = result.find(word); at != std::string::npos; at = result.find(word, at))
            result.replace(at, word.size(), stems == Stems::Several ? several : one);
    return result;
}

// The apex and, in homomorphism, the stem: the pieces' turns add up to the heading function's, so
// at each node the turtle heads exactly along the stem.
constexpr std::string_view kApex
    = R"(/* The apex<ofs> at x, in layer k between the lines at[<low>k] and at[<low>k + 1], makes the layer's node j. It is
   the stem's node i. Above the topmost line the stem goes on to its end. */
A(<s>x, k, j, i<t>) : k < LAYERS && nodes[<low>k] == 0 --> A(<s>x, k + 1, 0, i<t>)
)";

// Before the rules that make nodes.
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
    --> S(<s>x, y)B(<s>y, i)A(<s>y, m, n, i + 1<t>)
)";

constexpr std::string_view kTop
    = "A(x, k, j, i) : * --> S(x, at[LAYERS])B(at[LAYERS], i)S(at[LAYERS], 1)\n";

// What stands between the topmost line and the top comes after it.
constexpr std::string_view kTopOfSeveral = R"(A(s, x, k, j, i, t) : k == LAYERS
    { y = at[low[s] + k]; }
    --> S(s, x, y)B(s, y, i)A(s, y, k + 1, 0, i + 1, t)
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
B(<s>x, i) --> [+(func(<organs>3, x))/(ROLL)~l(LEN * func(<organs>5, x))][-(func(<organs>4, x))/(0 - ROLL)~l(LEN * func(<organs>6, x))]
)";

constexpr std::string_view kDecussate
    = R"(/* Pairs of organs: left and right, then behind and in front. */
B(<s>x, i) : floor(i / 2) * 2 == i
    --> [+(func(<organs>3, x))/(ROLL)~l(LEN * func(<organs>5, x))][/(180)+(func(<organs>4, x))/(ROLL)~l(LEN * func(<organs>6, x))]
B(<s>x, i) : *
    { a = (func(<organs>3, x) + func(<organs>4, x)) / 2; h = LEN * (func(<organs>5, x) + func(<organs>6, x)) / 2; }
    --> [/(90)+(a)/(ROLL)~l(h)][/(270)+(a)/(ROLL)~l(h)]
)";

// The remainder is written out: cpfg's % takes integers.
constexpr std::string_view kSpiral
    = R"(/* An organ t degrees around the stem from its left: a of the left's, b of the right's. */
B(<s>x, i) : *
    { t = i * DIVERGENCE - 360 * floor(i * DIVERGENCE / 360); b = 1 - fabs(t / 180 - 1); a = 1 - b; }
    --> [/(t)+(a * func(<organs>3, x) + b * func(<organs>4, x))/(ROLL)~l(LEN * (a * func(<organs>5, x) + b * func(<organs>6, x)))]
)";

constexpr std::string_view kWhorled
    = R"(/* Organ j of a whorl, t degrees around the stem from its left: a of the left's, b of the
   right's. Every other whorl is turned by half the way from organ to organ. */
W(<s>x, i, j) : *
    { t = (360 * j + 180 * (i - 2 * floor(i / 2))) / WHORL; b = 1 - fabs(t / 180 - 1); a = 1 - b; }
    --> /(t)+(a * func(<organs>3, x) + b * func(<organs>4, x))/(ROLL)~l(LEN * (a * func(<organs>5, x) + b * func(<organs>6, x)))
)";

constexpr std::string_view kBare = R"(/* Nothing stands on the stem. */
B(<s>x, i) : * --> *
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
    std::string text = "B(<s>x, i) -->";
    for (int j = 0; j < pattern.whorl; ++j)
        text += fmt::format(" [W(<s>x, i, {})]", j);
    return text + "\n" + std::string(kWhorled);
}

} // namespace

std::string stem_rules(Pattern const& pattern, Stems stems)
{
    bool const several = stems == Stems::Several;
    std::string text(kApex);
    if (several)
        text += kBearing;
    text += kApexNodes;
    text += several ? kTopOfSeveral : kTop;
    text += kStemPieces;
    return filled_in(text + organ_rules(pattern), stems);
}

} // namespace tractus::lines
