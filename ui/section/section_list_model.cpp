#include "ui/section/section_list_model.h"

namespace ui {

SectionListModel::SectionListModel(QObject* parent) : TableModel({{tr("Saved sections"), {}, kEditable}}, parent) {}

Cell SectionListModel::cell(int row, int) const {
    return text(m_sections[static_cast<std::size_t>(row)].name);
}

bool SectionListModel::edit(int row, int, const QVariant& value) {
    const QString name = value.toString().trimmed();
    if (!name.isEmpty() && name != cell(row, Name).text.toString()) {
        emit renamed(row, name);
    }
    return !name.isEmpty();
}

}  // namespace ui
