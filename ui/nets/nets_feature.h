#pragma once

#include "ui/nets/highlight_history.h"
#include "ui/nets/net_style_editing.h"
#include "ui/nets/nets_panel.h"
#include "ui/workspace/feature.h"
#include "ui/workspace/hint.h"

namespace ui {

/// The nets panel and the commands of the menu Nets. N chooses nets, the others are for the nets of the selection
/// (ui/workspace/selection_model.h), or while nothing is chosen for the net under the pointer.
class NetsFeature : public QObject {
    Q_OBJECT

public:
    explicit NetsFeature(FeatureContext& context);

private:
    void connectCommands(FeatureContext& context);
    void connectPanel(FeatureContext& context);
    void connectDimming(FeatureContext& context);
    /// Highlights the nets of what is pointed at or selected and no others, or ends that.
    void highlightNets();
    /// Adds them to those that are highlighted, or takes them away.
    void addNets();
    /// Of the element pointed at, or else of the selection; says so where there are none.
    [[nodiscard]] std::vector<model::BoardNet> netsToChoose();
    /// What commands work on; says so where there are none.
    [[nodiscard]] std::vector<model::BoardNet> targets();
    void colour();
    void hide();
    void isolate();

    Workspace& m_workspace;
    SelectionModel& m_selection;
    Hint m_hint;  ///< what a command lacks
    NetStyles& m_styles;
    NetStyleEditing m_editing;
    HighlightHistory m_highlights;
    NetModel m_nets;
    NetsPanel* m_panel;
    bool m_isReadAnew = false;  ///< the board that comes
};

}  // namespace ui
