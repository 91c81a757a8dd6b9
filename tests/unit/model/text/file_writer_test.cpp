#include "model/text/file_writer.h"

#include <zlib.h>

#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

#include "model/text/whole_file.h"
#include "tests/full_disk.h"

namespace {

std::string unpacked(const std::string& path) {
    std::string bytes;
    std::string piece(1U << 16U, '\0');
    gzFile file = gzopen(path.c_str(), "rb");
    for (int count = 0; (count = gzread(file, piece.data(), static_cast<unsigned>(piece.size()))) > 0;) {
        bytes.append(piece, 0, static_cast<std::size_t>(count));
    }
    gzclose(file);
    return bytes;
}

QStringList filesIn(const QTemporaryDir& folder) {
    return QDir(folder.path()).entryList(QDir::Files);
}

}  // namespace

class FileWriterTest : public QObject {
    Q_OBJECT

private slots:
    void piecesMakeTheFile() {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("board.step").toStdString();
        const std::string piece(100'000, 'x');
        {
            model::FileWriter writer(path);
            for (int i = 0; i < 20; ++i) {
                QVERIFY(writer.write(piece));
            }
            QCOMPARE(writer.size(), std::uint64_t{2'000'000});
            QVERIFY(!filesIn(folder).contains("board.step"));
            QVERIFY(writer.commit());
        }
        QCOMPARE(std::filesystem::file_size(path), std::uintmax_t{2'000'000});
        QCOMPARE(filesIn(folder), QStringList{"board.step"});
    }

    void onlyTheNameIsMissingOfWhatIsFinished() {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("board.obj").toStdString();
        {
            model::FileWriter left(path);
            QVERIFY(left.write("left") && left.finish());
        }
        QVERIFY(filesIn(folder).isEmpty());
        model::FileWriter writer(path);
        QVERIFY(writer.write("whole") && writer.finish());
        QCOMPARE(filesIn(folder).size(), qsizetype{1});
        QCOMPARE(QFileInfo(folder.filePath(filesIn(folder).front())).size(), qint64{5});
        QVERIFY(!std::filesystem::exists(path));
        QVERIFY(writer.commit());
        QCOMPARE(*model::readWholeFile(path), std::string("whole"));
    }

    void packedPiecesUnpackToWhatWasWritten() {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("board.stpz").toStdString();
        std::string all;
        model::FileWriter writer(path, model::FileWriter::Packing::Gzip);
        for (int i = 0; i < 40'000; ++i) {
            const std::string piece = "#" + std::to_string(i) + "=CARTESIAN_POINT('',(1.,2.,3.));\n";
            QVERIFY(writer.write(piece));
            all += piece;
        }
        QVERIFY(writer.commit());
        QCOMPARE(writer.size(), std::uint64_t{all.size()});
        QCOMPARE(writer.packedSize(), std::uint64_t{std::filesystem::file_size(path)});
        QVERIFY(writer.packedSize() * 3 < writer.size());
        QVERIFY(unpacked(path) == all);
        QCOMPARE(filesIn(folder), QStringList{"board.stpz"});
    }

    void packedFilesOfNothingAreWhole() {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("empty.stpz").toStdString();
        model::FileWriter writer(path, model::FileWriter::Packing::Gzip);
        QVERIFY(writer.commit());
        QCOMPARE(unpacked(path), std::string());
        QCOMPARE(writer.packedSize(), std::uint64_t{std::filesystem::file_size(path)});
    }

    void whatIsNotCommittedLeavesNothing() {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("board.step").toStdString();
        {
            model::FileWriter writer(path);
            writer.write("half");
        }
        QVERIFY(filesIn(folder).isEmpty());
        QVERIFY(model::writeWholeFile(path, "before"));
        {
            model::FileWriter writer(path);
            writer.write(std::string(1'000'000, 'x'));
        }
        QCOMPARE(*model::readWholeFile(path), std::string("before"));
        QCOMPARE(filesIn(folder), QStringList{"board.step"});
    }

    /// The disk fills up in the middle: what was there stays, the half is gone, the reason is said.
    void aFullDiskLeavesWhatWasThere() {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("board.step").toStdString();
        QVERIFY(model::writeWholeFile(path, "before"));
        {
            const FullDisk disk(1'000'000);
            model::FileWriter writer(path);
            bool isGood = true;
            for (int i = 0; i < 20; ++i) {
                isGood = writer.write(std::string(100'000, 'x'));
            }
            QVERIFY(!isGood);
            const base::Status end = writer.commit();
            QVERIFY(!end && end.error().code == base::ErrorCode::OutputFailed);
            QVERIFY2(end.error().text.find("board.step cannot be written: File too large") != std::string::npos,
                     end.error().text.c_str());
        }
        QCOMPARE(*model::readWholeFile(path), std::string("before"));
        QCOMPARE(filesIn(folder), QStringList{"board.step"});
    }

    /// Small pieces that are still gathered fail at the end.
    void aFullDeviceIsSaidAtTheEnd() {
        model::FileWriter writer("/dev/full");
        QVERIFY(writer.write("text"));
        QVERIFY(writer.status());
        const base::Status end = writer.commit();
        QVERIFY(!end && end.error().text.find("No space left on device") != std::string::npos);
        QVERIFY(!std::filesystem::is_regular_file("/dev/full"));
    }

    void foldersThatTakeNothingAreSaidAtOnce() {
        for (const char* path : {"/nowhere/board.step", "/proc/board.step", "/"}) {
            model::FileWriter writer(path);
            QVERIFY(!writer.status());
            QVERIFY(!writer.write("text"));
            const base::Status end = writer.commit();
            QVERIFY(!end && end.error().text.starts_with(std::string(path) + " cannot be written: "));
        }
    }

    void aNameThatIsTakenMeanwhileIsAFailure() {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("board.step").toStdString();
        {
            model::FileWriter writer(path);
            writer.write("text");
            std::filesystem::create_directory(path);
            QVERIFY(!writer.commit());
        }
        QVERIFY(filesIn(folder).isEmpty());
        QVERIFY(std::filesystem::is_directory(path));
    }

    void twoWritersOfOneNameDoNotMix() {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("board.step").toStdString();
        {
            model::FileWriter one(path);
            model::FileWriter two(path);
            one.write("one");
            two.write("two");
            QVERIFY(one.commit());
            QVERIFY(two.commit());
        }
        QCOMPARE(*model::readWholeFile(path), std::string("two"));
        QCOMPARE(filesIn(folder), QStringList{"board.step"});
    }
};

QTEST_GUILESS_MAIN(FileWriterTest)
#include "file_writer_test.moc"
