#include "engine/base/random.h"
#include "engine/export/fast_deflate.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>
#include <zlib.h>

namespace tractus::exports {
namespace {

std::vector<std::uint8_t> inflated(std::string const& packed, std::size_t size)
{
    std::vector<std::uint8_t> made(size + 1);
    std::string from = packed;
    z_stream stream {};
    EXPECT_EQ(inflateInit2(&stream, -15), Z_OK); // Without zlib's header.
    stream.next_in = reinterpret_cast<Bytef*>(from.data());
    stream.avail_in = static_cast<uInt>(from.size());
    stream.next_out = made.data();
    stream.avail_out = static_cast<uInt>(made.size());
    EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END) << (stream.msg ? stream.msg : "");
    EXPECT_EQ(stream.avail_in, 0u);
    made.resize(stream.total_out);
    inflateEnd(&stream);
    return made;
}

// Stretches of zeros, of one value and of random bytes up to a bound, of random lengths.
std::vector<std::uint8_t> sample(Random& random, std::size_t size)
{
    std::vector<std::uint8_t> made;
    while (made.size() < size) {
        auto const length = std::min<std::size_t>(size - made.size(), random.next_u64() % 900 + 1);
        auto const kind = random.next_u64() % 4;
        auto const bound = std::uint64_t { 1 } << random.next_u64() % 9;
        for (std::size_t i = 0; i < length; ++i)
            made.push_back(static_cast<std::uint8_t>(kind == 0       ? 0
                                                         : kind == 1 ? bound - 1
                                                                     : random.next_u64() % bound));
    }
    return made;
}

TEST(FastDeflate, ComesBackFromZlib)
{
    Random random({ .seed = 5, .stream = 1 });
    for (std::size_t const size : { 1u, 2u, 5u, 6u, 258u, 259u, 260u, 261u, 262u, 263u, 264u, 1000u,
                                    131071u, 131072u, 131073u, 400000u })
        for (int i = 0; i < 8; ++i) {
            auto const data = sample(random, size);
            std::string packed;
            append_deflated(data, packed);
            finish_deflated(packed);
            ASSERT_EQ(inflated(packed, size), data) << size;
        }
}

TEST(FastDeflate, TakesZerosOfEveryLength)
{
    for (std::size_t zeros = 0; zeros < 800; ++zeros) {
        std::vector<std::uint8_t> data(zeros, 0);
        data.push_back(7);
        std::string packed;
        append_deflated(data, packed);
        finish_deflated(packed);
        ASSERT_EQ(inflated(packed, data.size()), data) << zeros;
    }
}

TEST(FastDeflate, JoinsPieces)
{
    Random random({ .seed = 9, .stream = 1 });
    std::string packed;
    std::vector<std::uint8_t> all;
    for (std::size_t const size : { 3u, 0u, 70000u, 1u, 513u }) {
        auto const data = sample(random, size);
        append_deflated(data, packed);
        all.insert(all.end(), data.begin(), data.end());
    }
    finish_deflated(packed);
    EXPECT_EQ(inflated(packed, all.size()), all);
}

// Frequencies like Fibonacci numbers make the deepest trees. Codes have at most 15 bits.
TEST(FastDeflate, LimitsTheLengthOfCodes)
{
    std::vector<std::uint8_t> data;
    std::size_t a = 1;
    std::size_t b = 1;
    for (int value = 1; value < 24; ++value) {
        data.insert(data.end(), a, static_cast<std::uint8_t>(value));
        b += a;
        std::swap(a, b);
    }
    std::string packed;
    append_deflated(data, packed);
    finish_deflated(packed);
    EXPECT_EQ(inflated(packed, data.size()), data);
    EXPECT_LT(packed.size(), data.size() / 2);
}

} // namespace
} // namespace tractus::exports
