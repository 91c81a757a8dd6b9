#include "ui/comparison/comparison_feature.h"

#include <QDockWidget>
#include <algorithm>

#include "model/agreement/layer_agreement.h"
#include "ui/common/paths.h"
#include "ui/views/probing.h"

namespace ui {

namespace {

/// How much of the board is shown around a place, as a part of its size.
constexpr double kAround = 0.7;

/// Of a difference that has a location.
DifferenceMarks::Place placeOf(const model::Comparison& comparison, const model::Difference& difference) {
    const model::Point at = *difference.location;
    return {difference.box.isEmpty() ? model::Box{at, at} : difference.box, comparison.pair.a};
}

base::Result<ComparedBoards> compare(std::shared_ptr<const model::Document> board, const model::OpenRequest& request,
                                     base::Progress& progress) {
    ASSIGN_OR_RETURN(const model::OpenedBoard other, model::openBoard(request, progress));
    model::AgreementRequest wanted;
    wanted.most = ComparisonModel::kMost;
    ASSIGN_OR_RETURN(model::Agreement agreement, model::compareBoards(*board, *other.document, wanted, progress));
    return ComparedBoards{std::move(board), other.document, std::move(agreement), displayName(request.path)};
}

}  // namespace

ComparisonFeature::ComparisonFeature(FeatureContext& context)
    : QObject(&context.window),
      m_workspace(context.workspace),
      m_probing(context.probing),
      m_shown(context.workspace.selection(), context.views, this),
      m_marks(context.views, context.workspace, this),
      m_panel(new ComparisonPanel(m_differences, context.actions)) {
    m_differences.setParent(this);
    context.addPanel({ActionId::ShowComparisonDock, "comparison", tr("Comparison"), Qt::BottomDockWidgetArea},
                     *m_panel);
    connect(qobject_cast<QDockWidget*>(m_panel->parentWidget()), &QDockWidget::visibilityChanged, &m_marks,
            &DifferenceMarks::setShown);
    connect(m_panel, &ComparisonPanel::rowChosen, this, &ComparisonFeature::show);
    connect(m_panel, &ComparisonPanel::listed, this, &ComparisonFeature::frameListed);
    connectCommands(context);
    connectWork();
}

void ComparisonFeature::connectCommands(FeatureContext& context) {
    using enum FeatureContext::BoardPath;
    const auto choose = [this, &context](const QString& title, FeatureContext::BoardPath kind) {
        context.openBoardPath(title, kind, [this](const QString& path) {
            FeatureContext::raise(*m_panel);
            start(path);
        });
    };
    context.on(ActionId::CompareFile, this, [choose] { choose(tr("Compare with a board"), File); });
    context.on(ActionId::CompareFolder, this, [choose] { choose(tr("Compare with a board folder"), Folder); });
    context.escapes.emplace(EscapeRank::Mark, [this] { return endShown(); });
}

void ComparisonFeature::connectWork() {
    m_workspace.watch(m_compared.background(), [] { return tr("Comparison"); });
    connect(&m_compared.background(), &Background::finished, this, &ComparisonFeature::deliver);
    connect(&m_only.background(), &Background::finished, this, [this] {
        const auto only = m_only.take();
        if (!only || !m_marks.setOnly(*only)) {
            m_workspace.report(tr("Too much differs in this place to be painted: it is framed alone"));
        }
    });
    connect(&m_workspace, &Workspace::boardRead, this, &ComparisonFeature::clear);
    connect(&m_workspace, &Workspace::unitChanged, &m_differences, &ComparisonModel::setUnit);
}

void ComparisonFeature::start(const QString& path) {
    m_workspace.cancelLoading();
    model::OpenRequest request;
    request.path = toPath(path);
    request.noSession = true;
    m_compared.run([board = m_workspace.board()->document,
                    request](base::Progress& progress) { return compare(board, request, progress); },
                   tr("Comparing"), tr("There is not enough memory to compare the boards"));
}

void ComparisonFeature::deliver() {
    base::Result<ComparedBoards> compared = m_compared.take();
    if (!compared) {
        m_workspace.reportError(QString::fromStdString(compared.error().text));
        return;
    }
    clear();
    m_differences.setBoards(std::move(*compared));
    m_workspace.report(m_differences.summary());
}

void ComparisonFeature::clear() {
    endShown();
    m_differences.setBoards(std::nullopt);
    m_marks.setPlaces({});
}

void ComparisonFeature::frameListed() {
    std::vector<DifferenceMarks::Place> places;
    for (const int row : m_panel->listedRows(kMostFrames)) {
        const model::Difference* const difference = m_differences.difference(row);
        if (difference != nullptr && difference->location) {
            places.push_back(placeOf(m_differences.comparison(row), *difference));
        }
    }
    m_marks.setPlaces(std::move(places));
}

void ComparisonFeature::show(int row) {
    const model::Comparison& comparison = m_differences.comparison(row);
    const model::Difference* const difference = m_differences.difference(row);
    endShown();
    showLayer(comparison.pair.a);
    if (difference == nullptr || !difference->location) {
        return;
    }
    const DifferenceMarks::Place place = placeOf(comparison, *difference);
    const model::Box& box = place.box;
    const double around = kAround * base::toMm(static_cast<double>(std::max(box.width(), box.height())));
    m_marks.choose(place);
    m_probing.showPosition(base::toDouble(box.middle()), place.layer,
                           std::max(static_cast<float>(around), Probing::kAroundMm));
    if (comparison.region) {
        showOnly(comparison, box);
    }
}

void ComparisonFeature::showLayer(model::LayerId layer) {
    if (layer.isValid()) {
        m_workspace.showLayer(layer);
        m_shown.show({}, {layer});
    }
}

void ComparisonFeature::showOnly(const model::Comparison& comparison, const model::Box& place) {
    const ComparedBoards& boards = *m_differences.boards();
    const model::Nm pixel = model::AgreementRequest().tolerance;  // what differs was counted without its edge
    m_only.run(
        [a = boards.a, b = boards.b, shift = boards.agreement.shift, pair = comparison.pair,
         box = place.grownBy(2 * pixel)](base::Progress&) -> base::Result<std::array<model::PolygonSet, 2>> {
            return model::onlyDrawn(*a, *b, shift, pair, box);
        },
        tr("Comparing"), {});
}

bool ComparisonFeature::endShown() {
    m_only.cancel();
    m_shown.end();
    return m_marks.clearChosen();
}

}  // namespace ui
