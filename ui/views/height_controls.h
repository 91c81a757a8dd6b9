#pragma once

#include <QWidget>

#include "ui/workspace/actions.h"
#include "ui/workspace/workspace.h"

class QPainter;
class QSlider;

namespace ui {

class BoardViews;

/// How the 3D view draws heights otherwise than they are: two sliders for the tool bar, how far layers are spread apart
/// and how many times as thick they are drawn, together with the commands for the same (ActionId::Explode and the
/// scales of copper and dielectric, which multiply). A double click on a slider resets it, another board resets all.
/// What is selected stays where it is seen meanwhile, unless all of the board is shown. What is not as it is on the
/// board is written into a corner of the view, and of its pictures. Nothing of it is undone.
class HeightControls : public QWidget {
    Q_OBJECT

public:
    HeightControls(BoardViews& views, Workspace& workspace, const ActionSet& actions, QWidget* parent = nullptr);

    /// What the view is marked with; empty while heights are as they are.
    [[nodiscard]] QString text() const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] QSlider* addSlider(const char* name, int least, int most, const QString& tip);
    void onExplode(bool isOn);
    void onSpread(int value);
    void applyScale();
    void onBoard();
    void paint(QPainter& painter) const;

    BoardViews& m_views;
    const ActionSet& m_actions;
    QSlider* m_spread;
    QSlider* m_scale;
    bool m_isReadAnew = false;  ///< the board that comes: it is shown as it was
};

}  // namespace ui
