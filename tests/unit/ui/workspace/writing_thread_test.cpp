// Files are written one after another on a thread of their own, the last state of each, and what came of it is reported
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
    void allIsWrittenInOrderAndReportedHere() {
        QStringList written;
        QStringList reported;
        WritingThread files;
        for (const QString what : {"a", "b", "c"}) {
            files.add(nullptr, noting(written, what), [&reported, what](const base::Status& status) {
                QVERIFY(status.ok());
                QCOMPARE(QThread::currentThread(), qApp->thread());
                reported += what;
            });
        }
        QTRY_COMPARE(reported, (QStringList{"a", "b", "c"}));
        QCOMPARE(written, reported);
    }

    void ofOneKeyTheLastStateIsWritten() {
        std::binary_semaphore isBegun(0);
        std::binary_semaphore goOn(0);
        QStringList written;
        QStringList reported;
        const int one = 1;
        const int other = 2;
        const auto report = [&reported](const QString& what) {
            return [&reported, what](const base::Status&) { reported += what; };
        };
        WritingThread files;
        files.add(
            &one,
            [&]() -> base::Status {
                isBegun.release();
                goOn.acquire();
                written += "begun";
                return base::Done{};
            },
            report("begun"));
        isBegun.acquire();
        files.add(&one, noting(written, "older"), report("older"));
        files.add(&other, noting(written, "other"), report("other"));
        files.add(&one, noting(written, "last"), report("last"));
        goOn.release();
        QVERIFY(files.finish());
        QCOMPARE(written, (QStringList{"begun", "other", "last"}));
        QCOMPARE(reported, written);
    }

    void whatCannotBeWrittenIsReportedOnce() {
        QString why;
        WritingThread files;
        const auto reported = [&why](const base::Status& status) {
            why = status ? "" : QString::fromStdString(status.error().text);
        };
        files.add(
            nullptr,
            []() -> base::Status {
                return base::Error{base::ErrorCode::OutputFailed, "full"};
            },
            reported);
        QVERIFY(!files.finish());
        QCOMPARE(why, "full");
        QVERIFY(files.finish());
        files.add(
            nullptr, []() -> base::Status { throw std::bad_alloc(); }, reported);
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
