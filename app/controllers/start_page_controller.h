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
    tools::ToolKinds tools {}; // The first of each method that makes plants begins an empty sheet.
    // Folders of models, ours and a person's own; those that are not there have none.
    std::vector<std::filesystem::path> models {};
    std::filesystem::path sessions {};                // Whose newest are offered.
    std::filesystem::path pictures {};                // Where pictures are kept; empty: nowhere.
    std::function<std::chrono::sys_seconds()> now {}; // The clock on the wall.
};

// This program's models, and the folders of the person who runs it (user_folder.h): models in
// "models" among the sessions, pictures among what can be made again.
StartPageOptions start_page_of_user(tools::Methods const& methods);

// Contents of the start page: empty sheets, models and the newest sessions. What is chosen is
// opened in the background, as pictures are made. Belongs to one thread.
class StartPageController final : public view::StartPageModel {
public:
    static constexpr std::size_t kMostRecent = 12;

    explicit StartPageController(StartPageOptions options);
    ~StartPageController() override; // Leaves no file of what was chosen and not taken.

    // Shows it, with what there is now. `note`: see StartPageState.
    void open(std::string note);
    bool is_open() const { return is_open_; }

    // Takes what was made in the background.
    void advance();

    // What was chosen, when it is open: the page is closed then.
    struct Chosen {
        OpenedDrawing drawing;
        std::optional<tools::Tool> tool {}; // To be in hand.
    };
    std::optional<Chosen> take_opened();

    // Waits until pictures and what was chosen are there to be taken.
    void settle();

    view::StartPageState const& state() const override { return state_; }
    void choose(std::size_t group, std::size_t card) override;

private:
    struct Meaning {
        WantedDrawing wanted;
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
    std::vector<std::vector<Meaning>> meanings_; // As the state's cards are.
    std::optional<tools::Tool> chosen_tool_;
    CardPictures pictures_;
    NewestJob<WantedDrawing, Result<OpenedDrawing>> opening_;
};

} // namespace tractus::controllers
