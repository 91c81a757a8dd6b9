#pragma once

#include <QTimer>
#include <QVariantAnimation>
#include <QWidget>
#include <algorithm>
#include <array>
#include <functional>
#include <future>
#include <memory>
#include <optional>

#include "ui/layers/layer_model.h"
#include "ui/views/board_view.h"
#include "ui/workspace/loader.h"
#include "ui/workspace/settings.h"

class QSplitter;

namespace ui {

/// Per row of model::StepTree::steps.
using ElementStateLists = std::vector<render::ElementStates>;

/// The 2D and the 3D view of one board: one scene on the device, one set of ids, two cameras. Either alone, side by
/// side, or one above the other. Commands go to the view in use, which has a coloured edge: the one where a button, a
/// wheel or a key was used last. A pointer that crosses a view changes nothing of that, but keys are for the view that
/// it is on: the first one makes it the view in use.
class BoardViews : public QWidget {
    Q_OBJECT

public:
    explicit BoardViews(GpuContext& context, QWidget* parent = nullptr);
    ~BoardViews() override;

    /// Puts the board on the device and looks at it anew.
    void show(const LoadedBoard& board, const std::vector<LayerAppearance>& styles);
    /// The same board with other heights: nothing but a few numbers per layer goes to the device.
    void setHeights(std::shared_ptr<const model::Document> document);
    void setStyles(const std::vector<LayerAppearance>& styles);
    /// What layers look like in 3D whose colour nobody changed; `setStyles` comes after it.
    void setPalette(render::Palette palette) { m_palette = palette; }
    /// Likewise.
    void setBoardColours(const model::BoardColourChoice& chosen) { m_boardColours = chosen; }
    /// In 2D this layer is drawn over the others; none ends it.
    void setTopLayer(model::LayerId layer);
    /// In 2D all layers but this one fade into the background; none ends it.
    void setContrastLayer(model::LayerId layer);
    /// The same in both views and for several layers, over what `setContrastLayer` says; none ends it.
    void setContrastLayers(std::vector<model::LayerId> layers);
    void setBackend(render::Backend backend) {
        std::ranges::for_each(m_views, [backend](BoardView* view) { view->setBackend(backend); });
    }
    void setArrangement(Arrangement arrangement);
    [[nodiscard]] Arrangement arrangement() const { return m_arrangement; }
    /// How much of their room the 2D view has where both are shown, between 0 and 1.
    void divide(double flatShare);
    /// Spreads the layers of the 3D view apart by so much (render::ViewSettings::explode), with a short animation, or
    /// at once.
    void explode(float by);
    void setExplode(float by);
    [[nodiscard]] float exploded() const { return m_exploded; }
    /// Thicknesses as the 3D view draws them.
    void setZScale(const render::ZScale& scale);
    [[nodiscard]] const render::ZScale& zScale() const { return m_zScale; }
    /// Names the layer that stays where it is seen in 3D while layers are spread or scaled; none: they move about the
    /// lowest.
    void setAnchor(std::function<model::LayerId()> anchor) { m_anchor = std::move(anchor); }
    /// Cuts the board of the 3D view open; null: it is whole.
    void setCut(std::shared_ptr<const render::SectionCut> cut) { solid().setCut(std::move(cut)); }
    /// See BoardView, all three.
    void requestFrame() { std::ranges::for_each(m_views, &BoardView::requestFrame); }
    void requestFrameAtRest() { std::ranges::for_each(m_views, &BoardView::requestFrameAtRest); }
    void requestOverlay() { std::ranges::for_each(m_views, &BoardView::requestOverlay); }
    /// How elements look otherwise than their layers; the colours that they name, shader::kHighlightRow at most; and by
    /// how much what does not stand out is darkened, 0 to 1. They show in the next frame of the board, which the caller
    /// asks for.
    void setStates(ElementStateLists states);
    void setElementColours(std::vector<glm::vec3> colours) { m_elementColours = std::move(colours); }
    void setDim(float dim) {
        std::ranges::for_each(m_views, [dim](BoardView* view) { view->setDim(dim); });
    }

    [[nodiscard]] BoardView& flat() { return *m_views[0]; }
    [[nodiscard]] BoardView& solid() { return *m_views[1]; }
    [[nodiscard]] const std::array<BoardView*, 2>& both() const { return m_views; }
    /// The view that commands are for; it is always shown.
    [[nodiscard]] BoardView& active() { return *m_active; }
    void setActive(BoardView& view);
    /// What is done with this view is to be seen: asks for both of them where it is hidden.
    void reveal(const BoardView& view);
    /// Null while no board is shown. Where the device is software it gets there after the first flat picture.
    [[nodiscard]] render::BoardScene* scene() { return m_scene.get(); }

signals:
    /// The device failed and is about to be renewed: who made something from it gives that up.
    void deviceGoes();
    void timed(const render::FrameStats& stats);
    /// The user moved the line between the views.
    void divided(double flatShare);
    /// A view that is hidden is needed beside the other one.
    void bothWanted();
    /// The device failed; says whether it works again.
    void troubled(const QString& what);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void watch(BoardView& view);
    void onPointed(BoardView& view);
    void onLeft(BoardView& view);
    void onSplitterMoved();
    void makeScene();
    void loadScene();
    void loadInTurn();
    void takeLoaded(const base::Status& loaded);
    void dropScene();
    void showScene(BoardView& view);
    void applyHeights();
    void applyExplode(float by);
    [[nodiscard]] std::optional<float> anchorHeight();
    void followAnchor(std::optional<float> before);
    void applyStates();
    void applyStyles();
    void onTimed(const render::FrameStats& stats);
    void onDeviceLost();
    [[nodiscard]] std::vector<render::LayerStyle> stylesOf(const BoardView& view) const;

    GpuContext& m_context;
    std::unique_ptr<render::BoardScene> m_scene;
    QTimer m_load;                        ///< runs while the scene is still to be brought to the device
    std::future<base::Status> m_loading;  ///< the scene, which stays until that is done
    std::optional<LoadedBoard> m_board;
    std::vector<LayerAppearance> m_styles;
    ElementStateLists m_states;
    std::vector<glm::vec3> m_elementColours;
    render::Palette m_palette = render::Palette::Standard;
    model::BoardColourChoice m_boardColours;
    model::LayerId m_topLayer;                     ///< in 2D
    model::LayerId m_contrastLayer;                ///< in 2D
    std::vector<model::LayerId> m_contrastLayers;  ///< in both views
    render::ZScale m_zScale;
    QVariantAnimation m_explosion;
    std::function<model::LayerId()> m_anchor = [] { return model::LayerId{}; };
    float m_exploded = 0.0F;
    Arrangement m_arrangement = Arrangement::SideBySide;
    double m_flatShare = 0.5;
    bool m_isUntried = false;  ///< the device was renewed and has not finished a frame since
    QSplitter* m_splitter = nullptr;
    std::array<BoardView*, 2> m_views{};
    BoardView* m_active = nullptr;
    BoardView* m_pointed = nullptr;        ///< the pointer is on it
    BoardView* m_keyboardTaker = nullptr;  ///< it took the keyboard as the pointer came
};

}  // namespace ui
