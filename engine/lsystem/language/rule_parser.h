#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/language/cursor.h"
#include "engine/lsystem/language/expression_compiler.h"
#include "engine/lsystem/language/model.h"
#include "engine/lsystem/language/names.h"

#include <string>
#include <vector>

namespace tractus::lsystem {

// Parses rules and strings of modules, and adds the kinds of modules that occur in them to the
// alphabet.
class RuleParser {
public:
    RuleParser(Cursor& cursor, Names& names, Alphabet& alphabet)
        : cursor_(cursor)
        , names_(names)
        , alphabet_(alphabet)
    {
    }

    // Parses a rule up to the end of its line.
    Result<Rule> rule();

    // Parses modules whose parameters are expressions, up to the end of the line or a colon.
    Result<void> modules(SuccessorTemplate& result, ExpressionCompiler& compiler, Program& program);

private:
    // A module with the names of its formal parameters.
    struct FormalModule {
        KindId kind = 0;
        std::vector<std::string> parameters;
    };

    Result<void> predecessor(Rule& rule, ExpressionCompiler& compiler);
    Result<void> add_parameters(std::vector<FormalModule> const& modules,
                                std::vector<KindId>& kinds, Rule& rule,
                                ExpressionCompiler& compiler);
    Result<void> condition(Rule& rule, ExpressionCompiler& compiler);
    Result<void> successor(Rule& rule, ExpressionCompiler& compiler);
    void check_locals(Rule& rule, ExpressionCompiler const& compiler);
    Result<std::vector<FormalModule>> formal_modules();
    Result<FormalModule> formal_module();
    Result<KindId> kind(char symbol, std::size_t parameter_count);
    Result<char> symbol();

    Cursor& cursor_;
    Names& names_;
    Alphabet& alphabet_;
};

} // namespace tractus::lsystem
