#include "engine/lsystem/derivation/features.h"

#include "engine/lsystem/derivation/query.h"

#include <algorithm>
#include <fmt/format.h>
#include <initializer_list>

namespace tractus::lsystem {

namespace {

// Returns true if any instruction in the model's rules or blocks passes the test.
template<typename Test> bool any_instruction(Model const& model, Test const& test)
{
    auto const has
        = [&](Program const& program) { return std::any_of(program.begin(), program.end(), test); };
    auto const in_system = [&](LSystem const& system) {
        for (auto const* rules : { &system.rules, &system.decomposition, &system.homomorphism })
            for (auto const& rule : rules->rules)
                if (has(rule.condition) || has(rule.successor_program) || has(rule.probability))
                    return true;
        for (auto const* block : { &system.axiom_program, &system.start, &system.start_each,
                                   &system.end_each, &system.end })
            if (has(block->program))
                return true;
        return false;
    };
    return in_system(model)
        || std::any_of(model.subsystems.begin(), model.subsystems.end(), in_system);
}

bool uses(Model const& model, std::initializer_list<Op> ops)
{
    return any_instruction(model, [&](Instruction const& instruction) {
        return std::find(ops.begin(), ops.end(), instruction.op) != ops.end();
    });
}

template<typename Test> bool any_rule(RuleSet const& rules, Test const& test)
{
    return std::any_of(rules.rules.begin(), rules.rules.end(), test);
}

// Returns a count with its noun, such as "1 organ" or "2 organs".
std::string counted(std::size_t count, char const* what)
{
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

template<typename Test> bool any_kind(Model const& model, Test const& test)
{
    auto const& kinds = model.alphabet.kinds;
    return std::any_of(kinds.begin(), kinds.end(), test);
}

void add_modules(Model const& model, std::vector<std::string>& features)
{
    if (any_kind(model, [](ModuleKind const& kind) { return kind.parameter_count > 0; }))
        features.emplace_back("parameters");
    if (any_kind(model, [](ModuleKind const& kind) { return kind.symbol == '%'; }))
        features.emplace_back("cuts");
    if (has_queries(model))
        features.emplace_back("query modules");
    if (has_queries(model) && any_kind(model, [](ModuleKind const& kind) {
            return kind.symbol == 'E' && kind.parameter_count > 0;
        }))
        features.push_back(model.view.environment.name.empty()
                               ? "an environment, if somebody answers ?E (--environment)"
                               : "the environment " + model.view.environment.name);
}

void add_rules(LSystem const& model, std::vector<std::string>& features)
{
    auto const& rules = model.rules;
    features.push_back(counted(rules.rules.size(), "rule"));
    if (any_rule(rules, [](Rule const& rule) { return rule.has_condition; }))
        features.emplace_back("conditions");
    if (any_rule(rules, [](Rule const& rule) { return !rule.left.empty(); }))
        features.emplace_back("left context");
    if (any_rule(rules, [](Rule const& rule) { return !rule.right.empty(); }))
        features.emplace_back("right context");
    if (any_rule(rules, [](Rule const& rule) { return rule.predecessor.size() > 1; }))
        features.emplace_back("predecessors of several modules");
    if (any_rule(rules, [](Rule const& rule) { return rule.has_probability; }))
        features.emplace_back("rules chosen at random");
    if (model.ring)
        features.emplace_back("ring L-system");
    for (auto const& [name, set] : { std::pair("decomposition", &model.decomposition),
                                     std::pair("homomorphism", &model.homomorphism) })
        if (set->specified)
            features.push_back(fmt::format("{} of {}, to depth {}", name,
                                           counted(set->rules.size(), "rule"), set->max_depth));
}

void add_blocks(LSystem const& model, std::vector<std::string>& features)
{
    for (auto const& [name, block] :
         { std::pair("Start", &model.start), std::pair("StartEach", &model.start_each),
           std::pair("EndEach", &model.end_each), std::pair("End", &model.end) })
        if (!block->program.empty())
            features.push_back(fmt::format("{} block", name));
    auto const external_arrays
        = std::count_if(model.externals.begin(), model.externals.end(),
                        [](ExternalName const& external) { return external.is_array; });
    auto const arrays = model.arrays.size() - static_cast<std::size_t>(external_arrays);
    auto const others = static_cast<std::size_t>(GlobalIndex::Count) + model.externals.size()
        - static_cast<std::size_t>(external_arrays);
    if (model.globals.size() > others)
        features.push_back(counted(model.globals.size() - others, "global variable"));
    if (arrays > 0)
        features.push_back(counted(arrays, "array"));
    if (!model.externals.empty())
        features.push_back(counted(model.externals.size(), "external name"));
}

void add_functions(Model const& model, std::vector<std::string>& features)
{
    if (uses(model, { Op::Random, Op::Normal, Op::Beta, Op::Binomial }))
        features.emplace_back("random numbers");
    if (uses(model, { Op::Function }))
        features.push_back(counted(model.view.functions.size(), "function"));
    if (uses(model, { Op::CurveX, Op::CurveY, Op::CurveZ, Op::CurveLength }))
        features.push_back(counted(model.view.curves.size(), "curve"));
    if (uses(model, { Op::Print }))
        features.emplace_back("printf");
    if (any_instruction(model, [](Instruction const& instruction) {
            return instruction.op == Op::StoreGlobal
                && instruction.target == static_cast<std::uint16_t>(GlobalIndex::DerivationLength);
        }))
        features.emplace_back("a derivation length that the model changes");
}

void add_view(View const& view, std::vector<std::string>& features)
{
    if (!view.tropisms.empty())
        features.push_back(counted(view.tropisms.size(), "tropism"));
    if (!view.contours.empty())
        features.push_back(counted(view.contours.size(), "contour"));
    if (!view.curves.empty())
        features.push_back(counted(view.curves.size(), "curve"));
    if (!view.surfaces.empty()) {
        std::vector<char> letters;
        for (auto const& [letter, surface] : view.surfaces)
            letters.push_back(letter);
        features.push_back(
            fmt::format("{}: {}", counted(letters.size(), "surface"), fmt::join(letters, ", ")));
    }
    if (view.pipe_model)
        features.push_back(fmt::format("radii by the pipe model, exponent {}", view.pipe_exponent));
    if (!view.materials.empty())
        features.push_back(counted(view.materials.size(), "material"));
    if (!view.organs.empty()) {
        std::vector<char> letters;
        for (auto const& organ : view.organs)
            letters.push_back(organ.letter);
        features.push_back(
            fmt::format("{}: {}", counted(letters.size(), "organ"), fmt::join(letters, ", ")));
    }
}

} // namespace

std::vector<std::string> features_used(Model const& model)
{
    std::vector<std::string> features;
    add_rules(model, features);
    add_modules(model, features);
    add_blocks(model, features);
    add_functions(model, features);
    for (auto const& subsystem : model.subsystems) {
        std::vector<std::string> own;
        add_rules(subsystem, own);
        add_blocks(subsystem, own);
        features.push_back(fmt::format("sub-L-system {}: {}", subsystem.id, fmt::join(own, ", ")));
    }
    add_view(model.view, features);
    return features;
}

} // namespace tractus::lsystem
