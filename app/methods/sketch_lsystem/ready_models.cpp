#include "app/methods/sketch_lsystem/ready_models.h"

#include "engine/base/check.h"

#include <algorithm>
#include <string>

namespace tractus::sketch {

// Returns the text of a view file without the statements that request grown leaves.
static std::string without_grown_leaves(std::string_view view)
{
    std::string result;
    while (!view.empty()) {
        auto const line = view.substr(0, view.find('\n'));
        if (!line.starts_with("leaf:"))
            result.append(line).append("\n");
        view.remove_prefix(std::min(line.size() + 1, view.size()));
    }
    return result;
}

sketch::ModelRule ready_model(std::string_view name)
{
    auto const all = model_texts();
    auto const found = std::ranges::find(all, name, &ModelTexts::name);
    CHECK(found != all.end());
    std::string const stem(name);
    return { .source = { stem + ".l", std::string(found->rules), stem + ".v",
                         without_grown_leaves(found->view) } };
}

} // namespace tractus::sketch
