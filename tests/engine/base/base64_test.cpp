#include "engine/base/base64.h"

#include <gtest/gtest.h>

namespace tractus {
namespace {

// The test vectors are those of RFC 4648, section 10.
TEST(Base64, WritesAndReadsThePublishedVectors)
{
    struct Vector {
        char const* bytes;
        char const* text;
    };
    for (auto const& [bytes, text] : { Vector { "", "" },
                                       { "f", "Zg==" },
                                       { "fo", "Zm8=" },
                                       { "foo", "Zm9v" },
                                       { "foob", "Zm9vYg==" },
                                       { "fooba", "Zm9vYmE=" },
                                       { "foobar", "Zm9vYmFy" } }) {
        EXPECT_EQ(base64(bytes), text);
        EXPECT_EQ(from_base64(text), bytes);
    }
    EXPECT_EQ(from_base64("Zg"), "f");
    EXPECT_EQ(from_base64("Zm 9v"), std::nullopt);
}

TEST(Base64, TakesAnyByte)
{
    std::string bytes;
    for (int i = 0; i < 256; ++i)
        bytes += static_cast<char>(i);
    EXPECT_EQ(from_base64(base64(bytes)), bytes);
}

} // namespace
} // namespace tractus
