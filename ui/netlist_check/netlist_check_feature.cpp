#include "ui/netlist_check/netlist_check_feature.h"

#include <QLabel>

#include "ui/common/panel_parts.h"
#include "ui/common/sorted_rows.h"
#include "ui/common/table_view.h"
#include "ui/findings/finding_table.h"

namespace ui {

NetlistCheckFeature::NetlistCheckFeature(FeatureContext& context)
    : QObject(&context.window),
      m_workspace(context.workspace),
      m_shown(context.workspace.selection(), context.views, this) {
    m_findings.setParent(this);
    QWidget* panel = makePanel(context.actions);
    context.addPanel({ActionId::ShowNetCheckDock, "netCheck", tr("Netlist check"), Qt::BottomDockWidgetArea}, *panel);
    context.on(ActionId::CheckNets, this, [this, panel] {
        FeatureContext::raise(*panel);
        start();
    });
    m_workspace.watch(m_checks.background(), [] { return tr("Nets"); });
    connect(&m_checks.background(), &Background::finished, this, &NetlistCheckFeature::deliver);
    connect(&m_workspace, &Workspace::boardRead, this, [this] { m_findings.setChecks(nullptr, {}); });
    connect(&m_workspace, &Workspace::boardOpened, &m_shown, &ShownFinding::end);
    connect(&m_workspace, &Workspace::unitChanged, &m_findings, &NetlistCheckModel::setUnit);
}

QWidget* NetlistCheckFeature::makePanel(const ActionSet& actions) {
    auto* table = new TableView(m_findings);
    QLineEdit* filter = filterEdit(table->makeSortable(), tr("Filter by net, layer or kind"));
    table->fitColumns(NetlistCheckModel::What);
    auto* summary = new QLabel(m_findings.summary());
    walkWithArrows(*table);
    connect(table, &TableView::rowChosen, this, [this](int row) { show(m_findings.finding(row)); });
    connect(&m_findings, &QAbstractItemModel::modelReset, summary,
            [this, summary] { summary->setText(m_findings.summary()); });
    auto* controls = buttonRow({&actions[ActionId::CheckNets], &actions[ActionId::InferNets]});
    controls->addWidget(filter, 1);
    controls->addWidget(summary);
    return panelOf(controls, table);
}

void NetlistCheckFeature::start() {
    m_workspace.cancelLoading();
    m_board = m_workspace.board()->document;
    m_checks.run([board = m_board](base::Progress& progress) { return model::checkAllNets(*board, progress); },
                 tr("Checking nets"), tr("There is not enough memory to check the nets"));
}

void NetlistCheckFeature::deliver() {
    if (const auto checks = m_checks.take()) {
        m_findings.setChecks(m_board, *checks);
        m_workspace.report(tr("Nets against copper: %1").arg(m_findings.summary()));
    } else {
        m_workspace.reportError(QString::fromStdString(checks.error().text));
    }
}

void NetlistCheckFeature::show(const NetlistCheckModel::Finding& finding) {
    const SelectionModel& selection = m_workspace.selection();
    const std::uint32_t row = selection.firstCopyOf(finding.step);
    const model::StepCopy& copy = selection.tree().copies[row];
    const model::LayerId layer =
        selection.tree().steps[finding.step]->layerOfCopy(m_findings.layerOf(finding), copy.isFlipped);
    std::vector<model::BoardElement> elements;
    std::vector<model::LayerId> layers{layer};
    for (const model::ElementId element : m_findings.elementsOf(finding)) {
        elements.push_back({row, element});
        layers.push_back(selection.layerOf({row, element}));
    }
    m_workspace.showLayer(layer);
    m_shown.show(std::move(elements), std::move(layers));
    m_workspace.showLocation(copy.placement.apply(m_findings.locationOf(finding)), layer);
}

}  // namespace ui
