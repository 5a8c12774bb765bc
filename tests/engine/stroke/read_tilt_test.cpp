#include "engine/stroke/read_tilt.h"

#include "engine/base/random.h"
#include "tests/corpus.h"
#include "tests/engine/stroke/corpus_strokes.h"
#include "tests/file_bytes.h"

#include <cstring>
#include <gtest/gtest.h>
#include <iterator>
#include <limits>
#include <zlib.h>

namespace tractus {
namespace {

using Buffer = std::vector<std::byte>;

// Codes of the compression methods of zip archives.
constexpr std::uint16_t kStored = 0;
constexpr std::uint16_t kDeflated = 8;

template<typename T> void put(Buffer& to, T value)
{
    auto const* const bytes = reinterpret_cast<std::byte const*>(&value);
    to.insert(to.end(), bytes, bytes + sizeof value);
}

void put(Buffer& to, Buffer const& from)
{
    to.insert(to.end(), from.begin(), from.end());
}

void put(Buffer& to, std::string const& text)
{
    for (char const letter : text)
        to.push_back(static_cast<std::byte>(letter));
}

// Returns the data of a .tilt sketch with two strokes. The first has three points with pressure,
// time and an unknown extension; the second has a single point.
Buffer sketch()
{
    Buffer data;
    put<std::uint32_t>(data, 0xc576a5cd);
    put<std::int32_t>(data, 5);
    put<std::int32_t>(data, 0);
    put<std::uint32_t>(data, 3);
    put(data, std::string("abc"));
    put<std::int32_t>(data, 2);
    for (std::int32_t const points : { 3, 1 }) {
        put(data, Buffer(24));
        put<std::uint32_t>(data, 1 << 1 | 1 << 16);
        put<std::uint32_t>(data, 3);
        put<float>(data, 1);         // Scale of the stroke.
        put<std::uint32_t>(data, 5); // The unknown extension begins with its size.
        put(data, Buffer(5));
        put<std::int32_t>(data, points);
        for (std::int32_t i = 0; i < points; ++i) {
            for (float const coordinate : { 1.f + static_cast<float>(i), 5.f, 2.f })
                put(data, coordinate);
            put(data, Buffer(16));
            put<float>(data, 0.5f);
            put<std::uint32_t>(data, 1000 + 20 * static_cast<std::uint32_t>(i));
        }
    }
    return data;
}

Buffer deflated(Buffer const& data)
{
    Buffer packed(compressBound(static_cast<uLong>(data.size())) + 64);
    z_stream stream {};
    deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(data.data()));
    stream.avail_in = static_cast<uInt>(data.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH);
    deflateEnd(&stream);
    return { packed.begin(), packed.begin() + static_cast<std::ptrdiff_t>(stream.total_out) };
}

void put_entry_fields(Buffer& to, std::uint16_t method, std::size_t packed, Buffer const& data)
{
    put<std::uint16_t>(to, 20); // Version of zip that is needed to extract the entry.
    put<std::uint16_t>(to, 0);
    put<std::uint16_t>(to, method);
    put<std::uint32_t>(to, 0); // Modification time and date.
    put(to,
        static_cast<std::uint32_t>(
            crc32_z(0, reinterpret_cast<Bytef const*>(data.data()), data.size())));
    put(to, static_cast<std::uint32_t>(packed));
    put(to, static_cast<std::uint32_t>(data.size()));
    put<std::uint16_t>(to, 11);
    put<std::uint16_t>(to, 0);
}

// Returns a .tilt file, which is a zip archive that contains the data of a sketch.
Buffer tilt(Buffer const& data, std::uint16_t method)
{
    auto const packed = method == kDeflated ? deflated(data) : data;
    Buffer zip;
    put<std::uint32_t>(zip, 0x04034b50);
    put_entry_fields(zip, method, packed.size(), data);
    put(zip, std::string("data.sketch"));
    put(zip, packed);
    auto const directory = zip.size();
    put<std::uint32_t>(zip, 0x02014b50);
    put<std::uint16_t>(zip, 20);
    put_entry_fields(zip, method, packed.size(), data);
    put(zip, Buffer(10));
    put<std::uint32_t>(zip, 0); // Offset of the header of the entry.
    put(zip, std::string("data.sketch"));
    auto const size = zip.size() - directory;
    put<std::uint32_t>(zip, 0x06054b50);
    put<std::uint32_t>(zip, 0);
    put<std::uint16_t>(zip, 1);
    put<std::uint16_t>(zip, 1);
    put(zip, static_cast<std::uint32_t>(size));
    put(zip, static_cast<std::uint32_t>(directory));
    put<std::uint16_t>(zip, 0);

    Buffer file;
    put(file, std::string("tilT"));
    put<std::uint16_t>(file, 16);
    put<std::uint16_t>(file, 1);
    put(file, Buffer(8));
    put(file, zip);
    return file;
}

TEST(ReadTilt, ReadsStoredAndDeflatedStrokes)
{
    for (auto const method : { kStored, kDeflated }) {
        auto const strokes = read_tilt("a.tilt", tilt(sketch(), method));
        ASSERT_TRUE(strokes) << strokes.error().message;
        ASSERT_EQ(strokes->size(), 1u); // A single point is not a stroke.
        auto const& tips = strokes->front().tips;
        ASSERT_EQ(tips.size(), 3u);
        EXPECT_EQ(tips[0].position_mm, Vec3(-100, 0, 0));
        EXPECT_EQ(tips[2].position_mm, Vec3(100, 0, 0));
        EXPECT_EQ(tips[1].pressure, 0.5);
        EXPECT_EQ(tips[1].time, timestamp_ns(1'020'000'000));
    }
}

TEST(ReadTilt, SaysWhatIsWrong)
{
    auto const error
        = [](Buffer const& bytes) { return read_tilt("a.tilt", bytes).error().message; };
    EXPECT_EQ(error({}), "a.tilt: cannot read the sketch: it does not begin like a .tilt file");
    auto whole = tilt(sketch(), kStored);
    Buffer const half(whole.begin(), whole.begin() + 60);
    EXPECT_EQ(error(half),
              "a.tilt: cannot read the sketch: its archive is damaged: Not a zip archive");
    auto short_sketch = sketch();
    short_sketch.resize(100);
    EXPECT_EQ(error(tilt(short_sketch, kDeflated)),
              "a.tilt: cannot read the sketch: stroke 1 of 2 is cut off");
    EXPECT_NE(error(tilt({}, kStored)).find("do not begin as they should"), std::string::npos);
}

// Zip archives of kilobytes whose sketch would take much more memory.
TEST(ReadTilt, RefusesToInflateFarMoreThanASketch)
{
    constexpr std::size_t kMebibyte = std::size_t { 1 } << 20;
    auto const refusal = [](Buffer const& bytes) {
        auto const strokes = read_tilt("a.tilt", bytes);
        EXPECT_FALSE(strokes);
        return strokes ? "" : strokes.error().message;
    };
    auto const bomb = tilt(Buffer(65 * kMebibyte), kDeflated);
    ASSERT_LT(bomb.size(), kMebibyte / 4);
    EXPECT_EQ(refusal(bomb), "a.tilt: cannot read the sketch: its strokes are more than 64 MB");

    // A sketch that claims more strokes, and a stroke that claims more points, than there are.
    constexpr std::size_t kStrokeCount = 19; // Offset of the number of strokes.
    constexpr std::size_t kPointCount = kStrokeCount + 4 + 24 + 4 * 4 + 5;
    for (auto const at : { kStrokeCount, kPointCount }) {
        auto claims = sketch();
        std::int32_t const most = std::numeric_limits<std::int32_t>::max();
        std::memcpy(claims.data() + at, &most, sizeof most);
        EXPECT_NE(refusal(tilt(claims, kDeflated)).find("is cut off"), std::string::npos) << at;
    }
}

TEST(ReadTilt, SurvivesAnyDamage)
{
    Random random({ .seed = 3 });
    for (auto const method : { kStored, kDeflated }) {
        auto const whole = tilt(sketch(), method);
        for (std::size_t size = 0; size < whole.size(); ++size)
            EXPECT_FALSE(read_tilt("a.tilt", std::span(whole).first(size)));
        for (int i = 0; i < 4000; ++i) {
            auto damaged = whole;
            for (int n = 0; n < 3; ++n)
                damaged[random.next_u32() % damaged.size()]
                    = static_cast<std::byte>(random.next_u32());
            auto const strokes = read_tilt("a.tilt", damaged);
            for (auto const& stroke : strokes ? *strokes : std::vector<Stroke> {})
                for (auto const& tip : stroke.tips)
                    EXPECT_TRUE(tip.position_mm.allFinite());
        }
    }
}

TEST(ReadTilt, ReadsASketchThatSomebodyDrew)
{
    auto const bytes = file_bytes(shipped("strokes") / "toolkit_sketch1.tilt");
    auto const strokes = read_tilt("toolkit_sketch1.tilt", std::as_bytes(std::span(bytes)));
    ASSERT_TRUE(strokes) << strokes.error().message;
    auto const expected = read_strokes(shipped("strokes") / "toolkit_sketch1.strokes.txt");
    ASSERT_EQ(strokes->size(), expected.size());
    Vec3 const moved = (*strokes)[0].tips[0].position_mm - expected[0][0];
    for (std::size_t i = 0; i < expected.size(); ++i) {
        ASSERT_EQ((*strokes)[i].tips.size(), expected[i].size());
        // The text has six digits, so the points are compared with a tolerance.
        for (std::size_t n = 0; n < expected[i].size(); ++n)
            EXPECT_LT(((*strokes)[i].tips[n].position_mm - moved - expected[i][n]).norm(), 0.02);
    }
}

} // namespace
} // namespace tractus
