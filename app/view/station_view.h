#pragma once

#include "app/document/document.h"
#include "app/station/station.h"
#include "app/tools/shown_skeleton.h"
#include "app/tools/stroke_previewer.h"
#include "app/view/plant_grower.h"
#include "app/view/shown_layers.h"
#include "app/view/skeleton_picture.h"
#include "app/view/window_model.h"
#include "engine/mesh/mesh.h"
#include "engine/scene/scene.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace tractus::view {

// A station and the document that its strokes go to as the window shows them, wherever the reports
// come from: the hand, its strokes, what is selected, and the plant, which is grown anew in the
// background after each stroke. Whoever owns it says in state() what else is to be seen.
class StationView {
public:
    StationView(station::Station const& station, document::Document const& document);

    WindowState& state() { return state_; }
    WindowState const& state() const { return state_; }

    // What has changed since the last call.
    void show(station::Station const& station, document::Document const& document);

    // So much of the window's time goes by: lines that are seen for a while fade.
    void pass(Duration step);

    // What a stroke has done, in the status.
    void tell(document::DrawnStroke const& drawn);

    // Waits for the plant as it was wanted last, and for all variations, and shows them.
    void settle();

    // What the pen did since the last call, for who lets it work the window. After show().
    void show_pen(std::vector<station::PenMoment> const& moments);

    // Another station in place of the one before, or one that has begun again.
    void begin_again(station::Station const& station, document::Document const& document);

    // What other growth was previewed is gone.
    void show_growth();

    // What other growth would give.
    void preview(scene::SetGrowth const& growth);

    // What another season would give.
    void preview(std::optional<scene::Season> const& season);

    // Shows the document as edits of it would leave it, before they are made; none: as it is. What
    // has changed meanwhile is shown without them.
    void propose(std::vector<scene::Edit> edits);

    // Grows so many variations of the plant, from its own seed on.
    void collect(std::size_t count);

    // What the plant grows from, as of the last change that was not only previewed. Shared with who
    // grows it in the background; nobody changes it.
    std::shared_ptr<scene::Scene const> const& grown_scene() const { return grown_scene_; }

private:
    struct WantedPreview {
        std::shared_ptr<scene::Scene const> scene; // Shared with this; nobody changes it.
        tools::Tool tool {};
        std::vector<TipSample> ink {};
        std::uint32_t orders = 0; // Only branches of lower orders than this are looked at.
        std::size_t stroke = 0;   // Which it is, by its number.
    };
    struct Preview {
        // Shared by those in which they are alike; nobody changes them. Null: none.
        std::shared_ptr<std::vector<tools::SkeletonLine> const> lines {};
        std::string note {};
        std::size_t stroke = 0; // Of which stroke, by its number.
    };
    // What shows strokes under way, on the thread that does.
    struct Previewing {
        Preview show(WantedPreview const& wanted);

        std::unique_ptr<tools::StrokePreviewer> (*made_by)() = nullptr;
        std::unique_ptr<tools::StrokePreviewer> previewer {};
        std::shared_ptr<std::vector<tools::SkeletonLine> const> last {};
    };

    struct WantedProposal {
        std::shared_ptr<scene::Scene const> scene; // Shared with this; nobody changes it.
        std::vector<scene::Edit> edits;
    };

    // A picture's file, read: null where it cannot be, for a reason.
    struct ReadPicture {
        std::shared_ptr<std::string const> file;
        std::shared_ptr<render::Image const> image;
        std::string why {};
    };
    static ReadPicture read(std::shared_ptr<std::string const> const& file);

    // Station::inks(), which are copied once for a frame.
    using Inks = std::span<std::vector<TipSample> const>;

    void show_grown();
    void show_picture(scene::Scene const& scene);
    void show_drawn_glyph();
    void take_picture();
    void propose_outcome(station::Station const& station, std::vector<TipSample> const& ink);
    void take_proposal();
    void show_in_place(std::shared_ptr<scene::Scene const> const& scene);
    void show_live(station::Station const& station, document::Document const& document);
    void show_ink(station::Station const& station, Inks inks,
                  std::vector<tools::ToolStroke> const& waiting);
    void show_surface(station::Station const& station);
    void show_scene(std::shared_ptr<document::Snapshot const> const& snapshot);
    void show_strokes(scene::Scene const& scene);
    void show_layers(scene::Scene const& scene);
    void see_layers();
    void show_variations();
    void show_preview(station::Station const& station, Inks inks);
    void take_preview();
    void set_preview(Preview preview);
    void list_orphans(scene::Scene const& scene);
    void show_selecting(station::Station const& station, Inks inks);
    void show_skeleton(tools::ShownSkeleton::Touched const& touched = {});
    void grow_plant(std::shared_ptr<document::Snapshot const> const& snapshot);
    void take_kept(std::shared_ptr<document::Snapshot const> const& snapshot);

    // On the heap, since a thread knows it.
    std::unique_ptr<PlantGrower> grower_ = std::make_unique<PlantGrower>();
    std::shared_ptr<scene::Scene const> grown_scene_; // Of a snapshot; shared with the grower.
    std::uint64_t shown_revision_ = 0;                // Of that snapshot,
    std::uint64_t shown_drawn_revision_ = 0;          // and of what is seen as drawn.
    // The strokes that state_.strokes begins with, in its order: they need not be in memory.
    std::vector<SharedVector<TipSample>> inked_;
    ShownLayers layers_;
    Nib nib_ = Nib::Point; // The end of the pen whose ink is shown.
    std::size_t finished_strokes_ = 0;
    std::size_t shown_tips_ = 0;
    double shown_surface_mm_ = 0; // That the last picture of the pad was made for.
    // What a selecting pen is drawn over, and the plant that it was made of; none before it is
    // needed.
    std::optional<tools::ShownSkeleton> shown_skeleton_;
    std::shared_ptr<scene::Scene const> shown_scene_; // Shared with the document, which may go on.
    std::vector<SegmentId> (*aims_at_)(scene::Scene const& scene) = nullptr; // Of the tool in hand.
    std::optional<tools::ShownSkeleton::Touched> shown_touched_; // As the skeleton shows it.
    SkeletonPicture skeleton_;
    scene::SelectionAngle shown_angle_;
    bool is_selecting_ = false;
    std::unique_ptr<NewestJob<WantedPreview, Preview>> preview_; // On the heap, as the grower.
    std::uint64_t previewed_live_ = 0;                           // The ink's revision.
    std::shared_ptr<std::vector<tools::SkeletonLine> const> previewed_; // As the state has them.
    // On the heap, as the grower. It gives null for edits that cannot be made.
    std::unique_ptr<NewestJob<WantedProposal, std::shared_ptr<scene::Scene const>>> proposal_;
    std::unique_ptr<NewestJob<std::shared_ptr<std::string const>, ReadPicture>> reading_;
    std::shared_ptr<scene::BackPicture const> picture_; // Picture that is shown, or being read.
    // Scene of plant and skeleton as they are shown.
    std::shared_ptr<scene::Scene const> shown_in_place_;
    std::shared_ptr<scene::Scene const> glyph_scene_;   // That the drawn glyph shows,
    tools::DrawnGlyphKind const* glyph_kind_ = nullptr; // and how.
    std::uint64_t proposed_live_ = 0;                   // As previewed_live_.
    bool is_outcome_proposed_ = false;                  // Of a stroke under way.
    bool is_proposed_ = false; // Edits that are not made yet are shown, or will be.
    bool is_drawing_ = false;
    std::size_t shown_waiting_ = 0; // Strokes as ink.
    // On the heap, since the state points to it when this moves.
    std::unique_ptr<mesh::Mesh const> plant_;
    WindowState state_;
};

// The growth that a person sets, all else as it is. Fails, as the user's fault, for a preset that
// there is not.
Result<scene::SetGrowth> growth_set_to(GrowthView const& wanted, scene::SetGrowth growth);

} // namespace tractus::view
