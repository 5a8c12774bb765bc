#include "engine/export/png.h"

#include "engine/base/check.h"
#include "engine/export/fast_deflate.h"

#include <algorithm>
#include <cstddef>
#include <libdeflate.h>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>
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

std::string file_header(int width, int height, int channels)
{
    std::string header;
    append_u32_be(header, static_cast<std::uint32_t>(width));
    append_u32_be(header, static_cast<std::uint32_t>(height));
    header += '\x08'; // Bit depth of each channel.
    header += colour_type(channels);
    header.append(3, '\0'); // Three zeros: compression by deflate, default filters, not interlaced.
    std::string bytes = "\x89PNG\r\n\x1a\n";
    append_chunk(bytes, "IHDR", header);
    return bytes;
}

} // namespace

std::string png_bytes(PngPicture const& picture)
{
    CHECK(picture.width > 0 && picture.height > 0);
    CHECK(picture.channels == 1 || picture.channels == 3 || picture.channels == 4);
    CHECK(picture.pixels.size()
          == static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height)
              * static_cast<std::size_t>(picture.channels));
    auto bytes = file_header(picture.width, picture.height, picture.channels);
    bool const is_small = picture.packing == PngPicture::Packing::Small;
    auto const rows = filtered_rows(picture);
    auto const size = (row_bytes(picture) + 1) * static_cast<std::size_t>(picture.height);
    auto const packed = is_small ? pack_small(rows.get(), size) : pack_fast(rows.get(), size);
    bytes.reserve(packed.size + 100);
    append_chunk(bytes, "IDAT", { reinterpret_cast<char const*>(packed.bytes.get()), packed.size });
    append_chunk(bytes, "IEND", "");
    return bytes;
}

PngStrips::PngStrips(int width, int height, int channels)
    : width_(width)
    , height_(height)
    , channels_(channels)
{
    CHECK(width > 0 && height > 0 && (channels == 1 || channels == 3 || channels == 4));
}

PngStrips::Strip PngStrips::pack(std::span<std::uint8_t const> rows,
                                 std::span<std::uint8_t const> above) const
{
    // Rows are filtered and packed some at a time, so that they stay in the processor's cache.
    constexpr std::size_t kPiece = 1 << 17;
    auto const width = static_cast<std::size_t>(width_) * static_cast<std::size_t>(channels_);
    CHECK(rows.size() % width == 0 && (above.empty() || above.size() == width));
    auto const count = rows.size() / width;
    auto const each = std::max<std::size_t>(1, kPiece / (width + 1));
    Strip strip { .bytes = count * (width + 1) };
    std::vector<std::uint8_t> filtered;
    std::string packed;
    for (std::size_t first = 0; first < count; first += each) {
        auto const end = std::min(count, first + each);
        filtered.resize((end - first) * (width + 1));
        auto* to = filtered.data();
        for (auto y = first; y < end; ++y) {
            auto const* const row = rows.data() + y * width;
            auto const* const up = y > 0 ? row - width : above.empty() ? nullptr : above.data();
            *to++ = 2; // The number of the filter: the difference from the row above.
            for (std::size_t i = 0; i < width; ++i)
                to[i] = static_cast<std::uint8_t>(row[i] - (up ? up[i] : 0));
            to += width;
        }
        strip.sum = libdeflate_adler32(strip.sum, filtered.data(), filtered.size());
        append_deflated(filtered, packed);
    }
    append_chunk(strip.chunk, "IDAT", packed);
    return strip;
}

std::string PngStrips::header() const
{
    auto bytes = file_header(width_, height_, channels_);
    append_chunk(bytes, "IDAT", "\x78\x01"); // The stream's header, of zlib (RFC 1950).
    return bytes;
}

void PngStrips::append(Strip const& strip, std::string& file)
{
    file += strip.chunk;
    sum_ = static_cast<std::uint32_t>(
        adler32_combine(sum_, strip.sum, static_cast<z_off_t>(strip.bytes)));
}

std::string PngStrips::end() const
{
    std::string last;
    finish_deflated(last);
    append_u32_be(last, sum_);
    std::string bytes;
    append_chunk(bytes, "IDAT", last);
    append_chunk(bytes, "IEND", "");
    return bytes;
}

} // namespace tractus::exports
