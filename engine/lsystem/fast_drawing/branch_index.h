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

// Finds the ends of long branches without reading the whole string. The string is divided into
// blocks. For each block the bracket depth at its beginning and the lowest depth in it are stored,
// so that blocks in which a branch cannot end are skipped.
class BranchIndex {
public:
    // Prepares searches for branches of at least `long_branch` modules. Model and string must
    // outlive this object.
    BranchIndex(Model const& model, ModuleString const& string, std::size_t long_branch);

    struct End {
        // The closing bracket; the string's size if no bracket closes the branch.
        std::size_t module = 0;
        // Index of the first parameter of `module`; the number of parameters if no bracket closes
        // the branch.
        std::size_t parameter = 0;
    };

    // Returns the first module, from `module` on, at which a long branch may begin; the string's
    // size if there is none.
    std::size_t next_opening(std::size_t module) const;

    // Quick test: returns false if a branch whose first module is `module` is certainly not long.
    // `depth` is the bracket depth in the branch, counted from the beginning of the string.
    bool may_be_long(std::size_t module, std::int64_t depth) const
    {
        auto const end = std::min((module + long_branch_) / kBlock, blocks_.size() - 1);
        for (auto block = module / kBlock + 1; block <= end; ++block)
            if (blocks_[block].depth < depth)
                return false;
        return true;
    }

    // Finds the end of a branch whose first module, after the opening bracket, is `module`.
    End find_end(std::size_t module) const;

    // Returns the index of a module's first parameter.
    std::size_t parameter(std::size_t module) const;

    std::size_t long_branch() const { return long_branch_; }

private:
    static constexpr std::size_t kBlock = 256;      // Number of modules in a block.
    static constexpr std::size_t kSuperblock = 256; // Number of blocks in a superblock.

    // A value that is greater than any depth.
    static constexpr auto kBeyond = std::int64_t { 1 } << 60;

    struct Step {
        std::uint32_t parameters = 0;
        int depth = 0; // Change of the bracket depth by the module.
    };
    // A value that is greater than any depth within a block.
    static constexpr std::int32_t kNoOpening = 1 << 20;
    // Effect of two successive modules on parameter index and depth. Blocks are measured two
    // modules at a time.
    struct Pair {
        std::uint16_t parameters = 0;
        std::int8_t depth = 0;
        // Lower of the depths after the first and after the second module, relative to that before
        // them.
        std::int8_t floor = 0;
        // Depth in a branch that one of the two modules opens; kNoOpening if neither does.
        std::int32_t opening = 0;
    };
    struct Block {
        std::size_t parameter = 0; // Index of the first parameter of the block's first module.
        std::int64_t depth = 0;    // Bracket depth before the block's first module.
        std::int64_t floor = 0;    // Lowest bracket depth in the block.
        // Lowest depth in any branch that begins in the block; greater than any depth if none
        // begins there. opens_long, computed from it, is true if such a branch may be long.
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
    std::array<Step, 256> steps_ {}; // Effect of a module of each kind.
    // Effects of pairs of modules, at index (first kind * kind_count_ + second kind).
    std::vector<Pair> pairs_;
    std::vector<Block> blocks_;
    std::vector<std::int64_t> floors_; // Lowest bracket depth in each superblock.
};

// Selects the branches of a piece of the string that become separate pieces: long branches that are
// followed by a long remainder of the piece.
class BranchCutter {
public:
    explicit BranchCutter(BranchIndex const& index)
        : index_(&index)
    {
    }

    // Starts to select branches of the piece [begin, end) of the string.
    void begin(std::size_t begin, std::size_t end)
    {
        look_from_ = begin;
        end_ = end;
    }

    // Returns a module, `at` or a later one, such that no branch that begins between `at` and it
    // needs to be cut off.
    std::size_t look_from(std::size_t at)
    {
        if (at >= look_from_)
            look_from_ = index_->next_opening(at);
        return look_from_;
    }

    // Returns the end of the branch that opens at `at`, or no value if it should not be cut off.
    // `at` must not be before look_from(). `depth` is the depth inside the branch, counted from the
    // beginning of the string.
    std::optional<BranchIndex::End> cut(std::size_t at, std::int64_t depth);

private:
    BranchIndex const* index_; // Not owned.
    std::size_t look_from_ = 0;
    std::size_t end_ = 0;
};

} // namespace tractus::lsystem
