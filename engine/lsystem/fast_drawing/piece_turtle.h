#pragma once

#include "engine/base/arena.h"
#include "engine/lsystem/fast_drawing/branch_index.h"
#include "engine/lsystem/fast_drawing/interpret.h"
#include "engine/lsystem/fast_drawing/segment_plan.h"
#include "engine/lsystem/language/virtual_machine.h"
#include "engine/lsystem/rewriting/expander.h"
#include "engine/lsystem/turtle/plant_assembly.h"
#include "engine/lsystem/turtle/turtle.h"

#include <array>
#include <atomic>
#include <optional>
#include <vector>

namespace tractus::lsystem {

// A part of the string without the branches that are left to other pieces, and its drawing.
struct Piece {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t parameter = 0; // Index of the first parameter of the piece's first module.
    // Bracket depth at the first module, counted from the beginning of the string.
    std::int64_t depth = 0;
    Turtle::Start start;
    // For a planned piece, where its first axis and first segment are written.
    TurtleDrawing::Target target;
    DrawnPiece drawn;
    // Pieces for the branches that are left out, in the order of the string.
    std::vector<Piece> branches;
    // True if the turtle reached the end of the piece with all brackets and polygons closed.
    bool is_complete = true;
};

// Data that all pieces of a string share.
struct DrawingJob {
    Model const& model;
    ModuleString const& string;
    TurtleOptions const& options;
    bool is_expanded = false; // True if homomorphism rules have already been applied to the string.
    bool is_finite = false;   // True if all parameters of the string are finite.
    // Matching brackets of the string; only filled if homomorphism rules have contexts.
    Branches branches {};
    Arena memory {}; // Memory for the drawings of the pieces.
    std::atomic<std::size_t> drawn { 0 };
    std::atomic<std::size_t> parts { 0 };
    std::atomic<std::size_t> bytes { 0 }; // Memory that the pieces' drawings use.

    bool is_over_limit() const
    {
        return drawn > options.max_modules || parts > options.max_parts
            || bytes > options.max_memory_bytes;
    }
};

// Draws pieces one after another. Each thread needs its own turtle.
class PieceTurtle {
public:
    // `index` is nullptr if no branches are left out, or if a plan lists those that are.
    PieceTurtle(DrawingJob& job, BranchIndex const* index);

    void draw(Piece& piece);

    // Draws a planned piece to its place in the plant, and sets the beginnings of the pieces that
    // fill its gaps.
    void draw(std::vector<PlannedPiece> const& plan, std::size_t index, std::vector<Piece>& pieces);

    VirtualMachine const& machine() const { return machine_; }

private:
    void begin(Piece const& piece);
    void end(Piece& piece);
    bool draw_to(std::size_t end);
    void draw_plain(std::size_t end, std::array<bool, 256> const& stops);
    bool draw_next();
    std::size_t draw_one();
    bool leave_out(Piece& piece);
    void leave_out(PlannedPiece const& planned, std::size_t index, Piece& branch);
    void count();
    void pass(std::size_t count)
    {
        for (; count > 0; --count)
            parameter_ += parameter_counts_[string_.kinds[at_++]];
    }

    DrawingJob& job_;
    Model const& model_;
    ModuleString const& string_;
    std::optional<BranchCutter> cutter_;
    VirtualMachine machine_;
    Expander homomorphism_;
    Turtle turtle_;
    TurtleDrawing drawing_; // Drawing of the current piece; its memory is reused for the next one.
    std::array<bool, 256> has_rules_ {};
    std::array<bool, 256> opens_ {};
    // True for kinds of modules that the turtle cannot draw by itself.
    std::array<bool, 256> stops_ {};
    std::array<std::uint8_t, 256> parameter_counts_ {};
    std::size_t at_ = 0;
    std::size_t parameter_ = 0;
    // Index of a module; branches that begin before it are drawn as part of the piece.
    std::size_t look_from_ = 0;
    std::size_t drawn_ = 0; // Number of modules drawn since the last check of the limits.
    std::size_t counted_parts_ = 0;
    std::size_t counted_bytes_ = 0;
};

} // namespace tractus::lsystem
