#pragma once

#include <QAbstractItemModel>
#include <QString>

/// Tables as text, for the clipboard and for tests.
namespace ui {

/// The cell as plain text: its edit value where it has one (numbers without grouping), else what it shows; a colour as
/// #rrggbb, a check mark as yes or no.
[[nodiscard]] QString cellText(const QModelIndex& index);

/// All rows with a heading line; cells separated by tabs, lines ended by a line feed: spreadsheets take it as a table.
[[nodiscard]] QString tableText(const QAbstractItemModel& model);

/// The same as a file: separated by commas, cells in quotes where they need them, the unit behind headings of lengths.
/// For a TableModel, or its SortedRows.
[[nodiscard]] QString tableCsv(const QAbstractItemModel& model);

/// The rows that hold any of `cells`, in the order of the model and with all their columns; no heading.
[[nodiscard]] QString rowsText(const QModelIndexList& cells);

}  // namespace ui
