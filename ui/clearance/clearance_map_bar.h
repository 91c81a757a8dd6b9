#pragma once

#include <QWidget>

#include "ui/common/lengths.h"

class QLabel;
class QSlider;

namespace ui {

class ActionSet;

/// Switches the distance map on, sets the end of its colours in round steps, and says what it shows.
class ClearanceMapBar : public QWidget {
    Q_OBJECT

public:
    explicit ClearanceMapBar(const ActionSet& actions, QWidget* parent = nullptr);

    void setUnit(LengthUnit unit);
    void showText(const QString& text);
    /// nm
    [[nodiscard]] double reach() const;
    [[nodiscard]] QSlider& slider() { return *m_slider; }
    [[nodiscard]] QString text() const;

signals:
    void reachChanged(double nm);

private:
    void showReach();

    QSlider* m_slider;
    QLabel* m_reach;
    QLabel* m_text;
    LengthUnit m_unit = LengthUnit::Millimetre;
};

}  // namespace ui
