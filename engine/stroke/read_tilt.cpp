#include "engine/stroke/read_tilt.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <fmt/format.h>
#include <limits>
#include <optional>
#include <string_view>
#include <zlib.h>

namespace tractus {

namespace {

using Bytes = std::span<std::byte const>;

constexpr std::size_t kMostSketchBytes = std::size_t { 64 } << 20;
constexpr std::string_view kEntry = "data.sketch";

auto fail_reading(std::string const& name, std::string const& reason)
{
    return fail(Fault::User, fmt::format("{}: cannot read the sketch: {}", name, reason));
}

// Little-endian numbers one after the other. Past the end everything is 0, and is_good() false.
class Reader {
public:
    explicit Reader(Bytes bytes)
        : bytes_(bytes)
    {
    }

    template<typename T> T read()
    {
        T value {};
        if (auto const from = take(sizeof value); !from.empty())
            std::memcpy(&value, from.data(), sizeof value);
        return value;
    }

    void skip(std::size_t count) { (void)take(count); }

    bool is_good() const { return is_good_; }
    std::size_t left() const { return bytes_.size(); }

private:
    Bytes take(std::size_t count)
    {
        if (count > bytes_.size()) {
            is_good_ = false;
            bytes_ = {};
            return {};
        }
        auto const taken = bytes_.first(count);
        bytes_ = bytes_.subspan(count);
        return taken;
    }

    Bytes bytes_;
    bool is_good_ = true;
};

// Takes a deflated entry apart, up to a limit.
std::optional<std::vector<std::byte>> inflated(Bytes packed, std::size_t size)
{
    std::vector<std::byte> bytes(size);
    z_stream stream {};
    if (inflateInit2(&stream, -MAX_WBITS) != Z_OK)
        return std::nullopt;
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(packed.data()));
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
    stream.avail_out = static_cast<uInt>(bytes.size());
    int const end = inflate(&stream, Z_FINISH);
    bool const is_whole = end == Z_STREAM_END && stream.avail_out == 0;
    inflateEnd(&stream);
    if (!is_whole)
        return std::nullopt;
    return bytes;
}

// The directory at a zip archive's end names its entries (APPNOTE.TXT sections 4.3.12 and 4.3.16).
struct Directory {
    std::size_t begin = 0;
    std::size_t entries = 0;
};

std::optional<Directory> find_directory(Bytes zip)
{
    constexpr std::size_t kEndSize = 22;
    constexpr std::uint32_t kEndMark = 0x06054b50;
    for (std::size_t back = kEndSize; back <= std::min(zip.size(), kEndSize + 0xffff); ++back) {
        Reader end(zip.subspan(zip.size() - back));
        if (end.read<std::uint32_t>() != kEndMark)
            continue;
        end.skip(6);
        auto const entries = end.read<std::uint16_t>();
        auto const size = end.read<std::uint32_t>();
        auto const begin = end.read<std::uint32_t>();
        // Counted from the end, since the offset may or may not count what is before the archive.
        auto const place = zip.size() - back - std::min<std::size_t>(size, zip.size() - back);
        return Directory { std::max<std::size_t>(place, std::min<std::size_t>(begin, place)),
                           entries };
    }
    return std::nullopt;
}

// What an entry's own header says, from its beginning.
Result<std::vector<std::byte>> unpacked(std::string const& name, Bytes entry, std::uint16_t method,
                                        std::size_t packed_size, std::size_t size)
{
    constexpr std::uint32_t kLocalMark = 0x04034b50;
    Reader header(entry);
    if (header.read<std::uint32_t>() != kLocalMark)
        return fail_reading(name, "its archive points to nothing");
    header.skip(22);
    auto const name_size = header.read<std::uint16_t>();
    auto const extra_size = header.read<std::uint16_t>();
    header.skip(std::size_t { name_size } + extra_size);
    if (!header.is_good() || packed_size > header.left())
        return fail_reading(name, "the file is cut off");
    if (size > kMostSketchBytes)
        return fail_reading(name, fmt::format("its strokes are {} bytes, more than 64 MB", size));
    auto const packed = entry.subspan(entry.size() - header.left(), packed_size);
    if (method == 0 && packed_size == size)
        return std::vector<std::byte>(packed.begin(), packed.end());
    if (method == 8)
        if (auto bytes = inflated(packed, size))
            return *std::move(bytes);
    return fail_reading(name, "its strokes are packed in a damaged or unknown way");
}

Result<std::vector<std::byte>> find_sketch(std::string const& name, Bytes zip)
{
    auto const directory = find_directory(zip);
    if (!directory)
        return fail_reading(name, "it has no archive, or the file is cut off");
    // Where the archive begins in the file, by its first entry's mark.
    Reader entries(zip.subspan(directory->begin));
    for (std::size_t i = 0; i < directory->entries && entries.is_good(); ++i) {
        constexpr std::uint32_t kEntryMark = 0x02014b50;
        if (entries.read<std::uint32_t>() != kEntryMark)
            break;
        entries.skip(6);
        auto const method = entries.read<std::uint16_t>();
        entries.skip(8);
        auto const packed_size = entries.read<std::uint32_t>();
        auto const size = entries.read<std::uint32_t>();
        auto const name_size = entries.read<std::uint16_t>();
        auto const extra_size = entries.read<std::uint16_t>();
        auto const comment_size = entries.read<std::uint16_t>();
        entries.skip(8);
        auto const offset = entries.read<std::uint32_t>();
        std::string entry_name;
        for (std::size_t n = 0; n < name_size && entries.is_good(); ++n)
            entry_name += entries.read<char>();
        entries.skip(std::size_t { extra_size } + comment_size);
        if (entries.is_good() && entry_name == kEntry && offset < zip.size())
            return unpacked(name, zip.subspan(offset), method, packed_size, size);
    }
    return fail_reading(name, "there is no data.sketch in it");
}

// Which of the optional numbers a stroke and its points have (bits of two masks), each 4 bytes but
// for the first stroke extension that says its own length.
struct SketchStroke {
    Stroke stroke;
    bool has_time = false;
};

constexpr std::uint32_t kPressureBit = 1;
constexpr std::uint32_t kTimeBit = 2;

// Tilt Brush is y up and left-handed, in decimetres.
Vec3 world_mm(float x, float y, float z)
{
    return 100 * Vec3(x, z, y);
}

bool read_stroke(Reader& in, SketchStroke& result)
{
    in.skip(4 + 16 + 4); // Brush, colour, size.
    auto const stroke_mask = in.read<std::uint32_t>();
    auto const point_mask = in.read<std::uint32_t>();
    for (std::uint32_t bit = 0; bit < 32; ++bit) {
        if ((stroke_mask >> bit & 1) == 0)
            continue;
        // Flags, scale, group and seed are four bytes; from the 17th bit on each says its size.
        in.skip(bit < 16 ? 4 : in.read<std::uint32_t>());
    }
    auto const count = in.read<std::uint32_t>();
    std::size_t const point_size = 28 + 4 * static_cast<std::size_t>(std::popcount(point_mask));
    if (!in.is_good() || count > in.left() / point_size)
        return false;
    result.has_time = (point_mask & kTimeBit) != 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        auto const x = in.read<float>();
        auto const y = in.read<float>();
        auto const z = in.read<float>();
        in.skip(16); // The controller's orientation.
        TipSample tip { .position_mm = world_mm(x, y, z), .pressure = 1, .touching = true };
        tip.time = timestamp_ns(std::int64_t { i } * 10'000'000);
        for (std::uint32_t bit = 1; bit != 0; bit <<= 1) {
            if ((point_mask & bit) == 0)
                continue;
            if (bit == kPressureBit)
                tip.pressure = std::clamp(static_cast<double>(in.read<float>()), 0.0, 1.0);
            else if (bit == kTimeBit)
                tip.time = timestamp_ns(std::int64_t { in.read<std::uint32_t>() } * 1'000'000);
            else
                in.skip(4);
        }
        result.stroke.tips.push_back(tip);
    }
    return in.is_good();
}

bool has_shape(Stroke const& stroke)
{
    auto const is_finite = [](TipSample const& tip) { return tip.position_mm.allFinite(); };
    auto const is_elsewhere
        = [&](TipSample const& tip) { return tip.position_mm != stroke.tips.front().position_mm; };
    return std::all_of(stroke.tips.begin(), stroke.tips.end(), is_finite)
        && std::any_of(stroke.tips.begin(), stroke.tips.end(), is_elsewhere);
}

void stand_on_desk(std::vector<Stroke>& strokes)
{
    Vec3 low_mm = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 high_mm = -low_mm;
    for (auto const& stroke : strokes)
        for (auto const& tip : stroke.tips) {
            low_mm = low_mm.cwiseMin(tip.position_mm);
            high_mm = high_mm.cwiseMax(tip.position_mm);
        }
    Vec3 const foot_mm((low_mm.x() + high_mm.x()) / 2, (low_mm.y() + high_mm.y()) / 2, low_mm.z());
    for (auto& stroke : strokes)
        for (auto& tip : stroke.tips.own())
            tip.position_mm -= foot_mm;
}

} // namespace

Result<std::vector<Stroke>> read_tilt(std::string const& name, std::span<std::byte const> bytes)
{
    constexpr std::uint32_t kMagic = 0x546c6974; // "tilT"
    constexpr std::uint32_t kSketchMagic = 0xc576a5cd;
    Reader file(bytes);
    bool const is_tilt = file.read<std::uint32_t>() == kMagic;
    auto const header_size = file.read<std::uint16_t>();
    if (!is_tilt || header_size < 8 || header_size > bytes.size())
        return fail_reading(name, "it does not begin like a .tilt file");
    auto const sketch = TRY(find_sketch(name, bytes.subspan(header_size)));

    Reader in(sketch);
    if (in.read<std::uint32_t>() != kSketchMagic)
        return fail_reading(name, "its strokes do not begin as they should");
    in.skip(8); // Version, and a reserved number.
    in.skip(in.read<std::uint32_t>());
    auto const count = in.read<std::int32_t>();
    std::vector<Stroke> strokes;
    for (std::int32_t i = 0; i < count; ++i) {
        SketchStroke read;
        if (!read_stroke(in, read))
            return fail_reading(name, fmt::format("stroke {} of {} is cut off", i + 1, count));
        if (!read.stroke.tips.empty() && has_shape(read.stroke))
            strokes.push_back(std::move(read.stroke));
    }
    if (strokes.empty())
        return fail_reading(name, "there is no stroke in it");
    stand_on_desk(strokes);
    return strokes;
}

} // namespace tractus
