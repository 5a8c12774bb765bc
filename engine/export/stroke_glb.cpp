#include "engine/export/stroke_glb.h"

#include "engine/export/glb_column.h"
#include "engine/export/glb_stream.h"
#include "engine/export/glb_writer.h"
#include "engine/export/gltf_frame.h"

#include <fmt/core.h>
#include <sstream>
#include <string>
#include <vector>

namespace tractus::exports {

namespace {

constexpr int kLineStrip = 3; // Primitive mode LINE_STRIP (glTF 2.0 section 5.24.4).
constexpr NumberFormat kPositions {};
constexpr NumberFormat kScalars { .components = 1, .element_bytes = 4 };

// The vertex data of one stroke, and the limits of its positions.
struct StrokeColumns {
    std::vector<Vec3f> positions_m;
    std::vector<float> pressures;
    std::vector<float> times_s;
    Vec3f low = Vec3f::Constant(std::numeric_limits<float>::infinity());
    Vec3f high = -low;
};

StrokeColumns columns_of(Stroke const& stroke)
{
    StrokeColumns columns;
    for (auto const& tip : stroke.tips) {
        Vec3f const position_m = to_gltf(tip.position_mm).cast<float>();
        columns.positions_m.push_back(position_m);
        columns.pressures.push_back(static_cast<float>(tip.pressure));
        columns.times_s.push_back(
            static_cast<float>(to_seconds(tip.time - stroke.tips.front().time)));
        columns.low = columns.low.cwiseMin(position_m);
        columns.high = columns.high.cwiseMax(position_m);
    }
    return columns;
}

template<typename Element>
Json::number_unsigned_t write_column(GlbStream& stream, GltfJson& json, NumberFormat const& format,
                                     std::vector<Element> const& elements,
                                     Json const& more = Json::object())
{
    auto column = open_column(stream, format, elements.size());
    stream.write(column.block, std::as_bytes(std::span(elements)));
    return add_accessor(json, column, kArrayBuffer, more);
}

void write_stroke(GlbStream& stream, GltfJson& json, Stroke const& stroke, std::size_t number)
{
    auto const columns = columns_of(stroke);
    Json attributes;
    attributes["POSITION"] = write_column(stream, json, kPositions, columns.positions_m,
                                          limits_json(columns.low, columns.high));
    attributes["_PRESSURE"] = write_column(stream, json, kScalars, columns.pressures);
    attributes["_TIME"] = write_column(stream, json, kScalars, columns.times_s);
    auto const name = fmt::format("stroke {}", number);
    Json const primitive { { "attributes", std::move(attributes) }, { "mode", kLineStrip } };
    auto const mesh
        = json.meshes.add({ { "name", name }, { "primitives", Json::array({ primitive }) } });
    json.scene.push_back(json.nodes.add(
        { { "name", name },
          { "mesh", mesh },
          { "extras", { { "begin_s", json_number(to_seconds(stroke.tips.front().time)) } } } }));
}

std::string write_strokes(GlbStream& stream, std::span<Stroke const> strokes)
{
    GltfJson json;
    for (std::size_t i = 0; i < strokes.size(); ++i)
        if (strokes[i].tips.size() > 1)
            write_stroke(stream, json, strokes[i], i + 1);
    auto text = json.text(stream.binary_bytes());
    text.resize((text.size() + 3) / 4 * 4, ' ');
    return text;
}

Result<void> check(std::span<Stroke const> strokes)
{
    constexpr std::uint64_t kBytesPerTip = 20;
    constexpr std::uint64_t kBytesPerStroke = 1500; // Maximum size of the JSON of a stroke.
    std::uint64_t bytes = 0;
    for (auto const& stroke : strokes) {
        bytes += kBytesPerStroke + kBytesPerTip * stroke.tips.size();
        for (auto const& tip : stroke.tips)
            if (!tip.position_mm.allFinite())
                return fail(Fault::Station, "a stroke has a tip that is nowhere");
    }
    if (bytes > kMaxGlbBytes)
        return fail(Fault::User,
                    fmt::format("{} strokes are more than the 4 GiB that a .glb file holds: write "
                                "fewer of them",
                                strokes.size()));
    return {};
}

} // namespace

// The JSON comes first in the file, but its size is known only after the strokes have been written.
// So the file is written twice, the first time to memory.
Result<void> write_strokes_glb(std::ostream& out, std::span<Stroke const> strokes)
{
    TRY(check(strokes));
    std::ostringstream tried;
    GlbStream trial(tried, 0);
    auto const room = write_strokes(trial, strokes).size();
    GlbStream stream(out, room);
    return stream.finish(write_strokes(stream, strokes));
}

} // namespace tractus::exports
