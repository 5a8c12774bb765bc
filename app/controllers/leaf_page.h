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

// A page that shows the leaves of one grammar at any age and with any damage before a plant has
// them. They are painted in the background while sliders move. Belongs to one thread.
class LeafPage final : public view::StartPageModel {
public:
    struct Subject {
        std::string title {}; // "Oak".
        methods::GrammarOfLeaves grammar {};
        methods::Dressing wanted {};            // As the page shows it at first.
        std::optional<scene::Season> season {}; // Of the document.
    };

    LeafPage();

    void open(Subject subject);
    bool is_open() const { return is_open_; }

    // Takes what was painted in the background.
    void advance();
    void settle();

    // The leaves as they were accepted: the page is closed then.
    std::optional<view::DressActivePlant> take_accepted()
    {
        return std::exchange(accepted_, std::nullopt);
    }

    // Whether it was left without that since the last call.
    bool take_left() { return std::exchange(is_left_, false); }

    view::StartPageState const& state() const override { return state_; }
    void choose(std::size_t, std::size_t) override { }
    void slide(std::size_t slider, double value) override;
    void accept() override;
    void leave() override;

private:
    struct Wanted {
        std::shared_ptr<Subject const> subject; // Shared with the page; nobody changes it.
        leaf::LeafLook look;
    };

    void set_season(double month);
    leaf::LeafLook look() const;
    void show_sliders();
    void show(leaf::LeafStudy study);

    bool is_open_ = false;
    bool is_left_ = false;
    view::StartPageState state_;
    std::shared_ptr<Subject const> subject_ {}; // As it was opened.
    methods::Dressing wanted_ {};
    std::optional<scene::Season> season_ {};
    std::optional<view::DressActivePlant> accepted_ {};
    NewestJob<Wanted, Result<leaf::LeafStudy>> job_;
};

} // namespace tractus::controllers
