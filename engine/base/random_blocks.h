#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace tractus {

// Several of random_block()'s blocks at once, which a processor's vectors make in the time of two
// or three: of one seed and stream, each of its own substream and index, which must be below 2^32.
// Word w of block i is words[w][i].
struct RandomBlocks {
    static constexpr std::size_t kCount = 8;
    using Words = std::array<std::uint32_t, kCount>;

    std::array<Words, 4> words {};
};

RandomBlocks random_blocks(std::uint64_t seed, std::uint32_t stream,
                           RandomBlocks::Words const& substreams,
                           RandomBlocks::Words const& indices);

} // namespace tractus
