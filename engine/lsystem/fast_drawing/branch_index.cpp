#include "engine/lsystem/fast_drawing/branch_index.h"

#include "engine/base/parallel.h"

namespace tractus::lsystem {

BranchIndex::BranchIndex(Model const& model, ModuleString const& string, std::size_t long_branch)
    : string_(string)
    , long_branch_(long_branch)
    , kind_count_(model.alphabet.kinds.size())
    , blocks_((string.size() + kBlock - 1) / kBlock)
    , floors_((blocks_.size() + kSuperblock - 1) / kSuperblock)
{
    for (std::size_t i = 0; i < model.alphabet.kinds.size(); ++i) {
        auto const& kind = model.alphabet.kinds[i];
        steps_[i] = { kind.parameter_count, (kind.symbol == '[') - (kind.symbol == ']') };
    }
    for (std::size_t i = 0; i < kind_count_ * kind_count_; ++i)
        pairs_.push_back(pair(steps_[i / kind_count_], steps_[i % kind_count_]));
    // Measures each block by itself, then sums the results over the blocks before it.
    parallel_for(blocks_.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (auto b = begin; b < end; ++b)
            blocks_[b] = measure(b);
    });
    Block next;
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
        auto const own = blocks_[b];
        blocks_[b].parameter = next.parameter;
        blocks_[b].depth = next.depth;
        blocks_[b].floor += next.depth;
        blocks_[b].opening += next.depth;
        next.parameter += own.parameter;
        next.depth += own.depth;
        auto& floor = floors_[b / kSuperblock];
        floor = b % kSuperblock == 0 ? blocks_[b].floor : std::min(floor, blocks_[b].floor);
    }
    parallel_for(blocks_.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (auto b = begin; b < end; ++b)
            blocks_[b].opens_long = may_open_long(b);
    });
}

// Returns true if a branch that opens in the block may be long: it is still open at the beginning
// of the following blocks.
bool BranchIndex::may_open_long(std::size_t block) const
{
    auto const opening = blocks_[block].opening;
    auto const end = std::min(block + long_branch_ / kBlock, blocks_.size() - 1);
    for (auto b = block + 1; b <= end; ++b)
        if (blocks_[b].depth < opening)
            return false;
    return opening < kBeyond / 2;
}

std::size_t BranchIndex::next_opening(std::size_t module) const
{
    auto block = module / kBlock;
    if (block < blocks_.size() && blocks_[block].opens_long)
        return module;
    while (block < blocks_.size() && !blocks_[block].opens_long)
        ++block;
    return std::min(block * kBlock, string_.size());
}

BranchIndex::Pair BranchIndex::pair(Step const& first, Step const& second)
{
    auto const depth = first.depth + second.depth;
    auto const opening = first.depth > 0 ? first.depth : second.depth > 0 ? depth : kNoOpening;
    return { static_cast<std::uint16_t>(first.parameters + second.parameters),
             static_cast<std::int8_t>(depth),
             static_cast<std::int8_t>(std::min(first.depth, depth)), opening };
}

// Computes the number of parameters in a block, the change of depth over it, and the lowest depths
// in it.
BranchIndex::Block BranchIndex::measure(std::size_t block) const
{
    auto const begin = block * kBlock;
    auto const size = std::min(kBlock, string_.size() - begin);
    auto const* const kinds = string_.kinds.data() + begin;
    std::uint32_t parameters = 0;
    std::int32_t depth = 0;
    std::int32_t floor = 0;
    std::int32_t opening = kNoOpening;
    auto const add = [&](Pair const& next) {
        parameters += next.parameters;
        floor = std::min(floor, depth + next.floor);
        opening = std::min(opening, depth + next.opening);
        depth += next.depth;
    };
    for (std::size_t i = 0; i + 1 < size; i += 2)
        add(pairs_[kinds[i] * kind_count_ + kinds[i + 1]]);
    if (size % 2 != 0)
        add(pair(steps_[kinds[size - 1]], {}));
    Block result;
    result.parameter = parameters;
    result.depth = depth;
    result.floor = floor;
    if (opening < kNoOpening / 2)
        result.opening = opening;
    return result;
}

// Returns the first block, from `block` on, in which the depth falls below `depth`.
std::size_t BranchIndex::first_block_below(std::size_t block, std::int64_t depth) const
{
    while (block < blocks_.size()) {
        if (block % kSuperblock == 0 && floors_[block / kSuperblock] >= depth)
            block += kSuperblock;
        else if (blocks_[block].floor >= depth)
            ++block;
        else
            return block;
    }
    return blocks_.size();
}

BranchIndex::End BranchIndex::find_end(std::size_t module) const
{
    // Depths and parameter indices count from the beginning of the string.
    auto block = std::min(module / kBlock, blocks_.size());
    std::int64_t depth_inside = 0;
    bool is_known = false; // True once depth_inside is known.
    while (block < blocks_.size()) {
        auto depth = blocks_[block].depth;
        auto parameter = blocks_[block].parameter;
        auto const last = std::min((block + 1) * kBlock, string_.size());
        for (auto i = block * kBlock; i < last; ++i) {
            if (i == module) {
                depth_inside = depth;
                is_known = true;
            }
            auto const& step = steps_[string_.kinds[i]];
            depth += step.depth;
            if (is_known && depth < depth_inside)
                return { i, parameter };
            parameter += step.parameters;
        }
        block = first_block_below(block + 1, depth_inside);
    }
    return { string_.size(), string_.parameters.size() };
}

std::size_t BranchIndex::parameter(std::size_t module) const
{
    auto const block = std::min(module / kBlock, blocks_.size() - 1);
    auto result = blocks_[block].parameter;
    for (auto i = block * kBlock; i < module; ++i)
        result += steps_[string_.kinds[i]].parameters;
    return result;
}

std::optional<BranchIndex::End> BranchCutter::cut(std::size_t at, std::int64_t depth)
{
    auto const long_branch = index_->long_branch();
    if (end_ - at < 2 * long_branch) {
        look_from_ = end_;
        return std::nullopt;
    }
    if (!index_->may_be_long(at + 1, depth))
        return std::nullopt;
    auto const end = index_->find_end(at + 1);
    if (end.module - at < long_branch || end.module >= end_ || end_ - end.module < long_branch) {
        // Searches again only a little later, which bounds the cost of failed searches.
        look_from_ = at + long_branch / 32;
        return std::nullopt;
    }
    return end;
}

} // namespace tractus::lsystem
