#include "app/controllers/drawn_leaf_files.h"

#include "app/methods/all_leaves.h"
#include "app/methods/all_organs.h"
#include "engine/base/file.h"
#include "engine/base/fnv.h"

#include <fmt/format.h>
#include <system_error>

namespace tractus::controllers {

namespace fs = std::filesystem;

// Files with different texts get different folders, because thumbnails are cached by path.
Result<fs::path> write_shown_leaf(std::string const& name, std::string const& text,
                                  fs::path const& folder)
{
    auto const own = folder / "drawn-leaves" / fmt::format("{:016x}", fnv1a_64(text));
    auto file = own / name;
    std::error_code error;
    if (!fs::exists(file, error)) {
        TRY(make_folder(own));
        TRY(write_file(file, text));
    }
    return file;
}

std::vector<DrawnLeafFile> write_drawn_leaves(scene::DocumentState const& state,
                                              fs::path const& folder)
{
    std::vector<DrawnLeafFile> files;
    for (auto const& [plant, grammar] : methods::drawn_leaves(state))
        if (auto file = write_shown_leaf("drawn-leaf.leaf", grammar, folder))
            files.push_back({ plant, *std::move(file) });
    return files;
}

std::vector<DrawnOrganFile> write_drawn_organs(scene::DocumentState const& state,
                                               fs::path const& folder)
{
    std::vector<DrawnOrganFile> files;
    for (auto const& [plant, text] : methods::drawn_organs(state))
        if (auto file = write_shown_leaf("drawn-leaf.organ", text, folder))
            files.push_back({ plant, *std::move(file) });
    return files;
}

Result<fs::path> keep_leaf(fs::path const& leaf, fs::path const& folder)
{
    auto const text = TRY(methods::read_leaf_grammar(leaf));
    TRY(make_folder(folder));
    auto const name = leaf.stem().string();
    auto const ending = leaf.extension().string();
    for (int number = 1;; ++number) {
        auto const file
            = folder / (number == 1 ? name + ending : fmt::format("{}-{}{}", name, number, ending));
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
