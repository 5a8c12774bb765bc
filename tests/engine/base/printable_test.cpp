#include "engine/base/printable.h"

#include <gtest/gtest.h>
#include <string>

namespace tractus {
namespace {

TEST(Printable, EscapesWhatControlsATerminal)
{
    EXPECT_EQ(printable("a\x1b[31mb\x7f"), "a\\x1b[31mb\\x7f");
    EXPECT_EQ(printable(std::string("\0\a", 2)), "\\x00\\x07");
    EXPECT_EQ(printable("a\tb\nc\r"), "a\\tb\\nc\\r");
    EXPECT_EQ(printable("a\tb\nc\r", "\n\t"), "a\tb\nc\\r");
    EXPECT_EQ(printable("\xc2\x9b"
                        "31m"),
              "\\xc2\\x9b31m"); // U+009B has the same meaning as ESC [.
}

TEST(Printable, LeavesTextAndEscapesBytesThatAreNone)
{
    EXPECT_EQ(printable("Bäume … 樹 🌳 ~!\\"), "Bäume … 樹 🌳 ~!\\");
    EXPECT_EQ(printable("\xff\xc3"), "\\xff\\xc3");
    EXPECT_EQ(printable("\xe2\x80"), "\\xe2\\x80"); // The last character is truncated.
    EXPECT_EQ(printable("\xc2\xa0"), "\xc2\xa0");
    EXPECT_EQ(printable(""), "");
}

} // namespace
} // namespace tractus
