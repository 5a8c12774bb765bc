#include "app/render/font.h"

// The assembler copies the file at TRACTUS_FONT between two labels.
__asm__(".section .rodata\n"
        ".balign 16\n"
        ".global kTractusFontBegin\n"
        ".global kTractusFontEnd\n"
        "kTractusFontBegin:\n"
        ".incbin \"" TRACTUS_FONT "\"\n"
        "kTractusFontEnd:\n"
        ".byte 0\n"
        ".previous\n");

// NOLINTBEGIN(readability-identifier-naming): labels of the assembler's.
extern "C" {
extern std::byte const kTractusFontBegin[];
extern std::byte const kTractusFontEnd[];
}
// NOLINTEND(readability-identifier-naming)

namespace tractus {

std::span<std::byte const> font_file()
{
    return { kTractusFontBegin, kTractusFontEnd };
}

} // namespace tractus
