#include "app/render/font.h"

// The assembler embeds the font file, whose path is TRACTUS_FONT, between two labels.
__asm__(".section .rodata\n"
        ".balign 16\n"
        ".global tractus_font_begin\n"
        ".global tractus_font_end\n"
        "tractus_font_begin:\n"
        ".incbin \"" TRACTUS_FONT "\"\n"
        "tractus_font_end:\n"
        ".byte 0\n"
        ".previous\n");

// NOLINTBEGIN(readability-identifier-naming): labels of the assembler's.
extern "C" {
extern std::byte const tractus_font_begin[];
extern std::byte const tractus_font_end[];
}
// NOLINTEND(readability-identifier-naming)

namespace tractus::render {

std::span<std::byte const> font_file()
{
    return { tractus_font_begin, tractus_font_end };
}

} // namespace tractus::render
