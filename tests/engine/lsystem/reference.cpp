#include "tests/engine/lsystem/reference.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace tractus::lsystem {

ReferenceRewriter::ReferenceRewriter(Model const& model, std::uint64_t seed)
    : model_(model)
    , machine_(model, seed)
{
    for (auto const* const rules : { &model.rules, &model.decomposition, &model.homomorphism })
        for (auto const& rule : rules->rules)
            frames_.emplace_back(&rule, rule.frame);
}

RegisterFile& ReferenceRewriter::frame(Rule const& rule)
{
    for (auto& [known, frame] : frames_)
        if (known == &rule)
            return frame;
    std::abort();
}

std::optional<ReferenceString> ReferenceRewriter::derive(int steps, std::size_t most_modules)
{
    machine_.global(GlobalIndex::Steps) = steps;
    machine_.global(GlobalIndex::DerivationLength) = steps;
    machine_.begin_module(0, kNoPosition);
    machine_.run(model_.start);
    auto values = model_.axiom_program.frame;
    machine_.run(model_.axiom_program.program, values.data());
    ReferenceString string;
    auto reg = model_.axiom.parameters.begin();
    for (auto const kind : model_.axiom.kinds) {
        string.push_back({ kind });
        for (int i = 0; i < model_.alphabet[kind].parameter_count; ++i)
            string.back().parameters.push_back(static_cast<float>(values[*reg++]));
    }
    for (int number = 1; number <= steps; ++number) {
        string = step(string, number, most_modules);
        if (string.size() > most_modules)
            return std::nullopt;
    }
    return string;
}

ReferenceString ReferenceRewriter::step(ReferenceString const& string, int number,
                                        std::size_t most_modules)
{
    auto const stream = static_cast<std::uint32_t>(number);
    machine_.global(GlobalIndex::Step) = number;
    machine_.begin_module(stream, kNoPosition);
    machine_.run(model_.start_each);
    ReferenceString out;
    for (std::size_t at = 0; at < string.size() && out.size() <= most_modules;) {
        machine_.begin_module(stream, at);
        at += rewrite(string, at, out);
    }
    machine_.begin_module(stream, kNoPosition - 1);
    machine_.run(model_.end_each);
    return out;
}

// Appends the successor of the module at `at` to `out`. Returns the number of modules that the rule
// has consumed.
std::size_t ReferenceRewriter::rewrite(ReferenceString const& string, std::size_t at,
                                       ReferenceString& out)
{
    ReferenceString const rest(string.begin() + static_cast<std::ptrdiff_t>(at), string.end());
    if (auto const* const rule = find(model_.rules, string, at, kNoPosition, rest)) {
        auto const end = at + rule->predecessor.size();
        for (auto const& module : successor(*rule))
            expand(model_.decomposition, string, at, end, module, 0, out);
        return end - at;
    }
    if (symbol(string[at].kind) == '%' && string[at].parameters.empty()) {
        auto end = at + 1;
        for (int depth = 0; end < string.size(); ++end) {
            if (symbol(string[end].kind) == ']' && depth-- == 0)
                break;
            depth += symbol(string[end].kind) == '[';
        }
        return end - at;
    }
    expand(model_.decomposition, string, at, at + 1, string[at], 0, out);
    return 1;
}

// Appends the module to `out`, or the result of applying `rules` to it recursively.
void ReferenceRewriter::expand(RuleSet const& rules, ReferenceString const& string,
                               std::size_t left, std::size_t right, ReferenceModule const& module,
                               int depth, ReferenceString& out)
{
    auto const* const rule
        = depth < rules.max_depth ? find(rules, string, left, right, { module }) : nullptr;
    if (!rule)
        return out.push_back(module);
    for (auto const& next : successor(*rule))
        expand(rules, string, left, right, next, depth + 1, out);
}

ReferenceString ReferenceRewriter::drawn(ReferenceString const& string)
{
    ReferenceString out;
    for (std::size_t i = 0; i < string.size(); ++i)
        expand(model_.homomorphism, string, i, i + 1, string[i], 0, out);
    return out;
}

// Finds the rule to apply to `predecessor`. Its left context ends before `left`, and its right
// context begins at `right`. If `right` is kNoPosition, the right context begins behind the
// predecessor.
Rule const* ReferenceRewriter::find(RuleSet const& rules, ReferenceString const& string,
                                    std::size_t left, std::size_t right,
                                    ReferenceString const& predecessor)
{
    std::vector<Rule const*> found;
    std::vector<double> weights;
    double total = 0;
    for (auto const& rule : rules.rules) {
        if (!matches(rule, string, left, right, predecessor))
            continue;
        if (!model_.stochastic)
            return &rule;
        auto& values = frame(rule);
        machine_.run(rule.probability, values.data());
        double const weight = rule.has_probability ? values[rule.probability_result] : 1;
        if (!(weight > 0))
            continue;
        found.push_back(&rule);
        weights.push_back(weight);
        total += weight;
    }
    if (found.empty())
        return nullptr;
    double number = found.size() > 1 ? total * machine_.uniform() : 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        number -= weights[i];
        if (number < 0)
            return found[i];
    }
    return found.back();
}

bool ReferenceRewriter::matches(Rule const& rule, ReferenceString const& string, std::size_t left,
                                std::size_t right, ReferenceString const& predecessor)
{
    auto const length = rule.predecessor.size();
    if (length > predecessor.size())
        return false;
    auto& values = frame(rule);
    std::size_t filled = 0;
    for (std::size_t i = 0; i < length; ++i)
        if (predecessor[i].kind != rule.predecessor[i])
            return false;
    for (std::size_t i = 0; i < length; ++i)
        for (auto const parameter : predecessor[i].parameters)
            values[filled++] = static_cast<double>(parameter);
    auto const behind = right == kNoPosition ? left + length : right;
    std::size_t of_left = 0;
    for (auto const kind : rule.left)
        of_left += model_.alphabet[kind].parameter_count;
    if (!matches_context(rule.right, Looks::Right, string, behind, values.data() + filled)
        || !matches_context(rule.left, Looks::Left, string, left,
                            values.data() + rule.parameter_count - of_left))
        return false;
    machine_.run(rule.condition, values.data());
    return !rule.has_condition || values[rule.condition_result] != 0;
}

bool ReferenceRewriter::matches_context(std::vector<KindId> const& context, Looks looks,
                                        ReferenceString const& string, std::size_t from,
                                        double* values)
{
    int rounds = 0;
    for (auto const wanted : context) {
        auto const at = next(string, from, looks, symbol(wanted) == '[', rounds);
        if (!at || string[*at].kind != wanted)
            return false;
        for (auto const parameter : string[*at].parameters)
            *values++ = static_cast<double>(parameter);
        from = looks == Looks::Right ? *at + 1 : *at;
    }
    return true;
}

// Returns the position of the next module before or behind `from` that may match a context; no
// value if there is none.
std::optional<std::size_t> ReferenceRewriter::next(ReferenceString const& string, std::size_t from,
                                                   Looks looks, bool names_bracket,
                                                   int& rounds) const
{
    bool const is_right = looks == Looks::Right;
    auto const is_at_end = [&] { return is_right ? from >= string.size() : from == 0; };
    auto const here = [&] { return is_right ? from : from - 1; };
    auto const go_on = [&] { is_right ? ++from : --from; };
    auto const enters = is_right ? '[' : ']';
    auto const leaves = is_right ? ']' : '[';
    while (true) {
        if (is_at_end()) {
            if (!model_.ring || string.empty() || ++rounds > 1)
                return std::nullopt;
            from = is_right ? 0 : string.size();
        }
        auto const kind = string[here()].kind;
        bool const is_ignored = model_.ignored[kind];
        bool const enters_branch = symbol(kind) == enters && !(is_right && is_ignored);
        if (enters_branch && !names_bracket) {
            int depth = 0;
            do {
                depth += (symbol(string[here()].kind) == enters)
                    - (symbol(string[here()].kind) == leaves);
                go_on();
            } while (depth > 0 && !is_at_end());
        } else if (is_ignored || (!is_right && symbol(kind) == leaves)) {
            go_on();
        } else {
            return here();
        }
    }
}

ReferenceString ReferenceRewriter::successor(Rule const& rule)
{
    auto& values = frame(rule);
    machine_.run(rule.successor_program, values.data());
    ReferenceString out;
    auto reg = rule.successor.parameters.begin();
    for (auto const kind : rule.successor.kinds) {
        out.push_back({ kind });
        for (int i = 0; i < model_.alphabet[kind].parameter_count; ++i)
            out.back().parameters.push_back(static_cast<float>(values[*reg++]));
    }
    return out;
}

std::string to_string(Model const& model, ReferenceString const& string)
{
    std::string text;
    for (auto const& [kind, parameters] : string) {
        text += model.alphabet[kind].symbol;
        for (std::size_t i = 0; i < parameters.size(); ++i)
            text += fmt::format("{}{:a}", i == 0 ? "(" : ",", parameters[i]);
        text += parameters.empty() ? "" : ")";
    }
    return text;
}

namespace {

struct ReferenceTurtle {
    Vec3 position = Vec3::Zero();
    Vec3 heading = Vec3::UnitZ();
    Vec3 left = -Vec3::UnitX();
    double diameter = 0;

    void turn(Vec3 const& around, double angle_deg)
    {
        Eigen::AngleAxisd const rotation(radians(angle_deg), around);
        heading = rotation * heading;
        left = rotation * left;
    }
    Vec3 upper_side() const { return heading.cross(left); }
};

void turn(ReferenceTurtle& turtle, char symbol, double angle_deg)
{
    switch (symbol) {
    case '+':
        return turtle.turn(turtle.upper_side(), angle_deg);
    case '-':
        return turtle.turn(turtle.upper_side(), -angle_deg);
    case '|':
        return turtle.turn(turtle.upper_side(), 180);
    case '&':
        return turtle.turn(turtle.left, angle_deg);
    case '^':
        return turtle.turn(turtle.left, -angle_deg);
    case '\\':
        return turtle.turn(turtle.heading, angle_deg);
    case '/':
        return turtle.turn(turtle.heading, -angle_deg);
    default:
        return;
    }
}

} // namespace

std::vector<ReferenceSegment> draw_reference(Model const& model, ReferenceString const& string,
                                             double angle_deg, double width)
{
    std::vector<ReferenceSegment> segments;
    ReferenceTurtle turtle { .diameter = width };
    std::vector<ReferenceTurtle> saved;
    for (auto const& [kind, parameters] : string) {
        auto const symbol = model.alphabet[kind].symbol;
        auto const parameter_or = [&given = parameters](double otherwise) {
            return given.empty() ? otherwise : static_cast<double>(given[0]);
        };
        if (symbol == '[') {
            saved.push_back(turtle);
        } else if (symbol == ']' && !saved.empty()) {
            turtle = saved.back();
            saved.pop_back();
        } else if (symbol == '!' || symbol == '#') {
            turtle.diameter = parameter_or(turtle.diameter);
        } else if (symbol == 'v') { // This is the only module here whose name begins with @.
            Vec3 const level = Vec3::UnitZ().cross(turtle.heading);
            if (level.norm() >= 1e-9)
                turtle.left = level.normalized();
        } else if (symbol == 'F' || symbol == 'G' || symbol == 'f' || symbol == 'g') {
            Vec3 const to = turtle.position + parameter_or(1) * turtle.heading;
            if ((symbol == 'F' || symbol == 'G') && to != turtle.position)
                segments.push_back({ turtle.position, to, turtle.diameter });
            turtle.position = to;
        } else {
            turn(turtle, symbol, parameter_or(angle_deg));
        }
    }
    return segments;
}

} // namespace tractus::lsystem
