#include "engine/lsystem/model.h"

#include "engine/lsystem/expression_compiler.h"

#include <algorithm>
#include <cctype>
#include <fmt/core.h>

namespace tractus {

namespace {

using NewNames = ExpressionCompiler::NewNames;

constexpr int kMaxDepth = 1'000'000;
constexpr std::size_t kMaxParameters = 64;
constexpr double kMaxArraySize = 1e6;

// A symbol as it stands in a rule, its kind not yet known.
struct FormalModule {
    KindId kind = 0;
    std::vector<std::string> parameters;
};

struct SymbolList {
    bool is_consider = false;
    std::string symbols;
};

class Parser {
public:
    Parser(ModelSource const& source, SourceText const& text, View view)
        : cursor_(text)
    {
        model_.name = source.name;
        model_.view = std::move(view);
        globals_.variables = model_.globals;
        for (auto const& function : model_.view.functions)
            globals_.functions.push_back(function.name);
    }

    Result<Model> parse();

private:
    Result<void> header();
    Result<bool> header_item();
    Result<bool> block_item();
    Result<void> items();
    Result<bool> section();
    Result<bool> section_item();
    Result<void> axiom();
    Result<void> rule();
    Result<void> predecessor(Rule& rule, ExpressionCompiler& compiler);
    Result<void> condition(Rule& rule, ExpressionCompiler& compiler);
    Result<void> successor(Rule& rule, ExpressionCompiler& compiler);
    Result<std::vector<FormalModule>> formal_modules();
    Result<FormalModule> formal_module();
    Result<void> modules(SuccessorTemplate& result, ExpressionCompiler& compiler, Program& program);
    Result<KindId> kind(char symbol, std::size_t parameter_count);
    Result<char> symbol();
    Result<double> constant_value();
    Result<Block> block();
    Result<void> arrays();
    Result<void> end_line();
    bool take_word(std::string_view word);
    void add_rule(Rule rule);
    void set_ignored();
    Model finish();

    Cursor cursor_;
    Model model_;
    GlobalNames globals_;
    SymbolList ignored_;
    RuleSet* rules_ = &model_.rules;
    bool has_axiom_ = false;
    bool has_probabilities_ = false;
};

// A word of the language, in either case, with blanks where `word` has them.
bool Parser::take_word(std::string_view word)
{
    cursor_.skip();
    auto const text = cursor_.rest();
    if (text.size() < word.size())
        return false;
    for (std::size_t i = 0; i < word.size(); ++i)
        if (std::tolower(static_cast<unsigned char>(text[i])) != word[i])
            return false;
    cursor_.set_position(cursor_.position() + word.size());
    return true;
}

Result<void> Parser::end_line()
{
    if (!cursor_.at_line_end())
        return cursor_.unexpected("the end of the line");
    if (!cursor_.at_end())
        cursor_.take_character();
    cursor_.set_arrow_seen(false);
    return {};
}

Result<Model> Parser::parse()
{
    TRY(header());
    TRY(items());
    if (!has_axiom_)
        return cursor_.unexpected("'Axiom:'");
    cursor_.skip();
    auto const after = cursor_.rest();
    if (std::any_of(after.begin(), after.end(), [](unsigned char c) { return !std::isspace(c); }))
        globals_.warn(
            fmt::format("{}: sub-L-systems are not supported; what follows endlsystem is not read",
                        cursor_.source().place(cursor_.position())));
    set_ignored();
    return finish();
}

Result<void> Parser::header()
{
    while (!cursor_.at_end() && cursor_.peek() == '\n')
        cursor_.take_character();
    if (!take_word("lsystem:"))
        return cursor_.unexpected("'Lsystem:'");
    cursor_.take_line();
    return end_line();
}

Result<void> Parser::items()
{
    while (!cursor_.at_end()) {
        if (cursor_.peek() == '\n') {
            TRY(end_line());
            continue;
        }
        if (take_word("endlsystem"))
            return end_line();
        bool found = TRY(header_item());
        if (!found)
            found = TRY(block_item());
        if (!found)
            found = TRY(section());
        if (!found && !has_axiom_)
            return cursor_.unexpected("'Axiom:' or another statement of the header");
        if (!found)
            TRY(rule());
        TRY(end_line());
    }
    globals_.warn(fmt::format("{}: the file ends without endlsystem",
                              cursor_.source().place(cursor_.position())));
    return {};
}

Result<bool> Parser::header_item()
{
    if (take_word("axiom:")) {
        TRY(axiom());
    } else if (take_word("derivation length:") || take_word("derivationlength:")) {
        auto const value = TRY(constant_value());
        model_.steps = static_cast<int>(std::clamp(value, 0.0, 1e9));
    } else if (take_word("seed:")) {
        auto const value = TRY(constant_value());
        if (rules_ == &model_.rules) {
            model_.stochastic = true;
            model_.seed = static_cast<std::uint64_t>(std::clamp(value, 0.0, 1e15));
        }
    } else if (take_word("maximum depth:")) {
        auto const value = TRY(constant_value());
        rules_->max_depth = static_cast<int>(std::clamp(value, 0.0, double { kMaxDepth }));
    } else if (take_word("ring l-system") || take_word("ring lsystem")) {
        model_.ring = true;
    } else if (take_word("ignore:")) {
        ignored_ = { false, std::string(cursor_.take_line()) };
    } else if (take_word("consider:")) {
        ignored_ = { true, std::string(cursor_.take_line()) };
    } else {
        return false;
    }
    return true;
}

Result<bool> Parser::block_item()
{
    if (take_word("define:")) {
        TRY(arrays());
        return true;
    }
    Block* target = nullptr;
    if (take_word("starteach:") || take_word("start each:"))
        target = &model_.start_each;
    else if (take_word("start:"))
        target = &model_.start;
    else if (take_word("endeach:") || take_word("end each:"))
        target = &model_.end_each;
    else if (take_word("end:"))
        target = &model_.end;
    if (!target)
        return false;
    *target = TRY(block());
    return true;
}

Result<bool> Parser::section()
{
    auto const begin = cursor_.position();
    RuleSet* set = nullptr;
    if (take_word("homomorphism"))
        set = &model_.homomorphism;
    else if (take_word("decomposition"))
        set = &model_.decomposition;
    if (!set)
        return false;
    cursor_.take(":");
    if (!take_word("no warnings"))
        take_word("warnings");
    if (!cursor_.at_line_end()) { // A rule whose predecessor begins with an h, say.
        cursor_.set_position(begin);
        return false;
    }
    rules_ = set;
    set->specified = true;
    return true;
}

Result<double> Parser::constant_value()
{
    ExpressionCompiler compiler(cursor_, globals_, NewNames::Global);
    Program program;
    auto const position = cursor_.position();
    auto const value = TRY(compiler.expression(program));
    if (!program.empty())
        return cursor_.error_at(position, "expected an expression of numbers alone");
    return compiler.take_frame()[value];
}

Result<Block> Parser::block()
{
    Block result;
    ExpressionCompiler compiler(cursor_, globals_, NewNames::Global);
    TRY(compiler.block(result.program));
    result.frame = compiler.take_frame();
    return result;
}

// define: { array NAME[size]... = { values }, ...; }
Result<void> Parser::arrays()
{
    if (!cursor_.take("{"))
        return cursor_.unexpected("'{'");
    cursor_.enter_block();
    while (!cursor_.take("}")) {
        if (ExpressionCompiler::name(cursor_) != "array")
            return cursor_.unexpected("'array'");
        do {
            auto const name = ExpressionCompiler::name(cursor_);
            if (!name || cursor_.peek() != '[')
                return cursor_.unexpected("an array's name and '['");
            GlobalNames::Array array { *name, {} };
            double size = 1;
            while (cursor_.take("[")) {
                auto const extent = TRY(constant_value());
                size *= extent;
                if (!(extent >= 1) || size > kMaxArraySize)
                    return cursor_.error(
                        fmt::format("the size of array {} must be 1 to {}", *name, kMaxArraySize));
                array.sizes.push_back(static_cast<std::size_t>(extent));
                if (!cursor_.take("]"))
                    return cursor_.unexpected("']'");
            }
            std::size_t count = 1;
            for (auto const extent : array.sizes)
                count *= extent;
            ArrayVariable variable { *name, std::vector<double>(count) };
            if (cursor_.take("=")) {
                if (!cursor_.take("{"))
                    return cursor_.unexpected("'{'");
                for (std::size_t i = 0; !cursor_.take("}"); ++i) {
                    auto const value = TRY(constant_value());
                    if (i < count)
                        variable.values[i] = value;
                    if (!cursor_.take(",") && cursor_.peek() != '}')
                        return cursor_.unexpected("',' or '}'");
                }
            }
            globals_.arrays.push_back(std::move(array));
            model_.arrays.push_back(std::move(variable));
        } while (cursor_.take(","));
        if (!cursor_.take(";"))
            return cursor_.unexpected("';'");
    }
    cursor_.leave_block();
    return {};
}

Result<KindId> Parser::kind(char symbol, std::size_t parameter_count)
{
    ModuleKind const wanted { symbol, static_cast<std::uint8_t>(parameter_count) };
    auto& kinds = model_.alphabet.kinds;
    auto const found = std::find(kinds.begin(), kinds.end(), wanted);
    if (found != kinds.end())
        return static_cast<KindId>(found - kinds.begin());
    if (kinds.size() >= Alphabet::kMaxKinds)
        return cursor_.error(
            fmt::format("the model has more than {} kinds of modules (a symbol with a "
                        "number of parameters is a kind)",
                        Alphabet::kMaxKinds));
    kinds.push_back(wanted);
    return static_cast<KindId>(kinds.size() - 1);
}

Result<char> Parser::symbol()
{
    static constexpr std::string_view kNotSymbols = "<>:*()\n";
    char const c = cursor_.peek();
    if (c == '\0' || kNotSymbols.find(c) != std::string_view::npos)
        return cursor_.unexpected("a module");
    return cursor_.take_character();
}

Result<FormalModule> Parser::formal_module()
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

// Zero or more modules, or * for none.
Result<std::vector<FormalModule>> Parser::formal_modules()
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

Result<void> Parser::predecessor(Rule& rule, ExpressionCompiler& compiler)
{
    std::vector<FormalModule> left;
    std::vector<FormalModule> right;
    auto strict = TRY(formal_modules());
    if (cursor_.take("<")) {
        left = std::move(strict);
        strict = TRY(formal_modules());
    }
    if (strict.empty())
        return cursor_.unexpected("a module to replace");
    if (cursor_.take(">"))
        right = TRY(formal_modules());
    std::reverse(left.begin(), left.end());

    auto const add
        = [&](std::vector<FormalModule> const& from, std::vector<KindId>& kinds) -> Result<void> {
        for (auto const& module : from) {
            kinds.push_back(module.kind);
            for (auto const& parameter : module.parameters) {
                if (!compiler.add_parameter(parameter))
                    return cursor_.error(fmt::format("the rule has two parameters {}", parameter));
                ++rule.parameter_count;
            }
        }
        return {};
    };
    TRY(add(strict, rule.predecessor));
    rule.predecessor_parameter_count = rule.parameter_count;
    TRY(add(right, rule.right));
    TRY(add(left, rule.left));
    return {};
}

Result<void> Parser::condition(Rule& rule, ExpressionCompiler& compiler)
{
    Program condition;
    if (cursor_.peek() == '{')
        TRY(compiler.block(condition));
    if (!cursor_.take("*") && cursor_.peek() != '{' && !cursor_.sees_arrow()) {
        rule.condition_result = TRY(compiler.expression(condition));
        rule.has_condition = true;
    }
    rule.condition = std::move(condition);
    if (cursor_.peek() == '{')
        TRY(compiler.block(rule.successor_program));
    return {};
}

// Modules with expressions, up to the end of the line or a colon.
Result<void> Parser::modules(SuccessorTemplate& result, ExpressionCompiler& compiler,
                             Program& program)
{
    while (!cursor_.at_line_end() && !cursor_.sees(":")) {
        if (cursor_.take("*"))
            continue;
        auto const name = TRY(symbol());
        std::size_t count = 0;
        if (cursor_.take("(")) {
            do {
                if (cursor_.peek() == '"')
                    return cursor_.error(
                        "modules with strings, such as @L(\"text\"), are not supported");
                result.parameters.push_back(TRY(compiler.expression(program)));
                ++count;
            } while (cursor_.take(","));
            if (!cursor_.take(")"))
                return cursor_.unexpected("',' or ')'");
        }
        if (count > kMaxParameters)
            return cursor_.error(
                fmt::format("a module may have at most {} parameters", kMaxParameters));
        result.kinds.push_back(TRY(kind(name, count)));
    }
    return {};
}

Result<void> Parser::successor(Rule& rule, ExpressionCompiler& compiler)
{
    TRY(modules(rule.successor, compiler, rule.successor_program));
    if (cursor_.take(":")) {
        rule.probability_result = TRY(compiler.expression(rule.probability));
        rule.has_probability = true;
        has_probabilities_ = has_probabilities_ || rules_ == &model_.rules;
    }
    return {};
}

Result<void> Parser::rule()
{
    Rule rule;
    ExpressionCompiler compiler(cursor_, globals_, NewNames::Local);
    rule.line = cursor_.source().places[cursor_.position()].line;
    TRY(predecessor(rule, compiler));
    if (cursor_.take(":"))
        TRY(condition(rule, compiler));
    if (!cursor_.take("-->") && !cursor_.take("-o>"))
        return cursor_.unexpected("'-->'");
    cursor_.set_arrow_seen(true);
    if (rules_->rules.size() >= 65000)
        return cursor_.error("the model has more than 65000 rules");
    TRY(successor(rule, compiler));
    compiler.prepend_reset(rule.condition);
    rule.frame = compiler.take_frame();
    add_rule(std::move(rule));
    return {};
}

void Parser::add_rule(Rule rule)
{
    auto const first = rule.predecessor.front();
    rules_->by_kind[first].push_back(static_cast<std::uint16_t>(rules_->rules.size()));
    rules_->rules.push_back(std::move(rule));
}

Result<void> Parser::axiom()
{
    if (has_axiom_)
        return cursor_.error("found a second axiom, expected one");
    ExpressionCompiler compiler(cursor_, globals_, NewNames::Global);
    TRY(modules(model_.axiom, compiler, model_.axiom_program.program));
    model_.axiom_program.frame = compiler.take_frame();
    has_axiom_ = true;
    return {};
}

void Parser::set_ignored()
{
    for (std::size_t i = 0; i < model_.alphabet.kinds.size(); ++i) {
        char const symbol = model_.alphabet.kinds[i].symbol;
        bool const listed = ignored_.symbols.find(symbol) != std::string::npos;
        bool const is_bracket = symbol == '[' || symbol == ']'; // Structure, whatever is listed.
        model_.ignored[i] = listed != ignored_.is_consider && !is_bracket;
    }
}

Model Parser::finish()
{
    model_.stochastic = model_.stochastic || has_probabilities_;
    model_.globals = std::move(globals_.variables);
    auto& warnings = model_.warnings;
    warnings = std::move(model_.view.warnings);
    warnings.insert(warnings.end(), globals_.warnings.begin(), globals_.warnings.end());
    return std::move(model_);
}

} // namespace

Result<Model> compile_model(ModelSource const& source, IncludeReader const& include)
{
    auto view = TRY(parse_view(source.view_name, source.view_text, include));
    auto const text = TRY(preprocess(source.name, source.text, include));
    return Parser(source, text, std::move(view)).parse();
}

} // namespace tractus
