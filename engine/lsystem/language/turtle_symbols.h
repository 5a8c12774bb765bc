#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace tractus::lsystem {

// Table of the turtle's symbols, used to draw and print strings and to count segments before
// drawing. interpret.h describes what the symbols mean.

enum class SymbolAction : std::uint8_t {
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
    Organ,  // Draws an organ, which the next character names.
    At,     // Begins a symbol of two or three characters; see AtSymbol.
    Call,   // Calls a sub-L-system, or is a query, depending on the next character.
    Return, // Returns from a sub-L-system.
    Cut,
};

struct TurtleSymbol {
    char symbol = 0;
    SymbolAction does = SymbolAction::Nothing;
    int sign = 1; // Sign of the turn or of the change: 1 or -1.
    // True if the step sets a vertex of a polygon or a control point of a path.
    bool sets_vertex = false;
};

inline constexpr std::array kTurtleSymbols {
    TurtleSymbol { 'F', SymbolAction::Draw, 1, true },
    TurtleSymbol { 'G', SymbolAction::Draw },
    TurtleSymbol { 'f', SymbolAction::Move, 1, true },
    TurtleSymbol { 'g', SymbolAction::Move },
    TurtleSymbol { '+', SymbolAction::Turn },
    TurtleSymbol { '-', SymbolAction::Turn, -1 },
    TurtleSymbol { '&', SymbolAction::Pitch },
    TurtleSymbol { '^', SymbolAction::Pitch, -1 },
    TurtleSymbol { '/', SymbolAction::Roll },
    TurtleSymbol { '\\', SymbolAction::Roll, -1 },
    TurtleSymbol { '|', SymbolAction::TurnRound },
    TurtleSymbol { '[', SymbolAction::Push },
    TurtleSymbol { ']', SymbolAction::Pop },
    TurtleSymbol { '#', SymbolAction::Width },
    TurtleSymbol { '!', SymbolAction::Width, -1 },
    TurtleSymbol { ';', SymbolAction::Color },
    TurtleSymbol { ',', SymbolAction::Color, -1 },
    TurtleSymbol { '_', SymbolAction::BendAsOlder },
    TurtleSymbol { '{', SymbolAction::BeginPath },
    TurtleSymbol { '.', SymbolAction::Dot },
    TurtleSymbol { '}', SymbolAction::EndPath },
    TurtleSymbol { '~', SymbolAction::Organ },
    TurtleSymbol { '@', SymbolAction::At },
    TurtleSymbol { '?', SymbolAction::Call },
    TurtleSymbol { '$', SymbolAction::Return },
    TurtleSymbol { '%', SymbolAction::Cut },
};

enum class AtSymbolAction : std::uint8_t {
    Unknown, // Not a known @-symbol: it draws nothing and causes a warning.
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
    Label, // Label, BackFace and RunProgram are not supported: they cause a warning.
    BackFace,
    RunProgram,
    Ignored, // An @-symbol that is meant for other programs.
};

// An @-symbol: a symbol of two or three characters that begins with @.
struct AtSymbol {
    char second = 0;
    AtSymbolAction does = AtSymbolAction::Unknown;
    std::string_view thirds {}; // Possible third characters; empty if the symbol has only two.
    // True if the symbol never draws segments or moves the turtle, whatever follows it.
    bool is_plain = false;
};

inline constexpr std::array kAtSymbols {
    AtSymbol { 'v', AtSymbolAction::Level, {}, true },
    AtSymbol { 'M', AtSymbolAction::Position },
    AtSymbol { 'R', AtSymbolAction::Frame, {}, true },
    AtSymbol { 'o', AtSymbolAction::Ball, {}, true },
    AtSymbol { 'O', AtSymbolAction::Ball, {}, true },
    AtSymbol { 'c', AtSymbolAction::Disc, {}, true },
    AtSymbol { 'b', AtSymbolAction::Circle, "co" },
    AtSymbol { 'D', AtSymbolAction::Scale, "id" },
    AtSymbol { 'T', AtSymbolAction::Movement, "sdpfix", true },
    AtSymbol { 'G', AtSymbolAction::Cylinder, "scetr" },
    AtSymbol { '#', AtSymbolAction::Contour },
    AtSymbol { '!', AtSymbolAction::Sides },
    AtSymbol { 'P', AtSymbolAction::Patch, "scdSCD" },
    AtSymbol { 'm', AtSymbolAction::Cut, "oc" },
    AtSymbol { 'C', AtSymbolAction::Unknown, "sae" },
    AtSymbol { 'L', AtSymbolAction::Label, {}, true },
    AtSymbol { ';', AtSymbolAction::BackFace, {}, true },
    AtSymbol { ',', AtSymbolAction::BackFace, {}, true },
    AtSymbol { 'S', AtSymbolAction::RunProgram },
    AtSymbol { 'I', AtSymbolAction::Ignored },
    AtSymbol { 'J', AtSymbolAction::Ignored },
    AtSymbol { 'Z', AtSymbolAction::Ignored, {}, true },
    AtSymbol { 'Y', AtSymbolAction::Ignored, {}, true },
};

// Characters that make a query if they follow a ?.
inline constexpr std::string_view kQueryCharacters = "PHLUEQR";

namespace detail {

// Makes a table indexed by character. The entry of a character that is not in the list does
// nothing.
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
