#include "engine/stroke/read_tilt.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <fmt/format.h>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>
#include <zip.h>

namespace tractus {

namespace {

using Bytes = std::span<std::byte const>;

constexpr std::size_t kMaxSketchBytes = std::size_t { 64 } << 20;
constexpr char const* kEntry = "data.sketch";

auto fail_reading(std::string const& name, std::string const& reason)
{
    return fail(Fault::User, fmt::format("{}: cannot read the sketch: {}", name, reason));
}

// Reads consecutive little-endian numbers. Past the end every number is 0, and is_good() is false.
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

struct CloseArchive {
    void operator()(zip_t* archive) const { zip_discard(archive); }
};
using Archive = std::unique_ptr<zip_t, CloseArchive>;

struct CloseEntry {
    void operator()(zip_file_t* entry) const { zip_fclose(entry); }
};
using Entry = std::unique_ptr<zip_file_t, CloseEntry>;

std::string reason_of(zip_error_t& error)
{
    std::string reason = zip_error_strerror(&error);
    zip_error_fini(&error);
    return reason;
}

Result<Archive> open_archive(std::string const& name, Bytes zip)
{
    zip_error_t error;
    zip_error_init(&error);
    auto* const source = zip_source_buffer_create(zip.data(), zip.size(), 0, &error);
    if (source == nullptr)
        return fail_reading(name, reason_of(error));
    auto* const archive = zip_open_from_source(source, ZIP_RDONLY, &error);
    if (archive == nullptr) {
        zip_source_free(source);
        return fail_reading(name, "its archive is damaged: " + reason_of(error));
    }
    zip_error_fini(&error);
    return Archive(archive);
}

// Extracts the file data.sketch. Reads until its data end, whatever size the archive claims.
Result<std::vector<std::byte>> find_sketch(std::string const& name, Bytes zip)
{
    auto const archive = TRY(open_archive(name, zip));
    Entry const entry(zip_fopen(archive.get(), kEntry, 0));
    if (!entry)
        return fail_reading(name,
                            fmt::format("there is no {} in it that can be read: {}", kEntry,
                                        zip_strerror(archive.get())));
    std::vector<std::byte> bytes;
    std::vector<std::byte> piece(std::size_t { 1 } << 16);
    for (;;) {
        auto const count = zip_fread(entry.get(), piece.data(), piece.size());
        if (count < 0)
            return fail_reading(name, "its strokes are packed in a damaged or unknown way");
        if (count == 0)
            return bytes;
        if (bytes.size() + static_cast<std::size_t>(count) > kMaxSketchBytes)
            return fail_reading(name, "its strokes are more than 64 MB");
        bytes.insert(bytes.end(), piece.begin(), piece.begin() + count);
    }
}

struct SketchStroke {
    Stroke stroke;
    bool has_time = false;
};

// Bits of the mask that lists the optional fields of each point of a stroke. Each such field has 4
// bytes.
constexpr std::uint32_t kPressureBit = 1;
constexpr std::uint32_t kTimeBit = 2;

// Converts from Tilt Brush's left-handed frame, in decimetres with y up.
Vec3 world_mm(float x, float y, float z)
{
    return 100 * Vec3(x, z, y);
}

bool read_stroke(Reader& in, SketchStroke& result)
{
    in.skip(4 + 16 + 4); // Skips brush, colour and size.
    auto const stroke_mask = in.read<std::uint32_t>();
    auto const point_mask = in.read<std::uint32_t>();
    for (std::uint32_t bit = 0; bit < 32; ++bit) {
        if ((stroke_mask >> bit & 1) == 0)
            continue;
        // Optional fields of the stroke: flags, scale, group and seed have four bytes each;
        // extensions, from bit 16 on, begin with their size.
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
        in.skip(16); // Skips the orientation of the controller.
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
    in.skip(8); // Skips the version and a reserved number.
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
