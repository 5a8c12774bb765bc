// No file of the program but its own, and the one list, names a tool or a kind of edit.

#include "app/methods/all_methods.h"
#include "drivers/file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace tractus {
namespace {

namespace fs = std::filesystem;

struct SourceText {
    std::string path; // From the root.
    std::string text; // Without comments.
};

std::string without_comments(std::string const& text)
{
    std::string code;
    for (std::size_t i = 0; i < text.size();) {
        auto const end = std::min(text.find('\n', i), text.size());
        auto const line = text.substr(i, end - i);
        code += line.substr(0, line.find("//")) + '\n';
        i = end + 1;
    }
    return code;
}

std::vector<SourceText> sources()
{
    std::vector<SourceText> all;
    for (auto const* const folder : { "app", "calib", "drivers", "engine", "sim" })
        for (auto const& entry : fs::recursive_directory_iterator(fs::path(TRACTUS_ROOT) / folder))
            if (auto const ending = entry.path().extension(); ending == ".cpp" || ending == ".h")
                all.push_back({ fs::relative(entry.path(), TRACTUS_ROOT).generic_string(),
                                without_comments(read_file(entry.path()).value()) });
    return all;
}

// A row says its word in one of these ways.
bool defines(SourceText const& source, std::string const& word)
{
    return source.text.find(fmt::format(".word = \"{}\"", word)) != std::string::npos
        || std::regex_search(source.text,
                             std::regex(fmt::format("make_edit_kind<[^>]*>\\(\\s*\"{}\"", word)));
}

// Words of other languages that happen to be the same, and who speaks them.
bool is_another_language(std::string const& path, std::string const& word)
{
    static std::set<std::pair<std::string, std::string>> const others {
        { "sim/gesture_script.cpp", "select" }, // The script of a simulated hand.
        { "sim/gesture_script.cpp", "draw" },
        { "sim/gesture_script.cpp", "indicate" },
        { "app/verbs/window.cpp", "draw" },                       // "tractus draw",
        { "app/methods/leaves/leaves_command.cpp", "draw" },      // and "tractus leaves draw".
        { "app/live/calibration_panel_controller.cpp", "press" }, // Of the tool line "calibrate".
        { "app/calibration/calibration_controller.cpp", "press" },
    };
    return others.contains({ path, word });
}

std::vector<std::string> all_words()
{
    std::vector<std::string> words { "press" };
    for (auto const* const kind : all_methods().tools)
        words.emplace_back(kind->word);
    for (auto const* const kind : all_methods().edits)
        words.emplace_back(kind->word);
    return words;
}

TEST(MethodWords, StandInTheFilesOfTheirRowsAlone)
{
    auto const files = sources();
    ASSERT_GT(files.size(), 300u);
    for (auto const& word : all_words()) {
        auto const literal = fmt::format("\"{}\"", word);
        int definitions = 0;
        for (auto const& file : files) {
            bool const is_own = defines(file, word);
            definitions += is_own;
            if (!is_own && !is_another_language(file.path, word))
                EXPECT_EQ(file.text.find(literal), std::string::npos)
                    << file.path << " names " << literal;
        }
        EXPECT_GE(definitions, 1) << word;
    }
}

// A tool's header belongs to its own folder and the list; but anybody's other end may erase.
TEST(MethodWords, ToolsAreIncludedByTheirFolderAndTheList)
{
    std::regex const include("#include \"(app/[a-z_/]*)/([a-z_]*)_tool\\.h\"");
    int count = 0;
    for (auto const& file : sources()) {
        auto const folder = file.path.substr(0, file.path.rfind('/'));
        for (std::sregex_iterator i(file.text.begin(), file.text.end(), include), end; i != end;
             ++i) {
            ++count;
            bool const is_eraser = (*i)[2] == "erase" && folder.starts_with("app/methods/");
            EXPECT_TRUE((*i)[1] == folder || is_eraser
                        || file.path == "app/methods/all_methods.cpp")
                << file.path << ": " << i->str();
        }
    }
    EXPECT_GT(count, 10);
}

// What a method has in its folders nobody else includes, but the two files of the list.
TEST(MethodWords, MethodsAreIncludedByTheListAlone)
{
    std::regex const include("#include \"((?:app|engine)/methods/[a-z_]+)/");
    for (auto const& file : sources())
        for (std::sregex_iterator i(file.text.begin(), file.text.end(), include), end; i != end;
             ++i) {
            auto const method = (*i)[1].str().substr((*i)[1].str().rfind('/') + 1);
            bool const is_own = file.path.starts_with("app/methods/" + method + "/")
                || file.path.starts_with("engine/methods/" + method + "/");
            bool const is_list = file.path.starts_with("app/methods/all_");
            EXPECT_TRUE(is_own || is_list) << file.path << ": " << i->str();
        }
}

} // namespace
} // namespace tractus
