#include "ui/clearance/rule_waivers.h"

#include <QDate>
#include <algorithm>
#include <utility>

#include "model/session/session.h"
#include "ui/clearance/system_user.h"
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

QString locationsText(const RuleWaivers::List& waivers, LengthUnit unit) {
    const QString first = locationText(waivers.front(), unit);
    return waivers.size() == 1 ? first : RuleWaivers::tr("%L1 locations, the first: %2").arg(waivers.size()).arg(first);
}

/// The author of the last waiver; before the first one whoever works here.
QString authorFor(const Settings& settings) {
    const QString last = settings.author();
    return last.isEmpty() ? systemUserName() : last;
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

void RuleWaivers::request(const List& waivers, QWidget& parent) {
    auto* dialog = new WaiveDialog(locationsText(waivers, m_workspace.unit()), authorFor(m_settings), &parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, waivers] {
        List said = waivers;
        for (model::Waiver& waiver : said) {
            waiver.reason = dialog->reason().toStdString();
            waiver.author = dialog->author().toStdString();
            waiver.date = QDate::currentDate().toString(Qt::ISODate).toStdString();
        }
        m_settings.setAuthor(dialog->author());
        add(said);
    });
    dialog->open();
}

void RuleWaivers::add(const List& waivers) {
    const auto sameIn = [](List& list, const model::Waiver& one) {
        return std::ranges::find_if(list, [&](const model::Waiver& other) { return model::areOfOnePlace(other, one); });
    };
    List added;
    for (const model::Waiver& one : waivers) {
        if (const auto same = sameIn(added, one); same == added.end()) {
            added.push_back(one);
        } else if (one.distance < same->distance) {
            *same = one;
        }
    }
    List after = m_list;
    std::erase_if(after, [&](const model::Waiver& old) { return sameIn(added, old) != added.end(); });  // it is better
    after.insert(after.end(), added.begin(), added.end());
    m_part.edit(waivers.size() == 1 ? tr("waiving a location") : tr("waiving %L1 locations").arg(waivers.size()),
                m_list, std::move(after));
}

void RuleWaivers::withdraw(const List& waivers) {
    List after = m_list;
    std::erase_if(after, [&](const model::Waiver& one) { return std::ranges::find(waivers, one) != waivers.end(); });
    if (after != m_list) {
        const std::size_t count = m_list.size() - after.size();
        m_part.edit(count == 1 ? tr("withdrawing a waiver") : tr("withdrawing %L1 waivers").arg(count), m_list,
                    std::move(after));
    }
}

base::Status RuleWaivers::read(const QString& path) {
    ASSIGN_OR_RETURN(List list, model::readWaivers(toPath(path)));
    m_part.edit(tr("the waivers"), m_list, std::move(list));
    return base::Done{};
}

}  // namespace ui
