#include "engine/lsystem/language/arithmetic.h"
#include "tests/engine/lsystem/small_model.h"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <rapidcheck/gtest.h>
#include <string>
#include <vector>

namespace tractus::lsystem {
namespace {

// The structures below are the contents of a rule, an L-system and a model, without their notation.
// Parameters of modules in successors are integers. Parameters in contexts and predecessors have
// names that the printer chooses.
struct PlainModule {
    char symbol = 'A';
    std::vector<int> parameters;

    bool operator==(PlainModule const&) const = default;
};

struct PlainRule {
    // Parameters in `left`, `predecessor` and `right` are only names, stored as 0.
    std::vector<PlainModule> left, predecessor, right, successor;
    bool has_condition = false;
    int weight = 0; // Weight of a stochastic rule; 0: the rule is not stochastic.

    bool operator==(PlainRule const&) const = default;
};

struct PlainSystem {
    int id = 1;
    bool ring = false;
    std::vector<PlainModule> axiom;
    std::string ignored;
    std::vector<int> array; // Values of a defined array; empty if the L-system has none.
    std::vector<PlainRule> rules, decomposition, homomorphism;
    int depth = 1; // Maximum depth of decomposition and homomorphism.

    bool operator==(PlainSystem const&) const = default;
};

constexpr std::string_view kSymbols = "ABCFXYfg+-&^/|!#;,_.{}~@[]$%";

rc::Gen<std::vector<PlainModule>> random_modules(std::size_t least, std::string_view symbols)
{
    auto const module = rc::gen::map(
        rc::gen::pair(rc::gen::elementOf(std::string(symbols)),
                      rc::gen::container<std::vector<int>>(rc::gen::inRange(-9, 99))),
        [](auto const& parts) {
            auto [symbol, parameters] = parts;
            parameters.resize(std::min<std::size_t>(parameters.size(), 3));
            return PlainModule { symbol, parameters };
        });
    return rc::gen::map(rc::gen::container<std::vector<PlainModule>>(module),
                        [least](std::vector<PlainModule> modules) {
                            modules.resize(std::clamp<std::size_t>(modules.size(), least, 6));
                            return modules;
                        });
}

std::vector<PlainModule> formal(std::vector<PlainModule> modules)
{
    for (auto& module : modules)
        std::fill(module.parameters.begin(), module.parameters.end(), 0);
    return modules;
}

PlainRule random_rule()
{
    PlainRule rule;
    rule.left = formal(*random_modules(0, "ABCF+"));
    rule.predecessor = formal(*random_modules(1, "ABCF+"));
    rule.right = formal(*random_modules(0, "ABCF+"));
    rule.successor = *random_modules(0, kSymbols);
    rule.has_condition = *rc::gen::arbitrary<bool>();
    rule.weight = *rc::gen::inRange(0, 4);
    return rule;
}

std::vector<PlainRule> random_rules()
{
    std::vector<PlainRule> rules;
    for (int count = *rc::gen::inRange(0, 4); count > 0; --count)
        rules.push_back(random_rule());
    return rules;
}

PlainSystem random_system(int id)
{
    PlainSystem system;
    system.id = id;
    system.ring = *rc::gen::arbitrary<bool>();
    system.axiom = *random_modules(1, kSymbols);
    system.ignored = *rc::gen::element<std::string>("", "+-", "F&");
    system.array = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 99));
    system.rules = random_rules();
    system.decomposition = random_rules();
    system.homomorphism = random_rules();
    system.depth = *rc::gen::inRange(1, 9);
    return system;
}

// Returns random blanks, or none.
std::string blank()
{
    return *rc::gen::element<std::string>("", " ", "\t", "  ");
}

std::string print(std::vector<PlainModule> const& modules)
{
    std::string text;
    for (auto const& module : modules) {
        text += module.symbol;
        if (!module.parameters.empty())
            text += fmt::format("({})", fmt::join(module.parameters, "," + blank()));
        text += *rc::gen::element<std::string>("", " ");
    }
    return text;
}

std::string print_formal(std::vector<PlainModule> const& modules, int& next)
{
    std::string text;
    for (auto const& module : modules) {
        text += module.symbol;
        for (std::size_t i = 0; i < module.parameters.size(); ++i)
            text += fmt::format("{}p{}", i == 0 ? "(" : ",", next++);
        text += module.parameters.empty() ? "" : ")";
    }
    return text;
}

std::string print(PlainRule const& rule)
{
    int next = 0;
    std::string text;
    if (!rule.left.empty())
        text += print_formal(rule.left, next) + blank() + "<" + blank();
    text += print_formal(rule.predecessor, next);
    if (!rule.right.empty())
        text += blank() + ">" + blank() + print_formal(rule.right, next);
    if (rule.has_condition)
        text += blank() + ":" + blank() + "1 > 0";
    text += " -->" + blank() + (rule.successor.empty() ? "*" : print(rule.successor));
    if (rule.weight > 0)
        text += fmt::format(":{}{}", blank(), rule.weight);
    return text + *rc::gen::element<std::string>("\n", " \n", " // done\n", "\n\n");
}

std::string print(PlainSystem const& system)
{
    auto text = fmt::format("Lsystem: {}\n{}", system.id, system.ring ? "ring L-system\n" : "");
    if (!system.ignored.empty())
        text += "ignore: " + system.ignored + "\n";
    if (!system.array.empty())
        text += fmt::format("define: {{ array a[{}] = {{{}}}; }}\n", system.array.size(),
                            fmt::join(system.array, ","));
    text += "Axiom: " + print(system.axiom) + "\n";
    for (auto const& rule : system.rules)
        text += print(rule);
    text += fmt::format("decomposition\nmaximum depth: {}\n", system.depth);
    for (auto const& rule : system.decomposition)
        text += print(rule);
    text += fmt::format("homomorphism:\nmaximum depth: {}\n", system.depth);
    for (auto const& rule : system.homomorphism)
        text += print(rule);
    return text + "endlsystem\n";
}

// Converts compiled modules back to plain modules.
std::vector<PlainModule> read_back(Model const& model, std::vector<KindId> const& kinds)
{
    std::vector<PlainModule> modules;
    for (auto const kind : kinds)
        modules.push_back({ model.alphabet[kind].symbol,
                            std::vector<int>(model.alphabet[kind].parameter_count) });
    return modules;
}

std::vector<PlainModule> read_back(Model const& model, SuccessorTemplate const& successor,
                                   RegisterFile const& frame)
{
    auto modules = read_back(model, successor.kinds);
    auto const* reg = successor.parameters.data();
    for (auto& module : modules)
        for (auto& parameter : module.parameters)
            parameter = static_cast<int>(frame[*reg++]);
    return modules;
}

std::vector<PlainRule> read_back(Model const& model, RuleSet const& rules)
{
    std::vector<PlainRule> result;
    for (auto const& rule : rules.rules) {
        PlainRule plain;
        plain.left = read_back(model, rule.left);
        std::reverse(plain.left.begin(), plain.left.end());
        plain.predecessor = read_back(model, rule.predecessor);
        plain.right = read_back(model, rule.right);
        plain.successor = read_back(model, rule.successor, rule.frame);
        plain.has_condition = rule.has_condition;
        plain.weight
            = rule.has_probability ? static_cast<int>(rule.frame[rule.probability_result]) : 0;
        result.push_back(plain);
    }
    return result;
}

PlainSystem read_back(Model const& model, LSystem const& system)
{
    PlainSystem plain;
    plain.id = system.id;
    plain.ring = system.ring;
    plain.axiom = read_back(model, system.axiom, system.axiom_program.frame);
    for (std::size_t i = 0; i < model.alphabet.kinds.size(); ++i)
        if (system.ignored[i])
            plain.ignored += model.alphabet.kinds[i].symbol;
    for (auto const& array : system.arrays)
        plain.array.assign(array.values.begin(), array.values.end());
    plain.rules = read_back(model, system.rules);
    plain.decomposition = read_back(model, system.decomposition);
    plain.homomorphism = read_back(model, system.homomorphism);
    RC_ASSERT(system.decomposition.max_depth == system.homomorphism.max_depth);
    plain.depth = system.homomorphism.max_depth;
    return plain;
}

RC_GTEST_PROP(LanguageProperty, LSystemsPrintAndParse, ())
{
    std::vector<PlainSystem> systems;
    for (int id = 1, count = *rc::gen::inRange(1, 4); id <= count; ++id)
        systems.push_back(random_system(id));
    ModelSource source;
    for (auto const& system : systems)
        source.text += print(system);
    auto const model = compile_model(source);
    if (!model)
        RC_FAIL(model.error().message + "\n" + source.text);
    // Only these warnings are allowed: random letters have no effect, and some look like names.
    for (auto const& warning : model->warnings)
        RC_ASSERT(warning.find("%(x)") != std::string::npos
                  || warning.find("no effect") != std::string::npos
                  || warning.find("there is no seed") != std::string::npos
                  || warning.find("names have one letter") != std::string::npos
                  || warning.find("names have several letters") != std::string::npos);
    RC_ASSERT(model->subsystems.size() + 1 == systems.size());
    for (std::size_t i = 0; i < systems.size(); ++i) {
        auto const& compiled_system
            = i == 0 ? static_cast<LSystem const&>(*model) : model->subsystems[i - 1];
        auto found = read_back(*model, compiled_system);
        // The compiler knows an ignored symbol only if the symbol occurs in a rule or the axiom.
        for (auto const symbol : found.ignored)
            RC_ASSERT(systems[i].ignored.find(symbol) != std::string::npos);
        found.ignored = systems[i].ignored;
        RC_ASSERT(found == systems[i]);
    }
}

// An expression tree. Each node is a number, or an operation on one or two operands.
struct Expression {
    double number = 0;
    std::string text; // Text of the operator.
    Op op = Op::Copy;
    int level = 9; // Precedence of the operator.
    std::unique_ptr<Expression> left, right;
};

struct OperatorEntry {
    char const* text;
    Op op;
    int level;
};

constexpr std::array<OperatorEntry, 13> kOperators { { { "==", Op::Equal, 2 },
                                                       { "!=", Op::NotEqual, 2 },
                                                       { "<", Op::Less, 3 },
                                                       { "<=", Op::LessEqual, 3 },
                                                       { ">", Op::Greater, 3 },
                                                       { ">=", Op::GreaterEqual, 3 },
                                                       { "+", Op::Add, 4 },
                                                       { "-", Op::Subtract, 4 },
                                                       { "*", Op::Multiply, 5 },
                                                       { "/", Op::Divide, 5 },
                                                       { "%", Op::Remainder, 5 },
                                                       { "^", Op::Power, 6 },
                                                       { "!", Op::Not, 7 } } };

std::unique_ptr<Expression> random_expression(int depth)
{
    auto result = std::make_unique<Expression>();
    if (depth == 0 || *rc::gen::inRange(0, 4) == 0) {
        result->number = *rc::gen::inRange(0, 9) / 2.0;
        return result;
    }
    auto const& entry = kOperators[*rc::gen::inRange<std::size_t>(0, kOperators.size())];
    result->text = entry.text;
    result->op = entry.op;
    result->level = entry.level;
    result->left = random_expression(depth - 1);
    if (entry.op != Op::Not)
        result->right = random_expression(depth - 1);
    return result;
}

double value(Expression const& expression)
{
    if (!expression.left)
        return expression.number;
    double const left = value(*expression.left);
    return compute(expression.op, left, expression.right ? value(*expression.right) : left);
}

// Prints an expression with the minimum number of parentheses.
std::string print(Expression const& expression, int level)
{
    if (!expression.left)
        return fmt::format("{}", expression.number);
    auto const inner = expression.right
        ? print(*expression.left, expression.level) + " " + expression.text + " "
            + print(*expression.right, expression.level + 1)
        : expression.text + print(*expression.left, expression.level);
    return expression.level < level ? "(" + inner + ")" : inner;
}

RC_GTEST_PROP(LanguageProperty, ExpressionsKeepTheirTree, ())
{
    auto const expression = random_expression(4);
    auto const text = print(*expression, 0);
    // The expression is compiled twice. As a constant, the compiler computes it; with a parameter,
    // the machine computes it while rules are applied.
    auto const model = compiled(with_header("Axiom: A(" + text + ")B(0)\nB(zero) : { x = zero + ("
                                            + text + "); } 1 --> B(x)"));
    auto const string = derive(model);
    RC_ASSERT(string.has_value());
    auto const expected = static_cast<float>(value(*expression));
    for (auto const found : string->parameters.span())
        if (std::isnan(expected))
            RC_ASSERT(std::isnan(found));
        else
            RC_ASSERT(found == expected);
}

} // namespace
} // namespace tractus::lsystem
