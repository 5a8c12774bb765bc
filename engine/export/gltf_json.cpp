#include "engine/export/gltf_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tractus {

std::size_t JsonArray::add(std::string_view element)
{
    if (count_ > 0)
        text_ += ',';
    text_ += element;
    return count_++;
}

std::string quoted(std::string const& text)
{
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string GltfJson::text(std::uint64_t buffer_bytes) const
{
    std::string text = "{\"asset\":{\"version\":\"2.0\",\"generator\":\"tractus\"},\"scene\":0";
    JsonArray required;
    for (auto const& name : required_extensions)
        required.add(quoted(name));
    auto used = required;
    for (auto const& name : optional_extensions)
        used.add(quoted(name));
    if (used.count() > 0)
        text += fmt::format(",\"extensionsUsed\":[{}]", used.text());
    if (required.count() > 0)
        text += fmt::format(",\"extensionsRequired\":[{}]", required.text());
    text += scene.count() > 0 ? ",\"scenes\":[{\"nodes\":[" + scene.text() + "]}]"
                              : ",\"scenes\":[{}]";
    auto const append = [&](char const* key, JsonArray const& array) {
        if (array.count() > 0)
            text += fmt::format(",\"{}\":[{}]", key, array.text());
    };
    append("nodes", nodes);
    append("meshes", meshes);
    append("animations", animations);
    append("materials", materials);
    append("textures", textures);
    append("images", images);
    append("samplers", samplers);
    append("accessors", accessors);
    append("bufferViews", buffer_views);
    if (buffer_bytes > 0)
        text += fmt::format(",\"buffers\":[{{\"byteLength\":{}}}]", buffer_bytes);
    return text + "}";
}

} // namespace tractus
