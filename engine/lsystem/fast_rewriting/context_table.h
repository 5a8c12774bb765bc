#pragma once

#include "engine/lsystem/fast_rewriting/piece_neighbours.h"
#include "engine/lsystem/language/model.h"
#include "engine/lsystem/language/module_string.h"
#include "engine/lsystem/rewriting/fixed_successor.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace tractus::lsystem {

// Rewrites by table lookup. This is possible for models whose rules have no parameters, no
// probabilities, and contexts of at most one module, such as models of signals in plants. The
// successor of a module then depends on three kinds: its own and those of its two neighbours. A
// string is scanned from the right to find right neighbours, then rewritten from the left. Both
// passes use a stack for branches and treat the string in pieces.
class ContextTable {
public:
    // Makes a table for a model, which must outlive it. Returns no value if the model has other
    // rules or no context at all.
    static std::optional<ContextTable> create(Model const& model);

    // Rewrites all of `in`, in parallel if it has more than two pieces of `piece` modules. Stops
    // when the size of `out` exceeds `max_modules`.
    void rewrite(Column<KindId> const& in, Column<KindId>& out, std::size_t max_modules,
                 std::size_t piece);

private:
    using Role = NeighbourRoles::Role;

    // The input and the limits of one step.
    struct Task {
        Column<KindId> const& in;
        std::size_t max_modules = 0;
        std::size_t piece = 0;
        std::size_t piece_count = 0;
    };
    // Buffers for a piece that is written at the same time as others.
    struct Written {
        Column<KindId> out;
        Column<KindId> stack;
    };

    explicit ContextTable(Model const& model);

    void find_right_neighbours(Task const& task);
    void write_in_parallel(Task const& task, Column<KindId>& out);
    void write_piece(Task const& task, std::size_t number, Column<KindId>& stack,
                     Column<KindId>& out) const;
    template<bool kIsRow, bool kIsOneToOne>
    void write(Task const& task, std::size_t number, Column<KindId>& stack,
               Column<KindId>& out) const;
    static std::size_t index(unsigned bits, std::size_t left, std::size_t kind, std::size_t right)
    {
        return ((left << bits | kind) << bits) | right;
    }

    unsigned kind_bits_ = 0;
    NeighbourRoles roles_;
    bool is_row_ = true;
    bool is_one_to_one_ = true; // True if every successor is a single module.
    // Successor for each combination of the kinds of a module and its two neighbours, as an index
    // into successors_.
    std::vector<std::uint16_t> table_;
    // Kind of the successor for each such combination; only filled if is_one_to_one_.
    std::vector<KindId> one_to_one_;
    std::vector<FixedSuccessor> successors_;
    std::size_t longest_ = 1;
    // Right neighbour of each module. Reserves more memory than it uses; only memory that is
    // written is touched.
    Column<KindId> right_;
    std::vector<PieceNeighbours> pieces_;
    std::vector<Written> written_;
};

} // namespace tractus::lsystem
