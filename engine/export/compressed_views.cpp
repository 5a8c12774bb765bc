#include "engine/export/compressed_views.h"

#include "engine/base/parallel.h"
#include "engine/export/gltf_json.h"
#include "engine/export/gltf_scene.h"
#include "engine/export/mesh_codec.h"

#include <cstring>
#include <fmt/core.h>
#include <initializer_list>
#include <optional>
#include <utility>

namespace tractus::exports {
namespace {

constexpr char const* kMeshopt = "EXT_meshopt_compression";
constexpr std::size_t kJsonStart = 20;
constexpr std::uint64_t kMaxDecompressed = std::uint64_t { 1 } << 32;

// Returns a member of an object, or null if there is none.
Json const* member(Json const* object, char const* name)
{
    if (!object || !object->is_object())
        return nullptr;
    auto const found = object->find(name);
    return found == object->end() ? nullptr : &*found;
}

Json const* meshopt_of(Json const& element)
{
    return member(member(&element, "extensions"), kMeshopt);
}

auto fail_view(std::size_t view, char const* reason)
{
    return fail_reading(fmt::format("buffer view {}, which is compressed, {}", view, reason));
}

Result<CompressedView> view_from(Json const& json, std::size_t index)
{
    CompressedView view { .view = index };
    auto const text = [&](char const* name, std::string& to) {
        if (auto const* const value = member(&json, name); value && value->is_string())
            to = value->get<std::string>();
    };
    auto const number = [&](char const* name, auto& to) {
        auto const* const value = member(&json, name);
        if (value && value->is_number_unsigned())
            to = value->get<std::uint64_t>();
        return !value || value->is_number_unsigned();
    };
    bool const are_numbers = number("buffer", view.buffer) && number("byteOffset", view.offset)
        && number("byteLength", view.bytes) && number("byteStride", view.stride)
        && number("count", view.count);
    if (!are_numbers)
        return fail_view(index, "has a size that is no whole number");
    text("mode", view.mode);
    text("filter", view.filter);
    return view;
}

// Returns the file `glb` with another JSON chunk. `rest`: the bytes of `glb` after its JSON chunk.
std::string with_json(std::string_view glb, std::string_view rest, std::string json)
{
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::string made;
    made.reserve(kJsonStart + json.size() + rest.size());
    made += glb.substr(0, kJsonStart);
    made += json;
    made += rest;
    auto const put = [&](std::size_t at, std::size_t value) {
        auto const number = static_cast<std::uint32_t>(value);
        std::memcpy(made.data() + at, &number, sizeof number);
    };
    put(8, made.size());
    put(12, json.size());
    return made;
}

template<typename Value>
std::optional<Value> value_of(std::initializer_list<std::pair<std::string_view, Value>> words,
                              std::string_view wanted)
{
    for (auto const& [word, value] : words)
        if (word == wanted)
            return value;
    return std::nullopt;
}

std::optional<CodecMode> mode_of(std::string_view word)
{
    return value_of<CodecMode>({ { "ATTRIBUTES", CodecMode::Attributes },
                                 { "TRIANGLES", CodecMode::Triangles },
                                 { "INDICES", CodecMode::Indices } },
                               word);
}

std::optional<CodecFilter> filter_of(std::string_view word)
{
    return value_of<CodecFilter>({ { "NONE", CodecFilter::None },
                                   { "OCTAHEDRAL", CodecFilter::Octahedral },
                                   { "QUATERNION", CodecFilter::Quaternion },
                                   { "EXPONENTIAL", CodecFilter::Exponential } },
                                 word);
}

Result<CompressedElements> elements_of(CompressedView const& view, tinygltf::Model const& model)
{
    auto const mode = mode_of(view.mode);
    auto const filter = filter_of(view.filter);
    if (!mode || !filter)
        return fail_view(view.view, "has a mode or filter that is not known");
    if (view.buffer >= model.buffers.size())
        return fail_view(view.view, "has no buffer");
    auto const& buffer = model.buffers[view.buffer].data;
    if (view.offset > buffer.size() || view.bytes > buffer.size() - view.offset)
        return fail_view(view.view, "reaches beyond its buffer: the file is damaged");
    CompressedElements const elements {
        .mode = *mode,
        .filter = *filter,
        .count = view.count,
        .stride = view.stride,
        .bytes = std::as_bytes(std::span(buffer)).subspan(view.offset, view.bytes),
    };
    if (auto const* const flaw = find_flaw(elements))
        return fail_view(view.view, flaw);
    return elements;
}

// Checks that all views together have no more compressed bytes than the buffers. If views could
// share their bytes, a small file could require any amount of memory.
Result<void> check_total(std::vector<CompressedView> const& views, tinygltf::Model const& model)
{
    std::uint64_t left = 0;
    for (auto const& buffer : model.buffers)
        left += buffer.data.size();
    for (auto const& view : views) {
        if (view.bytes > left)
            return fail_reading("its compressed buffer views overlap");
        left -= view.bytes;
    }
    return {};
}

// The compressed elements of a view, and their place in the additional buffer, in bytes.
struct Decompression {
    CompressedElements from {};
    std::uint64_t start = 0;
    std::uint64_t size = 0;
};

Result<std::vector<Decompression>> plan_decompression(std::vector<CompressedView> const& views,
                                                      tinygltf::Model const& model)
{
    TRY(check_total(views, model));
    std::vector<Decompression> plan;
    std::uint64_t start = 0;
    for (auto const& view : views) {
        if (view.view >= model.bufferViews.size())
            return fail_view(view.view, "does not exist");
        auto const elements = TRY(elements_of(view, model));
        auto const size = elements.count * elements.stride;
        plan.push_back({ elements, start, size });
        start += (size + 3) / 4 * 4;
        if (start > kMaxDecompressed)
            return fail_reading("its compressed buffer views hold more than 4 GiB");
    }
    return plan;
}

} // namespace

Result<CompressedViews> find_compressed_views(std::string_view glb)
{
    CompressedViews found;
    std::uint32_t json_bytes = 0;
    std::memcpy(&json_bytes, glb.data() + 12, sizeof json_bytes);
    auto const text = glb.substr(kJsonStart, json_bytes);
    if (text.find(kMeshopt) == std::string_view::npos)
        return found;
    auto json = Json::parse(text, nullptr, false);
    auto const* const views = member(&json, "bufferViews");
    if (!views || !views->is_array())
        return found;
    for (std::size_t i = 0; i < views->size(); ++i)
        if (auto const* const meshopt = meshopt_of((*views)[i]))
            found.views.push_back(TRY(view_from(*meshopt, i)));
    if (found.views.empty())
        return found;
    if (auto const buffers = json.find("buffers"); buffers != json.end() && buffers->is_array())
        for (auto& buffer : *buffers)
            if (meshopt_of(buffer) && !buffer.contains("uri"))
                buffer["byteLength"] = 1;
    found.glb = with_json(glb, glb.substr(kJsonStart + json_bytes), json_text(json));
    return found;
}

Result<void> decompress_views(std::vector<CompressedView> const& views, tinygltf::Model& model)
{
    if (views.empty())
        return {};
    auto const plan = TRY(plan_decompression(views, model));
    std::vector<unsigned char> data((plan.back().start + plan.back().size + 3) / 4 * 4);
    std::vector<char> succeeded(plan.size());
    parallel_for(plan.size(), 1, [&](std::size_t begin, std::size_t end) {
        auto const bytes = std::as_writable_bytes(std::span(data));
        for (auto i = begin; i != end; ++i)
            succeeded[i] = decompress(plan[i].from, bytes.subspan(plan[i].start, plan[i].size));
    });
    for (std::size_t i = 0; i < plan.size(); ++i) {
        if (!succeeded[i])
            return fail_view(views[i].view, "is damaged");
        auto& view = model.bufferViews[views[i].view];
        view.buffer = static_cast<int>(model.buffers.size());
        view.byteOffset = plan[i].start;
        view.byteLength = plan[i].size;
        if (plan[i].from.mode == CodecMode::Attributes)
            view.byteStride = plan[i].from.stride;
    }
    model.buffers.emplace_back().data = std::move(data);
    return {};
}

} // namespace tractus::exports
