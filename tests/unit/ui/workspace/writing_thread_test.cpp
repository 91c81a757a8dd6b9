// Files are written one after another on a thread of their own, the last state of each, and what came of it is told
// where it was asked for.

#include "ui/workspace/writing_thread.h"

#include <QtTest>
#include <new>
#include <semaphore>

using ui::WritingThread;

namespace {

WritingThread::Write noting(QStringList& written, const QString& what) {
    return [&written, what]() -> base::Status {
        written += what;
        return base::Done{};
    };
}

}  // namespace

class WritingThreadTest : public QObject {
    Q_OBJECT

private slots:
    void allIsWrittenInOrderAndToldHere() {
        QStringList written;
        QStringList told;
        WritingThread files;
        for (const QString what : {"a", "b", "c"}) {
            files.add(nullptr, noting(written, what), [&told, what](const base::Status& status) {
                QVERIFY(status.ok());
                QCOMPARE(QThread::currentThread(), qApp->thread());
                told += what;
            });
        }
        QTRY_COMPARE(told, (QStringList{"a", "b", "c"}));
        QCOMPARE(written, told);
    }

    void ofOneKeyTheLastStateIsWritten() {
        std::binary_semaphore isBegun(0);
        std::binary_semaphore goOn(0);
        QStringList written;
        QStringList told;
        const int one = 1;
        const int other = 2;
        const auto tell = [&told](const QString& what) { return [&told, what](const base::Status&) { told += what; }; };
        WritingThread files;
        files.add(
            &one,
            [&]() -> base::Status {
                isBegun.release();
                goOn.acquire();
                written += "begun";
                return base::Done{};
            },
            tell("begun"));
        isBegun.acquire();
        files.add(&one, noting(written, "older"), tell("older"));
        files.add(&other, noting(written, "other"), tell("other"));
        files.add(&one, noting(written, "last"), tell("last"));
        goOn.release();
        QVERIFY(files.finish());
        QCOMPARE(written, (QStringList{"begun", "other", "last"}));
        QCOMPARE(told, written);
    }

    void whatCannotBeWrittenIsToldOnce() {
        QString why;
        WritingThread files;
        const auto told = [&why](const base::Status& status) {
            why = status ? "" : QString::fromStdString(status.error().text);
        };
        files.add(
            nullptr,
            []() -> base::Status {
                return base::Error{base::ErrorCode::OutputFailed, "full"};
            },
            told);
        QVERIFY(!files.finish());
        QCOMPARE(why, "full");
        QVERIFY(files.finish());
        files.add(
            nullptr, []() -> base::Status { throw std::bad_alloc(); }, told);
        QVERIFY(!files.finish());
        QVERIFY2(why.contains("memory"), qPrintable(why));
    }

    void whatIsLeftIsWrittenBeforeItGoes() {
        QStringList written;
        {
            WritingThread files;
            for (int i = 0; i < 20; ++i) {
                files.add(nullptr, noting(written, QString::number(i)), [](const base::Status&) { QFAIL("gone"); });
            }
        }
        QCOMPARE(written.size(), 20);
        QCoreApplication::processEvents();
    }
};

QTEST_GUILESS_MAIN(WritingThreadTest)
#include "writing_thread_test.moc"
