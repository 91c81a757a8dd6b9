#include "ui/clearance/clearance_model.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace ui {

namespace {

struct ColumnText {
    const char* heading;
    const char* tip;
};

constexpr ColumnText kColumns[ClearanceModel::ColumnCount] = {
    {"Gap", "How far apart; 0: they touch or overlap"},
    {"Rule", "The rule that is broken there"},
    {"Layer", "Where it is"},
    {"First", "The net of the one side"},
    {"Second", "The net of the other side"},
    {"X", "Where it is, in the coordinates of the step"},
    {"Y", "Where it is, in the coordinates of the step"},
    {"Step", "The step it is on; seen in all its copies"},
};

}  // namespace

void ClearanceModel::setSpacings(std::shared_ptr<const model::Document> board, std::vector<StepGaps> gaps,
                                 model::RuleTable rules) {
    beginResetModel();
    m_board = std::move(board);
    m_tree = m_board ? model::unfoldCopies(*m_board) : model::StepTree{};
    m_rules = std::move(rules);
    m_locations.clear();
    for (const StepGaps& step : gaps) {
        const auto at = std::ranges::find_if(m_tree.steps, [&](const auto& known) { return &*known == step.step; });
        const auto row = static_cast<std::uint32_t>(at - m_tree.steps.begin());
        for (const model::RuleFinding& found : step.locations) {
            m_locations.push_back({row, found});
        }
    }
    std::ranges::stable_sort(m_locations, {},
                             [](const Location& p) { return std::tuple(p.found.rule, p.found.spacing.distance); });
    endResetModel();
}

void ClearanceModel::setUnit(LengthUnit unit) {
    m_unit = unit;
    if (!m_locations.empty()) {
        emit dataChanged(index(0, Spacing), index(rowCount() - 1, Y));
    }
}

QString ClearanceModel::summary() const {
    if (!m_board) {
        return QStringLiteral("Nothing was measured yet");
    }
    if (m_locations.empty()) {
        return m_rules.rules.empty() ? QStringLiteral("Nothing found") : QStringLiteral("All rules are kept");
    }
    const auto narrowest =
        std::ranges::min_element(m_locations, {}, [](const Location& p) { return p.found.spacing.distance; });
    return QStringLiteral("%L1 %2, the narrowest %3")
        .arg(m_locations.size())
        .arg(m_locations.size() == 1 ? QStringLiteral("place") : QStringLiteral("places"),
             lengthText(narrowest->found.spacing.distance, m_unit));
}

int ClearanceModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_locations.size());
}

int ClearanceModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QString ClearanceModel::text(const Location& location, int column) const {
    const model::Document& step = *m_tree.steps[location.step];
    const model::RuleFinding& found = location.found;
    switch (column) {
        case Spacing: return lengthText(found.spacing.distance, m_unit);
        case Rule:
            return m_rules.rules.empty() ? QString()
                                         : QString::fromStdString(model::titleOf(m_rules.rules[found.rule]));
        case Layer: return QString::fromStdString(step.layer(found.layer).name);
        case First: return QString::fromStdString(model::sideOf(step, found.a));
        case Second: return QString::fromStdString(model::sideOf(step, found.b));
        case X: return lengthText(found.spacing.from.x, m_unit);
        case Y: return lengthText(found.spacing.from.y, m_unit);
        case Step: return QString::fromStdString(step.job.step);
        default: return {};
    }
}

double ClearanceModel::number(const Location& location, int column) const {
    const model::Spacing& gap = location.found.spacing;
    return column == Spacing ? gap.distance : column == X ? gap.from.x : gap.from.y;
}

QVariant ClearanceModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) {
        return {};
    }
    const Location& at = location(index.row());
    const bool isNumber = index.column() == Spacing || index.column() == X || index.column() == Y;
    if (role == Qt::EditRole && isNumber) {  // for sorting
        return number(at, index.column());
    }
    if (role == Qt::TextAlignmentRole && isNumber) {
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    }
    return role == Qt::DisplayRole || role == Qt::EditRole ? QVariant(text(at, index.column())) : QVariant();
}

QVariant ClearanceModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount) {
        return {};
    }
    switch (role) {
        case Qt::DisplayRole: return QLatin1String(kColumns[section].heading);
        case Qt::ToolTipRole: return QString::fromUtf8(kColumns[section].tip);
        default: return {};
    }
}

}  // namespace ui
