#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace tractus::lsystem {

// Table of the turtle's symbols, used for drawing, for counting segments before drawing, and for
// printing strings. Their meaning is described in interpret.h.

enum class SymbolDoes : std::uint8_t {
    Nothing,
    Draw, // A step that draws a segment.
    Move, // A step that draws nothing.
    Turn,
    Pitch,
    Roll,
    TurnRound,
    Push,
    Pop,
    Width,
    Color,
    BendAsOlder, // Sets the elasticity of the older kind of tropism.
    BeginPath,   // Begins a polygon or a generalised cylinder.
    Dot,
    EndPath,
    Organ,  // An organ, named by the next character.
    At,     // A symbol of two or three characters, see AtSymbol.
    Call,   // Calls a sub-L-system, or is a query, depending on the next character.
    Return, // Returns from a sub-L-system.
    Cut,
};

struct TurtleSymbol {
    char symbol = 0;
    SymbolDoes does = SymbolDoes::Nothing;
    int sign = 1; // Sign of a turn or of a change.
    // True if the step sets a vertex of a polygon or a control point of a path.
    bool sets_vertex = false;
};

inline constexpr std::array kTurtleSymbols {
    TurtleSymbol { 'F', SymbolDoes::Draw, 1, true },
    TurtleSymbol { 'G', SymbolDoes::Draw },
    TurtleSymbol { 'f', SymbolDoes::Move, 1, true },
    TurtleSymbol { 'g', SymbolDoes::Move },
    TurtleSymbol { '+', SymbolDoes::Turn },
    TurtleSymbol { '-', SymbolDoes::Turn, -1 },
    TurtleSymbol { '&', SymbolDoes::Pitch },
    TurtleSymbol { '^', SymbolDoes::Pitch, -1 },
    TurtleSymbol { '/', SymbolDoes::Roll },
    TurtleSymbol { '\\', SymbolDoes::Roll, -1 },
    TurtleSymbol { '|', SymbolDoes::TurnRound },
    TurtleSymbol { '[', SymbolDoes::Push },
    TurtleSymbol { ']', SymbolDoes::Pop },
    TurtleSymbol { '#', SymbolDoes::Width },
    TurtleSymbol { '!', SymbolDoes::Width, -1 },
    TurtleSymbol { ';', SymbolDoes::Color },
    TurtleSymbol { ',', SymbolDoes::Color, -1 },
    TurtleSymbol { '_', SymbolDoes::BendAsOlder },
    TurtleSymbol { '{', SymbolDoes::BeginPath },
    TurtleSymbol { '.', SymbolDoes::Dot },
    TurtleSymbol { '}', SymbolDoes::EndPath },
    TurtleSymbol { '~', SymbolDoes::Organ },
    TurtleSymbol { '@', SymbolDoes::At },
    TurtleSymbol { '?', SymbolDoes::Call },
    TurtleSymbol { '$', SymbolDoes::Return },
    TurtleSymbol { '%', SymbolDoes::Cut },
};

enum class AtDoes : std::uint8_t {
    Unknown, // An @-symbol that is not known: it draws nothing and causes a warning.
    Level,   // Rolls until the left vector is horizontal.
    Position,
    Frame,
    Ball,
    Disc,
    Circle,
    Scale,
    Movement, // Tropisms, and parallel transport of a cylinder's sides.
    Cylinder,
    Contour,
    Sides,
    Patch,
    Cut,
    Label, // Label, BackFace and RunProgram are not supported and cause a warning.
    BackFace,
    RunProgram,
    Ignored, // An @-symbol meant for other programs.
};

// The second character of a symbol that begins with @.
struct AtSymbol {
    char second = 0;
    AtDoes does = AtDoes::Unknown;
    std::string_view thirds {}; // Possible third characters; empty: the symbol has two characters.
    // True if it never draws segments or moves the turtle, whatever follows it.
    bool is_plain = false;
};

inline constexpr std::array kAtSymbols {
    AtSymbol { 'v', AtDoes::Level, {}, true },
    AtSymbol { 'M', AtDoes::Position },
    AtSymbol { 'R', AtDoes::Frame, {}, true },
    AtSymbol { 'o', AtDoes::Ball, {}, true },
    AtSymbol { 'O', AtDoes::Ball, {}, true },
    AtSymbol { 'c', AtDoes::Disc, {}, true },
    AtSymbol { 'b', AtDoes::Circle, "co" },
    AtSymbol { 'D', AtDoes::Scale, "id" },
    AtSymbol { 'T', AtDoes::Movement, "sdpfix", true },
    AtSymbol { 'G', AtDoes::Cylinder, "scetr" },
    AtSymbol { '#', AtDoes::Contour },
    AtSymbol { '!', AtDoes::Sides },
    AtSymbol { 'P', AtDoes::Patch, "scdSCD" },
    AtSymbol { 'm', AtDoes::Cut, "oc" },
    AtSymbol { 'C', AtDoes::Unknown, "sae" },
    AtSymbol { 'L', AtDoes::Label, {}, true },
    AtSymbol { ';', AtDoes::BackFace, {}, true },
    AtSymbol { ',', AtDoes::BackFace, {}, true },
    AtSymbol { 'S', AtDoes::RunProgram },
    AtSymbol { 'I', AtDoes::Ignored },
    AtSymbol { 'J', AtDoes::Ignored },
    AtSymbol { 'Z', AtDoes::Ignored, {}, true },
    AtSymbol { 'Y', AtDoes::Ignored, {}, true },
};

// Characters after ? that make a query.
inline constexpr std::string_view kQueryCharacters = "PHLUEQR";

namespace detail {

// Makes a table indexed by character; characters that are not in the list do nothing.
template<typename Symbol, std::size_t kCount>
constexpr std::array<Symbol, 256> by_character(std::array<Symbol, kCount> const& symbols,
                                               char Symbol::*character)
{
    std::array<Symbol, 256> table {};
    for (auto const& symbol : symbols)
        table[static_cast<unsigned char>(symbol.*character)] = symbol;
    return table;
}

inline constexpr auto kByCharacter = by_character(kTurtleSymbols, &TurtleSymbol::symbol);
inline constexpr auto kBySecond = by_character(kAtSymbols, &AtSymbol::second);

} // namespace detail

constexpr TurtleSymbol const& turtle_symbol(char symbol)
{
    return detail::kByCharacter[static_cast<unsigned char>(symbol)];
}

constexpr AtSymbol const& at_symbol(char second)
{
    return detail::kBySecond[static_cast<unsigned char>(second)];
}

} // namespace tractus::lsystem
