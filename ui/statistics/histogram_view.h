#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "model/statistics/histogram.h"
#include "ui/common/display_units.h"

namespace ui {

/// A histogram of the board with all copies of steps on it as bars. A click on a bar selects its elements, Left and
/// Right for those of the next one. Heights go by the square root of the counts, which are over them.
class HistogramView : public QWidget {
    Q_OBJECT

public:
    explicit HistogramView(QWidget* parent = nullptr);

    /// A null document empties the plot.
    void setDocument(std::shared_ptr<const model::Document> document);
    void setMeasure(model::Measure measure);
    void setUnit(LengthUnit unit);
    /// Measured when it is first asked for: not while the plot is out of sight.
    [[nodiscard]] const model::Histogram& histogram() const;
    /// The room of a bar from the top of the plot to its foot, pixels.
    [[nodiscard]] QRectF columnRect(std::size_t bar) const;
    /// What stands under a bar: its lengths; where bars are too narrow for that its least one, and under some bars
    /// alone where even those have no room side by side. Empty for none, and never cut: a part of a number is another.
    [[nodiscard]] QString labelUnder(std::size_t bar) const;
    /// Where the number of elements stands over a bar: turned by a quarter where the bars are too narrow for one of
    /// them, and empty where they are too narrow for that, too. A number is never cut, and the tip of the bar says it
    /// anyway.
    [[nodiscard]] QRectF countRect(std::size_t bar) const;

signals:
    void chosen(const std::vector<model::BoardElement>& elements);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    enum class Counts { Level, Turned, None };

    void invalidate();
    void choose(std::size_t bar);
    [[nodiscard]] std::size_t barAt(QPointF at) const;
    [[nodiscard]] QString lengthsText(const model::HistogramBar& bar) const;
    /// Without the unit.
    [[nodiscard]] QString numbersText(const QString& lengths) const;
    [[nodiscard]] QString countText(std::size_t bar) const;
    [[nodiscard]] double widestCount() const;
    /// How the numbers over the bars are written, all alike.
    [[nodiscard]] Counts counts() const;
    [[nodiscard]] double topOf(std::size_t bar) const;
    void paintBar(QPainter& painter, std::size_t bar) const;
    void paintCount(QPainter& painter, std::size_t bar) const;
    void paintLabel(QPainter& painter, std::size_t bar) const;

    std::shared_ptr<const model::Document> m_document;
    model::Measure m_measure = model::Measure::TrackWidth;
    LengthUnit m_unit = LengthUnit::Millimetre;
    mutable std::optional<model::Histogram> m_histogram;
    std::optional<std::size_t> m_current;  ///< the bar chosen last
};

}  // namespace ui
