#include "app/controllers/rules_file.h"

#include "engine/base/file.h"
#include "engine/scene/write_rules.h"

#include <fmt/format.h>
#include <utility>

namespace tractus::controllers {

namespace fs = std::filesystem;

Result<fs::path> write_rules(scene::PlantState const& plant, fs::path const& folder)
{
    auto const model = TRY(plant.source.model());
    if (!model || !plant.source.accepts_rules())
        return fail(Fault::User,
                    "the rules of this plant are not written here: choose one that was drawn with "
                    "construction lines");
    for (auto const& [name, text] : model->includes)
        TRY(write_file(folder / name, text));
    TRY(write_file(folder / model->source.view_name, model->source.view_text));
    auto path = folder / model->source.name;
    TRY(write_file(path, model->source.text));
    return path;
}

std::optional<scene::LoadModel> model_drawn_on(scene::DocumentState const& state)
{
    auto const* const plant = scene::active_plant(state);
    if (!plant)
        return std::nullopt;
    if (auto const* const loaded = scene::loaded_model(plant->source))
        return *loaded;
    auto const model = plant->source.accepts_rules() ? plant->source.model()
                                                     : std::optional<scene::SourceModel>();
    if (!model || !*model)
        return std::nullopt;
    return scene::LoadModel { .source = (*model)->source, .includes = (*model)->includes };
}

Result<document::StepRequest::Change> take_rules(scene::LoadModel const& model,
                                                 scene::Scene const& scene)
{
    auto const name = fs::path(model.source.name).filename();
    auto const drawn_on = model_drawn_on(scene.state);
    if (!drawn_on || fs::path(drawn_on->source.name).filename() != name)
        return fail(Fault::User,
                    fmt::format("{} has been saved, but another plant is drawn on: choose its "
                                "plant and save it "
                                "again",
                                name.string()));
    auto const said = fmt::format("The plant is that of {} as it was saved", name.string());
    auto const& source = scene::active_plant(scene.state)->source;
    if (source.accepts_rules())
        return document::StepRequest::Change {
            { scene::WriteRules { scene.state.active,
                                  { model.source.text, model.source.view_text } } },
            said
        };
    auto edit = model;
    edit.steps = drawn_on->steps;
    edit.seed = drawn_on->seed;
    edit.drawn = scene::Drawn::Keep;
    return document::StepRequest::Change { { edit }, said };
}

} // namespace tractus::controllers
