#include "engine/lsystem/rewriter.h"

namespace tractus {

Rewriter::Rewriter(Model const& model, RuleSet const& rules, Machine& machine, bool stochastic)
    : model_(model)
    , rules_(rules)
    , machine_(machine)
    , stochastic_(stochastic)
{
    for (auto const& rule : rules.rules)
        frames_.push_back(rule.frame);
}

Rule const* Rewriter::find(Modules const& modules, Surroundings const& around, bool adjacent)
{
    auto const& candidates = rules_.by_kind[modules.kinds[0]];
    if (stochastic_ && candidates.size() > 1)
        return choose(modules, around, adjacent);
    for (auto const index : candidates)
        if (matches(rules_.rules[index], frames_[index].data(), modules, around, adjacent))
            return &rules_.rules[index];
    return nullptr;
}

// Among all rules that match, by their weights.
Rule const* Rewriter::choose(Modules const& modules, Surroundings const& around, bool adjacent)
{
    candidates_.clear();
    double total = 0;
    for (auto const index : rules_.by_kind[modules.kinds[0]]) {
        auto const& rule = rules_.rules[index];
        auto* const values = frames_[index].data();
        if (!matches(rule, values, modules, around, adjacent))
            continue;
        machine_.run(rule.probability, values);
        double const weight = rule.has_probability ? values[rule.probability_result] : 1;
        if (weight > 0)
            candidates_.push_back({ &rule, weight });
        total += weight > 0 ? weight : 0;
    }
    if (candidates_.empty())
        return nullptr;
    double left = candidates_.size() > 1 ? total * machine_.uniform() : 0;
    for (auto const& candidate : candidates_) {
        left -= candidate.weight;
        if (left < 0)
            return candidate.rule;
    }
    return candidates_.back().rule;
}

void Rewriter::load(KindId kind, float const* from, double*& to) const
{
    for (auto left = model_.alphabet[kind].parameter_count; left > 0; --left)
        *to++ = static_cast<double>(*from++);
}

bool Rewriter::matches(Rule const& rule, double* frame, Modules const& modules,
                       Surroundings const& around, bool adjacent)
{
    auto const length = rule.predecessor.size();
    if (length > modules.count)
        return false;
    for (std::size_t i = 1; i < length; ++i)
        if (modules.kinds[i] != rule.predecessor[i])
            return false;
    for (std::size_t i = 0; i < rule.predecessor_parameter_count; ++i)
        frame[i] = static_cast<double>(modules.parameters[i]);
    if (!rule.right.empty()) {
        auto from = around;
        if (adjacent) {
            from.right = around.left + length;
            from.right_parameters = around.left_parameters + rule.predecessor_parameter_count;
        }
        if (!matches_right(rule, frame + rule.predecessor_parameter_count, from))
            return false;
    }
    if (!rule.left.empty() && !matches_left(rule, frame + rule.parameter_count, around))
        return false;
    machine_.run(rule.condition, frame);
    return !rule.has_condition || frame[rule.condition_result] != 0;
}

// Rightwards: ignored modules are passed over, and branches too where the context does not name
// their bracket. `=` in a context passes over the rest of the branch.
bool Rewriter::matches_right(Rule const& rule, double* parameters, Surroundings const& around) const
{
    auto const& string = *around.string;
    auto at = around.right;
    auto at_parameters = around.right_parameters;
    auto left_to_pass = string.size(); // A ring is gone round at most once.
    auto const pass = [&] {
        at_parameters += model_.alphabet[string.kinds[at]].parameter_count;
        ++at;
    };
    auto const pass_branch = [&] { // To the bracket that closes it.
        for (int depth = 0; at < string.size(); pass()) {
            char const symbol = model_.alphabet[string.kinds[at]].symbol;
            if (symbol == ']' && depth-- == 0)
                return;
            depth += symbol == '[';
        }
    };
    for (std::size_t i = 0; i < rule.right.size();) {
        auto const wanted = model_.alphabet[rule.right[i]].symbol;
        if (wanted == '=') {
            pass_branch();
            ++i;
            continue;
        }
        if (at >= string.size()) {
            if (!model_.ring || string.size() == 0)
                return false;
            at = 0;
            at_parameters = 0;
        }
        if (left_to_pass-- == 0)
            return false;
        auto const kind = string.kinds[at];
        if (model_.ignored[kind]) {
            pass();
        } else if (wanted != '[' && model_.alphabet[kind].symbol == '[') {
            pass();
            pass_branch();
            if (at < string.size())
                pass();
        } else {
            if (kind != rule.right[i])
                return false;
            load(kind, string.parameters.data() + at_parameters, parameters);
            pass();
            ++i;
        }
    }
    return true;
}

// Leftwards and down: whole branches are passed over, an opening bracket leads to what bears the
// branch. Fills the parameters from the end, since the context is read backwards.
bool Rewriter::matches_left(Rule const& rule, double* parameters, Surroundings const& around) const
{
    auto const& string = *around.string;
    auto at = around.left;
    auto at_parameters = around.left_parameters;
    auto left_to_pass = string.size() + 1;
    auto const step_left = [&] {
        --at;
        at_parameters -= model_.alphabet[string.kinds[at]].parameter_count;
    };
    for (auto const kind : rule.left)
        parameters -= model_.alphabet[kind].parameter_count;
    for (std::size_t i = 0; i < rule.left.size();) {
        if (at == 0) {
            if (!model_.ring || string.size() == 0)
                return false;
            at = string.size();
            at_parameters = string.parameters.size();
        }
        if (left_to_pass-- == 0)
            return false;
        step_left();
        auto const kind = string.kinds[at];
        char const symbol = model_.alphabet[kind].symbol;
        if (symbol == ']') {
            for (int depth = 1; depth > 0 && at > 0;) {
                step_left();
                char const inner = model_.alphabet[string.kinds[at]].symbol;
                depth += (inner == ']') - (inner == '[');
            }
        } else if (symbol != '[' && !model_.ignored[kind]) {
            if (kind != rule.left[i])
                return false;
            load(kind, string.parameters.data() + at_parameters, parameters);
            ++i;
        }
    }
    return true;
}

void Rewriter::apply(Rule const& rule, ModuleString& out)
{
    auto* const values = frame(rule);
    machine_.run(rule.successor_program, values);
    auto const& successor = rule.successor;
    out.kinds.append(successor.kinds.data(), successor.kinds.size());
    out.parameters.reserve_more(successor.parameters.size());
    auto* to = out.parameters.data() + out.parameters.size();
    for (auto const reg : successor.parameters)
        *to++ = static_cast<float>(values[reg]);
    out.parameters.set_size(out.parameters.size() + successor.parameters.size());
}

} // namespace tractus
