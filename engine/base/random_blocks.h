#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace tractus {

// The results of eight calls of random_block(), which random_blocks() computes at once with vector
// instructions, in the time of two or three calls. All share a seed and a stream; each has its own
// substream and index. Indices must be below 2^32. Word w of block i is words[w][i].
struct RandomBlocks {
    static constexpr std::size_t kCount = 8;
    using Words = std::array<std::uint32_t, kCount>;

    std::array<Words, 4> words {};
};

RandomBlocks random_blocks(std::uint64_t seed, std::uint32_t stream,
                           RandomBlocks::Words const& substreams,
                           RandomBlocks::Words const& indices);

} // namespace tractus
