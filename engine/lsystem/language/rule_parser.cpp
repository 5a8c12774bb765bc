#include "engine/lsystem/language/rule_parser.h"

#include "engine/lsystem/language/local_variables.h"
#include "engine/lsystem/language/statement_compiler.h"

#include <algorithm>
#include <fmt/core.h>

namespace tractus::lsystem {

static constexpr std::size_t kMaxParameters = 64;
static constexpr std::string_view kWrongArrow
    = "found ->, expected -->: the arrow of rules has two dashes here (--dialect book reads both)";

Result<KindId> RuleParser::kind(char symbol, std::size_t parameter_count)
{
    ModuleKind const wanted { symbol, static_cast<std::uint8_t>(parameter_count) };
    auto& kinds = alphabet_.kinds;
    auto const found = std::find(kinds.begin(), kinds.end(), wanted);
    if (found != kinds.end())
        return static_cast<KindId>(found - kinds.begin());
    if (kinds.size() >= Alphabet::kMaxKinds)
        return cursor_.error(
            fmt::format("the model has more than {} kinds of modules (a symbol with a "
                        "number of parameters is a kind)",
                        Alphabet::kMaxKinds));
    kinds.push_back(wanted);
    auto const result = static_cast<KindId>(kinds.size() - 1);
    // Rewriting puts a module of the kind %(x,i) before a branch that %(x) cuts off, so that kind
    // is needed, too.
    if (wanted == ModuleKind { '%', 1 })
        TRY(kind('%', 2));
    return result;
}

Result<char> RuleParser::symbol()
{
    static constexpr std::string_view kNotSymbols = "<>:*()\n";
    char const c = cursor_.peek();
    auto const at = cursor_.position();
    if (c == '>' && at > 0 && cursor_.source().text[at - 1] == '-')
        return cursor_.error_at(at - 1, kWrongArrow);
    if (c == '\0' || kNotSymbols.find(c) != std::string_view::npos)
        return cursor_.unexpected("a module");
    return cursor_.take_character();
}

Result<RuleParser::FormalModule> RuleParser::formal_module()
{
    FormalModule result;
    auto const name = TRY(symbol());
    if (cursor_.take("(")) {
        do {
            auto const parameter = ExpressionCompiler::name(cursor_);
            if (!parameter)
                return cursor_.unexpected("the name of a parameter");
            result.parameters.push_back(*parameter);
        } while (cursor_.take(","));
        if (!cursor_.take(")"))
            return cursor_.unexpected("',' or ')'");
        if (result.parameters.size() > kMaxParameters)
            return cursor_.error(
                fmt::format("a module may have at most {} parameters", kMaxParameters));
    }
    result.kind = TRY(kind(name, result.parameters.size()));
    return result;
}

// Parses zero or more modules; a * stands for no modules.
Result<std::vector<RuleParser::FormalModule>> RuleParser::formal_modules()
{
    std::vector<FormalModule> result;
    while (!cursor_.at_line_end() && !cursor_.sees_arrow() && !cursor_.sees("<")
           && !cursor_.sees(">") && !cursor_.sees(":")) {
        if (cursor_.take("*"))
            continue;
        result.push_back(TRY(formal_module()));
    }
    return result;
}

Result<void> RuleParser::predecessor(Rule& rule, ExpressionCompiler& compiler)
{
    std::vector<FormalModule> left;
    std::vector<FormalModule> right;
    cursor_.skip();
    auto begin = cursor_.position();
    auto strict = TRY(formal_modules());
    if (cursor_.take("<")) {
        left = std::move(strict);
        cursor_.skip();
        begin = cursor_.position();
        strict = TRY(formal_modules());
    }
    names_.uses.add_predecessor(std::string_view(cursor_.source().text).substr(begin),
                                strict.size(), begin);
    if (strict.empty())
        return cursor_.unexpected("a module to replace");
    if (cursor_.take(">"))
        right = TRY(formal_modules());
    if (!left.empty() || !right.empty())
        names_.uses.add_context();
    std::reverse(left.begin(), left.end());
    TRY(add_parameters(strict, rule.predecessor, rule, compiler));
    rule.predecessor_parameter_count = rule.parameter_count;
    TRY(add_parameters(right, rule.right, rule, compiler));
    return add_parameters(left, rule.left, rule, compiler);
}

Result<void> RuleParser::add_parameters(std::vector<FormalModule> const& modules,
                                        std::vector<KindId>& kinds, Rule& rule,
                                        ExpressionCompiler& compiler)
{
    for (auto const& module : modules) {
        kinds.push_back(module.kind);
        names_.uses.add_known(alphabet_[module.kind].symbol);
        for (auto const& parameter : module.parameters) {
            if (!compiler.add_parameter(parameter))
                return cursor_.error(fmt::format("the rule has two parameters {}", parameter));
            ++rule.parameter_count;
        }
    }
    return {};
}

Result<void> RuleParser::condition(Rule& rule, ExpressionCompiler& compiler)
{
    Program condition;
    if (cursor_.peek() == '{')
        TRY(StatementCompiler(compiler).block(condition));
    if (!cursor_.take("*") && cursor_.peek() != '{' && !cursor_.sees_arrow()) {
        rule.condition_result = TRY(compiler.expression(condition));
        rule.has_condition = true;
    }
    rule.condition = std::move(condition);
    if (cursor_.peek() == '{')
        TRY(StatementCompiler(compiler).block(rule.successor_program));
    return {};
}

// Parses modules whose parameters are expressions, up to the end of the line or a colon.
Result<void> RuleParser::modules(SuccessorTemplate& result, ExpressionCompiler& compiler,
                                 Program& program)
{
    names_.uses.begin_string();
    while (!cursor_.at_line_end() && !cursor_.sees(":")) {
        if (cursor_.take("*"))
            continue;
        auto const position = cursor_.position();
        auto const name = TRY(symbol());
        std::size_t count = 0;
        if (cursor_.take("(")) {
            do {
                result.parameters.push_back(cursor_.peek() == '"'
                                                ? TRY(compiler.text())
                                                : TRY(compiler.expression(program)));
                ++count;
            } while (cursor_.take(","));
            if (!cursor_.take(")"))
                return cursor_.unexpected("',' or ')'");
        }
        if (count > kMaxParameters)
            return cursor_.error(
                fmt::format("a module may have at most {} parameters", kMaxParameters));
        result.kinds.push_back(TRY(kind(name, count)));
        names_.uses.add(name, position, count > 0);
    }
    names_.uses.end_string();
    return {};
}

Result<void> RuleParser::successor(Rule& rule, ExpressionCompiler& compiler)
{
    TRY(modules(rule.successor, compiler, rule.successor_program));
    if (rule.successor.kinds.size() == 1)
        names_.uses.add_known(alphabet_[rule.successor.kinds.front()].symbol);
    if (cursor_.take(":")) {
        rule.probability_result = TRY(compiler.expression(rule.probability));
        rule.has_probability = true;
    }
    return {};
}

// Warns of undefined variables, and marks rules that depend on the values of their previous match.
// As in cpfg, local variables keep these values, so that the order of matches matters.
void RuleParser::check_locals(Rule& rule, ExpressionCompiler const& compiler)
{
    for (auto const& [name, local] : compiler.locals()) {
        if (local.is_parameter || !local.first_read)
            continue;
        auto const place = cursor_.source().place(*local.first_read);
        if (!local.is_assigned) {
            names_.warn_undefined(name, place);
        } else if (is_read_before_set(rule, local.value)) {
            rule.keeps_locals = true;
            names_.warn(fmt::format("{}: {} is used before it is set; it then has the value that "
                                    "this rule gave it last, or 0",
                                    place, name));
        }
    }
}

Result<Rule> RuleParser::rule()
{
    Rule rule;
    ExpressionCompiler compiler(cursor_, names_, ExpressionCompiler::NewNames::Local);
    rule.line = cursor_.source().places[cursor_.position()].line;
    TRY(predecessor(rule, compiler));
    if (cursor_.take(":"))
        TRY(condition(rule, compiler));
    if (!cursor_.take("-->") && !cursor_.take("-o>"))
        return cursor_.unexpected("'-->'");
    cursor_.set_arrow_seen(true);
    TRY(successor(rule, compiler));
    check_locals(rule, compiler);
    rule.frame = compiler.frame().take_frame();
    return rule;
}

} // namespace tractus::lsystem
