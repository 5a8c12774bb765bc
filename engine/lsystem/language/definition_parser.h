#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/language/cursor.h"
#include "engine/lsystem/language/model.h"
#include "engine/lsystem/language/names.h"

#include <cstddef>
#include <string>

namespace tractus::lsystem {

// Reads an expression of numbers alone.
Result<double> constant_value(Cursor& cursor, Names& names);

// Reads what stands behind define: for one file, whose arrays have a limit together.
class DefinitionParser {
public:
    DefinitionParser(Cursor& cursor, Names& names)
        : cursor_(cursor)
        , names_(names)
    {
    }

    // Reads { array NAME[size]... = { values }, ...; external NAME, NAME[size]..., ...; } of a
    // system.
    Result<void> block(LSystem& system);

private:
    Result<void> array_definition(LSystem& system);
    Result<void> array_values(ArrayVariable& variable);
    Result<void> external_definition(LSystem& system);
    Result<void> new_array(LSystem& system, std::string const& name);

    Cursor& cursor_;
    Names& names_;
    std::size_t array_elements_ = 0;
};

} // namespace tractus::lsystem
