#include "engine/lsystem/features.h"

#include <algorithm>
#include <fmt/format.h>
#include <initializer_list>

namespace tractus {

namespace {

// Every program of a model, rules and blocks alike.
template<typename Test> bool any_instruction(Model const& model, Test const& test)
{
    auto const has
        = [&](Program const& program) { return std::any_of(program.begin(), program.end(), test); };
    for (auto const* rules : { &model.rules, &model.decomposition, &model.homomorphism })
        for (auto const& rule : rules->rules)
            if (has(rule.condition) || has(rule.successor_program) || has(rule.probability))
                return true;
    for (auto const* block :
         { &model.axiom_program, &model.start, &model.start_each, &model.end_each, &model.end })
        if (has(block->program))
            return true;
    return false;
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

// "1 organ", "2 organs".
std::string counted(std::size_t count, char const* what)
{
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

void add_rules(Model const& model, std::vector<std::string>& features)
{
    auto const& rules = model.rules;
    features.push_back(counted(rules.rules.size(), "rule"));
    if (std::any_of(model.alphabet.kinds.begin(), model.alphabet.kinds.end(),
                    [](ModuleKind const& kind) { return kind.parameter_count > 0; }))
        features.emplace_back("parameters");
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

void add_statements(Model const& model, std::vector<std::string>& features)
{
    for (auto const& [name, block] :
         { std::pair("Start", &model.start), std::pair("StartEach", &model.start_each),
           std::pair("EndEach", &model.end_each), std::pair("End", &model.end) })
        if (!block->program.empty())
            features.push_back(fmt::format("{} block", name));
    constexpr auto kBuiltIn = static_cast<std::size_t>(GlobalIndex::Count);
    if (model.globals.size() > kBuiltIn)
        features.push_back(counted(model.globals.size() - kBuiltIn, "global variable"));
    if (!model.arrays.empty())
        features.push_back(counted(model.arrays.size(), "array"));
    if (uses(model, { Op::Random, Op::Normal, Op::Beta, Op::Binomial }))
        features.emplace_back("random numbers");
    if (uses(model, { Op::Function }))
        features.push_back(counted(model.view.functions.size(), "function"));
}

void add_view(View const& view, std::vector<std::string>& features)
{
    if (!view.tropisms.empty())
        features.push_back(counted(view.tropisms.size(), "tropism"));
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
    add_statements(model, features);
    add_view(model.view, features);
    return features;
}

} // namespace tractus
