#pragma once

#include "ui/views/board_views.h"
#include "ui/workspace/selection_model.h"

namespace ui {

/// A finding of a check while it is shown: what it is about is selected, and all layers but its own are faint, for what
/// lies on top would hide it. Until something else is selected.
class ShownFinding : public QObject {
    Q_OBJECT

public:
    ShownFinding(SelectionModel& selection, BoardViews& views, QObject* parent);

    /// In place of the one before, which ends without a word.
    void show(std::vector<model::BoardElement> elements, std::vector<model::LayerId> layers);
    void end();

signals:
    void ended();

private:
    SelectionModel& m_selection;
    BoardViews& m_views;
    bool m_isShown = false;
    std::vector<model::BoardElement> m_selected;  ///< of what is shown
};

}  // namespace ui
