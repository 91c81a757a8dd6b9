#include "ui/common/table_text.h"

#include <QColor>
#include <QCoreApplication>
#include <QStringList>
#include <set>

#include "model/text/formatting.h"
#include "ui/common/table_model.h"

namespace ui {

namespace {

QString rowText(const QAbstractItemModel& model, int row) {
    QStringList cells;
    for (int column = 0; column < model.columnCount(); ++column) {
        cells += cellText(model.index(row, column));
    }
    return cells.join('\t') + '\n';
}

QString headingText(const QAbstractItemModel& model) {
    QStringList cells;
    for (int column = 0; column < model.columnCount(); ++column) {
        cells += model.headerData(column, Qt::Horizontal).toString();
    }
    return cells.join('\t') + '\n';
}

}  // namespace

QString cellText(const QModelIndex& index) {
    const QVariant check = index.data(Qt::CheckStateRole);
    if (check.isValid()) {
        return check.toInt() == Qt::Checked ? QCoreApplication::translate("ui::Table", "yes")
                                            : QCoreApplication::translate("ui::Table", "no");
    }
    QVariant value = index.data(Qt::EditRole);
    if (!value.isValid()) {
        value = index.data(Qt::DisplayRole);
    }
    if (value.typeId() == QMetaType::QColor) {
        return value.value<QColor>().name();
    }
    // A tab or line feed inside a cell would tear the table apart.
    return value.toString().replace('\t', ' ').replace('\n', ' ');
}

QString tableText(const QAbstractItemModel& model) {
    QString text = headingText(model);
    for (int row = 0; row < model.rowCount(); ++row) {
        text += rowText(model, row);
    }
    return text;
}

QString tableCsv(const QAbstractItemModel& model) {
    const auto line = [&](const auto& textOf) {
        QStringList fields;
        for (int column = 0; column < model.columnCount(); ++column) {
            fields += QString::fromStdString(::model::csvField(textOf(column).toStdString()));
        }
        return fields.join(',') + '\n';
    };
    QString text = line(
        [&](int column) { return model.headerData(column, Qt::Horizontal, TableModel::kFileHeadingRole).toString(); });
    for (int row = 0; row < model.rowCount(); ++row) {
        text += line([&](int column) { return cellText(model.index(row, column)); });
    }
    return text;
}

QString rowsText(const QModelIndexList& cells) {
    std::set<int> rows;
    for (const QModelIndex& cell : cells) {
        rows.insert(cell.row());
    }
    QString text;
    for (const int row : rows) {
        text += rowText(*cells.first().model(), row);
    }
    return text;
}

}  // namespace ui
