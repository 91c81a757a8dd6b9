// Work on a thread of its own, and what of it arrives.
#include "ui/workspace/background.h"

#include <sys/resource.h>
#include <unistd.h>

#include <QSignalSpy>
#include <QtTest>
#include <atomic>
#include <thread>

namespace {

/// How far the calling thread steps back.
int niceness() {
    return getpriority(PRIO_PROCESS, static_cast<id_t>(gettid()));
}

}  // namespace

class BackgroundTest : public QObject {
    Q_OBJECT

private slots:
    void theWindowsThreadIsAnsweredBeforeIt() {
        ui::Background background;
        QSignalSpy finished(&background, &ui::Background::finished);
        int own = 0;
        background.start([&own](base::Progress&) { own = niceness(); }, "");
        QTRY_COMPARE(finished.count(), 1);
        QVERIFY2(own > niceness(), qPrintable(QString::number(own)));
    }

    void anotherOneCancelsTheOneBefore() {
        ui::Background background;
        QSignalSpy finished(&background, &ui::Background::finished);
        QSignalSpy cancelled(&background, &ui::Background::cancelled);
        std::atomic<bool> wasCancelled = false;
        background.start(
            [&wasCancelled](base::Progress& progress) {
                while (!progress.isCancelled()) {
                    std::this_thread::yield();
                }
                wasCancelled = true;
            },
            "");
        bool isDone = false;
        background.start([&isDone](base::Progress&) { isDone = true; }, "");
        QCOMPARE(cancelled.count(), 1);
        QTRY_COMPARE(finished.count(), 1);
        QVERIFY(isDone);
        QTRY_VERIFY(wasCancelled);
    }
};

QTEST_GUILESS_MAIN(BackgroundTest)
#include "background_test.moc"
