#include "engine/export/glb_stream.h"

#include <algorithm>
#include <array>
#include <bit>

namespace tractus::exports {

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");

namespace {

// Constants of the layout of a .glb file (glTF 2.0 section 4.4).
constexpr std::uint32_t kMagic = 0x46546C67;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;
constexpr std::uint64_t kFileHeaderBytes = 12;
constexpr std::uint64_t kChunkHeaderBytes = 8;

} // namespace

GlbStream::GlbStream(std::ostream& out, std::uint64_t json_room)
    : out_(out)
    , json_room_(json_room)
    , start_(out.tellp())
{
    put_u32({ 0, 0, 0, 0, 0 }); // Space for the headers, which finish() fills in.
    put_spaces(json_room);
}

std::uint64_t GlbStream::binary_start() const
{
    return kFileHeaderBytes + 2 * kChunkHeaderBytes + json_room_;
}

std::uint64_t GlbStream::file_bytes() const
{
    return binary_bytes_ > 0 ? binary_start() + binary_bytes_ : binary_start() - kChunkHeaderBytes;
}

GlbStream::Block GlbStream::open_block(std::uint64_t size)
{
    if (binary_bytes_ == 0)
        put_u32({ 0, 0 });
    Block const block { binary_bytes_, size, 0 };
    binary_bytes_ += (size + 3) / 4 * 4;
    return block;
}

void GlbStream::write(Block& block, std::span<std::byte const> bytes)
{
    seek(binary_start() + block.start + block.written);
    put(bytes.data(), bytes.size());
    block.written += bytes.size();
    if (block.written == block.size && block.size % 4 != 0)
        put("\0\0\0", 4 - block.size % 4);
}

// Moves to a position that may be beyond the end of the stream. Files are extended by seeking;
// memory streams have to be filled with spaces up to that position.
void GlbStream::seek(std::uint64_t offset)
{
    if (offset == at_ || !out_)
        return;
    if (!out_.seekp(start_ + static_cast<std::streamoff>(offset)) && !out_.bad()) {
        out_.clear();
        out_.seekp(start_ + static_cast<std::streamoff>(end_));
        at_ = end_;
        put_spaces(offset - end_);
    }
    at_ = offset;
}

void GlbStream::put(void const* bytes, std::size_t size)
{
    out_.write(static_cast<char const*>(bytes), static_cast<std::streamsize>(size));
    at_ += size;
    end_ = std::max(end_, at_);
}

void GlbStream::put_spaces(std::uint64_t count)
{
    std::array<char, 1 << 14> spaces;
    spaces.fill(' ');
    for (; count > 0 && out_; count -= std::min<std::uint64_t>(count, spaces.size()))
        put(spaces.data(), std::min<std::uint64_t>(count, spaces.size()));
}

void GlbStream::put_u32(std::initializer_list<std::uint32_t> values)
{
    put(values.begin(), values.size() * sizeof(std::uint32_t));
}

Result<void> GlbStream::check() const
{
    if (!out_)
        return fail(Fault::User,
                    "cannot write the glTF file: the disk is full or the stream failed");
    return {};
}

Result<void> GlbStream::finish(std::string_view json)
{
    seek(0);
    put_u32({ kMagic, 2, static_cast<std::uint32_t>(file_bytes()),
              static_cast<std::uint32_t>(json_room_), kJsonChunk });
    put(json.data(), json.size());
    if (binary_bytes_ > 0) {
        seek(binary_start() - kChunkHeaderBytes);
        put_u32({ static_cast<std::uint32_t>(binary_bytes_), kBinaryChunk });
    }
    seek(end_);
    out_.flush();
    return check();
}

} // namespace tractus::exports
