#include "engine/lsystem/language/model.h"

#include "engine/lsystem/language/book_habits.h"
#include "engine/lsystem/language/definition_parser.h"
#include "engine/lsystem/language/expression_compiler.h"
#include "engine/lsystem/language/rule_parser.h"
#include "engine/lsystem/language/statement_compiler.h"
#include "engine/lsystem/text/placed_text.h"
#include "engine/lsystem/text/user_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <fmt/core.h>

namespace tractus::lsystem {

namespace {

using NewNames = ExpressionCompiler::NewNames;

constexpr int kMaxDepth = 1'000'000;
constexpr std::size_t kMaxRules = 65'000;
constexpr std::size_t kMaxSystems = 1'000;

// First words of statements, of which one is suggested for a line that looks misspelt.
constexpr std::array<std::string_view, 18> kStatements {
    "Lsystem:",       "Axiom:",       "derivation length:", "Seed:",
    "maximum depth:", "ignore:",      "consider:",          "ring L-system",
    "define:",        "Start:",       "StartEach:",         "EndEach:",
    "End:",           "homomorphism", "decomposition",      "homomorphism:",
    "decomposition:", "endlsystem",
};

struct SymbolList {
    bool is_consider = false;
    std::string symbols;
};

// Parses the L-systems of a file, one after another.
class Parser {
public:
    Parser(ModelSource const& source, SourceText const& text, View view)
        : cursor_(text)
    {
        model_.name = source.name;
        model_.view = std::move(view);
        names_.warnings = text.warnings;
        for (auto const& function : model_.view.functions)
            names_.functions.push_back(function.name);
        for (auto const& curve : model_.view.curves)
            names_.curves.push_back(curve.name);
    }

    Result<Model> parse();

private:
    Result<void> system();
    Result<void> header();
    void skip_blank_lines();
    Result<bool> header_item();
    Result<bool> block_item();
    Result<void> items();
    Result<bool> section();
    Result<void> axiom();
    Result<void> rule();
    Result<Block> block();
    Result<void> end_line();
    Result<void> end_of_system();
    Result<void> rule_or_misspelt_statement();
    tl::unexpected<Error> no_statement(std::string_view expected);
    bool take_word(std::string_view word);
    bool sees_word(std::string_view word);
    bool is_main() const { return ignored_.empty(); }
    Result<void> finish_system();
    void set_ignored(LSystem& system, SymbolList const& list);
    Model finish();

    Cursor cursor_;
    Model model_;
    Names names_;
    RuleParser rules_parser_ { cursor_, names_, model_.alphabet };
    DefinitionParser definitions_parser_ { cursor_, names_ };
    LSystem system_; // The L-system being parsed.
    RuleSet* rules_ = &system_.rules;
    SymbolList seen_; // Symbols in the ignore: or consider: statement of the L-system being parsed.
    // Symbols in these statements of the L-systems parsed so far, the main one first.
    std::vector<SymbolList> ignored_;
    bool has_axiom_ = false;
    bool has_seed_ = false; // True if the L-system being parsed has a seed.
    // Position of the first production with a probability in the L-system being parsed.
    std::optional<std::string> probability_place_;
};

// Consumes a word of the language, ignoring case. A blank in `word` matches any number of blanks.
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

bool Parser::sees_word(std::string_view word)
{
    auto const begin = cursor_.position();
    bool const found = take_word(word);
    cursor_.set_position(begin);
    return found;
}

// Parses a rule. If that fails and the line does not look like a rule, reports a misspelt statement
// instead of the rule's error.
Result<void> Parser::rule_or_misspelt_statement()
{
    cursor_.skip();
    auto const begin = cursor_.position();
    auto const text = cursor_.rest();
    auto const line = text.substr(0, text.find('\n'));
    auto const label = label_of_production(line, names_);
    if (label) {
        names_.warn(fmt::format("{}: {}", cursor_.source().place(begin), describe_label(*label)));
        names_.uses.add_known(trimmed_line(line.substr(line.find(':') + 1)).front());
    }
    auto result = rule();
    auto const arrow = result ? "" : describe_wrong_arrow(line);
    if (!result && (label || !arrow.empty()))
        return cursor_.error_at(begin, arrow.empty() ? describe_label(*label) : arrow);
    auto const has = [&](std::string_view part) { return line.find(part) != line.npos; };
    auto const next = text.substr(std::min(line.size() + 1, text.size()), 1);
    if (result || has("-->") || has("-o>"))
        return result;
    bool const is_near = !nearest_beginning(line, kStatements).empty();
    if (!is_near && (has("{") || next == " " || next == "\t"))
        return result;
    cursor_.set_position(begin);
    return no_statement("a rule, which has -->, or a statement");
}

// Returns the error for a line that is neither a rule nor a statement of the language.
tl::unexpected<Error> Parser::no_statement(std::string_view expected)
{
    auto const line = trimmed_line(cursor_.rest().substr(0, cursor_.rest().find('\n')));
    if (is_axiom_of_book(line))
        return cursor_.error(fmt::format("found '{}', expected 'Axiom:', which books print as ω: "
                                         "(--dialect book reads it so)",
                                         shown(line)));
    if (is_figure_of_book(line))
        return cursor_.error(fmt::format("found '{}', expected {}; --dialect book reads models as "
                                         "books print them",
                                         shown(line), expected));
    auto const nearest = nearest_beginning(line, kStatements);
    return cursor_.error(
        nearest.empty() ? fmt::format("found '{}', expected {}", shown(line), expected)
                        : fmt::format("found '{}', expected '{}', perhaps", shown(line), nearest));
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

// Ends the L-system being parsed. The next line does not continue the present line, however it
// begins.
Result<void> Parser::end_of_system()
{
    if (!trimmed_line(cursor_.take_line()).empty())
        return cursor_.error("found more behind endlsystem, expected the end of the line");
    if (!cursor_.rest().empty())
        cursor_.take_character();
    cursor_.set_arrow_seen(false);
    return {};
}

void Parser::skip_blank_lines()
{
    while (!cursor_.at_end() && cursor_.peek() == '\n')
        cursor_.take_character();
}

Result<Model> Parser::parse()
{
    do {
        TRY(system());
        skip_blank_lines();
    } while (sees_word("lsystem:"));
    if (!cursor_.at_end())
        names_.warn(fmt::format("{}: what follows endlsystem is not read, since it is no "
                                "'Lsystem:'",
                                cursor_.source().place(cursor_.position())));
    return finish();
}

Result<void> Parser::system()
{
    system_ = {};
    rules_ = &system_.rules;
    seen_ = {};
    has_axiom_ = false;
    has_seed_ = false;
    probability_place_.reset();
    names_.variables = system_.globals;
    names_.arrays.clear();
    TRY(header());
    TRY(items());
    if (!has_axiom_ && is_main())
        return cursor_.unexpected("'Axiom:'");
    return finish_system();
}

// Parses "Lsystem:" and the label after it, which is the number by which ?(...) calls a
// sub-L-system. cpfg allows any text as the label.
Result<void> Parser::header()
{
    skip_blank_lines();
    if (!take_word("lsystem:"))
        return cursor_.at_end() ? cursor_.unexpected("'Lsystem:'") : no_statement("'Lsystem:'");
    auto const position = cursor_.position();
    cursor_.skip();
    auto const label = cursor_.take_line();
    system_.id = 0;
    std::from_chars(label.data(), label.data() + label.size(), system_.id);
    auto const has_same_id = [&](LSystem const& other) { return other.id == system_.id; };
    if (!is_main()
        && (model_.id == system_.id
            || std::any_of(model_.subsystems.begin(), model_.subsystems.end(), has_same_id)))
        return cursor_.error_at(
            position,
            fmt::format("found a second L-system {}, expected another number", system_.id));
    if (ignored_.size() >= kMaxSystems)
        return cursor_.error("the model has more than 1000 L-systems");
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
            return end_of_system();
        bool found = TRY(header_item());
        if (!found)
            found = TRY(block_item());
        if (!found)
            found = TRY(section());
        if (!found && !has_axiom_ && is_main())
            return no_statement("'Axiom:' or another statement of the header");
        if (!found)
            TRY(rule_or_misspelt_statement());
        TRY(end_line());
    }
    names_.warn(fmt::format("{}: the file ends without endlsystem",
                            cursor_.source().place(cursor_.position())));
    return {};
}

Result<bool> Parser::header_item()
{
    if (take_word("axiom:")) {
        TRY(axiom());
    } else if (take_word("derivation length:") || take_word("derivationlength:")) {
        auto const value = TRY(constant_value(cursor_, names_));
        if (is_main())
            model_.steps = static_cast<int>(std::clamp(value, 0.0, 1e9));
    } else if (take_word("seed:")) {
        auto const value = TRY(constant_value(cursor_, names_));
        has_seed_ = true;
        if (rules_ == &system_.rules) {
            system_.stochastic = true;
            system_.seed = static_cast<std::uint64_t>(std::clamp(value, 0.0, 1e15));
        }
    } else if (take_word("maximum depth:")) {
        auto const value = TRY(constant_value(cursor_, names_));
        rules_->max_depth = static_cast<int>(std::clamp(value, 0.0, double { kMaxDepth }));
    } else if (take_word("ring l-system") || take_word("ring lsystem")) {
        system_.ring = true;
    } else if (take_word("ignore:")) {
        seen_ = { false, std::string(cursor_.take_line()) };
    } else if (take_word("consider:")) {
        seen_ = { true, std::string(cursor_.take_line()) };
    } else {
        return false;
    }
    return true;
}

Result<bool> Parser::block_item()
{
    if (take_word("define:")) {
        TRY(definitions_parser_.block(system_));
        return true;
    }
    Block* target = nullptr;
    if (take_word("starteach:") || take_word("start each:"))
        target = &system_.start_each;
    else if (take_word("start:"))
        target = &system_.start;
    else if (take_word("endeach:") || take_word("end each:"))
        target = &system_.end_each;
    else if (take_word("end:"))
        target = &system_.end;
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
        set = &system_.homomorphism;
    else if (take_word("decomposition"))
        set = &system_.decomposition;
    if (!set)
        return false;
    cursor_.take(":");
    if (!take_word("no warnings"))
        take_word("warnings");
    // The line is a rule after all: for example, its predecessor begins with an h.
    if (!cursor_.at_line_end()) {
        cursor_.set_position(begin);
        return false;
    }
    rules_ = set;
    set->specified = true;
    return true;
}

Result<Block> Parser::block()
{
    Block result;
    ExpressionCompiler compiler(cursor_, names_, NewNames::Global);
    TRY(StatementCompiler(compiler).block(result.program));
    result.frame = compiler.frame().take_frame();
    return result;
}

Result<void> Parser::rule()
{
    if (rules_->rules.size() >= kMaxRules)
        return cursor_.error("the model has more than 65000 rules");
    cursor_.skip();
    auto const begin = cursor_.position();
    auto rule = TRY(rules_parser_.rule());
    if (rule.has_probability && rules_ == &system_.rules) {
        system_.stochastic = true;
        if (!probability_place_)
            probability_place_ = cursor_.source().place(begin);
    }
    auto const first = rule.predecessor.front();
    rules_->by_kind[first].push_back(static_cast<std::uint16_t>(rules_->rules.size()));
    rules_->rules.push_back(std::move(rule));
    return {};
}

Result<void> Parser::axiom()
{
    if (has_axiom_)
        return cursor_.error("found a second axiom, expected one");
    ExpressionCompiler compiler(cursor_, names_, NewNames::Global);
    TRY(rules_parser_.modules(system_.axiom, compiler, system_.axiom_program.program));
    system_.axiom_program.frame = compiler.frame().take_frame();
    has_axiom_ = true;
    return {};
}

Result<void> Parser::finish_system()
{
    if (probability_place_ && !has_seed_)
        names_.warn(fmt::format("{}: rules have probabilities, but there is no seed: cpfg then "
                                "always takes the first one, while one is drawn here; write "
                                "'Seed: 0' above the axiom, which keeps this plant",
                                *probability_place_));
    for (char const symbol : seen_.symbols)
        names_.uses.add_known(symbol);
    system_.globals = std::move(names_.variables);
    if (is_main())
        static_cast<LSystem&>(model_) = std::move(system_);
    else
        model_.subsystems.push_back(std::move(system_));
    ignored_.push_back(std::move(seen_));
    return {};
}

void Parser::set_ignored(LSystem& system, SymbolList const& list)
{
    for (std::size_t i = 0; i < model_.alphabet.kinds.size(); ++i) {
        char const symbol = model_.alphabet.kinds[i].symbol;
        bool const listed = list.symbols.find(symbol) != std::string::npos;
        system.ignored[i] = listed != list.is_consider;
    }
}

Model Parser::finish()
{
    set_ignored(model_, ignored_.front());
    for (std::size_t i = 0; i < model_.subsystems.size(); ++i)
        set_ignored(model_.subsystems[i], ignored_[i + 1]);
    if (!model_.subsystems.empty() && find_kind(model_.alphabet, { '%', 1 }))
        names_.warn(fmt::format("{}: %(x) removes the rest of its branch, as % does; models with "
                                "sub-L-systems cannot keep it at the string's end",
                                model_.name));
    model_.formats = std::move(names_.formats);
    // Warnings about what changes the plant most are listed first.
    auto& warnings = model_.warnings;
    warnings = std::move(names_.warnings);
    for (auto const& more : { names_.uses.warnings(cursor_.source()), model_.view.warnings,
                              names_.undefined_warnings() })
        warnings.insert(warnings.end(), more.begin(), more.end());
    return std::move(model_);
}

} // namespace

std::optional<KindId> find_kind(Alphabet const& alphabet, ModuleKind const& kind)
{
    auto const found = std::find(alphabet.kinds.begin(), alphabet.kinds.end(), kind);
    if (found == alphabet.kinds.end())
        return std::nullopt;
    return static_cast<KindId>(found - alphabet.kinds.begin());
}

Result<Model> compile_model(ModelSource const& source, IncludeReader const& include)
{
    auto view = TRY(parse_view(source.view_name, source.view_text, include));
    auto const text = TRY(preprocess(source.name, source.text, include));
    auto model = Parser(source, text, std::move(view)).parse();
    // A warning of the preprocessor may explain the error, for example if a macro swallowed a
    // statement.
    if (!model)
        for (auto const& warning : text.warnings)
            model.error().message += fmt::format("; before that, {}", warning);
    return model;
}

} // namespace tractus::lsystem
