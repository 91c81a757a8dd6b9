#include "ui/common/table_model.h"

#include <QColor>
#include <QLocale>

namespace ui {

namespace {

QVariant valid(const QString& text) {
    return text.isEmpty() ? QVariant() : QVariant(text);
}

QVariant alignmentOf(int traits) {
    return QVariant::fromValue(
        Qt::Alignment(Qt::AlignVCenter | ((traits & kNumber) != 0 ? Qt::AlignRight : Qt::AlignLeft)));
}

bool isOfCell(int role) {
    switch (role) {
        case Qt::DisplayRole:
        case Qt::EditRole:
        case TableModel::kSortRole:
        case Qt::CheckStateRole:
        case Qt::ForegroundRole:
        case Qt::DecorationRole:
        case Qt::FontRole:
        case TableModel::kChoicesRole:
        case Qt::AccessibleTextRole: return true;
        default: return false;
    }
}

QVariant partOf(const Cell& at, int role) {
    const QVariant& value = at.value.isValid() ? at.value : at.text;
    switch (role) {
        case Qt::DisplayRole: return at.text;
        case Qt::EditRole: return value;
        case TableModel::kSortRole: return at.order.isValid() ? at.order : value;
        case Qt::CheckStateRole:
            return at.isChecked ? QVariant(*at.isChecked ? Qt::Checked : Qt::Unchecked) : QVariant();
        case Qt::ForegroundRole: return at.colour;
        case Qt::DecorationRole: return at.decoration;
        case Qt::FontRole: return at.font;
        case TableModel::kChoicesRole: return at.choices;
        case Qt::AccessibleTextRole:
            return value.userType() == QMetaType::QColor ? value.value<QColor>().name() : QVariant();
        default: return {};
    }
}

}  // namespace

TableModel::TableModel(std::vector<Column> columns, QObject* parent)
    : QAbstractTableModel(parent), m_columns(std::move(columns)) {}

void TableModel::setUnit(LengthUnit unit) {
    m_unit = unit;
    announceChange();
}

QString TableModel::searchText(int row) const {
    QStringList texts;
    for (int column = 0; column < columnCount(); ++column) {
        texts += cell(row, column).text.toString();
    }
    return texts.join('\t');
}

int TableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : rows();
}

int TableModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_columns.size());
}

QVariant TableModel::data(const QModelIndex& index, int role) const {
    QModelRoleData one(role);
    multiData(index, one);
    return one.data();
}

void TableModel::multiData(const QModelIndex& index, QModelRoleDataSpan roles) const {
    std::optional<Cell> at;  // made once for all roles, and not for those that need none
    for (QModelRoleData& role : roles) {
        role.clearData();
        if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) {
            continue;
        }
        const int traits = m_columns[static_cast<std::size_t>(index.column())].traits;
        if (role.role() == Qt::TextAlignmentRole) {
            role.setData(alignmentOf(traits));
        } else if (role.role() == kTraitsRole) {
            role.setData(traits);
        } else if (role.role() == Qt::ToolTipRole) {
            role.setData(tipOf(index));
        } else if (const QVariant own = role.role() == kSortRole ? order(index.row(), index.column()) : QVariant();
                   own.isValid()) {
            role.setData(own);
        } else if (isOfCell(role.role())) {
            at = at ? std::move(at) : cell(index.row(), index.column());
            role.setData(partOf(*at, role.role()));
        }
    }
}

QVariant TableModel::tipOf(const QModelIndex& index) const {
    const QString own = tip(index.row(), index.column());
    if (!own.isEmpty()) {
        return own;
    }
    const Cell at = cell(index.row(), index.column());
    return valid(at.tip.isEmpty() && at.length ? fixedLengthInBoth(*at.length, m_unit) : at.tip);
}

QVariant TableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= columnCount()) {
        return {};
    }
    const Column& column = m_columns[static_cast<std::size_t>(section)];
    switch (role) {
        case Qt::DisplayRole: return column.heading;
        case kFileHeadingRole:
            return (column.traits & kLength) != 0
                       ? QStringLiteral("%1 (%2)").arg(column.heading, QLatin1String(unitName(m_unit)))
                       : column.heading;
        case Qt::ToolTipRole: return valid(column.tip);
        case Qt::TextAlignmentRole: return alignmentOf(column.traits);
        default: return {};
    }
}

Qt::ItemFlags TableModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) {
        return Qt::NoItemFlags;
    }
    const int traits = m_columns[static_cast<std::size_t>(index.column())].traits;
    Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
    flags.setFlag(Qt::ItemIsEditable, (traits & kEditable) != 0);
    flags.setFlag(Qt::ItemIsUserCheckable, (traits & kCheck) != 0);
    return flags;
}

bool TableModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return false;
    }
    if (role == Qt::CheckStateRole && flags(index).testFlag(Qt::ItemIsUserCheckable)) {
        return check(index.row(), index.column(), value.toInt() == Qt::Checked);
    }
    return role == Qt::EditRole && flags(index).testFlag(Qt::ItemIsEditable) &&
           edit(index.row(), index.column(), value);
}

void TableModel::announceChange() {
    if (rowCount() > 0) {
        emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    }
}

Cell TableModel::area(double nm2) const {
    return {areaText(nm2, m_unit), nm2 / (base::kNmPerMm * base::kNmPerMm)};
}

Cell TableModel::count(qulonglong number) {
    return {QLocale().toString(number), number};
}

QFont TableModel::boldFont() {
    QFont font;
    font.setBold(true);
    return font;
}

}  // namespace ui
