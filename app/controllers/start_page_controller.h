#pragma once

#include "app/controllers/card_pictures.h"
#include "app/controllers/drawing_file.h"
#include "app/tools/methods.h"
#include "app/tools/tool.h"
#include "app/view/start_page.h"
#include "engine/base/newest_job.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tractus::controllers {

struct StartPageOptions {
    scene::EditKinds kinds {}; // Kinds of edits that sessions may have.
    tools::ToolKinds tools {}; // For each method that makes plants, its first tool is selected on
                               // an empty sheet.
    // Folders of models, built-in and the user's; missing folders are ignored.
    std::vector<std::filesystem::path> models {};
    std::filesystem::path sessions {}; // Folder whose newest sessions are offered.
    std::filesystem::path pictures {}; // Cache folder for thumbnails; empty: no caching.
    std::function<std::chrono::sys_seconds()> now {}; // Returns the time of the wall clock.
};

// Options with the built-in models and the user's own folders (user_folder.h): models in "models"
// beside the sessions, thumbnails in the cache.
StartPageOptions start_page_of_user(tools::Methods const& methods);

// The start page: empty sheets, models and recent sessions. Pictures are made, and the choice is
// opened, in the background. Use from one thread.
class StartPageController final : public view::StartPageModel {
public:
    static constexpr std::size_t kMaxRecent = 12;

    explicit StartPageController(StartPageOptions options);
    ~StartPageController() override; // Deletes a new file if its drawing was chosen but not taken.

    // Shows the page with current contents. `note`: see StartPageState.
    void open(std::string note);
    bool is_open() const { return is_open_; }

    // Takes finished work from the background threads.
    void advance();

    // The chosen drawing, once it has been opened; the page is then closed.
    struct Chosen {
        OpenedDrawing drawing;
        std::optional<tools::Tool> tool {}; // The tool to select for the drawing.
    };
    std::optional<Chosen> take_opened();

    // Waits for pictures and the chosen drawing; they can then be taken.
    void settle();

    view::StartPageState const& state() const override { return state_; }
    void choose(std::size_t group, std::size_t card) override;

private:
    struct Meaning {
        DrawingRequest wanted;
        std::optional<tools::Tool> tool {};
    };

    void add_group(view::StartCards cards, std::vector<Meaning> meanings);
    void list_sheets();
    void list_models();
    void list_recent();
    std::map<std::filesystem::path, std::shared_ptr<render::Image const>>
    pictures_of_models() const;
    void show_picture(CardPictures::Made const& made);

    StartPageOptions options_;
    bool is_open_ = false;
    view::StartPageState state_;
    std::vector<std::vector<Meaning>> meanings_; // Meanings of the state's cards, with the same
                                                 // indices.
    std::optional<tools::Tool> chosen_tool_;
    CardPictures pictures_;
    NewestJob<DrawingRequest, Result<OpenedDrawing>> opening_;
};

} // namespace tractus::controllers
