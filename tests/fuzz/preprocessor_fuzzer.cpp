#include "engine/base/check.h"
#include "engine/lsystem/text/source_text.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

// Fuzzes the preprocessor. The input up to the first zero byte is a model's text; the rest is the
// text of every file that the model includes. Every output character must have a position in the
// input.
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    std::string_view const input(reinterpret_cast<char const*>(data), size);
    auto const middle = std::min(input.find('\0'), input.size());
    auto const included = input.substr(std::min(middle + 1, input.size()));
    auto const include
        = [&](std::string const&) -> tractus::Result<std::string> { return std::string(included); };
    auto const source = tractus::lsystem::preprocess("model.l", input.substr(0, middle), include);
    if (!source)
        return 0;
    CHECK(source->places.size() == source->text.size() + 1);
    for (auto const& place : source->places) {
        CHECK(place.file < source->files.size());
        CHECK(place.line >= 1 && place.column >= 1);
    }
    CHECK(!source->place(source->text.size() / 2).empty());
    return 0;
}
