#include "engine/lsystem/language/functions.h"

#include "engine/lsystem/text/user_text.h"

#include <algorithm>
#include <array>
#include <vector>

namespace tractus::lsystem {

static constexpr std::array kFunctions {
    FunctionEntry { "sin", Op::Sin, 1 },          FunctionEntry { "cos", Op::Cos, 1 },
    FunctionEntry { "tan", Op::Tan, 1 },          FunctionEntry { "asin", Op::Asin, 1 },
    FunctionEntry { "acos", Op::Acos, 1 },        FunctionEntry { "atan", Op::Atan, 1 },
    FunctionEntry { "atan2", Op::Atan2, 2 },      FunctionEntry { "exp", Op::Exp, 1 },
    FunctionEntry { "log", Op::Log, 1 },          FunctionEntry { "floor", Op::Floor, 1 },
    FunctionEntry { "ceil", Op::Ceil, 1 },        FunctionEntry { "trunc", Op::Round, 1 },
    FunctionEntry { "fabs", Op::Abs, 1 },         FunctionEntry { "sign", Op::Sign, 1 },
    FunctionEntry { "sqrt", Op::Sqrt, 1 },        FunctionEntry { "pow", Op::Power, 2 },
    FunctionEntry { "ran", Op::Random, 1 },       FunctionEntry { "nran", Op::Normal, 2 },
    FunctionEntry { "bran", Op::Beta, 2 },        FunctionEntry { "biran", Op::Binomial, 2 },
    FunctionEntry { "srand", Op::SeedRandom, 1 }, FunctionEntry { "func", Op::Function, 2 },
    FunctionEntry { "curveX", Op::CurveX, 2 },    FunctionEntry { "curveY", Op::CurveY, 2 },
    FunctionEntry { "curveZ", Op::CurveZ, 2 },    FunctionEntry { "curveGAL", Op::CurveLength, 1 },
};

static constexpr std::array kMissing {
    MissingFunction { "fopen", MissingFunction::About::Files, -1 },
    MissingFunction { "fclose", MissingFunction::About::Files },
    MissingFunction { "fflush", MissingFunction::About::Files },
    MissingFunction { "fprintf", MissingFunction::About::Files },
    MissingFunction { "fscanf", MissingFunction::About::Files },
    MissingFunction { "stop", MissingFunction::About::Window, 0,
                      MissingFunction::Value::FirstArgument },
    MissingFunction { "play", MissingFunction::About::Window },
    MissingFunction { "Display", MissingFunction::About::Window, 0,
                      MissingFunction::Value::FirstArgument },
    MissingFunction { "vvXmin", MissingFunction::About::Window },
    MissingFunction { "vvXmax", MissingFunction::About::Window },
    MissingFunction { "vvYmin", MissingFunction::About::Window },
    MissingFunction { "vvYmax", MissingFunction::About::Window },
    MissingFunction { "vvZmin", MissingFunction::About::Window },
    MissingFunction { "vvZmax", MissingFunction::About::Window },
    MissingFunction { "vvScale", MissingFunction::About::Window },
    MissingFunction { "inblob", MissingFunction::About::Blobs },
};

template<typename Table>
static typename Table::value_type const* find(Table const& table, std::string_view name)
{
    auto const* const found = std::find_if(table.begin(), table.end(),
                                           [&](auto const& entry) { return entry.name == name; });
    return found == table.end() ? nullptr : found;
}

FunctionEntry const* find_function(std::string_view name)
{
    return find(kFunctions, name);
}

std::string_view nearest_function(std::string_view name)
{
    std::vector<std::string_view> names { "printf", "SetDerivationLength", "GetDerivationLength",
                                          "if", "while" };
    for (auto const& entry : kFunctions)
        names.push_back(entry.name);
    for (auto const& entry : kMissing)
        names.push_back(entry.name);
    return nearest_word(name, names);
}

MissingFunction const* find_missing_function(std::string_view name)
{
    return find(kMissing, name);
}

} // namespace tractus::lsystem
