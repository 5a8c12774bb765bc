#pragma once

#include "engine/base/result.h"

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>
#include <string_view>

namespace tractus::exports {

// Writes the structure of a .glb file (glTF 2.0 section 4.4): a JSON chunk of a size fixed in
// advance, then a binary chunk with blocks, several of which can be open at a time. The file begins
// at the stream's current position.
class GlbStream {
public:
    // A block of the binary chunk. It is filled from its beginning to its end.
    struct Block {
        std::uint64_t start = 0; // Offset of the block in the binary chunk; a multiple of four.
        std::uint64_t size = 0;
        std::uint64_t written = 0;
    };

    // `json_room`: size of the JSON chunk in bytes; a multiple of four.
    GlbStream(std::ostream& out, std::uint64_t json_room);

    // Reserves `size` bytes at the end of the binary chunk.
    Block open_block(std::uint64_t size);

    // Appends `bytes` to a block. Several blocks may be filled in turn.
    void write(Block& block, std::span<std::byte const> bytes);

    // Fills in the headers and the JSON, which must fit into its chunk. All blocks must be full.
    // Fails if the stream has failed.
    Result<void> finish(std::string_view json);

    Result<void> check() const; // Fails if writing to the stream has failed.

    std::uint64_t binary_bytes() const { return binary_bytes_; }
    std::uint64_t file_bytes() const;

private:
    std::uint64_t binary_start() const;
    void seek(std::uint64_t offset);
    void put(void const* bytes, std::size_t size);
    void put_spaces(std::uint64_t count);
    void put_u32(std::initializer_list<std::uint32_t> values);

    std::ostream& out_;
    std::uint64_t json_room_;
    std::streamoff start_;
    std::uint64_t at_ = 0;  // Current position of the stream, relative to start_.
    std::uint64_t end_ = 0; // End of the data written so far, relative to start_.
    std::uint64_t binary_bytes_ = 0;
};

} // namespace tractus::exports
