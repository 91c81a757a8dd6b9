#pragma once

#include <QImage>
#include <QTimer>
#include <QWidget>
#include <array>
#include <future>
#include <optional>

#include "render/frame/offscreen_presenter.h"
#include "ui/canvas/gpu_context.h"
#include "ui/layers/layer_model.h"
#include "ui/workspace/background_result.h"
#include "ui/workspace/selection_model.h"

namespace ui {

/// The element selected last by itself, from above and aslant, in the colour of its layer and with its true height, on
/// a ground that it stands out from.
/// Modelled a moment after the selection changed, so that the views answer first, in the background, and when it is
/// painted, so that it costs nothing while it is out of sight; hidden while nothing is selected. It requests no room of
/// its own: a selection must not make the window grow.
class ElementPicture : public QWidget {
    Q_OBJECT

public:
    /// An area of more nodes is drawn without what is smaller than the picture's pixels, so that drawing it does not
    /// hold up the window; a track chain of more is not drawn.
    static constexpr std::size_t kMostNodes = 2'000;

    ElementPicture(GpuContext& context, SelectionModel& selection, LayerModel& layers, QWidget* parent = nullptr);
    ~ElementPicture() override { m_context.turns().end(*this); }

    /// Gives up what was made from the device, before it is renewed.
    void releaseDevice();

    enum View { Flat, Solid, ViewCount };
    /// Null where nothing is, could be, or has yet been drawn.
    [[nodiscard]] const QImage& image(View view) const { return m_images[view]; }
    /// Why nothing is drawn; empty otherwise.
    [[nodiscard]] const QString& reason() const { return m_reason; }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return {0, 0}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    /// The element by itself; without a model if it is too large.
    struct Modelled {
        std::shared_ptr<const model::Document> alone;
        std::optional<render::BoardModel> model;
        std::size_t layer = 0;  ///< of the board
    };

    void setStale();
    void startModelling();
    void makePresenter();
    void takeModelled();
    [[nodiscard]] QSize pixels() const;
    void drawInTurn();
    [[nodiscard]] QString drawModelled(QSize pixels);
    [[nodiscard]] QRect locationOf(int view) const;

    GpuContext& m_context;
    SelectionModel& m_selection;
    LayerModel& m_layers;
    std::optional<render::OffscreenPresenter> m_presenter;
    std::shared_future<void> m_pipelines;  ///< of the presenter; being made in the background
    BackgroundResult<Modelled> m_modelling;
    std::optional<Modelled> m_modelled;  ///< none while nothing is selected, or it is being modelled
    std::array<QImage, ViewCount> m_images;
    QSize m_pixels;  ///< of each image
    QString m_reason;
    QTimer m_settle;  ///< runs while the selection may be about to change again
    bool m_isStale = true;
};

}  // namespace ui
