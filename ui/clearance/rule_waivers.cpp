#include "ui/clearance/rule_waivers.h"

#include <QDate>

#include "model/session/session.h"
#include "ui/clearance/waive_dialog.h"
#include "ui/common/paths.h"
#include "ui/workspace/feature.h"

namespace ui {

RuleWaivers::RuleWaivers(Workspace& workspace, Settings& settings, QObject* parent)
    : QObject(parent),
      m_workspace(workspace),
      m_settings(settings),
      m_part(
          workspace, tr("The waivers"),
          [this](const List& list) {
              m_list = list;
              emit changed();
          },
          model::session::saveWaivers) {}

void RuleWaivers::open(const LoadedBoard& board) {
    if (m_part.open()) {
        m_list = board.session.waivers;
        emit changed();
    }
}

void RuleWaivers::request(const model::Waiver& waiver, QWidget& parent) {
    auto* dialog = new WaiveDialog(QString::fromStdString(model::placeOf(waiver)), m_settings.author(), &parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, waiver] {
        model::Waiver said = waiver;
        said.reason = dialog->reason().toStdString();
        said.author = dialog->author().toStdString();
        said.date = QDate::currentDate().toString(Qt::ISODate).toStdString();
        m_settings.setAuthor(dialog->author());
        add(said);
    });
    dialog->open();
}

void RuleWaivers::add(const model::Waiver& waiver) {
    List after = m_list;
    std::erase_if(after, [&](const model::Waiver& old) { return model::areOfOnePlace(old, waiver); });  // it is worse
    after.push_back(waiver);
    m_part.edit(tr("waiving a location"), m_list, std::move(after));
}

void RuleWaivers::withdraw(const std::vector<std::size_t>& rows) {
    List after;
    for (std::size_t row = 0; row < m_list.size(); ++row) {
        if (std::ranges::find(rows, row) == rows.end()) {
            after.push_back(m_list[row]);
        }
    }
    m_part.edit(tr("withdrawing a waiver"), m_list, std::move(after));
}

base::Status RuleWaivers::read(const QString& path) {
    ASSIGN_OR_RETURN(List list, model::readWaivers(toPath(path)));
    m_part.edit(tr("the waivers"), m_list, std::move(list));
    return base::Done{};
}

base::Status RuleWaivers::write(const QString& path) const {
    return writeFile(path, QByteArray::fromStdString(model::toJson(m_list)));
}

}  // namespace ui
