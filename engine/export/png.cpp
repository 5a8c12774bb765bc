#include "engine/export/png.h"

#include "engine/base/check.h"

#include <cstddef>
#include <string_view>
#include <zlib.h>

namespace tractus {

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
    auto const* const checked = reinterpret_cast<Bytef const*>(bytes.data() + start);
    append_u32_be(
        bytes,
        static_cast<std::uint32_t>(crc32(0, checked, static_cast<uInt>(bytes.size() - start))));
}

// Each row after a filter byte: 2, the difference to the row above, which suits soft pictures.
std::string filtered_rows(PngPicture const& picture)
{
    auto const& pixels = picture.pixels;
    auto const width = static_cast<std::size_t>(picture.width * picture.channels);
    std::string rows;
    rows.reserve(pixels.size() + static_cast<std::size_t>(picture.height));
    for (std::size_t start = 0; start < pixels.size(); start += width) {
        rows.push_back(2);
        for (std::size_t i = start; i < start + width; ++i) {
            int const above = start == 0 ? 0 : pixels[i - width];
            rows.push_back(static_cast<char>(pixels[i] - above));
        }
    }
    return rows;
}

std::string packed(std::string const& rows, int level)
{
    uLongf size = compressBound(static_cast<uLong>(rows.size()));
    std::string bytes(size, '\0');
    int const status = compress2(reinterpret_cast<Bytef*>(bytes.data()), &size,
                                 reinterpret_cast<Bytef const*>(rows.data()),
                                 static_cast<uLong>(rows.size()), level);
    CHECK(status == Z_OK);
    bytes.resize(size);
    return bytes;
}

// ISO/IEC 15948 section 11.2.2.
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
    header += '\x08'; // Bits.
    header += colour_type(picture.channels);
    header.append(3, '\0'); // Deflate, filters, no interlace.

    std::string bytes = "\x89PNG\r\n\x1a\n";
    append_chunk(bytes, "IHDR", header);
    bool const is_small = picture.packing == PngPicture::Packing::Small;
    append_chunk(bytes, "IDAT", packed(filtered_rows(picture), is_small ? 9 : 3));
    append_chunk(bytes, "IEND", "");
    return bytes;
}

} // namespace tractus
