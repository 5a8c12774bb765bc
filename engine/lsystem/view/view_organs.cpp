#include "engine/lsystem/view/view_organs.h"

#include "engine/lsystem/view/view_texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace tractus::lsystem {

namespace {

Result<void> read_organ_field(ViewReader const& reader, OrganDefinition& organ,
                              std::string_view field)
{
    static constexpr std::array<std::string_view, 4> kKinds { "blade", "needle", "disc", "ball" };
    auto& shape = organ.shape;
    auto const equals = std::min(field.find('='), field.size() - 1);
    auto const key = field.substr(0, equals);
    auto const text = field.substr(equals + 1);
    if (key == "kind") {
        auto const kind = std::find(kKinds.begin(), kKinds.end(), text);
        if (kind == kKinds.end())
            return reader.error(
                fmt::format("found kind={}, expected blade, needle, disc or ball", text));
        shape.kind = static_cast<OrganShape::Kind>(kind - kKinds.begin());
        return {};
    }
    struct Entry {
        std::string_view key;
        double* target;
        double min;
        double max;
    };
    double material = shape.material;
    double lobe_count = shape.lobe_count;
    double fold_deg = degrees(shape.fold_rad);
    double curl_deg = degrees(shape.curl_rad);
    std::array const entries {
        Entry { "material", &material, 0, 255 },
        Entry { "length", &shape.length_mm, 1e-6, 1e6 },
        Entry { "width", &shape.width_mm, 1e-6, 1e6 },
        Entry { "petiole", &shape.petiole_mm, 0, 1e6 },
        Entry { "widest", &shape.widest, 0, 1 },
        Entry { "tip", &shape.tip_sharpness, 0, 10 },
        Entry { "base", &shape.base_sharpness, 0, 10 },
        Entry { "lobes", &shape.lobes, 0, 1 },
        Entry { "lobe_count", &lobe_count, 0, 100 },
        Entry { "fold", &fold_deg, -90, 90 },
        Entry { "curl", &curl_deg, -360, 360 },
    };
    auto const* const entry
        = std::find_if(entries.begin(), entries.end(), [&](auto const& e) { return e.key == key; });
    if (entry == entries.end())
        return reader.error(fmt::format(
            "found '{}', expected kind=, material=, length=, width=, petiole=, widest=, "
            "tip=, base=, lobes=, lobe_count=, fold= or curl=",
            field));
    auto const value = TRY(reader.number(text));
    if (value < entry->min || value > entry->max)
        return reader.error(
            fmt::format("found {}={}, expected {} to {}", key, value, entry->min, entry->max));
    *entry->target = value;
    shape.material = static_cast<MaterialId>(material);
    shape.lobe_count = static_cast<int>(lobe_count);
    shape.fold_rad = radians(fold_deg);
    shape.curl_rad = radians(curl_deg);
    return {};
}

Result<int> color_index(ViewReader const& reader, std::string_view text)
{
    auto const index = TRY(reader.number(text));
    if (index < 0 || index > 255 || index != std::floor(index))
        return reader.error(
            fmt::format("found the index {}, expected a turtle colour, 0 to 255", index));
    return static_cast<int>(index);
}

// Reads the field roughness= or translucency=. Returns false for other fields.
Result<bool> read_share(ViewReader const& reader, Material& material, std::string_view part)
{
    auto const equals = std::min(part.find('='), part.size() - 1);
    auto const key = part.substr(0, equals);
    if (key != "roughness" && key != "translucency")
        return false;
    auto const share = std::clamp(TRY(reader.number(part.substr(equals + 1))), 0.0, 1.0);
    (key == "roughness" ? material.roughness : material.translucency) = static_cast<float>(share);
    return true;
}

// Reads the kind of a bark, such as "birch" for an old trunk's or "young-birch" for a limb's.
Result<Bark> read_bark(ViewReader& reader, std::string_view text)
{
    constexpr std::string_view kYoung = "young-";
    auto const age = text.starts_with(kYoung) ? BarkAge::Young : BarkAge::Old;
    auto const kind = bark_kind(age == BarkAge::Young ? text.substr(kYoung.size()) : text);
    if (!kind)
        return reader.error(
            fmt::format("found bark={}, expected one of {}, or one of them after {}", text,
                        fmt::join(kBarkNames, ", "), kYoung));
    return Bark { *kind, age };
}

} // namespace

Result<void> read_material(ViewReader& reader, std::string_view value)
{
    static constexpr std::array<std::string_view, 5> kKinds { "bark", "stem", "leaf", "petal",
                                                              "solid" };
    auto const parts = words(value);
    if (parts.size() < 2)
        return reader.error("expected 'material: INDEX NAME kind=... color=R,G,B'");
    auto const index = TRY(color_index(reader, parts[0]));
    Material material;
    material.name = parts[1];
    std::string texture;
    for (auto const part : std::vector(parts.begin() + 2, parts.end())) {
        auto const equals = std::min(part.find('='), part.size() - 1);
        auto const key = part.substr(0, equals);
        auto const text = part.substr(equals + 1);
        if (key == "kind") {
            auto const kind = std::find(kKinds.begin(), kKinds.end(), text);
            if (kind == kKinds.end())
                return reader.error(
                    fmt::format("found kind={}, expected bark, stem, leaf, petal or solid", text));
            material.kind = static_cast<Material::Kind>(kind - kKinds.begin());
        } else if (key == "color") {
            auto const color = TRY(reader.vector(text));
            material.base_color = color.cwiseMax(0).cwiseMin(1).cast<float>();
        } else if (key == "texture") {
            texture = text;
        } else if (key == "bark") {
            material.bark = TRY(read_bark(reader, text));
        } else if (!TRY(read_share(reader, material, part))) {
            return reader.error(fmt::format(
                "found '{}', expected kind=, bark=, color=, roughness=, translucency= or texture=",
                part));
        }
    }
    // The texture is read last, because its layout depends on kind=, which may come after it.
    if (!texture.empty())
        TRY(read_texture(reader, material, texture));
    reader.view.materials.insert_or_assign(index, material);
    return {};
}

// Reads a material without a name or kind. It is opaque, or a leaf's material if it is translucent.
Result<void> read_color(ViewReader& reader, std::string_view value)
{
    auto const parts = words(value);
    if (parts.size() < 2)
        return reader.error("expected 'color: INDEX R,G,B [roughness=] [translucency=]'");
    auto const index = TRY(color_index(reader, parts[0]));
    Material material;
    material.name = fmt::format("color {}", index);
    material.base_color = TRY(reader.vector(parts[1])).cwiseMax(0).cwiseMin(1).cast<float>();
    for (auto const part : std::vector(parts.begin() + 2, parts.end()))
        if (!TRY(read_share(reader, material, part)))
            return reader.error(
                fmt::format("found '{}', expected roughness= or translucency=", part));
    material.kind = material.translucency > 0 ? Material::Kind::Leaf : Material::Kind::Stem;
    reader.view.materials.try_emplace(index, material);
    return {};
}

Result<void> read_organ(ViewReader& reader, std::string_view value)
{
    auto const parts = words(value);
    if (parts.size() < 2 || parts[0].size() != 1)
        return reader.error(
            "expected 'organ: LETTER NAME kind=... material=INDEX length=... width=...'");
    OrganDefinition organ;
    organ.letter = parts[0][0];
    organ.shape.name = parts[1];
    organ.shape.length_mm = 1;
    organ.shape.width_mm = 0.5;
    for (auto const part : std::vector(parts.begin() + 2, parts.end()))
        TRY(read_organ_field(reader, organ, part));
    auto const same = std::find_if(reader.view.organs.begin(), reader.view.organs.end(),
                                   [&](auto const& other) { return other.letter == organ.letter; });
    if (same != reader.view.organs.end())
        *same = organ;
    else
        reader.view.organs.push_back(organ);
    return {};
}

Result<void> read_radii(ViewReader& reader, std::string_view value)
{
    auto const parts = words(value);
    if (parts.size() != 3 || parts[0] != "pipe")
        return reader.error("expected 'radii: pipe EXPONENT TIP_RADIUS'");
    reader.view.pipe_exponent = TRY(reader.number(parts[1]));
    reader.view.pipe_tip_radius = TRY(reader.number(parts[2]));
    if (reader.view.pipe_exponent < 0.5 || reader.view.pipe_exponent > 10
        || !(reader.view.pipe_tip_radius > 0))
        return reader.error("expected an exponent from 0.5 to 10 and a radius above 0");
    reader.view.pipe_model = true;
    return {};
}

} // namespace tractus::lsystem
