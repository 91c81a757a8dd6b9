#pragma once

#include "ui/common/table_view.h"

namespace ui {

/// The arrow keys walk through all findings, as clicks on their rows would; a filter that takes the current row away
/// shows no other one.
inline void walkWithArrows(TableView& table) {
    QObject::connect(table.selectionModel(), &QItemSelectionModel::currentRowChanged, &table,
                     [&table](const QModelIndex& now) {
                         if (table.hasFocus()) {
                             table.choose(now);
                         }
                     });
}

}  // namespace ui
