#include "app/controllers/drawn_leaf_files.h"

#include "app/methods/all_leaves.h"
#include "engine/base/file.h"
#include "engine/base/fnv.h"

#include <fmt/format.h>
#include <system_error>

namespace tractus::controllers {

namespace fs = std::filesystem;

// A folder of its own for each text: small pictures are kept by the file's path.
Result<fs::path> write_shown_leaf(std::string const& name, std::string const& grammar,
                                  fs::path const& folder)
{
    auto const own = folder / "drawn-leaves" / fmt::format("{:016x}", fnv1a_64(grammar));
    auto file = own / (name + ".leaf");
    std::error_code error;
    if (!fs::exists(file, error)) {
        TRY(make_folder(own));
        TRY(write_file(file, grammar));
    }
    return file;
}

std::vector<DrawnLeafFile> write_drawn_leaves(scene::DocumentState const& state,
                                              fs::path const& folder)
{
    std::vector<DrawnLeafFile> files;
    for (auto const& [plant, grammar] : methods::drawn_leaves(state))
        if (auto file = write_shown_leaf("drawn-leaf", grammar, folder))
            files.push_back({ plant, *std::move(file) });
    return files;
}

Result<fs::path> keep_leaf(fs::path const& grammar, fs::path const& folder)
{
    auto const text = TRY(methods::read_leaf_grammar(grammar));
    TRY(make_folder(folder));
    auto const name = grammar.stem().string();
    for (int number = 1;; ++number) {
        auto const file
            = folder / (number == 1 ? name + ".leaf" : fmt::format("{}-{}.leaf", name, number));
        std::error_code error;
        if (!fs::exists(file, error)) {
            TRY(write_file(file, text));
            return file;
        }
        if (auto const there = methods::read_leaf_grammar(file); there && *there == text)
            return file;
    }
}

} // namespace tractus::controllers
