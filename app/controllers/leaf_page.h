#pragma once

#include "app/methods/all_leaves.h"
#include "app/view/start_page.h"
#include "app/view/window_model.h"
#include "engine/base/newest_job.h"
#include "engine/scene/season.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace tractus::controllers {

// A page that previews the leaves of one grammar, at any age and with any damage, before the user
// puts them on a plant. Leaves are painted in the background while sliders move. Use from one
// thread.
class LeafPage final : public view::StartPageModel {
public:
    struct Subject {
        std::string title {}; // Title of the page, for example "Oak".
        methods::GrammarOfLeaves grammar {};
        methods::Foliage wanted {};             // Foliage with which the page's settings begin.
        std::optional<scene::Season> season {}; // The document's season.
    };

    LeafPage();

    void open(Subject subject);
    bool is_open() const { return is_open_; }

    // Shows the pictures that the background thread has finished.
    void advance();
    void settle();

    // Returns the foliage if the user has accepted it since the last call; the page is then closed.
    std::optional<view::SetActiveFoliage> take_accepted()
    {
        return std::exchange(accepted_, std::nullopt);
    }

    // True if the user has left the page without accepting since the last call.
    bool take_left() { return std::exchange(is_left_, false); }

    view::StartPageState const& state() const override { return state_; }
    void choose(std::size_t, std::size_t) override { }
    void slide(std::size_t slider, double value) override;
    void accept() override;
    void leave() override;

private:
    struct Wanted {
        std::shared_ptr<Subject const> subject; // Shared with the page; immutable.
        leaf::LeafLook look;
    };

    void set_season(double month);
    leaf::LeafLook look() const;
    void show_sliders();
    void show(leaf::LeafStudy study);

    bool is_open_ = false;
    bool is_left_ = false;
    view::StartPageState state_;
    // The leaf that the page shows, set by open().
    std::shared_ptr<Subject const> subject_ {};
    methods::Foliage wanted_ {};
    std::optional<scene::Season> season_ {};
    std::optional<view::SetActiveFoliage> accepted_ {};
    NewestJob<Wanted, Result<leaf::LeafStudy>> job_;
};

} // namespace tractus::controllers
