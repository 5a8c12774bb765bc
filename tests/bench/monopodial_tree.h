#pragma once

namespace tractus {

// ABoP figure 2.6, a monopodial tree with each rule split into two stochastic ones: 7 * 2^n - 6
// modules and 2^n - 1 segments after n steps. Published measurements of L-system engines use it.
constexpr char const* kMonopodialTree = R"(#define r1 0.9
#define r2 0.6
#define wr 0.707
Lsystem: 1
seed: 1
derivation length: 17
Axiom: A(1,10)
A(l,w) --> !(w)F(l)[&(45)B(l*r2,w*wr)]/(137.5)A(l*r1,w*wr) : 0.5
A(l,w) --> !(w)F(l)[&(50)B(l*r2,w*wr)]/(137.5)A(l*r1,w*wr) : 0.5
B(l,w) --> !(w)F(l)[-(45)@vC(l*r2,w*wr)]C(l*r1,w*wr) : 0.5
B(l,w) --> !(w)F(l)[-(50)@vC(l*r2,w*wr)]C(l*r1,w*wr) : 0.5
C(l,w) --> !(w)F(l)[+(45)@vB(l*r2,w*wr)]B(l*r1,w*wr) : 0.5
C(l,w) --> !(w)F(l)[+(50)@vB(l*r2,w*wr)]B(l*r1,w*wr) : 0.5
endlsystem
)";

} // namespace tractus
