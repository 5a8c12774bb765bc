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
    scene::EditKinds kinds {}; // Kinds of edits that sessions may contain.
    // Tools of all methods. For each method, the page offers an empty sheet with its first tool.
    tools::ToolKinds tools {};
    // Folders of models, built-in and the user's; missing folders are ignored.
    std::vector<std::filesystem::path> models {};
    std::filesystem::path sessions {}; // Folder of sessions, of which the page offers the newest.
    std::filesystem::path pictures {}; // Cache folder for thumbnails; empty: no caching.
    std::function<std::chrono::sys_seconds()> now {}; // Wall clock.
};

// Returns options with the built-in models and the user's own folders (user_folder.h): models in
// "models" beside the sessions, and thumbnails in the cache.
StartPageOptions start_page_of_user(tools::Methods const& methods);

// Controller of the start page, which offers empty sheets, models and recent sessions. Thumbnails
// are made in the background, where the chosen drawing is also opened. Use from one thread.
class StartPageController final : public view::StartPageModel {
public:
    static constexpr std::size_t kMaxRecent = 12;

    explicit StartPageController(StartPageOptions options);
    ~StartPageController() override; // If a drawing was chosen but not taken, deletes its new file.

    // Shows the page with current contents. For `note` see StartPageState.
    void open(std::string note);
    bool is_open() const { return is_open_; }

    // Takes finished thumbnails and the opened drawing from the background threads.
    void advance();

    // The drawing that the user chose, already opened. The page is closed when this can be taken.
    struct Chosen {
        OpenedDrawing drawing;
        // Tool to select for the drawing; no value: it depends on the drawing.
        std::optional<tools::Tool> tool {};
        bool is_for_tour = false; // True if the tour begins in the drawing.
    };
    std::optional<Chosen> take_opened();

    // Waits for thumbnails and the chosen drawing to be finished; the drawing can then be taken.
    void settle();

    view::StartPageState const& state() const override { return state_; }
    void choose(std::size_t group, std::size_t card) override;
    void begin_tour() override;

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
    // What choosing each card of state_ means, with the same indices.
    std::vector<std::vector<Meaning>> meanings_;
    std::optional<tools::Tool> chosen_tool_;
    bool tour_is_chosen_ = false;
    CardPictures pictures_;
    NewestJob<DrawingRequest, Result<OpenedDrawing>> opening_;
};

} // namespace tractus::controllers
