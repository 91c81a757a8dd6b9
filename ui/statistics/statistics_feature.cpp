#include "ui/statistics/statistics_feature.h"

#include "ui/statistics/drill_model.h"
#include "ui/statistics/histogram_view.h"
#include "ui/statistics/statistics_model.h"
#include "ui/statistics/statistics_panel.h"

namespace ui {

void addStatistics(FeatureContext& context) {
    Workspace& workspace = context.workspace;
    auto* statistics = new StatisticsModel(&context.window);
    auto* drills = new DrillModel(&context.window);
    auto* panel = new StatisticsPanel(*statistics, *drills);
    HistogramView& plot = panel->plot();
    context.addPanel({ActionId::ShowStatisticsDock, "statistics", StatisticsPanel::tr("Statistics"),
                      Qt::BottomDockWidgetArea, "messages", 0},
                     *panel);
    const auto setBoard = [statistics, drills, &plot](const LoadedBoard& board) {
        statistics->setDocument(board.document, board.copperNm2);
        drills->setDocument(board.document);
        plot.setDocument(board.document);
    };
    const auto select = [&workspace](const std::vector<model::ElementId>& elements) {
        std::vector<model::BoardElement> selected;
        for (const model::ElementId element : elements) {
            selected.push_back({0, element});
        }
        workspace.selection().select(selected);
    };
    QObject::connect(&workspace, &Workspace::boardRead, panel, setBoard);
    QObject::connect(&workspace, &Workspace::unitChanged, &plot, &HistogramView::setUnit);
    QObject::connect(&workspace, &Workspace::unitChanged, statistics, &StatisticsModel::setUnit);
    QObject::connect(&workspace, &Workspace::unitChanged, drills, &DrillModel::setUnit);
    QObject::connect(&plot, &HistogramView::chosen, &workspace, select);
    QObject::connect(panel, &StatisticsPanel::holesChosen, &workspace, select);
}

}  // namespace ui
