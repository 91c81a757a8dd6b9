#include "ui/parts/parts_feature.h"

#include <QDockWidget>

#include "ui/common/table_text.h"

namespace ui {

PartsFeature::PartsFeature(FeatureContext& context)
    : QObject(&context.window),
      m_parts(this),
      m_pins(this),
      m_partsPanel(new PartsPanel(m_parts, context.parts, context.actions)),
      m_pinsPanel(new PinsPanel(m_pins, context.parts, context.workspace.selection(), context.actions)) {
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
        m_partsPanel->setFollows(isOn);
        m_pinsPanel->table().setFollows(isOn);
    });
    context.on(ActionId::FollowFromTables, this, [this](bool isOn) {
        m_partsPanel->setShowsChosen(isOn);
        m_pinsPanel->setShowsChosen(isOn);
    });
}

void PartsFeature::connectExports(const FeatureContext& context) {
    const auto save = [&context](const QString& title, const QString& what, const auto& csv) {
        context.saveFile(title, what, {tr("Table (*.csv)")}, [csv](const QString&) { return csv().toStdString(); });
    };
    const auto parts = [this] { return m_partsPanel->csv(); };
    const auto pins = [this] { return tableCsv(*m_pinsPanel->table().model()); };
    connect(m_partsPanel, &PartsPanel::exportRequested, this, [this, save, parts] {
        m_partsPanel->isGrouped() ? save(tr("Export the bill of materials"), tr("bill of materials"), parts)
                                  : save(tr("Export the components"), tr("components"), parts);
    });
    connect(m_pinsPanel, &PinsPanel::exportRequested, this,
            [save, pins] { save(tr("Export the pins"), tr("pins"), pins); });
}

}  // namespace ui
