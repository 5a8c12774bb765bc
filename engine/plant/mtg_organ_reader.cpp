#include "engine/plant/mtg_organ_reader.h"

#include <cctype>
#include <fmt/format.h>

namespace tractus {

namespace {

struct OrganName {
    std::string_view name;
    MtgOrganClass kind;
};
constexpr std::array<OrganName, 5> kOrganNames { {
    { "organ", MtgOrganClass::Other },
    { "leaf", MtgOrganClass::Leaf },
    { "flower", MtgOrganClass::Flower },
    { "fruit", MtgOrganClass::Other },
    { "bud", MtgOrganClass::Other },
} };

} // namespace

std::string lower_letters(std::string_view text)
{
    std::string result;
    for (char const c : text)
        if (std::isalnum(static_cast<unsigned char>(c)))
            result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

MtgOrganReader::ClassId MtgOrganReader::add_class(std::string_view name, MtgOrganClass kind)
{
    classes_.push_back({ std::string(name), kind });
    return static_cast<ClassId>(classes_.size() - 1);
}

std::optional<MtgOrganReader::ClassId> MtgOrganReader::class_of_name(std::string_view name)
{
    auto const lower = lower_letters(name);
    for (auto const& organ : kOrganNames)
        if (lower == organ.name)
            return add_class(name, organ.kind);
    return std::nullopt;
}

bool MtgOrganReader::find_columns(std::span<std::string_view const> names, std::size_t first)
{
    columns_ = MtgOrganColumns::find(names, first);
    return columns_.has_value();
}

// Never fails: an organ whose row has too little data is only counted as left out.
void MtgOrganReader::add(ClassId of, std::uint32_t node,
                         std::array<std::optional<double>, 3> const& position,
                         std::span<std::string_view const> cells)
{
    auto read = columns_ ? columns_->read(cells) : std::nullopt;
    if (!read || !position[0] || !position[1] || !position[2])
        return leave_out(of);
    read->position = { *position[0], *position[1], *position[2] };
    read->kind = classes_[of].kind;
    read->node = node;
    organs_.push_back({ *read, of });
}

void MtgOrganReader::place(MeasuredPlant& measured, double scale)
{
    std::vector<MtgOrgan> sound;
    for (auto& [organ, of_class] : organs_) {
        organ.position *= scale;
        for (auto* const size : { &organ.length, &organ.width, &organ.petiole })
            *size *= scale;
        if (organ.depth)
            *organ.depth *= scale;
        if (is_plausible_organ(organ, measured.base_mm))
            sound.push_back(organ);
        else
            leave_out(of_class);
    }
    add_mtg_organs(measured, sound);
}

std::string MtgOrganReader::describe_omitted(std::string const& file) const
{
    std::string counts;
    for (auto const& of : classes_)
        if (of.left_out > 0)
            counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", of.left_out, of.name);
    if (counts.empty())
        return {};
    return fmt::format("{}: left out organs that have no place, direction and length in it: {}",
                       file, counts);
}

} // namespace tractus
