#include "ui/parts/parts_feature.h"

#include <QDockWidget>

#include "ui/common/table_text.h"

namespace ui {

PartsFeature::PartsFeature(FeatureContext& context)
    : QObject(&context.window),
      m_parts(this),
      m_pins(this),
      m_partsPanel(new PartsPanel(m_parts, context.parts)),
      m_pinsPanel(new PinsPanel(m_pins, context.parts, context.workspace.selection())) {
    context.addPanel({ActionId::ShowPartsDock, "parts", tr("Parts"), Qt::BottomDockWidgetArea}, *m_partsPanel);
    context.addPanel({ActionId::ShowPinsDock, "pins", tr("Pins"), Qt::LeftDockWidgetArea}, *m_pinsPanel);
    connect(qobject_cast<QDockWidget*>(m_pinsPanel->parentWidget()), &QDockWidget::visibilityChanged, m_pinsPanel,
            &PinsPanel::setSeen);
    connectFollowing(context);
    connectExports(context);
    connect(&context.workspace, &Workspace::boardOpened, this, [this](const LoadedBoard& board) {
        m_partsPanel->setBoard(board.document);
        m_pinsPanel->setBoard(board);
    });
    connect(&context.workspace, &Workspace::unitChanged, &m_parts, &PartModel::setUnit);
    connect(&context.workspace, &Workspace::unitChanged, &m_pins, &PinModel::setUnit);
}

void PartsFeature::connectFollowing(const FeatureContext& context) {
    context.on(ActionId::FollowInTables, this, [this](bool isOn) {
        m_partsPanel->table().setFollows(isOn);
        m_pinsPanel->table().setFollows(isOn);
    });
    context.on(ActionId::FollowFromTables, this, [this](bool isOn) {
        m_partsPanel->setShowsChosen(isOn);
        m_pinsPanel->setShowsChosen(isOn);
    });
}

void PartsFeature::connectExports(const FeatureContext& context) {
    const auto connectTo = [&](auto* panel, const QString& title, const QString& what) {
        connect(panel, &std::remove_pointer_t<decltype(panel)>::exportRequested, this, [&context, panel, title, what] {
            context.saveFile(title, what, {tr("Table (*.csv)")}, [panel](const QString& path) {
                return writeFile(path, tableCsv(*panel->table().model()).toUtf8());
            });
        });
    };
    connectTo(m_partsPanel, tr("Export the components"), tr("components"));
    connectTo(m_pinsPanel, tr("Export the pins"), tr("pins"));
}

}  // namespace ui
