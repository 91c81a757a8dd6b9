#include <QtTest>

#include "model/formats/registry.h"
#include "tests/places.h"

class ReaderTest : public QObject {
    Q_OBJECT

private slots:
    void missingPathIsNamed() {
        base::Progress progress;
        const auto result = model::readBoard("/nowhere/board.tgz", {}, progress);
        QVERIFY(!result);
        QCOMPARE(result.error().code, base::ErrorCode::BadInput);
        QVERIFY(result.error().text.find("/nowhere/board.tgz") != std::string::npos);
    }

    void aFileThatIsNoBoardIsRefused() {
        QTemporaryFile file;
        QVERIFY(file.open());
        file.write("Dear diary, this is not a board.\n");
        file.flush();
        base::Progress progress;
        const auto result = model::readBoard(file.fileName().toStdString(), {}, progress);
        QVERIFY(!result);
        QCOMPARE(result.error().code, base::ErrorCode::BadInput);
    }

    void bothFormatsOpenThroughOneDoor() {
        base::Progress progress;
        const auto job = model::readBoard(locations::kSample, {}, progress);
        QVERIFY2(job.ok(), job ? "" : job.error().text.c_str());
        QVERIFY((*job)->elements.size() > 1000);

        QTemporaryFile file;
        QVERIFY(file.open());
        file.write("LAYERBEGIN\nLAYERTYPE,Top\nBASEPLANEHEIGHT,0\nTHICKNESS,1\nLAYEREND\n");
        file.flush();
        QVERIFY(model::readBoard(file.fileName().toStdString(), {}, progress).ok());
    }

    void aCancelledReadSaysSo() {
        base::Progress progress;
        progress.cancel();
        const auto result = model::readBoard(locations::kSample, {}, progress);
        QVERIFY(!result);
        QCOMPARE(result.error().code, base::ErrorCode::Cancelled);
    }
};

QTEST_APPLESS_MAIN(ReaderTest)
#include "reader_test.moc"
