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

// The rules of a model without parameters and chance whose contexts are of one module at most, such
// as those that send signals through a plant: what becomes of a module then depends on three kinds
// alone, its own and its neighbours', and stands in a table. A string is read from the right for
// the right neighbours and rewritten from the left, each with a stack for the branches, in pieces.
class ContextTable {
public:
    // No value if the model has other rules, or none with a context. The model must outlive the
    // table.
    static std::optional<ContextTable> create(Model const& model);

    // Rewrites all of `in`, on several threads if it has more than two pieces of `piece` modules.
    // Stops when `out` has more than `max_modules`.
    void rewrite(Column<KindId> const& in, Column<KindId>& out, std::size_t max_modules,
                 std::size_t piece);

private:
    using Role = NeighbourRoles::Role;

    // A step's work on a string.
    struct Task {
        Column<KindId> const& in;
        std::size_t max_modules = 0;
        std::size_t piece = 0;
        std::size_t piece_count = 0;
    };
    // Buffers of a piece that is written beside others.
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
    bool is_one_to_one_ = true;        // Every successor is one module.
    std::vector<std::uint16_t> table_; // Indices into successors_.
    std::vector<KindId> one_to_one_;   // The successors themselves, if is_one_to_one_.
    std::vector<FixedSuccessor> successors_;
    std::size_t longest_ = 1;
    // Memory alone, of which no more is touched than what is written.
    Column<KindId> right_; // Each module's right neighbour.
    std::vector<PieceNeighbours> pieces_;
    std::vector<Written> written_;
};

} // namespace tractus::lsystem
