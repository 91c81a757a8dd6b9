#pragma once

#include <QObject>

#include "ui/nets/net_styles.h"
#include "ui/views/board_views.h"
#include "ui/workspace/selection_model.h"

class QAction;

namespace ui {

/// From what is pointed at and the styles of nets to what the views draw: highlighted, in a colour, or not at all.
/// While anything stands out (selected, highlighted, coloured) the rest may be darkened.
class ElementStyles : public QObject {
    Q_OBJECT

public:
    /// The rest is darkened while `dimOthers` is checked.
    ElementStyles(BoardViews& views, SelectionModel& selection, NetStyles& nets, const QAction& dimOthers,
                  QObject* parent = nullptr);

private:
    void onDimChanged();
    void onNetsChanged();
    void onHighlightChanged();
    void leaveOutlinesAlone(std::vector<std::vector<model::ElementId>>& highlighted) const;
    void apply();
    void addColoursOfHighlightedNets(ElementStateLists& states) const;
    void addColourOfNearby(ElementStateLists& states) const;

    BoardViews& m_views;
    SelectionModel& m_selection;
    NetStyles& m_nets;
    ElementStateLists m_ofNets;  ///< colours and hiding alone; kept, because the pointer changes the rest all the time
    const QAction& m_dimOthers;
};

}  // namespace ui
