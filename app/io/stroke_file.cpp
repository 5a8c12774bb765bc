#include "app/io/stroke_file.h"

#include "drivers/logs/foreign_log.h"
#include "engine/base/file.h"
#include "engine/export/stroke_glb.h"
#include "engine/stroke/read_tilt.h"
#include "engine/stroke/stroke_text.h"

#include <span>

namespace tractus::io {

bool is_stroke_file(std::filesystem::path const& path)
{
    auto const ending = path.extension();
    if (ending == ".txt")
        return !drivers::guess_file_format(path);
    return ending == ".tilt" || ending == ".strokes";
}

Result<std::vector<Stroke>> load_strokes(std::filesystem::path const& path)
{
    constexpr std::size_t kMaxStrokeFileSize = std::size_t { 256 } << 20;
    auto const text = TRY(read_text_file(path, kMaxStrokeFileSize));
    if (path.extension() == ".tilt")
        return read_tilt(path.string(), std::as_bytes(std::span(text)));
    return parse_strokes(path.string(), text);
}

std::vector<Stroke> strokes_of(scene::Scene const& scene)
{
    std::vector<Stroke> strokes;
    for (auto const& association : scene.associations) {
        auto const& stroke = association.what.stroke;
        if (strokes.empty() || strokes.back().tips.front().time != stroke.tips.front().time)
            strokes.push_back(stroke);
    }
    return strokes;
}

bool can_write_strokes_to(std::filesystem::path const& path)
{
    auto const ending = path.extension();
    return ending == ".strokes" || ending == ".txt" || ending == ".glb" || ending == ".svg";
}

Result<void> write_strokes(std::filesystem::path const& path, std::span<Stroke const> strokes,
                           exports::StrokeView view)
{
    return write_file(path, [&](std::ostream& out) -> Result<void> {
        if (path.extension() == ".glb")
            return exports::write_strokes_glb(out, strokes);
        if (path.extension() == ".svg")
            return exports::write_strokes_svg(out, strokes, view);
        out << print_strokes(strokes);
        return {};
    });
}

} // namespace tractus::io
