#include "app/plants/stroke_file.h"

#include "drivers/file.h"
#include "engine/stroke/read_tilt.h"
#include "engine/stroke/stroke_text.h"

#include <span>

namespace tractus {

bool is_stroke_file(std::filesystem::path const& path)
{
    auto const ending = path.extension();
    return ending == ".tilt" || ending == ".strokes" || ending == ".txt";
}

Result<std::vector<Stroke>> load_strokes(std::filesystem::path const& path)
{
    constexpr std::size_t kMaxFileSize = std::size_t { 256 } << 20;
    auto const text = TRY(read_text_file(path, kMaxFileSize));
    if (path.extension() == ".tilt")
        return read_tilt(path.string(), std::as_bytes(std::span(text)));
    return parse_strokes(path.string(), text);
}

} // namespace tractus
