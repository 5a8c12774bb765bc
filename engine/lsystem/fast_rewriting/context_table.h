#pragma once

#include "engine/lsystem/language/model.h"
#include "engine/lsystem/language/module_string.h"
#include "engine/lsystem/rewriting/fixed_successor.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace tractus {

// The rules of a model without parameters and chance whose contexts are of one module at most, such
// as those that send signals through a plant: what becomes of a module then depends on three kinds
// alone, its own and its neighbours', and stands in a table. A string is rewritten in two passes,
// from the right for the right neighbours and from the left for the rest, each with a stack for the
// branches.
class ContextTable {
public:
    // No value if the model has other rules, or none with a context. The model must outlive the
    // table.
    static std::optional<ContextTable> create(Model const& model);

    // Rewrites all of `in`. Stops when `out` has more than `max_modules`.
    void rewrite(Column<KindId> const& in, Column<KindId>& out, std::size_t max_modules);

private:
    // Role of a kind for its neighbours. In a row of modules that all are seen, the neighbours are
    // those next to it.
    enum class Role : std::uint8_t { Seen, Ignored, Opening, Closing };

    explicit ContextTable(Model const& model);

    void find_right_neighbours(Column<KindId> const& in);
    template<bool kIsRow, bool kIsOneToOne>
    void write(Column<KindId> const& in, Column<KindId>& out, std::size_t max_modules);
    std::size_t index(std::size_t left, std::size_t kind, std::size_t right) const
    {
        return ((left << kind_bits_ | kind) << kind_bits_) | right;
    }

    unsigned kind_bits_ = 0;
    KindId none_ = 0; // Stands for "no neighbour".
    std::array<Role, 256> roles_ {};
    bool is_row_ = true;
    bool sees_branches_ = true;        // Right contexts see branches.
    bool is_one_to_one_ = true;        // Every successor is one module.
    std::vector<std::uint16_t> table_; // Indices into successors_.
    std::vector<KindId> one_to_one_;   // The successors themselves, if is_one_to_one_.
    std::vector<FixedSuccessor> successors_;
    std::size_t longest_ = 1;
    // Memory alone, of which no more is touched than what is written.
    Column<KindId> right_; // Each module's right neighbour.
    Column<KindId> stack_;
};

} // namespace tractus
