#pragma once

#include <string>
#include <string_view>

namespace tractus::lsystem {

// A model in cpfg's language that was translated from the notation of a book.
struct BookModel {
    std::string text; // The rules. Line numbers in messages are those of the book's text.
    std::string view; // Statements for the view: the angle increment, if the book's text gives it.
};

// Translates a model in the notation of "The Algorithmic Beauty of Plants" (Prusinkiewicz and
// Lindenmayer 1990), which may be mixed with statements of cpfg:
//
// - // in axioms and productions is two rolls; a // begins a comment at the beginning of a line,
//   or with blanks on both sides. /* */ are comments.
// - ' is the next colour (cpfg: ;), and $ rolls until the left side is level (cpfg: @v).
// - "p1:" before a production is its label. "ω:", "w:", "omega:" and "axiom:" begin the axiom.
// - "->" and "→" are arrows as is "-->"; "→.33" or ".33" between "-->" or "->" and a blank is the
//   production's probability.
// - In conditions, = compares, & is and, | is or; ≤ ≥ ≠ ∧ ∨ and the typographic minus are read.
// - "n=7, δ=22.5°" gives the derivation length and the angle increment; for δ also d, delta, angle.
// - "#ignore: F+-" and "#consider: ..." are statements; "#include K" (a surface) is left out.
// - Names of several letters, such as Fl or F_r, that productions replace become free letters. A
//   name that begins with F, f, G or g is drawn like that letter.
//
// Missing "Lsystem:" and "endlsystem" are added, and a seed if productions have probabilities.
// Never fails: what is not understood is kept, and the compiler reports it.
BookModel read_book_model(std::string_view text);

} // namespace tractus::lsystem
