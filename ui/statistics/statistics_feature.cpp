#include "ui/statistics/statistics_feature.h"

#include <QComboBox>
#include <QSplitter>
#include <QTabWidget>

#include "ui/common/elided_label.h"
#include "ui/common/panel_parts.h"
#include "ui/common/table_view.h"
#include "ui/statistics/drill_model.h"
#include "ui/statistics/histogram_view.h"
#include "ui/statistics/statistics_model.h"
#include "ui/statistics/summary_text.h"

namespace ui {

namespace {

QWidget* plotWithChoice(HistogramView& plot) {
    auto* measure = new QComboBox;
    measure->addItems({StatisticsModel::tr("Track widths"), StatisticsModel::tr("Hole diameters"),
                       StatisticsModel::tr("Annular rings (round pads)")});  // in the order of model::Measure
    QObject::connect(measure, &QComboBox::currentIndexChanged, &plot,
                     [&plot](int index) { plot.setMeasure(static_cast<model::Measure>(index)); });
    auto* half = new QWidget;
    auto* column = columnIn(*half, 0);
    column->addWidget(measure);
    column->addWidget(&plot, 1);
    return half;
}

QWidget* panelOf(QLabel* summary, TableView* elements, TableView* drills, HistogramView& plot) {
    for (TableView* table : {elements, drills}) {
        table->makeSortable();
        table->fitColumns();
    }
    drills->setToolTip(StatisticsModel::tr("Click rows to select their holes"));
    auto* tabs = new QTabWidget;
    tabs->setDocumentMode(true);
    tabs->addTab(elements, StatisticsModel::tr("Elements"));
    tabs->addTab(drills, StatisticsModel::tr("Drills"));
    auto* halves = new QSplitter;
    halves->addWidget(tabs);
    halves->addWidget(plotWithChoice(plot));
    auto* panel = new QWidget;
    auto* column = columnIn(*panel);
    column->addWidget(summary);
    column->addWidget(halves, 1);
    return panel;
}

/// The board in a line that follows the unit and its thicknesses; in a narrow panel in several.
QLabel* makeSummary(Workspace& workspace, const DrillModel& drills) {
    constexpr int kMostLines = 3;
    auto* summary = new ElidedLabel;
    summary->setObjectName(QStringLiteral("boardSummary"));
    summary->setMostLines(kMostLines);
    const auto show = [&workspace, &drills, summary] {
        if (const LoadedBoard* board = workspace.board()) {
            summary->setText(summaryText(model::summaryOf(*board->document, drills.table()), workspace.unit()));
        }
    };
    QObject::connect(&drills, &QAbstractItemModel::modelReset, summary, show);
    QObject::connect(&workspace, &Workspace::restacked, summary, show);
    QObject::connect(&workspace, &Workspace::unitChanged, summary, show);
    return summary;
}

}  // namespace

void addStatistics(FeatureContext& context) {
    Workspace& workspace = context.workspace;
    auto* statistics = new StatisticsModel(&context.window);
    auto* drills = new DrillModel(&context.window);
    auto* drillTable = new TableView(*drills);
    auto* plot = new HistogramView;
    QWidget* panel = panelOf(makeSummary(workspace, *drills), new TableView(*statistics), drillTable, *plot);
    context.addPanel(
        {ActionId::ShowStatisticsDock, "statistics", StatisticsModel::tr("Statistics"), Qt::BottomDockWidgetArea},
        *panel);
    const auto setBoard = [statistics, drills, plot](const LoadedBoard& board) {
        statistics->setDocument(board.document, board.copperNm2);
        drills->setDocument(board.document);
        plot->setDocument(board.document);
    };
    const auto select = [&workspace](const std::vector<model::BoardElement>& elements) {
        workspace.selection().select(elements);
    };
    QObject::connect(&workspace, &Workspace::boardRead, panel, setBoard);
    QObject::connect(&workspace, &Workspace::unitChanged, plot, &HistogramView::setUnit);
    QObject::connect(&workspace, &Workspace::unitChanged, statistics, &StatisticsModel::setUnit);
    QObject::connect(&workspace, &Workspace::unitChanged, drills, &DrillModel::setUnit);
    QObject::connect(plot, &HistogramView::chosen, &workspace, select);
    QObject::connect(drillTable, &TableView::rowChosen, &workspace, [&workspace, drills, drillTable] {
        workspace.selection().select(drills->holesIn(drillTable->selectedRows()));
    });
}

}  // namespace ui
