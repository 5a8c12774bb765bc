#include "engine/base/markup.h"

#include <gtest/gtest.h>

namespace tractus {
namespace {

TEST(Markup, KeepsOrdinaryText)
{
    EXPECT_EQ(escape_markup("Linde, 30 % höher; it's 'old'"), "Linde, 30 % höher; it's 'old'");
    EXPECT_EQ(escape_markup(""), "");
}

TEST(Markup, CannotBeginATagOrEndAnAttribute)
{
    EXPECT_EQ(escape_markup("<a href=\"x\">&amp;</a>"),
              "&lt;a href=&quot;x&quot;&gt;&amp;amp;&lt;/a&gt;");
}

} // namespace
} // namespace tractus
