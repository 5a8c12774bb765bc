#include "engine/base/random.h"
#include "tests/engine/lsystem/whole_pipeline.h"

#include <array>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace tractus::lsystem {
namespace {

// Text of a model that uses most features of the language.
std::string const kModel = R"(#define STEP 0.5 /* growth */
#define half(x) ((x)/2)
Lsystem: 1
seed: 7
derivation length: 4
define: { array a[3] = {1,2,3}; }
Start: { n=0; }
StartEach: { n=n+1; if (n>2) { a[1]=n; } else { a[0]=ran(1); } }
ignore: +-/
Axiom: !(0.2)A(1,0)[+B]~l(2)%@S("x")@M(1,2)@R(0,0)@Di(0)
A(s,t) : t<3 {w=s*STEP;} --> F(s)[+(30)A(w,t+1)][-(30)&(20)A(half(s),t+1)]/(137.5)A(s*0.9,t+1)
A(s,t) : t>=3 --> ;~l(s) : 0.7
A(s,t) : t>=3 && s>0.1 --> ,{.F(s).+F.} : 0.3
F(x) < B --> C(x)
B > [=] --> @o(0.5)%(2)F(1)
F(x) < A(s,t) > F(y) : {i=0; while (i<3) {i=i+1;}} x>y --> F(nran(x,0.1))@v@Ts(1,0.2)
decomposition
maximum depth: 3
C(x) : x>0.2 --> f(x/2)C(x/2)
homomorphism
maximum depth: 2
C(x) --> #(0.1)G(x*func(1,x)+curveGAL(1)*stop(x))@Gs|^\@Ge
endlsystem
)";

// Text of a model with sub-L-systems, shared variables and printed output.
std::string const kSubsystems = R"(Lsystem: 1
derivation length: 4
define: { array a[2] = {4,5}; }
Start: { n=1; printf("%d\n", n); }
Axiom: A(3)[?(2,0.5)BB$F]?(3)C$%
A(x) : x>0 --> F(x)[+?(2,x/2)B$]A(x-1)
?(k,s) : n>30 --> ?(3,s)
endlsystem
Lsystem: 2
ignore: +-
define: { external n, a[2]; array b[2]; }
StartEach: { n=n+1; a[1]=n; b[0]=b[0]+1; }
End: { printf("%g %g\n", b[0], a[1]); }
Axiom: B
B < B --> B?(3)C(b[0])$
B --> +(10)FB : 2
B --> F% : 1
homomorphism
B --> ~l(n/5)
endlsystem
Lsystem: 3
C --> CF$
C(x) --> SetC
decomposition
maximum depth: 2
C --> FC
endlsystem
)";

std::string const kView
    = "angle increment: 25\ninitial line width: 0.3\ntropism: T: 0,1,0 E: 0.1\n"
      "tropism direction: 0,1,0\ninitial elasticity: 0.05\nfunction: f.func 10\n"
      "material: 1 bark kind=bark color=0.3,0.2,0.1\nmaterial: 2 leaf kind=leaf color=0.2,0.5,0.1\n"
      "organ: l leaf kind=blade material=2 length=2 width=1 lobes=0.2 lobe_count=3\nradii: pipe 2 "
      "0.05\n";

// Changes, removes, duplicates or moves up to six random pieces of the text.
std::string mutated(std::string text, Random& random)
{
    static constexpr std::string_view kPieces = "()[]{}<>:;,.*%@~?!#&|^\\/+-=\"\n\t 0919eAFfxmn";
    auto const place = [&] {
        return static_cast<std::size_t>(random.uniform() * static_cast<double>(text.size()));
    };
    for (int changes = 1 + static_cast<int>(random.uniform() * 6); changes > 0 && !text.empty();
         --changes) {
        auto const at = place();
        auto const length = static_cast<std::size_t>(1 + random.uniform() * 12);
        switch (random.next_u32() % 5) {
        case 0:
            text[at] = kPieces[random.next_u32() % kPieces.size()];
            break;
        case 1:
            text.erase(at, length);
            break;
        case 2:
            text.insert(at, text.substr(place(), length));
            break;
        case 3:
            text.insert(at, 1, kPieces[random.next_u32() % kPieces.size()]);
            break;
        default:
            text[at] = static_cast<char>(random.next_u32());
        }
    }
    return text;
}

TEST(HostileModels, DoNoHarm)
{
    std::string const sound = kModel + '\0' + kView;
    ASSERT_TRUE(run_whole_pipeline(sound));
    Random random({ .seed = 1, .stream = 1, .substream = 0 });
    int plants = 0;
    for (int i = 0; i < 10'000; ++i)
        plants += run_whole_pipeline(mutated(sound, random));
    // Most damaged texts fail and some still give a plant, so both cases are tested.
    EXPECT_GT(plants, 500);
    EXPECT_LT(plants, 9500);
}

TEST(HostileModels, DoNoHarmWithSubLSystems)
{
    std::string const sound = kSubsystems + '\0' + kView;
    ASSERT_TRUE(run_whole_pipeline(sound));
    Random random({ .seed = 2, .stream = 1, .substream = 0 });
    int plants = 0;
    for (int i = 0; i < 10'000; ++i)
        plants += run_whole_pipeline(mutated(sound, random));
    EXPECT_GT(plants, 500);
    EXPECT_LT(plants, 9500);
}

// Tests damaged texts of the files that a view refers to.
TEST(HostileFiles, DoNoHarm)
{
    struct Case {
        std::string statement;
        std::string file;
    };
    std::string surface = "0 1 0 1 0 1\nCONTACT POINT X: 0 Y: 0 Z: 0\nEND POINT X: 0 Y: 1 Z: 0\n"
                          "HEADING X: 0 Y: 1 Z: 0\nUP X: 0 Y: 0 Z: -1\nSIZE: 1\nsquare\n"
                          "TOP COLOR: 0 DIFFUSE: 0 BOTTOM COLOR: 0 DIFFUSE: 0\n"
                          "AL: ~ A: ~ AR: ~\nL: ~ R: ~\nBL: ~ B: ~ BR: ~\n";
    for (std::string const y : { "1", "0.7", "0.3", "0" })
        surface += "0 " + y + " 0 0.3 " + y + " 0 0.7 " + y + " 0 1 " + y + " 0\n";
    std::string const points = "1 -3 0 1\n3 3 0 1\n-3 3 1 1\n-3 -3 0 1\n";
    std::vector<Case> const cases {
        { "surface: s a.s 1", surface },
        { "tsurface: s a.t 2",
          "triangle\n0 0 0 0 0 1\n1 0 0\n0 2 0.5\ntriangle: 0 0 0\n0 2 1\n-1 0 0\n" },
        { "contour: 1 a.con", "cver 1 2\nname: x\npoints: 4 4\ntype: cr\n" + points },
        { "curve: a.crv 20", "points: 4\ndim: 4\ntype: bspline\n" + points },
        { "function: a.func",
          "fver 1 1\nname: a\nsamples: 5\npoints: 4\n0 0\n0.3 1\n0.6 1\n1 0\n" },
    };
    std::string const rules = "Lsystem: 1\nAxiom: F@#(1)@GsF+F@GeA~s(2)F\n"
                              "A --> F(func(1,0.3))f(curveX(1,0.5))\nendlsystem\n";
    Random random({ .seed = 3, .stream = 1, .substream = 0 });
    for (auto const& [statement, file] : cases) {
        auto const before = rules + '\0' + statement + '\0';
        ASSERT_TRUE(run_whole_pipeline(before + file)) << statement;
        int plants = 0;
        for (int i = 0; i < 1000; ++i)
            plants += run_whole_pipeline(before + mutated(file, random));
        EXPECT_GT(plants, 5) << statement;
        EXPECT_LT(plants, 1000) << statement;
    }
}

TEST(HostileModels, CannotIncludeWithoutEnd)
{
    // Fifty files, each of which includes the next one twice.
    auto const include = [](std::string const& name) -> Result<std::string> {
        auto const number = std::stoi(name);
        auto const line = "#include \"" + std::to_string(number + 1) + "\"\n";
        return number < 50 ? line + line : std::string();
    };
    ModelSource source;
    source.text = "#include \"1\"\nLsystem: 1\n";
    auto const model = compile_model(source, include);
    ASSERT_FALSE(model);
    EXPECT_EQ(model.error().fault, Fault::User);
    EXPECT_NE(model.error().message.find("more than 1000 includes"), std::string::npos);
}

} // namespace
} // namespace tractus::lsystem
