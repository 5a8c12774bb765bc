#include "app/methods/construction_lines/read_json_organs.h"

#include "app/methods/construction_lines/read_json_lines.h"
#include "engine/lsystem/view/view_texture.h"
#include "engine/methods/construction_lines/organ_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace tractus::lines {

using nlohmann::json;

namespace {

constexpr std::array kViewKeys { "left", "right", "midrib", "section" };
constexpr std::array kLayerKeys { "pattern", "divergence", "face", "organ" };

// Reads the number N of organs per whorl from "whorled(N)"; "whorled" alone means 3. No value for
// other words.
std::optional<int> whorl_of(std::string_view word)
{
    constexpr std::string_view kWhorled = "whorled";
    if (!word.starts_with(kWhorled))
        return std::nullopt;
    word.remove_prefix(kWhorled.size());
    if (word.empty())
        return Pattern().whorl;
    if (!word.starts_with('(') || !word.ends_with(')'))
        return std::nullopt;
    word = word.substr(1, word.size() - 2);
    int count = 0;
    auto const [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
    if (error != std::errc() || end != word.data() + word.size() || count < 2 || count > 24)
        return std::nullopt;
    return count;
}

Result<Pattern> read_pattern_word(json const& file)
{
    constexpr std::string_view kWhatToGive = "give \"distichous\", \"decussate\", \"spiral\", "
                                             "\"alternate\", or \"whorled(N)\" with N from 2 to 24";
    if (!has_value(file, "pattern") && has_value(file, "strokes"))
        // In a file of strokes, "pattern" may be missing: the line tool's default is used.
        return Pattern { .kind = Pattern::Kind::Distichous };
    if (!has_value(file, "pattern") || !file["pattern"].is_string())
        return fail(Fault::User, fmt::format("pattern is missing: {}", kWhatToGive));
    auto const& word = file["pattern"].get_ref<std::string const&>();
    Pattern pattern;
    if (auto const count = whorl_of(word)) {
        pattern.kind = Pattern::Kind::Whorled;
        pattern.whorl = *count;
        return pattern;
    }
    using enum Pattern::Kind;
    for (auto const kind : { Distichous, Decussate, Spiral, Alternate })
        if (word == name_of(kind)) {
            pattern.kind = kind;
            return pattern;
        }
    return fail(Fault::User, fmt::format("pattern is \"{}\": {}", word.substr(0, 40), kWhatToGive));
}

Result<Pattern::Sizes> read_sizes(json const& file)
{
    if (!has_value(file, "sizes") || file["sizes"] == "linear")
        return Pattern::Sizes::Linear;
    if (file["sizes"] == "half-ellipses")
        return Pattern::Sizes::HalfEllipses;
    return fail(Fault::User,
                "sizes is no way to change around the stem: give \"linear\" or "
                "\"half-ellipses\"");
}

Result<Pattern::Face> read_face(json const& face)
{
    constexpr std::array kFaces { "flat", "up", "down" };
    auto const found = std::find(kFaces.begin(), kFaces.end(), face);
    if (found == kFaces.end())
        return fail(Fault::User,
                    "face is no way to turn organs: give \"flat\", \"up\" or \"down\"");
    return static_cast<Pattern::Face>(1 + (found - kFaces.begin()));
}

// Reads the angles of a pattern whose kind has been read before. Kinds without a divergence ignore
// this key.
Result<void> read_turns(json const& object, Pattern& pattern)
{
    if (has_value(object, "face"))
        pattern.face = TRY(read_face(object["face"]));
    if (!has_value(object, "divergence"))
        return {};
    auto const& value = object["divergence"];
    double const divergence_deg = value.is_number() ? value.get<double>() : std::nan("");
    if (!(std::fabs(divergence_deg) <= 360))
        return fail(Fault::User, "divergence is no angle: give degrees from -360 to 360");
    if (pattern.kind == Pattern::Kind::Spiral || pattern.kind == Pattern::Kind::Alternate)
        pattern.divergence_deg = divergence_deg;
    return {};
}

Result<Pattern> read_kind(json const& object)
{
    auto pattern = TRY(read_pattern_word(object));
    if (pattern.kind == Pattern::Kind::Alternate)
        pattern.divergence_deg = 180;
    return pattern;
}

template<typename Keys>
Result<void> check_keys(json const& object, Keys const& known, std::string_view what)
{
    for (auto const& [key, value] : object.items())
        if (std::find(known.begin(), known.end(), key) == known.end())
            return fail(Fault::User,
                        fmt::format("{} has no \"{}\": give {}", what, key.substr(0, 40),
                                    fmt::join(known, ", ")));
    return {};
}

// Reads and checks an image file beside the sketch. The file's bytes are kept, so that the model
// does not need the file later.
Result<std::shared_ptr<std::string const>> read_texture(json const& value,
                                                        PictureReader const& pictures)
{
    if (!value.is_string())
        return fail(Fault::User,
                    "texture of the organ is no file: give the name of a PNG picture beside the "
                    "sketch, such as \"petal.png\"");
    auto const name = value.get<std::string>();
    auto const about = [&](Error const& error) {
        return fail(
            error.fault,
            fmt::format("texture \"{}\" of the organ: {}", name.substr(0, 80), error.message));
    };
    auto png = pictures(name);
    if (!png)
        return about(png.error());
    Material shown;
    if (auto const put = lsystem::put_texture(shown, *png); !put)
        return about(put.error());
    return std::make_shared<std::string const>(*std::move(png));
}

Result<OrganSurface> read_surface(json const& organ, PictureReader const& pictures)
{
    std::vector<std::string_view> keys(kViewKeys.begin(), kViewKeys.end());
    keys.insert(keys.end(), { "color", "texture" });
    TRY(check_keys(organ, keys, "organ"));
    OrganViews views;
    std::array const lines { &views.left, &views.right, &views.midrib, &views.section };
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (has_value(organ, kViewKeys[i]))
            *lines[i] = TRY(
                read_flat_line(organ[kViewKeys[i]], fmt::format("{} of the organ", kViewKeys[i])));
    OrganSurface surface { .patches = TRY(organ_surface(views)) };
    if (has_value(organ, "color"))
        surface.color = TRY(parse_color(
            organ["color"].is_string() ? organ["color"].get<std::string>() : std::string()));
    if (has_value(organ, "texture"))
        surface.picture = TRY(read_texture(organ["texture"], pictures));
    return surface;
}

// Reads the organ of a layer: null, the name of a file, or a leaf in three views.
Result<void> read_layer_organ(json const& organ, LayerOrgans& layer,
                              std::vector<OrganSource>& organs, PictureReader const& pictures)
{
    if (organ.is_null())
        return {};
    if (!organ.is_string() && !organ.is_object())
        return fail(Fault::User,
                    "organs are no sketches: write [\"leaf.json\", null], for each layer from "
                    "below the file of a sketch, a leaf's views, or null for leaves");
    auto const file = organ.is_string() ? organ.get<std::string>() : "";
    auto const known = std::find_if(organs.begin(), organs.end(), [&](OrganSource const& other) {
        return !file.empty() && other.file == file;
    });
    layer.organ = static_cast<std::size_t>(known - organs.begin()) + 1;
    if (known != organs.end())
        return {};
    organs.push_back({ .file = file });
    if (file.empty())
        organs.back().surface = TRY(read_surface(organ, pictures));
    return {};
}

bool is_layer(json const& entry)
{
    auto const has = [&](char const* key) { return entry.contains(key); };
    return entry.is_object() && std::any_of(kLayerKeys.begin(), kLayerKeys.end(), has);
}

Result<LayerOrgans> read_layer(json const& entry, Pattern const& of_sketch,
                               std::vector<OrganSource>& organs, PictureReader const& pictures)
{
    LayerOrgans layer;
    if (!is_layer(entry)) {
        TRY(read_layer_organ(entry, layer, organs, pictures));
        return layer;
    }
    TRY(check_keys(entry, kLayerKeys, "a layer of organs"));
    auto pattern = of_sketch;
    if (has_value(entry, "pattern")) {
        pattern = TRY(read_kind(entry));
        pattern.face = of_sketch.face;
    }
    TRY(read_turns(entry, pattern));
    if (pattern != of_sketch)
        layer.pattern = pattern;
    if (has_value(entry, "organ"))
        TRY(read_layer_organ(entry["organ"], layer, organs, pictures));
    return layer;
}

} // namespace

Result<Pattern> read_pattern(json const& file)
{
    auto pattern = TRY(read_kind(file));
    pattern.sizes = TRY(read_sizes(file));
    TRY(read_turns(file, pattern));
    return pattern;
}

Result<LayersRead> read_organs(json const& file, Pattern const& pattern,
                               PictureReader const& pictures)
{
    LayersRead result;
    if (!has_value(file, "organs"))
        return result;
    bool const is_list = file["organs"].is_array();
    auto const list = is_list ? file["organs"] : json::array({ file["organs"] });
    for (auto const& entry : list) {
        auto layer = read_layer(entry, pattern, result.organs, pictures);
        if (!layer && is_list)
            return fail(layer.error().fault,
                        fmt::format("organs of layer {}: {}", result.layers.size() + 1,
                                    layer.error().message));
        result.layers.push_back(TRY(std::move(layer)));
    }
    return result;
}

Result<OrganSource> read_organ(json const& file, PictureReader const& pictures)
{
    if (!has_value(file, "organ"))
        return OrganSource();
    auto const& organ = file["organ"];
    if (organ.is_string())
        return OrganSource { .file = organ.get<std::string>() };
    if (!organ.is_object())
        return fail(Fault::User,
                    "organ is no leaf's shape: write {\"left\": [[u, v], [u, v]], \"right\": …, "
                    "\"midrib\": …, \"section\": …}, or the name of a file (.organ)");
    auto surface = TRY(read_surface(organ, pictures));
    return OrganSource { .surface = std::move(surface) };
}

} // namespace tractus::lines
