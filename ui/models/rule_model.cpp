#include "ui/models/rule_model.h"

#include <QColor>
#include <cmath>
#include <utility>

#include "model/session/length_text.h"
#include "ui/models/clearance_model.h"

namespace ui::models {

namespace {

constexpr const char* kHeadings[RuleModel::ColumnCount] = {"Rule", "At least", "Result"};
/// Mid tones, readable on a light and on a dark ground; the word says the same.
constexpr QColor kBroken(0xd9, 0x4a, 0x3d);
constexpr QColor kKept(0x3a, 0x9a, 0x7a);
constexpr double kMostNm = 1e8;

/// None if the text is no length that a rule can ask for.
std::optional<model::Nm> lengthOf(const QString& text, LengthUnit unit) {
    bool isNumber = false;
    const double bare = text.trimmed().toDouble(&isNumber) * nmPer(unit);
    double nm = bare;
    if (!isNumber) {
        const base::Result<base::Nm> length = model::session::parseLength(text.trimmed().toStdString());
        nm = length ? static_cast<double>(*length) : -1.0;
    }
    return nm > 0.0 && nm <= kMostNm ? std::optional(static_cast<model::Nm>(std::lround(nm))) : std::nullopt;
}

}  // namespace

void RuleModel::setRules(model::RuleTable rules) {
    beginResetModel();
    m_rules = std::move(rules);
    m_counts.clear();
    endResetModel();
}

void RuleModel::setCounts(std::vector<std::size_t> counts) {
    m_counts = std::move(counts);
    if (rowCount() > 0) {
        emit dataChanged(index(0, Result), index(rowCount() - 1, Result));
    }
}

void RuleModel::setUnit(LengthUnit unit) {
    m_unit = unit;
    if (rowCount() > 0) {
        emit dataChanged(index(0, Least), index(rowCount() - 1, Least));
    }
}

int RuleModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rules.rules.size());
}

int RuleModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QString RuleModel::resultOf(std::size_t row) const {
    if (m_counts.empty()) {
        return QStringLiteral("not checked");
    }
    return m_counts[row] == 0   ? QStringLiteral("kept")
           : m_counts[row] == 1 ? QStringLiteral("broken in 1 place")
                                : QStringLiteral("broken in %L1 places").arg(m_counts[row]);
}

QVariant RuleModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) {
        return {};
    }
    const auto row = static_cast<std::size_t>(index.row());
    if (role == Qt::ForegroundRole && index.column() == Result && !m_counts.empty()) {
        return m_counts[row] == 0 ? kKept : kBroken;
    }
    if (role != Qt::DisplayRole && role != Qt::EditRole) {
        return {};
    }
    switch (index.column()) {
        case Title: return QString::fromStdString(model::titleOf(m_rules.rules[row]));
        case Least: return lengthText(m_rules.rules[row].least, m_unit);
        case Result: return resultOf(row);
        default: return {};
    }
}

QVariant RuleModel::headerData(int section, Qt::Orientation orientation, int role) const {
    const bool isHeading = orientation == Qt::Horizontal && role == Qt::DisplayRole && section >= 0;
    return isHeading && section < ColumnCount ? QVariant(QLatin1String(kHeadings[section])) : QVariant();
}

Qt::ItemFlags RuleModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    return index.column() == Least ? flags | Qt::ItemIsEditable : flags;
}

bool RuleModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!index.isValid() || index.column() != Least || role != Qt::EditRole) {
        return false;
    }
    const std::optional<model::Nm> least = lengthOf(value.toString(), m_unit);
    if (!least) {
        return false;
    }
    m_rules.rules[static_cast<std::size_t>(index.row())].least = *least;
    m_counts.clear();
    emit dataChanged(this->index(0, Least), this->index(rowCount() - 1, Result));
    return true;
}

}  // namespace ui::models
