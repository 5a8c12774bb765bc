#include "app/python/model_classes.h"

#include "app/batch/plant_to_grow.h"
#include "app/files/resources.h"
#include "app/io/model_file.h"
#include "app/python/arrays.h"
#include "app/python/model_constants.h"
#include "app/python/scene_class.h"
#include "engine/lsystem/derivation/derive.h"
#include "engine/lsystem/language/print.h"
#include "engine/lsystem/rewriting/homomorphism.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <utility>
#include <vector>

namespace tractus::python {

namespace {

namespace py = pybind11;
using namespace pybind11::literals;

Result<ModelHandle> compiled(scene::LoadModel edit)
{
    auto const include = [&](std::string const& name) -> Result<std::string> {
        if (auto const found = edit.includes.find(name); found != edit.includes.end())
            return found->second;
        return fail(Fault::User,
                    fmt::format("{} includes {}, which is missing", edit.source.name, name));
    };
    auto model = TRY(lsystem::compile_model(edit.source, include));
    auto name = std::filesystem::path(edit.source.name).stem().string();
    return ModelHandle { std::move(name), std::move(edit),
                         std::make_shared<lsystem::Model const>(std::move(model)) };
}

ModelHandle load_model_handle(std::filesystem::path const& model, io::ModelCompanions companions)
{
    return value_of(without_gil([&]() -> Result<ModelHandle> {
        auto const path = TRY(files::find_model(model.string()));
        return compiled(TRY(io::load_model_edit(path, companions)));
    }));
}

ModelHandle model_from_text(std::string text, std::string view, std::string name,
                            std::map<std::string, std::string> includes)
{
    scene::LoadModel edit;
    edit.source
        = { .name = std::move(name), .text = std::move(text), .view_text = std::move(view) };
    edit.includes = std::move(includes);
    return value_of(without_gil([&] { return compiled(std::move(edit)); }));
}

ModelHandle model_with_constants(ModelHandle const& model, py::kwargs const& numbers)
{
    Constants constants;
    for (auto const& [name, value] : numbers)
        constants[py::cast<std::string>(name)] = py::cast<double>(value);
    auto edit = model.edit;
    edit.source.text = value_of(with_constants(edit.source.name, edit.source.text, constants));
    return value_of(without_gil([&] { return compiled(std::move(edit)); }));
}

StringHandle derive_string(ModelHandle const& model, std::optional<int> steps, std::uint64_t seed,
                           CostLimits const& limits)
{
    check_range("steps", steps.value_or(0), 0, kMaxSteps);
    auto const run = document::load_options(interruptible(limits));
    lsystem::DeriveOptions options;
    options.steps = steps;
    options.seed = seed;
    options.limits = run.limits;
    options.print = run.print;
    auto string = value_of(without_gil([&] { return lsystem::derive(*model.model, options); }));
    return { model.model, std::make_shared<lsystem::ModuleString const>(std::move(string)),
             limits };
}

StringHandle homomorphic_image(StringHandle const& handle)
{
    auto const run = document::load_options(interruptible(handle.limits));
    lsystem::HomomorphismOptions how;
    how.limit = { run.limits.max_modules, run.limits.max_memory_bytes };
    how.time = run.limits.time;
    how.print = run.print;
    auto image = value_of(without_gil(
        [&] { return lsystem::apply_homomorphism(*handle.model, *handle.string, how); }));
    return { handle.model, std::make_shared<lsystem::ModuleString const>(std::move(image)),
             handle.limits };
}

std::string text_of(StringHandle const& handle)
{
    return without_gil([&] { return lsystem::to_string(*handle.model, *handle.string); });
}

std::vector<std::pair<std::string, int>> kinds_of(StringHandle const& handle)
{
    std::vector<std::pair<std::string, int>> kinds;
    for (auto const& kind : handle.model->alphabet.kinds)
        kinds.emplace_back(std::string(1, kind.symbol), kind.parameter_count);
    return kinds;
}

// One byte per module, which numpy shows as a text of one character.
py::array letters_of(StringHandle const& handle)
{
    auto const& string = *handle.string;
    std::vector<char> letters(string.size());
    without_gil([&] {
        std::array<char, 256> symbols {};
        auto const& kinds = handle.model->alphabet.kinds;
        for (std::size_t id = 0; id < kinds.size(); ++id)
            symbols[id] = kinds[id].symbol;
        std::transform(string.kinds.data(), string.kinds.data() + string.size(), letters.begin(),
                       [&](lsystem::KindId id) { return symbols[id]; });
    });
    auto const owner = std::make_shared<std::vector<char> const>(std::move(letters));
    return show_array(owner, py::dtype("S1"), owner->data(), { extent(string.size()) });
}

// Modules of one kind: where they stand in the string, and their parameters, module after module.
struct SelectedModules {
    std::vector<std::int64_t> places;
    std::vector<float> parameters;
};

SelectedModules select_modules(StringHandle const& handle, lsystem::KindId wanted)
{
    auto const& string = *handle.string;
    auto const& alphabet = handle.model->alphabet;
    std::size_t const width = alphabet[wanted].parameter_count;
    SelectedModules selected;
    auto const* parameter = string.parameters.data();
    for (std::size_t i = 0; i < string.size(); ++i) {
        if (string.kinds[i] == wanted) {
            selected.places.push_back(static_cast<std::int64_t>(i));
            selected.parameters.insert(selected.parameters.end(), parameter, parameter + width);
        }
        parameter += alphabet[string.kinds[i]].parameter_count;
    }
    return selected;
}

// Finds the kind of module with a letter. `parameters` is needed if the model has the letter with
// different numbers of parameters.
Result<lsystem::KindId> kind_with(lsystem::Model const& model, std::string const& letter,
                                  std::optional<int> parameters)
{
    std::vector<lsystem::KindId> found;
    auto const& kinds = model.alphabet.kinds;
    for (std::size_t id = 0; id < kinds.size(); ++id)
        if (letter.size() == 1 && kinds[id].symbol == letter.front()
            && (!parameters || kinds[id].parameter_count == *parameters))
            found.push_back(static_cast<lsystem::KindId>(id));
    if (found.size() == 1)
        return found.front();
    auto const counted = parameters ? fmt::format(" with {} parameters", *parameters) : "";
    if (found.empty())
        return fail(Fault::User, fmt::format("{} has no module {}{}", model.name, letter, counted));
    return fail(Fault::User,
                fmt::format("{} has the module {} with different numbers of parameters: say how "
                            "many",
                            model.name, letter));
}

py::tuple modules_of(StringHandle const& handle, std::string const& letter,
                     std::optional<int> parameters)
{
    auto const kind = value_of(kind_with(*handle.model, letter, parameters));
    auto selected = without_gil([&] { return select_modules(handle, kind); });
    auto const count = extent(selected.places.size());
    auto const width = extent(handle.model->alphabet[kind].parameter_count);
    return py::make_tuple(take_array(std::move(selected.places), { count }),
                          take_array(std::move(selected.parameters), { count, width }));
}

using ModelClass = py::class_<ModelHandle>;

void add_derivation(ModelClass& type)
{
    type.def(
            "derive",
            [](ModelHandle const& model, std::optional<int> steps, std::uint64_t seed,
               std::size_t max_modules, std::optional<std::uint64_t> max_memory_mb,
               double max_seconds) {
                return derive_string(model, steps, seed,
                                     { max_modules, max_memory_mb, max_seconds });
            },
            "steps"_a = py::none(), "seed"_a = 1, py::kw_only(),
            "max_modules"_a = CostLimits().max_modules, "max_memory_mb"_a = py::none(),
            "max_seconds"_a = CostLimits().max_seconds,
            R"(The string after so many derivation steps; None: the model's own number.

The same model and seed give the same string. Raises Error if the string has more than `max_modules`
modules, or needs more than `max_memory_mb` (None: half of the machine's) or `max_seconds` (0: as
long as it takes).)")
        .def(
            "load",
            [](ModelHandle const& model, std::optional<int> steps, std::uint64_t seed) {
                return scene_of_handle(model, steps, seed);
            },
            "steps"_a = py::none(), "seed"_a = 1, "The scene with the model's plant: see load().")
        .def(
            "grow",
            [](ModelHandle const& model, std::optional<int> steps, std::uint64_t seed) {
                return plant_of(scene_of_handle(model, steps, seed));
            },
            "steps"_a = py::none(), "seed"_a = 1,
            "The plant that the turtle draws after so many steps: load(steps, seed).plant().");
}

void add_facts(ModelClass& type)
{
    type.def_readonly("name", &ModelHandle::name, "The name of its file, without the ending.")
        .def_property_readonly(
            "text", [](ModelHandle const& model) { return model.edit.source.text; },
            "The text of the rules (.l).")
        .def_property_readonly(
            "view", [](ModelHandle const& model) { return model.edit.source.view_text; },
            "The text of the view (.v), with the colours.")
        .def_property_readonly(
            "constants",
            [](ModelHandle const& model) { return constants_of(model.edit.source.text); },
            "The numbers of the rules' lines `#define NAME NUMBER`, by name.")
        .def_property_readonly(
            "steps", [](ModelHandle const& model) { return model.model->steps; },
            "The number of derivation steps that the model gives.")
        .def_property_readonly(
            "warnings", [](ModelHandle const& model) { return model.model->warnings; },
            "What the program warns of: unsupported features, names without a meaning.")
        .def("__repr__", [](ModelHandle const& model) {
            return fmt::format("<tractus.Model {}: {} steps>", model.name, model.model->steps);
        });
}

void add_model(py::module_& module)
{
    py::class_<ModelHandle> type(module, "Model", R"(A compiled L-system in cpfg's language.

Model(model) reads an L-system file, or one of ours by its name (see model_names()), with the view
and the colours beside it. The keywords are the options of `tractus derive`.

Raises Error if there is no such model, or if its text has errors: "FILE:LINE:COLUMN: ...".)");
    type.def(py::init([](std::filesystem::path const& model, std::filesystem::path const& view,
                         std::filesystem::path const& colors, std::string environment,
                         std::string dialect) {
                 return load_model_handle(
                     model, { view, colors, std::move(environment), std::move(dialect) });
             }),
             "model"_a, py::kw_only(), "view"_a = "", "colors"_a = "", "environment"_a = "",
             "dialect"_a = "cpfg")
        .def_static("from_text", &model_from_text, "text"_a, "view"_a = "", py::kw_only(),
                    "name"_a = "model.l", "includes"_a = std::map<std::string, std::string>(),
                    R"(A model from the text of its rules, and of its view.

`includes` has the texts of the files that the rules include, by their names; `name` is for the
sentences of errors.)")
        .def("with_constants", &model_with_constants,
             R"(The same model with other numbers for some of its constants, given as keywords.

Raises Error if the rules have no such constant.)");
    add_derivation(type);
    add_facts(type);
}

void add_string(py::module_& module)
{
    py::class_<StringHandle>(module, "String", R"(A derived string of modules.

len() is the number of modules, str() the text that `tractus derive --string` prints. Its arrays are
read-only; those that are not made anew show the string's own memory and keep it alive.)")
        .def("__len__", [](StringHandle const& string) { return string.string->size(); })
        .def("__str__", &text_of)
        .def(
            "counts",
            [](StringHandle const& string) {
                return without_gil(
                    [&] { return lsystem::count_symbols(*string.model, *string.string); });
            },
            "How often each symbol stands in the string: what `tractus derive --count` prints.")
        .def("modules", &modules_of, "letter"_a, "parameters"_a = py::none(),
             R"(The modules with a letter: their places and their parameters.

Places: (n,) int64, indices into `letters`. Parameters: (n, k) float32, in the model's own units. Both are made anew.
`parameters` is k, which is needed if the model has the letter with different numbers of parameters.
Raises Error if the model has no such module.)")
        .def("homomorphism", &homomorphic_image,
             "The string after the homomorphism rules: what the turtle reads.")
        .def_property_readonly("letters", &letters_of,
                               "(n,) S1: the letter of each module. Made anew.")
        .def_property_readonly("kinds", &kinds_of,
                               "The model's kinds of modules: (letter, number of parameters).")
        .def_property_readonly(
            "kind_ids",
            [](StringHandle const& string) {
                return show_array(string.string, string.string->kinds.data(),
                                  { extent(string.string->size()) });
            },
            "(n,) uint8: the kind of each module, an index into `kinds`. Not copied.")
        .def_property_readonly(
            "parameters",
            [](StringHandle const& string) {
                return show_array(string.string, string.string->parameters.data(),
                                  { extent(string.string->parameters.size()) });
            },
            "(m,) float32: the parameters of all modules, module after module. Not copied.")
        .def_property_readonly(
            "nbytes", [](StringHandle const& string) { return string.string->byte_size(); },
            "The size of the string in memory: its letters and parameters.")
        .def("__repr__", [](StringHandle const& string) {
            return fmt::format("<tractus.String of {} modules>", string.string->size());
        });
}

} // namespace

void add_model_classes(py::module_& module)
{
    add_string(module); // First, since signatures of Model name it.
    add_model(module);
}

} // namespace tractus::python
