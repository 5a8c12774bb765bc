#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/language/cursor.h"
#include "engine/lsystem/language/model.h"
#include "engine/lsystem/language/names.h"

#include <cstddef>
#include <string>

namespace tractus::lsystem {

// Reads a constant expression and evaluates it.
Result<double> constant_value(Cursor& cursor, Names& names);

// Reads the define: statements of a file. The arrays that these define share a size limit.
class DefinitionParser {
public:
    DefinitionParser(Cursor& cursor, Names& names)
        : cursor_(cursor)
        , names_(names)
    {
    }

    // Reads the block of a define: statement and adds its arrays and external names to `system`.
    // The block is { array NAME[size]... = { values }, ...; external NAME, NAME[size]..., ...; }.
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
