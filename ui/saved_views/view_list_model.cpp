#include "ui/saved_views/view_list_model.h"

#include "ui/common/texts.h"

namespace ui {

namespace {

/// "net CLK", "3 nets"
QString netsText(const std::vector<model::session::NetName>& nets) {
    return nets.size() == 1 ? ViewListModel::tr("net %1").arg(QString::fromStdString(nets.front().name))
                            : ViewListModel::tr("%L1 nets").arg(nets.size());
}

QString elementsText(std::size_t count) {
    return count == 1 ? ViewListModel::tr("1 element") : ViewListModel::tr("%L1 elements").arg(count);
}

/// What it marks, and which layers it shows: "net CLK, 3 elements; TOP, DRILL".
QString contentsOf(const model::session::SavedView& view) {
    QStringList marked;
    if (!view.nets.empty()) {
        marked += netsText(view.nets);
    }
    if (!view.elements.empty()) {
        marked += elementsText(view.elements.size());
    }
    const QString layers = textsOf(view.layers).join(QStringLiteral(", "));
    return marked.empty() ? layers : ViewListModel::tr("%1; %2").arg(marked.join(QStringLiteral(", ")), layers);
}

}  // namespace

ViewListModel::ViewListModel(QObject* parent)
    : TableModel({{tr("Name"), {}, kEditable}, {tr("Contents"), {}}}, parent) {}

Cell ViewListModel::cell(int row, int column) const {
    return column == Name ? text(m_views[static_cast<std::size_t>(row)].name) : Cell{tip(row, column)};
}

QString ViewListModel::tip(int row, int) const {
    const model::session::SavedView& view = m_views[static_cast<std::size_t>(row)];
    return view.selection
               ? tr("%L1 nets, %L2 elements").arg(view.selection->nets.size()).arg(view.selection->elements.size())
               : contentsOf(view);
}

bool ViewListModel::edit(int row, int, const QVariant& value) {
    const QString name = value.toString().trimmed();
    if (!name.isEmpty() && name != cell(row, Name).text.toString()) {
        emit renamed(row, name);
    }
    return !name.isEmpty();
}

}  // namespace ui
