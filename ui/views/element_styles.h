#pragma once

#include <QObject>

#include "ui/nets/net_styles.h"
#include "ui/views/board_views.h"
#include "ui/workspace/selection_model.h"

class QAction;
class QSlider;

namespace ui {

/// From what is pointed at and the looks of nets to what the views draw: lit, in a colour, or not at all. While
/// anything stands out (selected, highlighted, coloured) the rest may be darkened.
class ElementStyles : public QObject {
    Q_OBJECT

public:
    ElementStyles(BoardViews& views, SelectionModel& selection, NetStyles& nets, QObject* parent = nullptr);

    /// Darkens the rest while `isOn` is checked, by so many percent as `amount` says.
    void obey(QAction& isOn, QSlider& amount);

private:
    void setDimming(bool isOn);
    void setDim(float dim);
    void onNetsChanged();
    void onHighlightChanged();
    void apply();

    BoardViews& m_views;
    SelectionModel& m_selection;
    NetStyles& m_nets;
    ElementStateLists m_ofNets;  ///< colours and hiding alone; kept, because the hand changes the rest all the time
    bool m_isDimming = false;
    float m_dim = render::kDimRest;
};

}  // namespace ui
