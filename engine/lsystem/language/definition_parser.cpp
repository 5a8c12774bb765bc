#include "engine/lsystem/language/definition_parser.h"

#include "engine/lsystem/language/expression_compiler.h"
#include "engine/lsystem/text/user_text.h"

#include <fmt/core.h>
#include <utility>
#include <vector>

namespace tractus::lsystem {

static constexpr double kMaxArraySize = 1e6;
// Maximum number of elements in all arrays of a file together.
static constexpr std::size_t kMaxArrayElements = 10'000'000;

Result<double> constant_value(Cursor& cursor, Names& names)
{
    ExpressionCompiler compiler(cursor, names, ExpressionCompiler::NewNames::Global);
    Program program;
    auto const position = cursor.position();
    auto const value = TRY(compiler.expression(program));
    if (!program.empty())
        return cursor.error_at(position, "expected an expression of numbers alone");
    return compiler.frame().value(value);
}

Result<void> DefinitionParser::block(LSystem& system)
{
    if (!cursor_.take("{"))
        return cursor_.unexpected("'{'");
    cursor_.enter_block();
    while (!cursor_.take("}")) {
        cursor_.skip();
        auto const position = cursor_.position();
        auto const word = ExpressionCompiler::name(cursor_);
        if (!word)
            return cursor_.unexpected("'array' or 'external'");
        if (word != "array" && word != "external")
            return cursor_.error_at(
                position, fmt::format("found '{}', expected 'array' or 'external'", shown(*word)));
        do
            TRY(word == "array" ? array_definition(system) : external_definition(system));
        while (cursor_.take(","));
        if (!cursor_.take(";"))
            return cursor_.unexpected("';'");
    }
    cursor_.leave_block();
    return {};
}

// Defines an array, whose sizes in brackets come next, and reads these.
Result<void> DefinitionParser::new_array(LSystem& system, std::string const& name)
{
    Names::Array array { name, {} };
    double size = 1;
    while (cursor_.take("[")) {
        auto const extent = TRY(constant_value(cursor_, names_));
        size *= extent;
        if (!(extent >= 1) || !(size <= kMaxArraySize))
            return cursor_.error(
                fmt::format("the size of array {} must be 1 to {}", name, kMaxArraySize));
        array.sizes.push_back(static_cast<std::size_t>(extent));
        if (!cursor_.take("]"))
            return cursor_.unexpected("']'");
    }
    std::size_t count = 1;
    for (auto const extent : array.sizes)
        count *= extent;
    array_elements_ += count;
    if (array_elements_ > kMaxArrayElements || names_.arrays.size() >= Names::kMax)
        return cursor_.error(
            fmt::format("the model's arrays have more than {} elements", kMaxArrayElements));
    names_.arrays.push_back(std::move(array));
    system.arrays.push_back({ name, std::vector<double>(count) });
    return {};
}

Result<void> DefinitionParser::array_definition(LSystem& system)
{
    auto const name = ExpressionCompiler::name(cursor_);
    if (!name || cursor_.peek() != '[')
        return cursor_.unexpected("an array's name and '['");
    TRY(new_array(system, *name));
    if (!cursor_.take("="))
        return {};
    return array_values(system.arrays.back());
}

Result<void> DefinitionParser::array_values(ArrayVariable& variable)
{
    if (!cursor_.take("{"))
        return cursor_.unexpected("'{'");
    for (std::size_t i = 0; !cursor_.take("}"); ++i) {
        auto const value = TRY(constant_value(cursor_, names_));
        if (i < variable.values.size())
            variable.values[i] = value;
        if (!cursor_.take(",") && cursor_.peek() != '}')
            return cursor_.unexpected("',' or '}'");
    }
    return {};
}

Result<void> DefinitionParser::external_definition(LSystem& system)
{
    auto const name = ExpressionCompiler::name(cursor_);
    if (!name)
        return cursor_.unexpected("the name of a variable or an array");
    if (cursor_.peek() == '[') {
        auto const index = static_cast<std::uint16_t>(names_.arrays.size());
        TRY(new_array(system, *name));
        system.externals.push_back({ true, index });
    } else {
        system.externals.push_back({ false, TRY(names_.add_variable(*name, cursor_)) });
    }
    return {};
}

} // namespace tractus::lsystem
