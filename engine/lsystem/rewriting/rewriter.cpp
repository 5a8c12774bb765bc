#include "engine/lsystem/rewriting/rewriter.h"

namespace tractus::lsystem {

std::size_t branch_end(Model const& model, ModuleString const& string, std::size_t from)
{
    bool const has_calls = !model.subsystems.empty();
    int depth = 0;
    int calls = 0;
    for (auto i = from; i < string.size(); ++i) {
        auto const& kind = model.alphabet[string.kinds[i]];
        if (kind.symbol == ']' && depth-- == 0)
            return i;
        if (has_calls && kind.symbol == '$' && calls-- == 0)
            return i;
        depth += kind.symbol == '[';
        calls += kind.symbol == '?' && kind.parameter_count > 0;
    }
    return string.size();
}

std::size_t cut_end(Model const& model, ModuleString const& string, std::size_t from)
{
    auto const end = branch_end(model, string, from);
    int depth = 0;
    for (auto i = from; i < end; ++i) {
        auto const& kind = model.alphabet[string.kinds[i]];
        depth += (kind.symbol == '[') - (kind.symbol == ']');
        if (kind.symbol == '%' && kind.parameter_count > 0 && depth == 0)
            return i;
    }
    return end;
}

void find_branches(Model const& model, ModuleString const& string, Branches& branches)
{
    auto const count = string.size();
    auto const none = static_cast<std::uint32_t>(count);
    bool const has_parameters = !string.parameters.empty();
    branches.partner.resize(count);
    branches.parameters.resize(has_parameters ? count : 0);
    std::vector<std::uint32_t> open;
    std::uint32_t parameter = 0;
    for (std::uint32_t i = 0; i < none; ++i) {
        auto const& kind = model.alphabet[string.kinds[i]];
        if (has_parameters) {
            branches.parameters[i] = parameter;
            parameter += kind.parameter_count;
        }
        if (kind.symbol == '[') {
            branches.partner[i] = none;
            open.push_back(i);
        } else if (kind.symbol == ']') {
            branches.partner[i] = open.empty() ? none : open.back();
            if (!open.empty()) {
                branches.partner[open.back()] = i;
                open.pop_back();
            }
        }
    }
}

Rewriter::Rewriter(Model const& model, LSystem const& system, RuleSet const& rules,
                   VirtualMachine& machine)
    : model_(model)
    , system_(system)
    , rules_(rules)
    , machine_(machine)
{
    for (auto const& rule : rules.rules) {
        frames_.push_back(rule.frame);
        successors_.push_back(FixedSuccessor::of(rule));
        has_contexts_ = has_contexts_ || !rule.left.empty() || !rule.right.empty();
    }
    for (std::size_t i = 0; i < model.alphabet.kinds.size(); ++i) {
        auto const& kind = model.alphabet.kinds[i];
        parameter_counts_[i] = kind.parameter_count;
        brackets_[i] = kind.symbol == '['                    ? Bracket::Open
            : kind.symbol == ']'                             ? Bracket::Close
            : kind.symbol == '%' && kind.parameter_count > 0 ? Bracket::Keep
                                                             : Bracket::None;
    }
}

Rule const* Rewriter::find(Modules const& modules, Surroundings const& around, bool adjacent)
{
    right_.is_known = false;
    left_.is_known = false;
    auto const& candidates = rules_.by_kind[modules.kinds[0]];
    if (system_.stochastic && candidates.size() > 1)
        return choose(modules, around, adjacent);
    for (auto const index : candidates)
        if (matches(index, modules, around, adjacent))
            return &rules_.rules[index];
    return nullptr;
}

// Chooses at random among all rules that match, in proportion to their weights.
Rule const* Rewriter::choose(Modules const& modules, Surroundings const& around, bool adjacent)
{
    candidates_.clear();
    double total = 0;
    for (auto const index : rules_.by_kind[modules.kinds[0]]) {
        if (!matches(index, modules, around, adjacent))
            continue;
        auto const& rule = rules_.rules[index];
        auto* const values = frames_[index].data();
        machine_.run(rule.probability, values);
        double const weight = rule.has_probability ? values[rule.probability_result] : 1;
        if (!(weight > 0))
            continue;
        candidates_.push_back({ &rule, weight });
        total += weight;
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

bool Rewriter::matches(std::uint16_t index, Modules const& modules, Surroundings const& around,
                       bool adjacent)
{
    auto const& rule = rules_.rules[index];
    auto* const values = frames_[index].data();
    auto const length = rule.predecessor.size();
    if (length > modules.count)
        return false;
    for (std::size_t i = 1; i < length; ++i)
        if (modules.kinds[i] != rule.predecessor[i])
            return false;
    for (std::size_t i = 0; i < rule.predecessor_parameter_count; ++i)
        values[i] = static_cast<double>(modules.parameters[i]);
    if (!rule.right.empty()) {
        auto from = around;
        if (adjacent) {
            from.right = around.left + length;
            from.right_parameters = around.left_parameters + rule.predecessor_parameter_count;
        }
        if (!matches_right(rule, values + rule.predecessor_parameter_count, from))
            return false;
    }
    if (!rule.left.empty() && !matches_left(rule, values + rule.parameter_count, around))
        return false;
    machine_.run(rule.condition, values);
    return !rule.has_condition || values[rule.condition_result] != 0;
}

// Returns the first module from `at` on that a context can match, or no value if there is none.
// Skips ignored modules, and whole branches if `brackets` is PassBranches. Does not go past a
// %(...).
std::optional<Rewriter::Place> Rewriter::next_right(Place at, int& rounds,
                                                    Surroundings const& around,
                                                    OpeningBrackets brackets) const
{
    auto const& string = *around.string;
    auto const size = string.size();
    while (true) {
        if (at.module >= size) {
            if (!system_.ring || size == 0 || ++rounds > 1)
                return std::nullopt;
            at = {};
        }
        auto const kind = string.kinds[at.module];
        if (brackets_[kind] == Bracket::Keep)
            return std::nullopt;
        if (system_.ignored[kind]) {
            at = after(at, string);
        } else if (brackets_[kind] == Bracket::Open && brackets == OpeningBrackets::PassBranches) {
            auto const end = around.branches->partner[at.module];
            if (end >= size)
                at = { size, string.parameters.size() };
            else
                at = { end + std::size_t { 1 },
                       around.branches->parameters.empty() ? 0 : around.branches->parameters[end] };
        } else {
            return at;
        }
    }
}

// Matches the right context of a rule. The symbol `=` in the context matches the rest of the
// branch.
bool Rewriter::matches_right(Rule const& rule, double* parameters, Surroundings const& around)
{
    auto const& string = *around.string;
    Place at { around.right, around.right_parameters };
    int rounds = 0;
    for (std::size_t i = 0; i < rule.right.size(); ++i) {
        auto const wanted = rule.right[i];
        if (model_.alphabet[wanted].symbol == '=') {
            for (auto const end = branch_end(model_, string, at.module); at.module < end;)
                at = after(at, string);
            continue;
        }
        std::optional<Place> found;
        if (brackets_[wanted] == Bracket::Open) {
            found = next_right(at, rounds, around, OpeningBrackets::Stop);
        } else if (i > 0) {
            found = next_right(at, rounds, around, OpeningBrackets::PassBranches);
        } else {
            if (!right_.is_known || right_.from != at.module)
                right_ = { true, at.module,
                           next_right(at, rounds, around, OpeningBrackets::PassBranches) };
            found = right_.place;
        }
        if (!found || string.kinds[found->module] != wanted)
            return false;
        load(wanted, string.parameters.data() + found->parameters, parameters);
        at = after(*found, string);
    }
    return true;
}

// Returns the last module before `at` that a context can match, or no value if there is none. Skips
// ignored modules and complete branches. From the beginning of a branch it continues to the parent
// axis. Does not go past a %(...).
std::optional<Rewriter::Place> Rewriter::next_left(Place at, int& rounds,
                                                   Surroundings const& around) const
{
    auto const& string = *around.string;
    while (true) {
        if (at.module == 0) {
            if (!system_.ring || string.size() == 0 || ++rounds > 1)
                return std::nullopt;
            at = { string.size(), string.parameters.size() };
        }
        auto const kind = string.kinds[at.module - 1];
        Place const before { at.module - 1, at.parameters - parameter_counts_[kind] };
        if (brackets_[kind] == Bracket::Keep)
            return std::nullopt;
        if (brackets_[kind] == Bracket::Close) {
            std::size_t const begin = around.branches->partner[before.module];
            if (begin >= string.size())
                at = {};
            else
                at = { begin,
                       around.branches->parameters.empty() ? 0
                                                           : around.branches->parameters[begin] };
        } else if (brackets_[kind] == Bracket::Open || system_.ignored[kind]) {
            at = before;
        } else {
            return before;
        }
    }
}

// Matches the left context of a rule and fills its parameters, which end at `parameters`.
bool Rewriter::matches_left(Rule const& rule, double* parameters, Surroundings const& around)
{
    auto const& string = *around.string;
    Place at { around.left, around.left_parameters };
    int rounds = 0;
    for (auto const kind : rule.left)
        parameters -= parameter_counts_[kind];
    for (std::size_t i = 0; i < rule.left.size(); ++i) {
        std::optional<Place> found;
        if (i > 0) {
            found = next_left(at, rounds, around);
        } else {
            if (!left_.is_known)
                left_ = { true, at.module, next_left(at, rounds, around) };
            found = left_.place;
        }
        if (!found || string.kinds[found->module] != rule.left[i])
            return false;
        load(rule.left[i], string.parameters.data() + found->parameters, parameters);
        at = *found;
    }
    return true;
}

void Rewriter::load_predecessor(Rule const& rule, float const* parameters)
{
    auto* const values = frames_[index(rule)].data();
    for (std::size_t i = 0; i < rule.predecessor_parameter_count; ++i)
        values[i] = static_cast<double>(parameters[i]);
}

void Rewriter::apply(Rule const& rule, ModuleString& out)
{
    out.kinds.reserve_more(rule.successor.kinds.size() + FixedSuccessor::kShort);
    out.parameters.reserve_more(rule.successor.parameters.size());
    ModuleWriter to(out);
    apply(rule, to);
    to.finish(out);
}

void Rewriter::apply(Rule const& rule, ModuleWriter& to)
{
    auto const number = index(rule);
    auto* const values = frames_[number].data();
    machine_.run(rule.successor_program, values);
    successors_[number].write_kinds(to.kinds);
    for (auto const reg : rule.successor.parameters)
        *to.parameters++ = static_cast<float>(values[reg]);
}

} // namespace tractus::lsystem
