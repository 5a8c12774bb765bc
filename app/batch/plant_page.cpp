#include "app/batch/plant_page.h"

#include "engine/base/base64.h"
#include "engine/base/markup.h"

#include <sstream>
#include <string_view>

// The assembler embeds the page's template, whose path is TRACTUS_PAGE, between two labels.
__asm__(".section .rodata\n"
        ".global tractus_page_begin\n"
        ".global tractus_page_end\n"
        "tractus_page_begin:\n"
        ".incbin \"" TRACTUS_PAGE "\"\n"
        "tractus_page_end:\n"
        ".byte 0\n"
        ".previous\n");

// NOLINTBEGIN(readability-identifier-naming): labels of the assembler's.
extern "C" {
extern char const tractus_page_begin[];
extern char const tractus_page_end[];
}
// NOLINTEND(readability-identifier-naming)

namespace tractus::batch {

Result<exports::GlbSummary> write_page(std::ostream& out, std::string const& title,
                                       std::span<exports::PlacedMesh const> plants,
                                       exports::GlbOptions const& options)
{
    auto glb = options;
    glb.organs = exports::GlbOptions::Organs::Instanced;
    glb.vertices = exports::GlbOptions::Vertices::Quantized;
    std::ostringstream bytes;
    auto const summary = TRY(exports::write_glb(bytes, plants, glb));
    std::string_view page(tractus_page_begin,
                          static_cast<std::size_t>(tractus_page_end - tractus_page_begin));
    // The template has placeholders between two signs: @TITLE@ and @GLB@.
    for (auto at = page.find('@'); at != std::string_view::npos; at = page.find('@')) {
        out << page.substr(0, at);
        page.remove_prefix(at + 1);
        auto const end = page.find('@');
        if (page.substr(0, end) == "TITLE")
            out << escape_markup(title);
        else
            out << base64(bytes.view());
        page.remove_prefix(end + 1);
    }
    out << page;
    if (!out)
        return fail(Fault::User, "the page could not be written: is the disk full?");
    return summary;
}

} // namespace tractus::batch
