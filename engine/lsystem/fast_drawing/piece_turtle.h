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

// A part of the string, outside of the branches left out of it, and what is drawn there.
struct Piece {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t parameter = 0; // Where the first module's parameters begin.
    std::int64_t depth = 0;    // Depth of the first module, counted from the string's beginning.
    Turtle::Start start;
    // Place where the first axis and segment of a planned piece come to lie.
    TurtleDrawing::Target target;
    DrawnPiece drawn;
    std::vector<Piece> branches; // Left out, in the order of the string.
    bool is_complete = true;     // Ends as if it had been drawn by itself.
};

// Data that all pieces of one string share.
struct DrawingJob {
    Model const& model;
    ModuleString const& string;
    TurtleOptions const& options;
    bool is_expanded = false; // The homomorphism has been applied.
    bool is_finite = false;   // All parameters of the string are finite.
    Branches branches {};     // Where homomorphism rules have contexts.
    Arena memory {};          // Holds what pieces have drawn.
    std::atomic<std::size_t> drawn { 0 };
    std::atomic<std::size_t> parts { 0 };
    std::atomic<std::size_t> bytes { 0 }; // Memory for those in pieces.

    bool is_over_limit() const
    {
        return drawn > options.max_modules || parts > options.max_parts
            || bytes > options.max_memory_bytes;
    }
};

// Draws pieces, one after the other. Each thread needs its own.
class PieceTurtle {
public:
    // `index` is nullptr where no branches are to be left out, or a plan says which.
    PieceTurtle(DrawingJob& job, BranchIndex const* index);

    void draw(Piece& piece);

    // Draws a piece to its place in the plant and says where those that fill its gaps begin.
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
    TurtleDrawing drawing_; // Drawing of one piece: the same memory for one after the other.
    std::array<bool, 256> has_rules_ {};
    std::array<bool, 256> opens_ {};
    std::array<bool, 256> stops_ {}; // Kinds that are more than a symbol to draw.
    std::array<std::uint8_t, 256> parameter_counts_ {};
    std::size_t at_ = 0;
    std::size_t parameter_ = 0;
    std::size_t look_from_ = 0; // Branches that begin before it are drawn here.
    std::size_t drawn_ = 0;     // Drawn, but not counted yet.
    std::size_t counted_parts_ = 0;
    std::size_t counted_bytes_ = 0;
};

} // namespace tractus::lsystem
