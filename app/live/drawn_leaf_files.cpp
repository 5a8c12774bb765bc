#include "app/live/drawn_leaf_files.h"

#include "app/methods/all_leaves.h"
#include "drivers/file.h"
#include "engine/base/fnv.h"

#include <fmt/format.h>
#include <system_error>

namespace tractus {

namespace fs = std::filesystem;

// A folder of its own for each text: small pictures are kept by the file's path.
std::vector<fs::path> write_drawn_leaves(DocumentState const& state, fs::path const& folder)
{
    std::vector<fs::path> files;
    for (auto const& [plant, grammar] : drawn_leaves(state)) {
        auto const own = folder / "drawn-leaves" / fmt::format("{:016x}", fnv1a_64(grammar));
        auto const file = own / "drawn-leaf.leaf";
        std::error_code error;
        if (fs::exists(file, error) || (make_folder(own) && write_file(file, grammar)))
            files.push_back(file);
    }
    return files;
}

Result<fs::path> keep_leaf(fs::path const& grammar, fs::path const& folder)
{
    auto const text = TRY(read_leaf_grammar(grammar));
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
        if (auto const there = read_leaf_grammar(file); there && *there == text)
            return file;
    }
}

} // namespace tractus
