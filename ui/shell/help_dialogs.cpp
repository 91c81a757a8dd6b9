#include "ui/shell/help_dialogs.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "ui/workspace/actions.h"
#include "ui/workspace/key_presets.h"

namespace ui {

namespace {

struct Gesture {
    const char* how;
    const char* what;
};

constexpr Gesture kGestures[] = {
    {QT_TRANSLATE_NOOP("HelpDialogs", "Left drag"),
     QT_TRANSLATE_NOOP("HelpDialogs", "Orbit (3D), select with a box (2D)")},
    {QT_TRANSLATE_NOOP("HelpDialogs", "Click"),
     QT_TRANSLATE_NOOP("HelpDialogs", "Select; again: what lies beneath; with Ctrl: add or remove")},
    {QT_TRANSLATE_NOOP("HelpDialogs", "Double click, Alt + click"),
     QT_TRANSLATE_NOOP("HelpDialogs", "Centre it in the other view")},
    {QT_TRANSLATE_NOOP("HelpDialogs", "Box from the left, from the right (2D)"),
     QT_TRANSLATE_NOOP("HelpDialogs", "Select what is inside; what is inside or touched")},
    {QT_TRANSLATE_NOOP("HelpDialogs", "Shift, Ctrl, Alt (measuring)"),
     QT_TRANSLATE_NOOP("HelpDialogs", "Straight, in steps of 45°, without snapping")},
    {QT_TRANSLATE_NOOP("HelpDialogs", "Wheel"), QT_TRANSLATE_NOOP("HelpDialogs", "Zoom to the cursor")},
    {QT_TRANSLATE_NOOP("HelpDialogs", "Shift + click, twice (cross-section)"),
     QT_TRANSLATE_NOOP("HelpDialogs", "Measure the clearance (edge to edge)")},
    {QT_TRANSLATE_NOOP("HelpDialogs", "Arrows (canvas)"),
     QT_TRANSLATE_NOOP("HelpDialogs", "Orbit, with Shift pan (3D); pan (2D)")},
    {QT_TRANSLATE_NOOP("HelpDialogs", "Click on a colour (layers)"),
     QT_TRANSLATE_NOOP("HelpDialogs", "Change the colour")},
    {QT_TRANSLATE_NOOP("HelpDialogs", "Drag in an opacity (layers)"),
     QT_TRANSLATE_NOOP("HelpDialogs", "Change the opacity")},
    {QT_TRANSLATE_NOOP("HelpDialogs", "Space (layers)"),
     QT_TRANSLATE_NOOP("HelpDialogs", "Show or hide the selected layers")},
    {QT_TRANSLATE_NOOP("HelpDialogs", "Enter, double click (nets)"),
     QT_TRANSLATE_NOOP("HelpDialogs", "Centre the net in both views")},
    {QT_TRANSLATE_NOOP("HelpDialogs", "Ctrl+C (any table)"),
     QT_TRANSLATE_NOOP("HelpDialogs", "Copy the selected rows")},
    {QT_TRANSLATE_NOOP("HelpDialogs", "Drop a file or folder"), QT_TRANSLATE_NOOP("HelpDialogs", "Open it")},
};

QString text(const char* source) {
    return QCoreApplication::translate("HelpDialogs", source);
}

QString row(const QString& how, const QString& what) {
    return QStringLiteral("<tr><td><b>%1</b></td><td>&nbsp;&nbsp;%2</td></tr>")
        .arg(how.toHtmlEscaped(), what.toHtmlEscaped());
}

QString section(const QString& title, const QString& rows) {
    return rows.isEmpty() ? QString() : QStringLiteral("<h3>%1</h3><table>%2</table>").arg(title.toHtmlEscaped(), rows);
}

QString rowsOf(MenuId menu, KeyPreset preset) {
    QString rows;
    for (const ActionSpec& spec : ActionSet::kSpecs) {
        if (spec.menu == menu) {
            rows += row(keysText(keysOf(spec, preset), text(" or ")), ActionSet::tr(spec.tip));
        }
    }
    return rows;
}

/// What drags of the right button do; the middle button always pans.
QString dragRows(const MouseHabits& habits) {
    const QString pan = text("Pan");
    if (habits.rightDragZooms) {
        return row(text("Middle drag, Shift + left or right drag, right drag (3D)"), pan) +
               row(text("Right drag down and right (2D)"), text("Zoom into the box")) +
               row(text("Right drag in another direction (2D)"), text("Zoom out of the box"));
    }
    if (habits.shiftRightDragOrbits) {
        return row(text("Middle drag, right drag, Shift + left drag"), pan) +
               row(text("Shift + right drag (3D)"), text("Orbit"));
    }
    return row(text("Middle drag, right drag, Shift + left drag"), pan);
}

/// A dialog that may stay open beside the window; there is at most one of each name.
void showDialog(QWidget& parent, const QString& name, const QString& title, QWidget& content) {
    delete parent.findChild<QDialog*>(name);
    auto* dialog = new QDialog(&parent);
    dialog->setObjectName(name);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(title);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    auto* layout = new QVBoxLayout(dialog);
    layout->addWidget(&content);
    layout->addWidget(buttons);
    dialog->show();
}

}  // namespace

QString keyListText(KeyPreset keys) {
    QString gestures = dragRows(mouseHabitsOf(keys));
    for (const Gesture& gesture : kGestures) {
        gestures += row(text(gesture.how), text(gesture.what));
    }
    QString html = section(text("Mouse and canvas"), gestures);
    for (std::size_t menu = 0; menu < kMenuCount; ++menu) {
        const auto id = static_cast<MenuId>(menu);
        html += section(menuTitle(id).remove('&'), rowsOf(id, keys));
    }
    return html;
}

void showKeyList(QWidget& parent, KeyPreset keys) {
    auto* plane = new QTextBrowser;
    plane->setHtml(keyListText(keys));
    plane->setMinimumSize(plane->fontMetrics().averageCharWidth() * 80, plane->fontMetrics().height() * 32);
    showDialog(parent, QStringLiteral("keysSheet"), text("Keys and mouse"), *plane);
}

void showAbout(QWidget& parent) {
    auto* label = new QLabel(text("<h2>Copperscope %1</h2>"
                                  "<p>Looks into printed circuit boards.</p>"
                                  "<p>Free software under the GNU General Public License, version 3 or later.<br>"
                                  "It comes without any warranty.</p>")
                                 .arg(QCoreApplication::applicationVersion().toHtmlEscaped()));
    showDialog(parent, QStringLiteral("about"), text("About Copperscope"), *label);
}

}  // namespace ui
