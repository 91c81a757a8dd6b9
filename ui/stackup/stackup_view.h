#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "model/export/stackup_drawing.h"
#include "ui/common/display_units.h"
#include "ui/stackup/name_cut.h"

namespace ui {

/// The stackup from the side: layers to scale or with the copper scale raised, labels, and what every kind of hole
/// passes; zones side by side. A click on a layer or its label chooses its row, Up and Down the next one; a click on a
/// hole chooses its layer. With Alt a click requests the layer alone in the views.
class StackupView : public QWidget {
    Q_OBJECT

public:
    explicit StackupView(QWidget* parent = nullptr);

    /// A null document, or one without a stackup, empties the drawing.
    void setStackup(std::shared_ptr<const model::Document> document);
    /// `colours` has one entry per layer of the document. `alone` is the layer that is shown alone, if one is.
    void setStyles(std::vector<QColor> colours, model::LayerId alone);
    void setExaggerated(bool isOn);
    void setUnit(LengthUnit unit);
    /// The row that stands out; -1 for none.
    void setSelected(int row);

    [[nodiscard]] bool isExaggerated() const { return m_isExaggerated; }
    [[nodiscard]] const model::StackupDrawing& drawing() const { return m_drawing; }
    /// Where a row of the stackup, a zone of it and a kind of hole is drawn, in pixels.
    [[nodiscard]] QRectF bandRect(std::size_t row) const;
    [[nodiscard]] QRectF zoneRect(std::size_t row, std::size_t zone) const;
    [[nodiscard]] QRectF boreRect(std::size_t row) const;
    /// The line below the drawing that says what a kind of hole is. Where there is no room for all of it the layer's
    /// name is cut, or left out once hardly a letter of it would be seen; how many holes there are stays.
    [[nodiscard]] QString captionOf(std::size_t row, int room) const;
    [[nodiscard]] QRectF captionRect(std::size_t row) const;
    /// Where the name of a zone is, above it: its letter if the names of the zones have no room there, which as many
    /// lines below the drawing then explain.
    [[nodiscard]] QRectF zoneHeading(std::size_t zone) const;
    [[nodiscard]] std::size_t letteredZones() const { return m_letteredZones; }
    /// How wide the names of the layers may be.
    [[nodiscard]] double nameRoom() const;
    [[nodiscard]] QString zoneCaptionOf(std::size_t zone, int room) const;
    /// What is under the pointer there; empty for nothing.
    [[nodiscard]] QString tipAt(QPointF at) const;
    [[nodiscard]] QSize sizeHint() const override;

signals:
    void rowChosen(std::size_t row);
    void holesChosen(model::LayerId layer);
    /// Shows this layer alone, or ends that; comes before the row is chosen.
    void isolateRequested(model::LayerId layer);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    void arrange();
    void draw();
    [[nodiscard]] bool hasNarrowZone() const;
    [[nodiscard]] QString zoneName(std::size_t zone) const;
    [[nodiscard]] QRectF captionLine(std::size_t row) const;
    void step(int by);
    [[nodiscard]] double roomBeside() const;
    [[nodiscard]] double lineHeight() const { return fontMetrics().height() + 1.0; }
    [[nodiscard]] double thicknessLeft() const;
    [[nodiscard]] NameCut nameCut() const;
    /// The drawing has its share of the width, and less of it where names would be cut to a few letters.
    [[nodiscard]] double labelLeft() const;
    /// Between a layer and its label.
    [[nodiscard]] double leader() const;
    /// The layer at a position, a hole before the layers it passes; none beside them or where the job has no layer.
    [[nodiscard]] model::LayerId layerAt(QPointF at) const;
    [[nodiscard]] QString zonesOf(std::size_t row) const;
    [[nodiscard]] std::size_t boreAt(QPointF at) const;
    [[nodiscard]] std::size_t captionAt(QPointF at) const;
    [[nodiscard]] std::size_t rowAt(QPointF at) const;
    [[nodiscard]] QString boreText(std::size_t row) const;
    [[nodiscard]] QColor colourOf(const model::StackupRow& row) const;
    void paintZoneNames(QPainter& painter) const;
    void paintBand(QPainter& painter, std::size_t row) const;
    void paintLabel(QPainter& painter, std::size_t row, const NameCut& cut) const;
    void paintBore(QPainter& painter, std::size_t row) const;
    void paintCaption(QPainter& painter, std::size_t row) const;

    std::shared_ptr<const model::Document> m_document;
    std::vector<QColor> m_colours;
    model::StackupDrawing m_drawing;
    std::size_t m_boreCount = 0;
    std::size_t m_letteredZones = 0;
    double m_leastHeight = 0.0;  ///< of the layers, pixels
    model::LayerId m_isolated;
    int m_selected = -1;
    bool m_isExaggerated = true;
    LengthUnit m_unit = LengthUnit::Millimetre;
};

}  // namespace ui
