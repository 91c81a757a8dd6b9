#include "tests/ui/window_fixture.h"

#include <QCursor>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QGuiApplication>
#include <QScreen>
#include <QSignalSpy>
#include <QWindow>
#include <QtTest>

#include "tests/locations.h"
#include "tests/patience.h"

namespace {

constexpr int kVisible = 6;  // of 255, in any channel
constexpr int kSceneMs = 2'000;
constexpr int kLoadMs = 60000;

bool differ(QRgb a, QRgb b) {
    return std::abs(qRed(a) - qRed(b)) > kVisible || std::abs(qGreen(a) - qGreen(b)) > kVisible ||
           std::abs(qBlue(a) - qBlue(b)) > kVisible;
}

/// The one of the process. Goes with its QApplication, for what a window has left on the device is reported then.
std::shared_ptr<ui::GpuContext> sharedContext() {
    static std::shared_ptr<ui::GpuContext> s_context;
    if (s_context == nullptr) {
        qAddPostRoutine([] { s_context.reset(); });
    }
    if (s_context == nullptr || s_context->device().isLost()) {
        base::Result<std::unique_ptr<ui::GpuContext>> context = ui::GpuContext::create();
        if (!context) {
            qFatal("%s", context.error().text.c_str());
        }
        s_context = std::move(*context);
    }
    return s_context;
}

}  // namespace

void TestWindow::save(ui::ActionId id, const QString& path) {
    actions()[id].trigger();
    nameFile(path);
}

void TestWindow::nameFile(const QString& path) {
    auto* dialog = findChild<QFileDialog*>();
    emit dialog->fileSelected(path);
    delete dialog;
    awaitFiles();
    activateWindow();  // keys go to the window again
    (void)QTest::qWaitForWindowActive(this);
}

void TestWindow::awaitFiles() const {
    static_cast<void>(workspace().files().finish());
}

void TestWindow::showPanel(const char* dock) const {
    auto* panel = findChild<QDockWidget*>(dock);
    panel->show();
    panel->raise();
    QTest::qWait(1);  // lays it out
}

QString TestWindow::fact(const QString& name) const {
    const QAbstractItemModel& facts = *elementPanel().findChild<ui::TableView*>()->model();
    for (int row = 0; row < facts.rowCount(); ++row) {
        if (facts.index(row, 0).data().toString() == name) {
            return facts.index(row, 1).data().toString();
        }
    }
    return {};
}

void TestWindow::savePicture(const QString& path, int width) const {
    find<ui::PictureSaver>().save(views().active(), path, width);
}

bool TestWindow::awaitWork() const {
    return QTest::qWaitFor([this] { return !workspace().isWorking(); }, kLoadMs);
}

WindowFixture::WindowFixture(const ui::Loader::Work& work)
    : m_settings(m_folder.filePath("settings.ini")),
      m_context(sharedContext()),
      m_errorsBefore(m_context->validationErrors()) {
    m_settings.setKnowsOfSoftwareDevice();  // as in every run but the first: what is shown once takes no room
    restart(work);
}

void WindowFixture::restart(const ui::Loader::Work& work) {
    if (m_window) {
        m_window->close();
    }
    m_window.reset();
    QCoreApplication::processEvents();  // a program that ends, and one that starts
    m_window = std::make_unique<TestWindow>(*m_context, m_settings, work);
    m_window->resize(1000, 700);
    m_window->show();
    if (!QTest::qWaitForWindowExposed(m_window.get())) {
        qFatal("the window does not appear");
    }
    m_window->activateWindow();
    // The display's own pointer points at nothing: tests send what a mouse would.
    QCursor::setPos(m_window->screen()->geometry().bottomRight());
}

bool WindowFixture::openAndWait(const QString& path) {
    bool isShown = false;
    const auto connection = QObject::connect(&m_window->loader(), &ui::Loader::loaded, [&] { isShown = true; });
    m_window->open(path.toStdString());
    const bool isDone = QTest::qWaitFor([&] { return !m_window->loader().isLoading(); }, kLoadMs);
    QObject::disconnect(connection);
    if (isShown) {  // a software device gets the board after the first flat picture (decision 204)
        (void)QTest::qWaitFor(
            [&] { return std::ranges::all_of(m_window->views().both(), [](auto* view) { return view->hasScene(); }); },
            kSceneMs);
    }
    do {
        QTest::qWait(50);  // lets the layout settle and the first frames come
    } while (!m_context->turns().isFree());
    return isDone && isShown;
}

bool WindowFixture::awaitRest() {
    constexpr int kQuietMs = 500;
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < kPatienceMs) {
        const QSignalSpy flat(&m_window->views().flat(), &ui::BoardView::drawn);
        const QSignalSpy solid(&m_window->views().solid(), &ui::BoardView::drawn);
        QTest::qWait(kQuietMs);
        if (flat.isEmpty() && solid.isEmpty() && m_context->turns().isFree()) {
            return true;
        }
    }
    return false;
}

std::filesystem::path WindowFixture::copyOfJob(const char* name) const {
    const std::filesystem::path job = std::filesystem::path(m_folder.path().toStdString()) / name;
    if (!std::filesystem::exists(job)) {
        std::filesystem::copy(std::filesystem::path(locations::kTestData) / "odb" / name, job,
                              std::filesystem::copy_options::recursive);
    }
    return job;
}

QString WindowFixture::copyOfSample() const {
    const QString path = folder() + "/sample.tgz";
    if (!QFile::exists(path)) {
        QFile::copy(locations::kSample, path);
    }
    return path;
}

QImage WindowFixture::picture() {
    base::Result<QImage> picture = m_window->views().solid().grabPicture();
    return picture ? picture->convertToFormat(QImage::Format_RGB32) : QImage();
}

QImage WindowFixture::shown() {
    QWidget& view = m_window->views().solid();
    if (m_context->surfaceInstance() == nullptr) {
        return view.grab().toImage().convertToFormat(QImage::Format_RGB32);
    }
    const QPoint corner = view.mapToGlobal(QPoint(0, 0));
    const QPixmap screen =
        QGuiApplication::primaryScreen()->grabWindow(0, corner.x(), corner.y(), view.width(), view.height());
    return screen.toImage().convertToFormat(QImage::Format_RGB32);
}

void WindowFixture::key(Qt::Key key, Qt::KeyboardModifiers modifiers) {
    QObject& canvas = m_window->views().solid().canvas();
    if (auto* nativeWindow = qobject_cast<QWindow*>(&canvas)) {
        QTest::keyClick(nativeWindow, key, modifiers);
    } else {
        QTest::keyClick(qobject_cast<QWidget*>(&canvas), key, modifiers);
    }
}

std::uint32_t validationErrorsOnClosing(std::unique_ptr<WindowFixture>& fixture) {
    const std::uint32_t errors = fixture->validationErrors();
    fixture.reset();
    return errors;
}

int differingPixels(const QImage& a, const QImage& b) {
    if (a.size() != b.size()) {
        return a.width() * a.height() + b.width() * b.height();
    }
    int count = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            count += differ(a.pixel(x, y), b.pixel(x, y)) ? 1 : 0;
        }
    }
    return count;
}

double inkOf(const QImage& picture) {
    QImage ground(picture.size(), picture.format());
    ground.fill(picture.pixel(0, 0));
    return static_cast<double>(differingPixels(picture, ground)) / (picture.width() * picture.height());
}
