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
    Q_DECLARE_TR_FUNCTIONS(HelpDialogs)
public:
    const char* how;
    const char* what;

    static const Gesture kAll[];
};

const Gesture Gesture::kAll[] = {
    {QT_TR_NOOP("Left drag"), QT_TR_NOOP("Orbit (3D), select with a box (2D)")},
    {QT_TR_NOOP("Click"), QT_TR_NOOP("Select; again after a pause: what lies beneath; with Ctrl: add or remove")},
    {QT_TR_NOOP("Tab, Shift + Tab (after a click)"), QT_TR_NOOP("Select what lies beneath; what lies above")},
    {QT_TR_NOOP("Double click, Alt + click"), QT_TR_NOOP("Zoom both views to it; the other view alone")},
    {QT_TR_NOOP("Right click"), QT_TR_NOOP("Menu of what lies there")},
    {QT_TR_NOOP("Box from the left, from the right (2D)"),
     QT_TR_NOOP("Select what is inside; what is inside or touched")},
    {QT_TR_NOOP("Shift, Ctrl, Alt (measuring)"), QT_TR_NOOP("Straight, in steps of 45°, without snapping")},
    {QT_TR_NOOP("Wheel"), QT_TR_NOOP("Zoom to the cursor")},
    {QT_TR_NOOP("Double click (sliders of the toolbar)"), QT_TR_NOOP("Layers together; true thickness")},
    {QT_TR_NOOP("Shift + click, twice (cross-section)"), QT_TR_NOOP("Measure the clearance (edge to edge)")},
    {QT_TR_NOOP("Arrows (canvas)"), QT_TR_NOOP("Orbit, with Shift pan (3D); pan (2D)")},
    {QT_TR_NOOP("Click on a colour (layers)"), QT_TR_NOOP("Change the colour")},
    {QT_TR_NOOP("Drag in an opacity (layers)"), QT_TR_NOOP("Change the opacity")},
    {QT_TR_NOOP("Space (layers)"), QT_TR_NOOP("Show or hide the selected layers")},
    {QT_TR_NOOP("Enter, double click (nets)"), QT_TR_NOOP("Centre the net in both views")},
    {QT_TR_NOOP("Ctrl+C (any table)"), QT_TR_NOOP("Copy the selected rows")},
    {QT_TR_NOOP("Drop a file or folder"), QT_TR_NOOP("Open it")},
};

QString text(const char* source) {
    return Gesture::tr(source);
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

QString wheelRow(const QString& modifier, WheelMove move) {
    const QString what = move == WheelMove::Zoom       ? text("Zoom to the cursor")
                         : move == WheelMove::Sideways ? text("Pan to the left and right")
                                                       : text("Pan up and down");
    return row(text("%1 + wheel").arg(modifier), what);
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
    const MouseHabits habits = mouseHabitsOf(keys);
    QString gestures =
        dragRows(habits) + wheelRow(text("Shift"), habits.shiftWheel) + wheelRow(text("Ctrl"), habits.ctrlWheel);
    for (const Gesture& gesture : Gesture::kAll) {
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
