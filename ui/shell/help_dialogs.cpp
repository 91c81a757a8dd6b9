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
    {"Left drag", "Orbit (3D), select with a box (2D)"},
    {"Click", "Select; again: what lies beneath; with Ctrl: add or take away"},
    {"Double click, Alt + click", "Bring it to the middle of the other view"},
    {"Box from the left, from the right (2D)", "Select what is inside; what is inside or touched"},
    {"Shift, Ctrl, Alt (measuring)", "Straight, in steps of 45°, without catching anything"},
    {"Wheel", "Zoom to the cursor"},
    {"Shift + click, twice (cross-section)", "Measure from edge to edge"},
    {"Arrows (canvas)", "Orbit, with Shift pan (3D); pan (2D)"},
    {"Click on a colour (layers)", "Change the colour"},
    {"Drag in an opacity (layers)", "Change the opacity"},
    {"Space (layers)", "Show or hide the selected layers"},
    {"Enter, double click (nets)", "Bring the net to the middle of both views"},
    {"Ctrl+C (any table)", "Copy the selected rows"},
    {"Drop a file or folder", "Open it"},
};

QString row(const QString& how, const QString& what) {
    return QStringLiteral("<tr><td><b>%1</b></td><td>&nbsp;&nbsp;%2</td></tr>")
        .arg(how.toHtmlEscaped(), what.toHtmlEscaped());
}

QString section(const QString& title, const QString& rows) {
    return rows.isEmpty() ? QString() : QStringLiteral("<h3>%1</h3><table>%2</table>").arg(title.toHtmlEscaped(), rows);
}

QString rowsOf(MenuId menu, KeyPreset preset) {
    QString rows;
    for (const ActionSpec& spec : actionSpecs()) {
        if (spec.menu == menu) {
            rows += row(keysText(keysOf(spec, preset), QStringLiteral(" or ")), QString::fromUtf8(spec.tip));
        }
    }
    return rows;
}

/// What drags of the right button do; the middle button always pans.
QString dragRows(const MouseHabits& habits) {
    const QString pan = QStringLiteral("Pan");
    if (habits.rightDragZooms) {
        return row(QStringLiteral("Middle drag, Shift + left or right drag, right drag (3D)"), pan) +
               row(QStringLiteral("Right drag down and right (2D)"), QStringLiteral("Zoom into the box")) +
               row(QStringLiteral("Right drag in another direction (2D)"), QStringLiteral("Zoom out of the box"));
    }
    if (habits.shiftRightDragOrbits) {
        return row(QStringLiteral("Middle drag, right drag, Shift + left drag"), pan) +
               row(QStringLiteral("Shift + right drag (3D)"), QStringLiteral("Orbit"));
    }
    return row(QStringLiteral("Middle drag, right drag, Shift + left drag"), pan);
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
        gestures += row(QString::fromUtf8(gesture.how), QString::fromUtf8(gesture.what));
    }
    QString text = section(QStringLiteral("Mouse and canvas"), gestures);
    for (std::size_t menu = 0; menu < kMenuCount; ++menu) {
        const auto id = static_cast<MenuId>(menu);
        text += section(QString::fromUtf8(menuTitle(id)).remove('&'), rowsOf(id, keys));
    }
    return text;
}

void showKeyList(QWidget& parent, KeyPreset keys) {
    auto* plane = new QTextBrowser;
    plane->setHtml(keyListText(keys));
    plane->setMinimumSize(plane->fontMetrics().averageCharWidth() * 80, plane->fontMetrics().height() * 32);
    showDialog(parent, QStringLiteral("keysSheet"), QStringLiteral("Keys and mouse"), *plane);
}

void showAbout(QWidget& parent) {
    auto* label =
        new QLabel(QStringLiteral("<h2>Copperscope %1</h2>"
                                  "<p>Looks into printed circuit boards.</p>"
                                  "<p>Free software under the GNU General Public License, version 3 or later.<br>"
                                  "It comes without any warranty.</p>")
                       .arg(QCoreApplication::applicationVersion().toHtmlEscaped()));
    showDialog(parent, QStringLiteral("about"), QStringLiteral("About Copperscope"), *label);
}

}  // namespace ui
