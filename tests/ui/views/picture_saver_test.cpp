// Pictures that are saved and copied, while the window goes on.
#include <QClipboard>
#include <QFileDialog>
#include <QGuiApplication>
#include <QInputDialog>
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>
#include <QTimer>
#include <QtTest>
#include <atomic>
#include <cmath>
#include <thread>

#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"
#include "ui/shell/message_bar.h"

using ui::ActionId;

namespace {

const QString kSample = locations::kSample;

std::atomic<bool> isHeld = false;

/// The sample, which is read once, and not delivered while boards are held.
base::Result<ui::LoadedBoard> givenWork(const model::OpenRequest& request, base::Progress& progress) {
    static const base::Result<ui::LoadedBoard> board = ui::loadBoard(request, progress);
    while (isHeld && !progress.isCancelled()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return board;
}

}  // namespace

class PictureSaverTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_fixture = std::make_unique<WindowFixture>();
        window().actions()[ActionId::ShowViewCube].trigger();  // it is on the screen and not in pictures
    }
    void cleanup() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void savedPictureIsWhatTheCanvasShows() {
        QVERIFY(m_fixture->openAndWait(kSample));
        const QString path = m_fixture->folder() + "/picture.png";
        window().savePicture(path);
        QVERIFY(window().awaitWork());
        const QImage saved = QImage(path).convertToFormat(QImage::Format_RGB32);
        QCOMPARE(differingPixels(saved, m_fixture->picture()), 0);
        QVERIFY(!window().messageBar().isVisible());
    }

    void anyBackEndDrawsASavedPicture() {
        QVERIFY(m_fixture->openAndWait(kSample));
        const QString path = m_fixture->folder() + "/picture.png";
        for (const ActionId view : {ActionId::ShowSolid, ActionId::ShowFlat}) {
            window().actions()[view].trigger();
            QVERIFY(m_fixture->awaitRest());
            for (const ActionId backend : {ActionId::BackendRaster, ActionId::BackendImpostor, ActionId::BackendPull}) {
                window().actions()[backend].trigger();
                window().savePicture(path);  // before the view has been drawn so
                QVERIFY(window().awaitWork());
                const base::Result<QImage> grabbed = window().views().active().grabPicture();
                QVERIFY(grabbed.ok());
                QCOMPARE(differingPixels(QImage(path).convertToFormat(QImage::Format_RGB32),
                                         grabbed->convertToFormat(QImage::Format_RGB32)),
                         0);
            }
        }
        window().actions()[ActionId::BackendAuto].trigger();
    }

    void picturesThatCannotBeWrittenAreAnError() {
        QVERIFY(m_fixture->openAndWait(kSample));
        for (const QString& path : {m_fixture->folder() + "/no/such/folder/picture.png", QString("/dev/full")}) {
            window().messageBar().hide();
            window().savePicture(path);
            QVERIFY(window().awaitWork());
            QVERIFY(window().messageBar().isVisible());
            QVERIFY2(window().error().contains(path), qPrintable(window().error()));
        }
    }

    void windowGoesOnWhileAPictureIsSaved() {
        QVERIFY(m_fixture->openAndWait(kSample));
        const QImage before = m_fixture->picture();
        int turns = 0;
        QTimer timer;
        connect(&timer, &QTimer::timeout, this, [&turns] { ++turns; });
        timer.start(0);
        const QStringList paths{m_fixture->folder() + "/one.png", m_fixture->folder() + "/two.png"};
        window().savePicture(paths[0], 1'500);
        window().savePicture(paths[1]);
        QVERIFY(window().workspace().isWorking());
        QVERIFY(!QFile::exists(paths[0]));
        window().views().solid().controller().look(render::NamedView::Bottom);  // they show what was there before
        window().selection().select({{0, model::ElementId{100}}});
        QVERIFY(window().awaitWork());
        QVERIFY(turns > 10);
        QCOMPARE(QImage(paths[0]).width(), 1'500);
        QCOMPARE(differingPixels(QImage(paths[1]).convertToFormat(QImage::Format_RGB32), before), 0);
        QTRY_VERIFY(m_fixture->context().turns().isFree());
        QVERIFY(differingPixels(m_fixture->picture(), before) > 1000);
    }

    void stoppedPicturesLeaveNothing_data() {
        QTest::addColumn<int>("waitMs");
        for (const int ms : {0, 50, 300}) {
            QTest::addRow("after %d ms", ms) << ms;
        }
    }
    void stoppedPicturesLeaveNothing() {
        QFETCH(int, waitMs);
        QVERIFY(m_fixture->openAndWait(kSample));
        const QDir folder(m_fixture->folder() + "/pictures");
        QVERIFY(folder.mkpath("."));
        window().savePicture(folder.filePath("picture.png"), 2'000);
        QTest::qWait(waitMs);
        if (!window().workspace().cancelWork()) {
            QVERIFY(QFile::exists(folder.filePath("picture.png")));
            return;  // a fast machine
        }
        QVERIFY(window().statusBar()->currentMessage().contains("picture.png"));
        QTRY_VERIFY(folder.isEmpty());
        QTRY_VERIFY(m_fixture->context().turns().isFree());
        QVERIFY(!window().messageBar().isVisible());
    }

    /// The board that comes is held until the pictures are there.
    void picturesGoOnWhileAnotherBoardIsRead() {
        isHeld = false;
        m_fixture = std::make_unique<WindowFixture>(givenWork);
        QVERIFY(m_fixture->openAndWait(kSample));
        isHeld = true;
        const QStringList paths{m_fixture->folder() + "/one.png", m_fixture->folder() + "/two.png"};
        window().savePicture(paths[0], 1'500);
        window().savePicture(paths[1]);
        window().open(std::filesystem::path(kSample.toStdString()));
        QTRY_VERIFY(QFile::exists(paths[0]) && QFile::exists(paths[1]));
        QVERIFY(window().loader().isLoading());
        isHeld = false;
        QVERIFY(window().awaitWork());
        QVERIFY(!window().messageBar().isVisible());
    }

    void picturesThatWereNotBegunAreReported() {
        isHeld = false;
        m_fixture = std::make_unique<WindowFixture>(givenWork);
        QVERIFY(m_fixture->openAndWait(kSample));
        const QDir folder(m_fixture->folder() + "/pictures");
        QVERIFY(folder.mkpath("."));
        for (int i = 0; i < 6; ++i) {
            window().savePicture(folder.filePath("%1.png").arg(i), 3'000);
        }
        connect(&window().workspace(), &ui::Workspace::sessionRestored, this,
                [this] { window().workspace().reportError("Of the new board"); });
        QVERIFY(m_fixture->openAndWait(kSample));  // at once: it has been read
        QTRY_VERIFY(window().messageBar().isVisible());
        QVERIFY2(window().error().startsWith("Of the new board\nThe board on the screen was replaced"),
                 qPrintable(window().error()));
        QVERIFY2(window().error().contains("not saved: ") && window().error().endsWith(folder.filePath("5.png")),
                 qPrintable(window().error()));
        QVERIFY(window().awaitWork());
        QVERIFY(!folder.exists("5.png"));
        for (const QString& name : folder.entryList(QDir::Files | QDir::Hidden)) {
            QVERIFY2(!window().error().contains(folder.filePath(name)), qPrintable(name));
        }
    }

    void closingAsksWhileAPictureIsWritten() {
        QVERIFY(m_fixture->openAndWait(kSample));
        const QString path = m_fixture->folder() + "/picture.png";
        window().savePicture(path, 2'000);
        window().close();
        QVERIFY(window().isVisible());
        auto* question = window().findChild<QMessageBox*>();
        QVERIFY(question != nullptr);
        QVERIFY2(question->text().startsWith("picture.png is still being written"), qPrintable(question->text()));
        QTest::mouseClick(question->button(QMessageBox::Cancel), Qt::LeftButton);
        QVERIFY(window().awaitWork());
        QCOMPARE(QImage(path).width(), 2'000);
    }

    void closingAsksForPicturesThatAreSavedAndNotForCopies() {
        QVERIFY(m_fixture->openAndWait(kSample));
        window().actions()[ActionId::CopyPicture].trigger();
        QVERIFY(window().workspace().isWorking());
        QCOMPARE(window().workspace().fileAtWork(), QString());
        window().savePicture(m_fixture->folder() + "/picture.png");  // waits for its turn
        QCOMPARE(window().workspace().fileAtWork(), QString("picture.png"));
        QVERIFY(window().awaitWork());
        window().actions()[ActionId::CopyPicture].trigger();
        QVERIFY(window().workspace().isWorking());
        window().close();
        QVERIFY(!window().isVisible());
    }

    void picturesEndWithTheirWindowOrDevice() {
        QVERIFY(m_fixture->openAndWait(kSample));
        const QDir folder(m_fixture->folder() + "/pictures");
        QVERIFY(folder.mkpath("."));
        const auto begin = [&] {
            for (int i = 0; i < 2; ++i) {
                window().savePicture(folder.filePath("%1.png").arg(i), 2'000);
            }
            QTest::qWait(20);  // the device may be at work, the pixels are not packed yet
        };
        begin();
        m_fixture->context().device().markLost();
        window().views().requestFrame();
        QTRY_VERIFY(!m_fixture->context().device().isLost());
        QVERIFY(window().awaitWork());
        QTRY_VERIFY(folder.isEmpty());
        QTRY_VERIFY2(window().error().contains("was started again.\n") && window().error().contains("not saved: "),
                     qPrintable(window().error()));
        QTRY_VERIFY(window().views().solid().hasScene());
        begin();
        window().close();
        auto* question = window().findChild<QMessageBox*>();
        QVERIFY(question != nullptr);
        QTest::mouseClick(question->button(QMessageBox::Close), Qt::LeftButton);
        QVERIFY(!window().isVisible());
        m_fixture->restart();
        QTRY_VERIFY(folder.isEmpty());
        QVERIFY(m_fixture->openAndWait(kSample));
    }

    void picturesOfAnySizeShowTheSame() {
        QVERIFY(m_fixture->openAndWait(kSample));
        window().actions()[ActionId::SaveLargePicture].trigger();
        auto* question = window().findChild<QInputDialog*>();
        QVERIFY(question != nullptr && question->isVisible());
        QCOMPARE(question->intValue(), 3840);
        question->setIntValue(1'700);
        question->accept();
        QVERIFY(QTest::qWaitFor([this] { return window().findChild<QFileDialog*>() != nullptr; }));
        window().findChild<QFileDialog*>()->reject();
        const QString path = m_fixture->folder() + "/large.png";
        window().savePicture(path, 1'700);
        QVERIFY(window().awaitWork());
        const QImage saved = QImage(path).convertToFormat(QImage::Format_RGB32);
        QCOMPARE(saved.width(), 1'700);
        const QImage shown = m_fixture->picture();
        QVERIFY(std::abs(saved.height() - 1'700.0 * shown.height() / shown.width()) <= 1.0);
        QVERIFY(std::abs(inkOf(saved) - inkOf(shown)) < 0.02);
        window().savePicture(path, 10'000'000);  // more than a device can
        QVERIFY(window().messageBar().isVisible());
        QCOMPARE(QImage(path).width(), 1'700);
    }

    void copiedPictureIsOnTheClipboard() {
        QVERIFY(m_fixture->openAndWait(kSample));
        window().actions()[ActionId::CopyPicture].trigger();
        QVERIFY(window().awaitWork());
        const QImage copied = QGuiApplication::clipboard()->image().convertToFormat(QImage::Format_RGB32);
        QCOMPARE(differingPixels(copied, m_fixture->picture()), 0);
    }

private:
    TestWindow& window() { return m_fixture->window(); }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(PictureSaverTest)
#include "picture_saver_test.moc"
