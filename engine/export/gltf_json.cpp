#include "engine/export/gltf_json.h"

#include <array>
#include <charconv>
#include <cmath>

namespace tractus::exports {

Json json_number(double value)
{
    constexpr double kMaxExact = 0x1p53; // Doubles represent all integers up to this exactly.
    if (std::abs(value) <= kMaxExact && value == std::trunc(value))
        return static_cast<std::int64_t>(value);
    return value;
}

// The JSON library writes only doubles. So a float becomes the double nearest to the float's
// shortest decimal form, which is then written.
Json json_number(float value)
{
    if (!std::isfinite(value))
        return value;
    std::array<char, 32> text;
    auto const written = std::to_chars(text.begin(), text.end(), value);
    double read = 0;
    std::from_chars(text.begin(), written.ptr, read);
    return json_number(read);
}

std::string json_text(Json const& value)
{
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::size_t JsonArray::add(Json const& element)
{
    if (count_ > 0)
        text_ += ',';
    text_ += json_text(element);
    return count_++;
}

std::string GltfJson::text(std::uint64_t buffer_bytes) const
{
    std::string text;
    auto const append = [&](char const* key, auto const&... parts) {
        text += text.empty() ? '{' : ',';
        text += json_text(key);
        text += ':';
        (text += ... += parts);
    };
    auto const add = [&](char const* key, Json const& value) { append(key, json_text(value)); };
    auto const add_array = [&](char const* key, JsonArray const& array) {
        if (array.count() > 0)
            append(key, "[", array.text(), "]");
    };
    add("asset", { { "version", "2.0" }, { "generator", "tractus" } });
    add("scene", 0);
    Json const required = required_extensions;
    Json used = required;
    for (auto const& name : optional_extensions)
        used.push_back(name);
    if (!used.empty())
        add("extensionsUsed", used);
    if (!required.empty())
        add("extensionsRequired", required);
    auto the_scene = Json::object();
    if (!scene.empty())
        the_scene["nodes"] = scene;
    add("scenes", Json::array({ the_scene }));
    add_array("nodes", nodes);
    add_array("meshes", meshes);
    add_array("animations", animations);
    add_array("materials", materials);
    add_array("textures", textures);
    add_array("images", images);
    add_array("samplers", samplers);
    add_array("accessors", accessors);
    add_array("bufferViews", buffer_views);
    auto buffers = Json::array();
    if (buffer_bytes > 0)
        buffers.push_back({ { "byteLength", buffer_bytes } });
    if (fallback_bytes > 0)
        buffers.push_back(
            { { "byteLength", fallback_bytes },
              { "extensions", { { "EXT_meshopt_compression", { { "fallback", true } } } } } });
    if (!buffers.empty())
        add("buffers", buffers);
    text += '}';
    return text;
}

} // namespace tractus::exports
