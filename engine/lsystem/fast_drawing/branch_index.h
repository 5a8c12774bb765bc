#pragma once

#include "engine/lsystem/language/model.h"
#include "engine/lsystem/language/module_string.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace tractus::lsystem {

// Finds the ends of long branches in a string without reading all of them. The string is cut into
// blocks, of which it is known how deep in brackets they begin and get; those in which a branch
// does not end are passed over.
class BranchIndex {
public:
    // Looks for branches of at least `long_branch` modules. All must outlive it.
    BranchIndex(Model const& model, ModuleString const& string, std::size_t long_branch);

    struct End {
        std::size_t module = 0;    // The closing bracket, or the string's size when none closes it.
        std::size_t parameter = 0; // Where that module's parameters begin.
    };

    // The first module from `module` on at which a long branch may begin; the string's size if
    // there is none.
    std::size_t next_opening(std::size_t module) const;

    // False if a branch of which `module`, at `depth`, is the first module is surely not long: a
    // quick look at few places. Depths count from the string's beginning.
    bool may_be_long(std::size_t module, std::int64_t depth) const
    {
        auto const end = std::min((module + long_branch_) / kBlock, blocks_.size() - 1);
        for (auto block = module / kBlock + 1; block <= end; ++block)
            if (blocks_[block].depth < depth)
                return false;
        return true;
    }

    // The end of the branch whose first module, behind the opening bracket, is `module`.
    End find_end(std::size_t module) const;

    // Where a module's parameters begin.
    std::size_t parameter(std::size_t module) const;

    std::size_t long_branch() const { return long_branch_; }

private:
    static constexpr std::size_t kBlock = 256;      // Modules.
    static constexpr std::size_t kSuperblock = 256; // Blocks.

    static constexpr auto kBeyond = std::int64_t { 1 } << 60; // No depth is as great.

    struct Step {
        std::uint32_t parameters = 0;
        int depth = 0; // Change behind the module.
    };
    static constexpr std::int32_t kNoOpening = 1 << 20; // No depth in a block is as great.
    // Effect of two modules, one behind the other: blocks are measured by twos.
    struct Pair {
        std::uint16_t parameters = 0;
        std::int8_t depth = 0;
        std::int8_t floor = 0;    // Least depth behind one of them.
        std::int32_t opening = 0; // Depth of a branch that one opens; kNoOpening if none does.
    };
    struct Block {
        std::size_t parameter = 0; // Index before its first module.
        std::int64_t depth = 0;    // Depth before its first module.
        std::int64_t floor = 0;    // No depth in it is less.
        // The least depth of a branch that begins in it, far beyond all if none does; then whether
        // it may be a long one.
        std::int64_t opening = 2 * kBeyond;
        bool opens_long = false;
    };

    static Pair pair(Step const& first, Step const& second);
    Block measure(std::size_t block) const;
    bool may_open_long(std::size_t block) const;
    std::size_t first_block_below(std::size_t block, std::int64_t depth) const;

    ModuleString const& string_;
    std::size_t long_branch_;
    std::size_t kind_count_;
    std::array<Step, 256> steps_ {}; // Indexed by kind.
    std::vector<Pair> pairs_;        // Indexed by first kind * kind_count_ + second kind.
    std::vector<Block> blocks_;
    std::vector<std::int64_t> floors_; // Least depths of superblocks.
};

// Says which branches of one part of a string are to be parts of their own: long ones that a long
// rest follows.
class BranchCutter {
public:
    explicit BranchCutter(BranchIndex const& index)
        : index_(&index)
    {
    }

    // Begins to follow the part [begin, end) of the string.
    void begin(std::size_t begin, std::size_t end)
    {
        look_from_ = begin;
        end_ = end;
    }

    // No branch that begins before this module, at or behind `at`, is to be cut off.
    std::size_t look_from(std::size_t at)
    {
        if (at >= look_from_)
            look_from_ = index_->next_opening(at);
        return look_from_;
    }

    // The end of the branch that opens at module `at`, not before look_from(), if it is to be cut
    // off. Inside of it the depth is `depth`, counted from the string's beginning.
    std::optional<BranchIndex::End> cut(std::size_t at, std::int64_t depth);

private:
    BranchIndex const* index_; // Not owned.
    std::size_t look_from_ = 0;
    std::size_t end_ = 0;
};

} // namespace tractus::lsystem
