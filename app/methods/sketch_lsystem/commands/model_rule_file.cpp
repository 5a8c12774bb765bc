#include "app/methods/sketch_lsystem/commands/model_rule_file.h"

#include "app/files/resources.h"
#include "app/io/model_file.h"

#include <algorithm>
#include <fmt/format.h>
#include <string_view>
#include <utility>

namespace tractus::sketch {

bool names_model(std::filesystem::path const& rule)
{
    if (rule.extension() == ".l")
        return true;
    auto const ours = files::model_names();
    std::error_code error;
    return std::find(ours.begin(), ours.end(), rule.string()) != ours.end()
        && !std::filesystem::is_regular_file(rule, error);
}

static sketch::ModelRule rule_of_model(scene::LoadModel edit)
{
    return { .source = std::move(edit.source), .includes = std::move(edit.includes) };
}

Result<sketch::ModelRule> load_model_rule(std::filesystem::path const& name)
{
    auto const path = TRY(files::find_model(name.string()));
    auto edit = TRY(io::load_model_edit(path));
    io::warn_of_unused_companions(path);
    return rule_of_model(std::move(edit));
}

std::string describe_contract(std::filesystem::path const& model, scene::LoadOptions const& options)
{
    auto edit = io::load_model_edit(model);
    if (!edit)
        return {}; // The general check of the model reports the error.
    auto const name = edit->source.name;
    auto const lacks = sketch::missing_for_stroke(rule_of_model(*std::move(edit)), options);
    if (lacks.empty())
        return "\nCan be grown along a stroke\n";
    // A model that was not written for strokes lacks all required parts, which are a number of
    // segments, three arrays and a turn. The manual lists them.
    constexpr std::size_t kParts = 5;
    if (lacks.size() >= kParts)
        return "\nCannot be grown along a stroke: it has not the places for it that the manual "
               "lists (models.md)\n";
    std::string text;
    for (std::string_view lack : lacks) {
        if (lack.starts_with(name + ": "))
            lack.remove_prefix(name.size() + 2);
        text += fmt::format("{}{}", text.empty() ? "" : "; ", lack);
    }
    return fmt::format("\nCannot be grown along a stroke: {}\n", text);
}

} // namespace tractus::sketch
