#include "app/methods/leaves/leaves_command.h"

#include "app/terminal/console.h"
#include "app/verbs/checks.h"
#include "drivers/file.h"
#include "engine/methods/leaves/leaf.h"
#include "engine/methods/leaves/leaf_grammar.h"

#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

namespace tractus {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kMostSteps = 1000;

struct LeavesArguments {
    fs::path grammar;
    int steps = 0;
    std::optional<int> final_step;
    double age = 1;
    std::uint64_t seed = 1;
};

Result<leaf::Grammar> load_grammar(fs::path const& path)
{
    constexpr std::size_t kMostBytes = std::size_t { 1 } << 20;
    return leaf::parse_grammar(TRY(read_text_file(path, kMostBytes)), path.string());
}

Json counts_json(leaf::MapCounts const& counts)
{
    return {
        { "faces", counts.faces },
        { "edges", counts.edges },
        { "vertices", counts.vertices },
        { "darts", counts.darts },
        { "chi", counts.euler_characteristic() },
        { "components", counts.components },
        { "border_edges", counts.border_edges },
        { "border_cycles", counts.border_cycles },
        { "triangles", counts.triangles },
    };
}

Json labels_json(leaf::Leaf const& leaf)
{
    Json labels = Json::object();
    for (auto const& [face, count] : leaf.face_counts())
        labels[std::string(1, face)] = count;
    return labels;
}

// To nine digits behind the point; what is no number is null.
Json variables_json(leaf::Grammar const& grammar, leaf::Leaf const& leaf)
{
    Json variables = Json::object();
    for (auto const& [name, first_value] : grammar.variables) {
        double const value = leaf.variable(name);
        double const rounded = std::round(value * 1e9) / 1e9;
        variables[grammar.names.name(name)] = std::isfinite(rounded) ? rounded : value;
    }
    return variables;
}

// The veins, then the limb and what they are together.
Result<Json> step_json(leaf::Grammar const& grammar, leaf::Leaf& leaf)
{
    Json step {
        { "step", leaf.step() },
        { "veins", counts_json(leaf.map().counts()) },
        { "labels", labels_json(leaf) },
        { "free_extremities", leaf.free_extremities() },
        { "variables", variables_json(grammar, leaf) },
    };
    TRY(leaf.fill());
    auto const& limb = leaf.limb();
    step["limb"]
        = { { "faces", limb.sizes.size() }, { "sizes", limb.sizes }, { "cuts", limb.cuts } };
    step["with_limb"] = counts_json(leaf.map().counts());
    return step;
}

Result<void> count_cells(LeavesArguments const& arguments)
{
    auto const grammar = TRY(load_grammar(arguments.grammar));
    leaf::Leaf::Options const options { .final_step
                                        = arguments.final_step.value_or(arguments.steps),
                                        .age = arguments.age,
                                        .seed = arguments.seed };
    auto leaf = TRY(leaf::Leaf::begin(grammar, options));
    Json steps = Json::array();
    steps.push_back(TRY(step_json(grammar, leaf)));
    while (leaf.step() < arguments.steps) {
        TRY(leaf.derive());
        steps.push_back(TRY(step_json(grammar, leaf)));
    }
    return print_out(Json { { "steps", steps } }.dump() + "\n");
}

Result<void> check_grammar(LeavesArguments const& arguments)
{
    auto const grammar = TRY(load_grammar(arguments.grammar));
    TRY(leaf::Leaf::begin(grammar, {}));
    return print_out(fmt::format("{}: understood: faces {}, rules {}, variables {}\n", grammar.name,
                                 grammar.faces.size(), grammar.rules.size(),
                                 grammar.variables.size()));
}

void add_grammar_argument(CLI::App& verb, LeavesArguments& arguments)
{
    verb.add_option("FILE", arguments.grammar, "A leaf grammar (.leaf)")
        ->type_name("FILE.leaf")
        ->required();
}

} // namespace

void add_leaves_command(CLI::App& root, Action& action)
{
    auto* const verb = root.add_subcommand("leaves", "Derive leaves from grammars");
    verb->require_subcommand(1);

    auto checked = std::make_shared<LeavesArguments>();
    auto* const check = verb->add_subcommand(
        "check", "Say whether a grammar is understood, and if not, what is wrong where");
    add_grammar_argument(*check, *checked);
    check->callback([checked, &action] { action = [checked] { return check_grammar(*checked); }; });

    auto counted = std::make_shared<LeavesArguments>();
    auto* const count = verb->add_subcommand(
        "count", "Print as JSON how many faces, edges and vertices a leaf has after each step");
    add_grammar_argument(*count, *counted);
    count->add_option("--steps", counted->steps, "How many steps to derive")
        ->type_name("N")
        ->check(whole_number(0, kMostSteps))
        ->required();
    count
        ->add_option("--finalstep", counted->final_step,
                     "What the grammar reads as finalstep; without it, N")
        ->type_name("M")
        ->check(whole_number(0, kMostSteps));
    count->add_option("--age", counted->age, "What the grammar reads as age")
        ->type_name("AGE")
        ->check(number(0, 1))
        ->capture_default_str();
    count->add_option("--seed", counted->seed, "Which random numbers ran and nran give")
        ->type_name("SEED")
        ->capture_default_str();
    count->footer(
        "A grammar (Peyrat, Terraz, Mérillou, Galin 2008) grows a leaf's veins as faces,\n"
        "splits and glues them, and fills the limb between them. Counted are the veins\n"
        "by themselves, the limb, and both together.");
    count->callback([counted, &action] { action = [counted] { return count_cells(*counted); }; });
}

} // namespace tractus
