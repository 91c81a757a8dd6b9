#include "model/text/scratch_file.h"

#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

#include "model/text/file_writer.h"
#include "model/text/whole_file.h"
#include "tests/full_disk.h"

namespace {

/// Numbered lines of so many bytes in all.
std::string linesOf(std::size_t bytes) {
    std::string lines;
    for (int i = 0; lines.size() < bytes; ++i) {
        lines += std::to_string(i) + '\n';
    }
    lines.resize(bytes);
    return lines;
}

model::ScratchPlace placeIn(const QTemporaryDir& folder) {
    return {folder.path().toStdString(), folder.filePath("whole").toStdString()};
}

void writeInPieces(model::ScratchFile& scratch, const std::string& text) {
    for (std::size_t at = 0; at < text.size(); at += 1'000) {
        scratch.write(std::string_view(text).substr(at, 1'000));
    }
}

}  // namespace

class ScratchFileTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsWrittenComesOut_data() {
        QTest::addColumn<std::size_t>("size");
        for (const std::size_t size : {0, 10, 262'143, 262'144, 1'000'000}) {
            QTest::addRow("%zu", size) << size;
        }
    }
    void whatIsWrittenComesOut() {
        QFETCH(std::size_t, size);
        const QTemporaryDir folder;
        const std::string text = linesOf(size);
        model::ScratchFile scratch(placeIn(folder));
        writeInPieces(scratch, text);
        QCOMPARE(scratch.size(), std::uint64_t{size});
        QVERIFY(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).isEmpty());
        QVERIFY(scratch.bytes() == text);
        const std::string path = folder.filePath("whole").toStdString();
        model::FileWriter file(path);
        scratch.moveTo(file, base::Progress());
        QVERIFY(scratch.status() && file.commit());
        QVERIFY(*model::readWholeFile(path) == text);
    }

    void nothingIsMadeBeforeItIsNeeded() {
        model::ScratchFile scratch({"/nowhere", "/nowhere/whole"});
        writeInPieces(scratch, linesOf(200'000));
        QVERIFY(scratch.status());
        writeInPieces(scratch, linesOf(200'000));
        QVERIFY(!scratch.status());
        QVERIFY(scratch.bytes().empty());
    }

    void fullDisksAreSaid() {
        const QTemporaryDir folder;
        const FullDisk disk(500'000);
        model::ScratchFile scratch(placeIn(folder));
        writeInPieces(scratch, linesOf(1'000'000));
        QVERIFY(!scratch.status());
        QCOMPARE(scratch.status().error().code, base::ErrorCode::OutputFailed);
        QVERIFY(
            scratch.status().error().text.starts_with(folder.filePath("whole").toStdString() + " cannot be written: "));
        QVERIFY(scratch.bytes().empty());
    }

    void movingIsCancelled() {
        const QTemporaryDir folder;
        model::ScratchFile scratch(placeIn(folder));
        writeInPieces(scratch, linesOf(1'000'000));
        model::FileWriter file(folder.filePath("whole").toStdString());
        base::Progress progress;
        progress.cancel();
        scratch.moveTo(file, progress);
        QVERIFY(file.size() < 1'000'000);
    }

    /// What is no plain file has no folder of its own.
    void scratchesLieBesideTheFile() {
        const model::ScratchPlace beside = model::FileWriter("/nowhere/a.glb").scratchPlace();
        QCOMPARE(beside.folder, std::filesystem::path("/nowhere"));
        QCOMPARE(beside.named, std::filesystem::path("/nowhere/a.glb"));
        const model::ScratchPlace elsewhere = model::FileWriter("/dev/null").scratchPlace();
        QCOMPARE(elsewhere.folder, std::filesystem::temp_directory_path());
        QCOMPARE(elsewhere.named, elsewhere.folder);
    }
};

QTEST_GUILESS_MAIN(ScratchFileTest)
#include "scratch_file_test.moc"
