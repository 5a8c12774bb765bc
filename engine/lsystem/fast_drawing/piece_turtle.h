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

// A part of the string, without the branches left to other pieces, and its drawing.
struct Piece {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t parameter = 0; // Index of the first module's first parameter.
    // Bracket depth of the first module, counted from the beginning of the string.
    std::int64_t depth = 0;
    Turtle::Start start;
    // Destination of a planned piece's first axis and first segment.
    TurtleDrawing::Target target;
    DrawnPiece drawn;
    std::vector<Piece> branches; // Branches left to other pieces, in the order of the string.
    // True if the turtle reached the end of the piece with all brackets and polygons closed.
    bool is_complete = true;
};

// Data shared by all pieces of a string.
struct DrawingJob {
    Model const& model;
    ModuleString const& string;
    TurtleOptions const& options;
    bool is_expanded = false; // True if the homomorphism has already been applied.
    bool is_finite = false;   // True if all parameters of the string are finite.
    Branches branches {};     // Matching brackets; filled if homomorphism rules have contexts.
    Arena memory {};          // Memory for what the pieces have drawn.
    std::atomic<std::size_t> drawn { 0 };
    std::atomic<std::size_t> parts { 0 };
    std::atomic<std::size_t> bytes { 0 }; // Memory used by the pieces' drawings.

    bool is_over_limit() const
    {
        return drawn > options.max_modules || parts > options.max_parts
            || bytes > options.max_memory_bytes;
    }
};

// Draws pieces one after another. Each thread needs a turtle of its own.
class PieceTurtle {
public:
    // `index` is nullptr if no branches are to be left out, or if a plan says which.
    PieceTurtle(DrawingJob& job, BranchIndex const* index);

    void draw(Piece& piece);

    // Draws a planned piece to its place in the plant, and sets where the pieces that fill its gaps
    // begin.
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
    std::array<bool, 256> stops_ {}; // True for kinds of modules that need more than drawing.
    std::array<std::uint8_t, 256> parameter_counts_ {};
    std::size_t at_ = 0;
    std::size_t parameter_ = 0;
    // Branches that begin before this module are drawn as part of the piece.
    std::size_t look_from_ = 0;
    std::size_t drawn_ = 0; // Modules drawn since the last check of the limits.
    std::size_t counted_parts_ = 0;
    std::size_t counted_bytes_ = 0;
};

} // namespace tractus::lsystem
