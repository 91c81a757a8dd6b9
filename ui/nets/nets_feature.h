#pragma once

#include "ui/nets/net_style_editing.h"
#include "ui/nets/nets_panel.h"
#include "ui/workspace/feature.h"

namespace ui {

/// The nets panel and the commands of the menu Nets. They are for the highlighted nets, or else for the net of what is
/// under the pointer, or else of what is selected.
class NetsFeature : public QObject {
    Q_OBJECT

public:
    explicit NetsFeature(FeatureContext& context);

private:
    void connectCommands(FeatureContext& context);
    void connectPanel(FeatureContext& context);
    void connectDimming(QAction& dimOthers);
    /// Highlights the net of what is pointed at or selected, or ends that.
    void highlightNet();
    [[nodiscard]] std::optional<model::BoardNet> netUnderPointer() const;
    [[nodiscard]] std::vector<model::BoardNet> targets();
    void colour();
    void hide();

    Workspace& m_workspace;
    SelectionModel& m_selection;
    NetStyles& m_styles;
    NetStyleEditing m_editing;
    NetModel m_nets;
    NetsPanel* m_panel;
};

}  // namespace ui
