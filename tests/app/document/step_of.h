#pragma once

#include "app/document/document.h"

#include <string>
#include <utility>
#include <vector>

namespace tractus {

// A step of these edits, whatever the scene is.
inline WantedStep step_of(std::vector<Edit> edits, std::string status = "")
{
    return { [change = WantedStep::Change { std::move(edits), std::move(status) }](
                 Scene const&) -> Result<WantedStep::Change> { return change; } };
}

} // namespace tractus
