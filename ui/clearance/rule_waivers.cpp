#include "ui/clearance/rule_waivers.h"

#include <QDate>
#include <algorithm>
#include <utility>

#include "model/session/session.h"
#include "ui/clearance/waive_dialog.h"
#include "ui/common/display_units.h"
#include "ui/common/paths.h"
#include "ui/workspace/feature.h"

namespace ui {

namespace {

QString sideText(const model::WaivedSide& side) {
    QStringList texts;
    for (const std::string& text : {side.net, side.pin, side.kind}) {
        if (!text.empty()) {
            texts += QString::fromStdString(text);
        }
    }
    return texts.join(QStringLiteral(", "));
}

/// As the list of locations says it, in the unit of the window.
QString locationText(const model::Waiver& waiver, LengthUnit unit) {
    const auto from = base::toDouble(waiver.from);
    return RuleWaivers::tr("%1 on %2 at %3: %4, %5 and %6")
        .arg(QLatin1String(model::nameOf(waiver.kind)), QString::fromStdString(waiver.layer),
             positionText(from.x, from.y, unit), fixedLengthInBoth(waiver.distance, unit), sideText(waiver.sides[0]),
             sideText(waiver.sides[1]));
}

}  // namespace

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
    auto* dialog = new WaiveDialog(locationText(waiver, m_workspace.unit()), m_settings.author(), &parent);
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

void RuleWaivers::withdraw(const List& waivers) {
    List after = m_list;
    std::erase_if(after, [&](const model::Waiver& one) { return std::ranges::find(waivers, one) != waivers.end(); });
    if (after != m_list) {
        m_part.edit(tr("withdrawing a waiver"), m_list, std::move(after));
    }
}

base::Status RuleWaivers::read(const QString& path) {
    ASSIGN_OR_RETURN(List list, model::readWaivers(toPath(path)));
    m_part.edit(tr("the waivers"), m_list, std::move(list));
    return base::Done{};
}

}  // namespace ui
