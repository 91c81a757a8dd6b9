#include "tests/soak/driver.h"

#include <QApplication>
#include <QDialog>
#include <QElapsedTimer>
#include <QMenu>
#include <QMouseEvent>
#include <QPointer>
#include <QTimer>
#include <QWheelEvent>
#include <QtTest>
#include <algorithm>

#include "tests/soak/resources.h"
#include "ui/common/paths.h"

namespace soak {

namespace fs = std::filesystem;
using ui::BoardView;

namespace {

constexpr int kStepMs = 2;
constexpr int kDragSteps = 6;
constexpr int kDialogTries = 4;
constexpr int kActivationMs = 1000;

fs::path folderOf(const WindowFixture& fixture, const char* name) {
    return fs::path(fixture.folder().toStdString()) / name;
}

std::vector<std::string> namesIn(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        names.push_back(entry.path().lexically_relative(folder).string());
    }
    std::ranges::sort(names);
    return names;
}

}  // namespace

Driver::Driver(const std::vector<fs::path>& boards) {
    fs::create_directory(outputFolder());
    for (const fs::path& board : boards) {
        const fs::path folder = folderOf(m_fixture, "boards") / std::to_string(m_boards.size());
        fs::create_directories(folder);
        fs::copy(board, folder / board.filename(), fs::copy_options::recursive);
        m_boards.push_back(folder / board.filename());
    }
    m_fixture.settings().setLastFolder(ui::fromPath(outputFolder()));
}

fs::path Driver::outputFolder() const {
    return folderOf(m_fixture, "out");
}

std::vector<std::string> Driver::outputs() const {
    return namesIn(outputFolder());
}

void Driver::removeOutputs() const {
    fs::remove_all(outputFolder());
    fs::create_directory(outputFolder());
}

std::vector<std::string> Driver::unfinishedFiles() const {
    std::vector<std::string> names = namesIn(fs::path(m_fixture.folder().toStdString()));
    std::erase_if(names, [](const std::string& name) { return name.find(".part") == std::string::npos; });
    return names;
}

void Driver::restart() {
    m_fixture.settings().setLastFolder(ui::fromPath(outputFolder()));
    m_fixture.restart();
}

void Driver::open(std::size_t board) {
    window().open(m_boards[board % m_boards.size()]);
}

void Driver::rest(int ms) {
    QElapsedTimer clock;
    clock.start();
    do {
        QCoreApplication::processEvents(QEventLoop::AllEvents);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QThread::msleep(kStepMs);
    } while (clock.elapsed() < ms);
}

bool Driver::settle(int mostMs) {
    QElapsedTimer clock;
    clock.start();
    do {
        rest(20);
    } while ((window().workspace().isWorking() || !context().turns().isFree()) && clock.elapsed() < mostMs);
    return !window().workspace().isWorking();
}

bool Driver::awaitThreads(std::size_t count, int mostMs) {
    QElapsedTimer clock;
    clock.start();
    // Threads that Qt keeps for a while may have been among those counted: a file that is being written says more.
    while ((threadsNow() > count || !unfinishedFiles().empty()) && clock.elapsed() < mostMs) {
        rest(kStepMs);
    }
    return threadsNow() <= count;
}

BoardView& Driver::view(Dice& dice) {
    ui::BoardViews& views = window().views();
    BoardView& drawn = dice.oneIn(2) ? views.flat() : views.solid();
    BoardView& other = &drawn == &views.flat() ? views.solid() : views.flat();
    return drawn.isVisible() ? drawn : other;
}

QPointF Driver::locationIn(BoardView& view, Dice& dice) {
    const double x = dice.share();
    const double y = dice.share();
    return {x * view.width(), y * view.height()};
}

void Driver::send(BoardView& view, QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::MouseButtons held,
                  Qt::KeyboardModifiers modifiers) {
    QMouseEvent event(type, at, view.mapToGlobal(at), button, held, modifiers);
    QCoreApplication::sendEvent(&view.canvas(), &event);
    rest(kStepMs);
}

void Driver::move(BoardView& view, QPointF to, Qt::MouseButton held) {
    send(view, QEvent::MouseMove, to, Qt::NoButton, held, {});
}

void Driver::click(BoardView& view, QPointF at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
    move(view, at);
    send(view, QEvent::MouseButtonPress, at, button, button, modifiers);
    send(view, QEvent::MouseButtonRelease, at, button, Qt::NoButton, modifiers);
}

void Driver::doubleClick(BoardView& view, QPointF at) {
    click(view, at);
    send(view, QEvent::MouseButtonDblClick, at, Qt::LeftButton, Qt::LeftButton, {});
    send(view, QEvent::MouseButtonRelease, at, Qt::LeftButton, Qt::NoButton, {});
}

void Driver::drag(BoardView& view, QPointF from, QPointF to, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
    move(view, from);
    send(view, QEvent::MouseButtonPress, from, button, button, modifiers);
    for (int step = 1; step <= kDragSteps; ++step) {
        const QPointF at = from + (to - from) * step / kDragSteps;
        send(view, QEvent::MouseMove, at, Qt::NoButton, button, modifiers);
    }
    send(view, QEvent::MouseButtonRelease, to, button, Qt::NoButton, modifiers);
}

void Driver::wheel(BoardView& view, QPointF at, int notches) {
    QWheelEvent event(at, view.mapToGlobal(at), {}, QPoint(0, 120 * notches), {}, {}, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&view.canvas(), &event);
    rest(kStepMs);
}

void Driver::key(Qt::Key key, Qt::KeyboardModifiers modifiers) {
    activate();
    m_fixture.key(key, modifiers);
    rest(kStepMs);
}

bool Driver::stopWork() {
    activate();
    if (!window().workspace().isWorking()) {
        return false;
    }
    m_fixture.key(Qt::Key_Escape);  // no event comes in between, so the work cannot end by itself
    return true;
}

void Driver::activate() {
    if (!window().isActiveWindow()) {
        window().activateWindow();  // a dialog had the keyboard, and not every display gives it back
        (void)QTest::qWaitForWindowActive(&window(), kActivationMs);
    }
}

void Driver::trigger(ui::ActionId id) {
    if (window().actions()[id].isEnabled()) {
        window().actions()[id].trigger();
    }
    rest(kStepMs);
}

void Driver::clickRow(ui::TableView& table, Dice& dice) {
    const std::size_t drawn = dice.next();
    const int rows = table.model()->rowCount();
    if (rows == 0 || !table.isVisible()) {
        return;
    }
    const QModelIndex at = table.model()->index(static_cast<int>(drawn % static_cast<std::size_t>(rows)), 0);
    table.scrollTo(at);
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, table.visualRect(at).center());
    rest(kStepMs);
}

void Driver::answerAll(Dice& dice) {
    answerMenu(dice);
    for (int i = 0; i < kDialogTries; ++i) {
        const auto widgets = QApplication::topLevelWidgets();
        const auto open = std::ranges::find_if(
            widgets, [](QWidget* widget) { return qobject_cast<QDialog*>(widget) != nullptr && widget->isVisible(); });
        if (open == widgets.end()) {
            break;
        }
        answerDialog(*qobject_cast<QDialog*>(*open), dice);
    }
}

void Driver::answerMenu(Dice& dice) {
    const std::size_t drawn = dice.next();
    const QPointer<QMenu> menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    if (!menu) {
        return;
    }
    const QList<QAction*> rows = menu->actions();
    QAction* row =
        rows.isEmpty() ? nullptr : rows[static_cast<qsizetype>(drawn % static_cast<std::size_t>(rows.size()))];
    menu->close();
    if (row != nullptr && row->isEnabled() && row->menu() == nullptr) {
        row->trigger();
    }
    rest(kStepMs);
}

void Driver::answerDialog(QDialog& dialog, Dice& dice) {
    const QPointer<QDialog> open(&dialog);
    // The key may open another one over it, as for a file that is there already, and comes back when that is answered.
    QTimer over;
    QObject::connect(&over, &QTimer::timeout, [&open] {
        auto* other = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        if (other != nullptr && other != open) {
            other->reject();
        }
    });
    over.start(kStepMs);
    QTest::keyClick(&dialog, dice.oneIn(3) ? Qt::Key_Return : Qt::Key_Escape);
    over.stop();
    rest(20);
    if (open && open->isVisible()) {
        open->reject();
        rest(kStepMs);
    }
}

}  // namespace soak
