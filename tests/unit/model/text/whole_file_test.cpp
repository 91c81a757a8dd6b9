#include "model/text/whole_file.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

class WholeFileTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsWrittenIsReadAndNothingElseIsLeft() {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("report").toStdString();
        QVERIFY(model::writeWholeFile(path, "one"));
        QVERIFY(model::writeWholeFile(path, "two"));
        QCOMPARE(*model::readWholeFile(path), std::string("two"));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
        QCOMPARE(model::readWholeFile(path + ".gone").error().text,
                 path + ".gone cannot be read: there is no such file");
        const std::string at = folder.path().toStdString();
        QCOMPARE(model::readWholeFile(at).error().text, at + " cannot be read: it is a folder");
    }

    void aLinkStaysOne() {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("report").toStdString();
        QVERIFY(model::writeWholeFile(path, "one"));
        std::filesystem::create_symlink(path, path + ".link");
        QVERIFY(model::writeWholeFile(path + ".link", "two"));
        QVERIFY(std::filesystem::is_symlink(path + ".link"));
        QCOMPARE(*model::readWholeFile(path), std::string("two"));
    }

    /// A file that cannot be replaced stays as it was.
    void failuresSayWhyAndLeaveTheFile() {
        const QTemporaryDir folder;
        const base::Status nowhere = model::writeWholeFile("/nowhere/report", "text");
        QVERIFY(!nowhere && nowhere.error().code == base::ErrorCode::OutputFailed);
        QVERIFY(nowhere.error().text.find("/nowhere/report cannot be written: No such file") != std::string::npos);
        const base::Status isFolder = model::writeWholeFile(folder.path().toStdString(), "text");
        QVERIFY(!isFolder);
    }

    /// A device is written to, not replaced by a file.
    void aFullDiskIsSaid() {
        const base::Status full = model::writeWholeFile("/dev/full", "text");
        QVERIFY(!full);
        QVERIFY2(full.error().text.find("No space left on device") != std::string::npos, full.error().text.c_str());
        QVERIFY(model::writeWholeFile("/dev/null", "text"));
        QVERIFY(!std::filesystem::is_regular_file("/dev/full") && !std::filesystem::is_regular_file("/dev/null"));
    }
};

QTEST_GUILESS_MAIN(WholeFileTest)
#include "whole_file_test.moc"
