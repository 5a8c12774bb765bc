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

// Rewrites by table lookup, for models whose rules have no parameters, no probabilities, and
// contexts of at most one module, such as models of signals in plants. The successor of a module
// then depends on three kinds: its own and those of its two neighbours. A string is scanned from
// the right for right neighbours and rewritten from the left, each with a stack for branches, in
// pieces.
class ContextTable {
public:
    // Makes a table for a model; no value if the model has other rules or no context at all. The
    // model must outlive the table.
    static std::optional<ContextTable> create(Model const& model);

    // Rewrites all of `in`, in parallel if it has more than two pieces of `piece` modules. Stops
    // when `out` exceeds `max_modules`.
    void rewrite(Column<KindId> const& in, Column<KindId>& out, std::size_t max_modules,
                 std::size_t piece);

private:
    using Role = NeighbourRoles::Role;

    // One step's work on a string.
    struct Task {
        Column<KindId> const& in;
        std::size_t max_modules = 0;
        std::size_t piece = 0;
        std::size_t piece_count = 0;
    };
    // Buffers for a piece that is written in parallel with others.
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
    // Successor for each combination of a module's own kind and its neighbours', as an index into
    // successors_.
    std::vector<std::uint16_t> table_;
    // Kind of the successor for each combination, if is_one_to_one_.
    std::vector<KindId> one_to_one_;
    std::vector<FixedSuccessor> successors_;
    std::size_t longest_ = 1;
    // Reserved memory; only the part that is written is touched.
    Column<KindId> right_; // Right neighbour of each module.
    std::vector<PieceNeighbours> pieces_;
    std::vector<Written> written_;
};

} // namespace tractus::lsystem
