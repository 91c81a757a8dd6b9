#pragma once

#include <QImage>
#include <QWidget>
#include <array>

#include "ui/gpu_context.h"
#include "ui/models/layer_model.h"
#include "ui/models/selection_model.h"

namespace ui {

/// The element selected last by itself, from above and aslant, in the colour of its layer and with its true height.
/// Drawn when it is painted, so it costs nothing while it is out of sight; hidden while nothing is selected. It asks
/// for no room of its own: a selection must not make the window grow. Nothing made from the device outlives the
/// drawing.
class ElementPicture : public QWidget {
    Q_OBJECT

public:
    /// An element of more nodes is not drawn: that would hold up the window.
    static constexpr std::size_t kMostNodes = 200'000;

    ElementPicture(GpuContext& context, models::SelectionModel& selection, models::LayerModel& layers,
                   QWidget* parent = nullptr);

    enum View { Flat, Solid, ViewCount };
    /// Null where nothing is or could be drawn.
    [[nodiscard]] const QImage& image(View view) const { return m_images[view]; }
    /// Why nothing is drawn; empty otherwise.
    [[nodiscard]] const QString& reason() const { return m_reason; }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return {0, 0}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void setStale();
    void draw(QSize pixels);
    [[nodiscard]] QString drawElement(const model::Document& document, model::ElementId element, QSize pixels);
    [[nodiscard]] QRect placeOf(int view) const;

    GpuContext& m_context;
    models::SelectionModel& m_selection;
    models::LayerModel& m_layers;
    std::array<QImage, ViewCount> m_images;
    QSize m_pixels;  ///< of each image
    QString m_reason;
    bool m_isStale = true;
};

}  // namespace ui
