#include "calib/height_model_file.h"

#include <fmt/core.h>

namespace tractus::calib {

namespace {

Result<double> scale(TomlTable& table)
{
    double const mm_per_count = TRY(table.number("mm_per_count"));
    if (mm_per_count == 0)
        return table.wrong("mm_per_count", "is 0, expected a number other than 0");
    return mm_per_count;
}

// Parses the track's bend; a file without one means a straight track.
Result<TrackBend> parse_bend(TomlTable& table)
{
    TrackBend bend;
    if (!table.has("bend"))
        return bend;
    for (auto const& knot : TRY(table.vec2_list("bend")))
        bend.push_back({ knot.x(), knot.y() });
    if (!is_valid(LinearHeight { .bend = bend }))
        return table.wrong("bend",
                           "is too steep or out of order, expected [counts, shift_counts] with "
                           "counts that rise and shifts that change by at most 0.3 of that");
    return bend;
}

std::string print_bend(TrackBend const& bend)
{
    if (bend.empty())
        return {};
    std::string text
        = "bend = [  # The model adds these counts to a reading: [counts, counts to add].\n";
    for (auto const& knot : bend)
        text += fmt::format("    [{}, {}],\n", knot.counts, knot.shift_counts);
    return text + "]\n";
}

Result<HeightModel> parse_linear(TomlTable& table)
{
    LinearHeight model;
    model.mm_per_count = TRY(scale(table));
    model.zero_counts = TRY(table.number("zero_counts"));
    model.bend = TRY(parse_bend(table));
    return model;
}

Result<HeightModel> parse_string(TomlTable& table)
{
    StringHeight model;
    model.mm_per_count = TRY(scale(table));
    model.zero_length_mm = TRY(table.number("zero_length_mm"));
    model.offset_mm = TRY(table.number("offset_mm", NumberRange::NotNegative));
    model.base_mm = TRY(table.number("base_mm"));
    if (table.has("spool"))
        model.spool
            = static_cast<StringHeight::Spool>(TRY(table.word("spool", { "below", "above" })));
    model.bend = TRY(parse_bend(table));
    return model;
}

Result<HeightModel> parse_monotone(TomlTable& table)
{
    MonotoneHeight model;
    for (auto const& knot : TRY(table.vec2_list("knots")))
        model.knots.push_back({ knot.x(), knot.y() });
    if (!is_valid(model))
        return table.wrong("knots",
                           "do not rise or fall all the way, expected [counts, height_mm] with "
                           "counts that rise and heights that only rise or only fall");
    return model;
}

// The models by their names in the file, in the order of HeightModel.
struct NamedModel {
    std::string_view name;
    Result<HeightModel> (*parse)(TomlTable&);
};

constexpr NamedModel kModels[] = {
    { "linear", parse_linear },
    { "string", parse_string },
    { "monotone", parse_monotone },
};

std::string print(LinearHeight const& model)
{
    return fmt::format(R"(model = "linear"     # height = mm_per_count * (counts - zero_counts)
mm_per_count = {}
zero_counts = {}
)",
                       model.mm_per_count, model.zero_counts)
        + print_bend(model.bend);
}

std::string print(StringHeight const& model)
{
    bool const is_below = model.spool == StringHeight::Spool::Below;
    return fmt::format(
               R"(model = "string"     # A slanted string to a spool beside the carriage's track:
                     # length = mm_per_count * counts + zero_length_mm
                     # height = {}sqrt(length^2 - offset_mm^2) - base_mm
mm_per_count = {}    # String length per count.
zero_length_mm = {}  # String length at reading 0.
offset_mm = {}       # Horizontal distance from the spool to the track of the string's end.
base_mm = {}         # Height of the string's end above the spool at height zero.
spool = "{}"      # The spool's side, seen from the carriage.
)",
               is_below ? "" : "-", model.mm_per_count, model.zero_length_mm, model.offset_mm,
               model.base_mm, is_below ? "below" : "above")
        + print_bend(model.bend);
}

std::string print(MonotoneHeight const& model)
{
    std::string text = "model = \"monotone\"   # A smooth curve through knots [counts, height_mm], "
                       "straight on beyond them.\nknots = [\n";
    for (auto const& knot : model.knots)
        text += fmt::format("    [{}, {}],\n", knot.counts, knot.height_mm);
    return text + "]\n";
}

} // namespace

Result<HeightModel> parse_height_model(TomlTable& table)
{
    std::vector<std::string_view> names;
    for (auto const& model : kModels)
        names.push_back(model.name);
    return kModels[TRY(table.word("model", names))].parse(table);
}

std::string print_height_model(HeightModel const& model)
{
    return std::visit([](auto const& kind) { return print(kind); }, model);
}

} // namespace tractus::calib
