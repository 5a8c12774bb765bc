#include "engine/export/png.h"

#include "engine/base/check.h"

#include <algorithm>
#include <cstddef>
#include <libdeflate.h>
#include <memory>
#include <string_view>
#include <utility>
#include <zlib.h>

namespace tractus::exports {

namespace {

void append_u32_be(std::string& bytes, std::uint32_t value)
{
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes.push_back(static_cast<char>(value >> shift & 0xff));
}

void append_chunk(std::string& bytes, std::string_view type, std::string_view data)
{
    append_u32_be(bytes, static_cast<std::uint32_t>(data.size()));
    auto const start = bytes.size();
    bytes += type;
    bytes += data;
    append_u32_be(bytes, libdeflate_crc32(0, bytes.data() + start, bytes.size() - start));
}

// Unlike the elements of a vector, these bytes are not initialised.
using Bytes = std::unique_ptr<std::uint8_t[]>;

std::size_t row_bytes(PngPicture const& picture)
{
    return static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.channels);
}

// Applies PNG's filter 2 to each row: stores the difference from the row above, which suits smooth
// pictures. Each row begins with a byte for the number of its filter.
Bytes filtered_rows(PngPicture const& picture)
{
    auto const width = row_bytes(picture);
    auto rows
        = std::make_unique_for_overwrite<std::uint8_t[]>((width + 1) * std::size_t(picture.height));
    auto const* from = picture.pixels.data();
    auto* to = rows.get();
    for (int y = 0; y < picture.height; ++y) {
        *to++ = 2;
        if (y == 0)
            std::copy_n(from, width, to);
        else
            for (std::size_t i = 0; i < width; ++i)
                to[i] = static_cast<std::uint8_t>(from[i] - (from - width)[i]);
        from += width;
        to += width;
    }
    return rows;
}

// Compressed rows, made by zlib (Packing::Small) or by libdeflate at level 1 (Packing::Fast), which
// is several times as fast. libdeflate's best level takes too long for the little space that it
// saves.
struct Packed {
    Bytes bytes;
    std::size_t size = 0;
};

Packed pack_small(std::uint8_t const* rows, std::size_t size)
{
    constexpr int kBest = 9;
    uLongf packed = compressBound(static_cast<uLong>(size));
    auto bytes = std::make_unique_for_overwrite<std::uint8_t[]>(packed);
    int const status = compress2(bytes.get(), &packed, rows, static_cast<uLong>(size), kBest);
    CHECK(status == Z_OK);
    return { std::move(bytes), packed };
}

Packed pack_fast(std::uint8_t const* rows, std::size_t size)
{
    struct Free {
        void operator()(libdeflate_compressor* compressor) const
        {
            libdeflate_free_compressor(compressor);
        }
    };
    std::unique_ptr<libdeflate_compressor, Free> const compressor(libdeflate_alloc_compressor(1));
    CHECK(compressor);
    auto const most = libdeflate_zlib_compress_bound(compressor.get(), size);
    auto bytes = std::make_unique_for_overwrite<std::uint8_t[]>(most);
    auto const packed = libdeflate_zlib_compress(compressor.get(), rows, size, bytes.get(), most);
    CHECK(packed > 0);
    return { std::move(bytes), packed };
}

// Returns the colour type of a PNG file (ISO/IEC 15948 section 11.2.2).
char colour_type(int channels)
{
    return channels == 1 ? '\x00' : channels == 3 ? '\x02' : '\x06';
}

} // namespace

std::string png_bytes(PngPicture const& picture)
{
    CHECK(picture.width > 0 && picture.height > 0);
    CHECK(picture.channels == 1 || picture.channels == 3 || picture.channels == 4);
    CHECK(picture.pixels.size()
          == static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height)
              * static_cast<std::size_t>(picture.channels));
    std::string header;
    append_u32_be(header, static_cast<std::uint32_t>(picture.width));
    append_u32_be(header, static_cast<std::uint32_t>(picture.height));
    header += '\x08'; // Bit depth of each channel.
    header += colour_type(picture.channels);
    header.append(3, '\0'); // Three zeros: compression by deflate, default filters, not interlaced.

    std::string bytes = "\x89PNG\r\n\x1a\n";
    append_chunk(bytes, "IHDR", header);
    bool const is_small = picture.packing == PngPicture::Packing::Small;
    auto const rows = filtered_rows(picture);
    auto const size = (row_bytes(picture) + 1) * static_cast<std::size_t>(picture.height);
    auto const packed = is_small ? pack_small(rows.get(), size) : pack_fast(rows.get(), size);
    bytes.reserve(packed.size + 100);
    append_chunk(bytes, "IDAT", { reinterpret_cast<char const*>(packed.bytes.get()), packed.size });
    append_chunk(bytes, "IEND", "");
    return bytes;
}

} // namespace tractus::exports
